// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/nc_program.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace rivulet::machine {

namespace {

constexpr int kSyntaxError = 12080;
constexpr int kTypeMismatch = 12150;
constexpr int kUnknownG = 12470;
constexpr int kUnknownName = 12550;
/// Control structures within each other.
constexpr std::size_t kNestingMax = 16;
/// Elements of one array.
constexpr int kElementsMax = 100000;

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Words that change nothing the virtual machine models.
bool isIgnoredWord(std::string_view word) {
  static constexpr std::array<std::string_view, 25> kWords{
      "FFWON",  "FFWOF",     "DYNNORM",  "DYNPOS",   "DYNROUGH", "DYNSEMIFIN", "DYNFINISH",
      "COMPOF", "ORIWKS",    "ORIAXES",  "CFC",      "CFTCP",    "CFIN",       "NORM",
      "FNORM",  "STARTFIFO", "STOPFIFO", "FIFOCTRL", "SUPA",     "DISPLOF",    "SAVE",
      "SBLON",  "SBLOF",     "CUT2D",    "KONT"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

/// G functions without effect on what the virtual machine models.
bool isIgnoredG(int number) {
  static constexpr std::array<int, 16> kNumbers{40,  53,  54,  55,  56,  57,  94,  153,
                                                450, 451, 500, 601, 602, 603, 505, 506};
  return std::find(kNumbers.begin(), kNumbers.end(), number) != kNumbers.end();
}

}  // namespace

/// Compiles one line after another; control structures are closed by back-patching.
class NcCompiler {
 public:
  explicit NcCompiler(NcProgram& program) : m_program(program) {}

  void line(std::string_view raw, base::LineNumber number) {
    m_line = number;
    m_firstOfBlock = true;
    m_dwell = false;
    m_ends = false;
    m_returns = false;
    m_text = upperOutsideStrings(raw);
    m_at = 0;
    skipBlanks();
    if (peek() == '%') {
      return;  // archive header of a transferred file
    }
    prefix();
    MotionStatement motion;
    bool hasMotion = false;
    while (!atEnd()) {
      if (!word(motion, hasMotion)) {
        return;
      }
    }
    if (hasMotion) {
      emit(motion);
    }
    if (m_ends) {
      emit(EndStatement{});
    } else if (m_returns) {
      emit(ReturnStatement{});
    }
  }

  void finish() {
    for (const Open& open : m_open) {
      m_line = open.line;
      m_firstOfBlock = true;
      alarm(kSyntaxError,
            fmt::format("The {} of line {} is not closed.", nameOf(open.kind), open.line.value));
      if (open.branch) {
        patch(*open.branch);
      }
    }
  }

 private:
  enum class Structure { If, While, For, Loop, Repeat };
  struct Open {
    Structure kind = Structure::If;
    std::optional<std::size_t> branch;  ///< to be patched at the end
    std::size_t begin = 0;              ///< where the loop goes on
    int slot = 0;                       ///< For
    base::LineNumber line;
  };

  static std::string_view nameOf(Structure kind) {
    static constexpr std::array<std::string_view, 5> kNames{"IF", "WHILE", "FOR", "LOOP", "REPEAT"};
    return kNames[static_cast<std::size_t>(kind)];
  }

  static std::string upperOutsideStrings(std::string_view raw) {
    std::string text;
    bool inString = false;
    for (const char c : raw) {
      if (c == '"') {
        inString = !inString;
      }
      if (c == ';' && !inString) {
        break;
      }
      text += inString || c < 'a' || c > 'z' ? c : static_cast<char>(c - 'a' + 'A');
    }
    return text;
  }

  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
  }

  void skipBlanks() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\r') {
      ++m_at;
    }
  }

  bool atEnd() {
    skipBlanks();
    return m_at >= m_text.size();
  }

  bool take(char c) {
    skipBlanks();
    if (peek() != c) {
      return false;
    }
    ++m_at;
    return true;
  }

  bool expect(char c) {
    return take(c) || alarm(kSyntaxError, fmt::format("Syntax error: '{}' is missing.", c));
  }

  [[nodiscard]] std::string name() const {
    std::size_t end = m_at;
    while (end < m_text.size() && (isLetter(m_text[end]) || isDigit(m_text[end]))) {
      ++end;
    }
    return m_text.substr(m_at, end - m_at);
  }

  std::string takeName() {
    skipBlanks();
    const std::string word = name();
    m_at += word.size();
    return word;
  }

  bool takeWord(std::string_view word) {
    skipBlanks();
    if (name() != word) {
      return false;
    }
    m_at += word.size();
    return true;
  }

  /// Block skip, block number and label in front of a block, in the orders that occur.
  void prefix() {
    for (int i = 0; i < 2; ++i) {
      skipBlanks();
      if (peek() == '/') {
        ++m_at;  // block skip is not active
        while (isDigit(peek())) {
          ++m_at;
        }
        skipBlanks();
      }
      if ((peek() == 'N' || peek() == ':') && isDigit(peek(1))) {
        std::size_t end = m_at + 1;
        while (end < m_text.size() && isDigit(m_text[end])) {
          ++end;
        }
        m_program.m_labels.push_back(
            {"N" + m_text.substr(m_at + 1, end - m_at - 1), m_program.m_statements.size()});
        m_at = end;
      }
    }
    skipBlanks();
    const std::string label = name();
    if (label.size() >= 2 && isLetter(label[0]) && isLetter(label[1]) &&
        peek(label.size()) == ':') {
      m_program.m_labels.push_back({label, m_program.m_statements.size()});
      m_at += label.size() + 1;
    }
  }

  template <class What>
  std::size_t emit(What what) {
    m_program.m_statements.push_back({m_line, std::move(what), m_firstOfBlock, m_readsMainRun});
    m_firstOfBlock = false;
    m_readsMainRun = false;
    return m_program.m_statements.size() - 1;
  }

  bool alarm(int number, std::string text) {
    emit(AlarmStatement{{number, std::move(text)}});
    return false;
  }

  void patch(std::size_t branch) {
    std::get<BranchStatement>(m_program.m_statements[branch].what).target =
        m_program.m_statements.size();
  }

  std::optional<Expression> expression() {
    std::string problem;
    std::optional<ParsedExpression> parsed =
        parseExpression(std::string_view(m_text).substr(m_at), problem, &m_program.m_variables);
    if (!parsed) {
      alarm(kSyntaxError, fmt::format("Syntax error: {}.", problem));
      return std::nullopt;
    }
    m_at += parsed->length;
    m_readsMainRun = (m_readsMainRun || parsed->expression.readsMainRun()) && !m_inSyncAction;
    return std::move(parsed->expression);
  }

  /// Value of an address: a signed number, or '=' and an expression.
  std::optional<Expression> addressValue() {
    skipBlanks();
    if (peek() == '=') {
      ++m_at;
    } else if (!isDigit(peek()) && peek() != '-' && peek() != '+' && peek() != '.') {
      alarm(kSyntaxError, "Syntax error: an address needs a number or '='.");
      return std::nullopt;
    }
    return expression();
  }

  /// As `addressValue`, or =AC(...), =IC(...).
  std::optional<Coordinate> coordinate() {
    Coordinate coordinate;
    skipBlanks();
    if (peek() == '=') {
      const std::size_t start = m_at++;
      const bool absolute = takeWord("AC");
      if (absolute || takeWord("IC")) {
        coordinate.reference =
            absolute ? Coordinate::Reference::Absolute : Coordinate::Reference::Incremental;
        skipBlanks();
        if (peek() != '(') {
          alarm(kSyntaxError, "Syntax error: AC and IC need their value in parentheses.");
          return std::nullopt;
        }
      } else {
        m_at = start;
      }
    }
    std::optional<Expression> value =
        coordinate.reference == Coordinate::Reference::Modal ? addressValue() : expression();
    if (!value) {
      return std::nullopt;
    }
    coordinate.value = std::move(*value);
    return coordinate;
  }

  /// @return false if the rest of the line is not to be read
  bool word(MotionStatement& motion, bool& hasMotion) {
    const std::string word = name();
    if (word.empty()) {
      return alarm(kSyntaxError, fmt::format("Syntax error at '{}'.", peek()));
    }
    if (word[0] == 'R' && (word == "R" || isDigit(word[1]))) {
      return assignment();
    }
    if (m_program.m_variables.contains(word)) {
      m_at += word.size();
      return localAssignment(m_program.m_variables.find(word)->second);
    }
    if (word == "I1" || word == "J1" || word == "K1") {
      m_at += 2;
      hasMotion = true;
      return into(motion.through[static_cast<std::size_t>(word[0] - 'I')], addressValue());
    }
    if (word == "RPL" || (word.size() >= 2 && isLetter(word[1]))) {
      return keyword(word, motion, hasMotion);
    }
    ++m_at;
    switch (word[0]) {
      case 'X':
      case 'Y':
      case 'Z':
        hasMotion = true;
        return into(motion.axes[static_cast<std::size_t>(word[0] - 'X')], coordinate());
      case 'I':
      case 'J':
      case 'K':
        hasMotion = true;
        return into(motion.centre[static_cast<std::size_t>(word[0] - 'I')], coordinate());
      case 'F':
        if (m_dwell) {
          std::optional<Expression> value = addressValue();
          m_dwell = false;
          return value && (emit(DwellStatement{std::move(*value)}), true);
        }
        hasMotion = true;
        return into(motion.feedMmPerMin, addressValue());
      case 'G':
        return gFunction(motion, hasMotion);
      case 'M':
        return mFunction();
      case 'L':
        return call("L" + digits(), {});
      case 'A':
      case 'B':
      case 'C':
        hasMotion = true;
        return into(motion.rotary[static_cast<std::size_t>(word[0] - 'A')], coordinate());
      case 'U':
      case 'V':
      case 'W':
        return coordinate().has_value();
      case 'S':
      case 'T':
      case 'D':
      case 'H':
        if (word[0] == 'T' && peek() == '=' && m_text.find('"', m_at) == m_at + 1) {
          const std::size_t close = m_text.find('"', m_at + 2);
          m_at = close == std::string::npos ? m_text.size() : close + 1;
          return true;  // T="name"
        }
        return addressValue().has_value();
      default:
        return alarm(kUnknownName, fmt::format("The name \"{}\" is not defined.", word));
    }
  }

  template <class Target, class Value>
  bool into(Target& target, Value value) {
    if (!value) {
      return false;
    }
    if (target) {
      return alarm(12010, "An address is programmed more than once in the block.");
    }
    target = std::move(value);
    return true;
  }

  std::string digits() {
    std::size_t end = m_at;
    while (end < m_text.size() && isDigit(m_text[end])) {
      ++end;
    }
    std::string text = m_text.substr(m_at, end - m_at);
    m_at = end;
    return text;
  }

  bool gFunction(MotionStatement& motion, bool& hasMotion) {
    const std::optional<int> number = base::parseInteger(digits());
    if (!number) {
      return alarm(kSyntaxError, "Syntax error: G needs a number.");
    }
    hasMotion = true;
    switch (*number) {
      case 0:
        return once(motion.mode, PathMode::Rapid);
      case 1:
        return once(motion.mode, PathMode::Line);
      case 2:
        return once(motion.mode, PathMode::Clockwise);
      case 3:
        return once(motion.mode, PathMode::CounterClockwise);
      case 4:
        m_dwell = true;
        hasMotion = false;
        return true;
      case 9:
        motion.exactStopOnce = true;
        return true;
      case 17:
        return once(motion.plane, Plane::XY);
      case 18:
        return once(motion.plane, Plane::ZX);
      case 19:
        return once(motion.plane, Plane::YZ);
      case 60:
        return once(motion.end, BlockEnd::ExactStop);
      case 64:
      case 642:
      case 643:
      case 644:
      case 645:
        motion.rounding = RoundingKind::Deviation;
        return once(motion.end, BlockEnd::Rounded);
      case 641:
        motion.rounding = RoundingKind::Distance;
        return once(motion.end, BlockEnd::Rounded);
      case 70:
      case 700:
        return once(motion.inches, true);
      case 71:
      case 710:
        return once(motion.inches, false);
      case 90:
        return once(motion.absolute, true);
      case 91:
        return once(motion.absolute, false);
      default:
        return isIgnoredG(*number) ||
               alarm(kUnknownG, fmt::format("G{} is not known to this machine.", *number));
    }
  }

  template <class Value>
  bool once(std::optional<Value>& target, Value value) {
    if (target) {
      return alarm(12060, "Two G functions of one group are in the block.");
    }
    target = value;
    return true;
  }

  bool mFunction() {
    const std::optional<int> number = base::parseInteger(digits());
    if (!number) {
      return alarm(kSyntaxError, "Syntax error: M needs a number.");
    }
    // The end comes behind whatever else is in the block.
    m_ends = m_ends || *number == 2 || *number == 30;
    m_returns = m_returns || *number == 17;
    return true;  // spindle, coolant and the like move no axis
  }

  bool assignment() {
    ++m_at;
    Expression index;
    if (isDigit(peek())) {
      index = Expression::number(base::parseNumber(digits()).value_or(-1.0));
    } else {
      if (!expect('[')) {
        return false;
      }
      std::optional<Expression> inner = expression();
      if (!inner || !expect(']')) {
        return false;
      }
      index = std::move(*inner);
    }
    if (!expect('=')) {
      return false;
    }
    std::optional<Expression> value = expression();
    return value && (emit(AssignStatement{std::move(index), std::move(*value)}), true);
  }

  /// Index of an element of an array, as one number.
  std::optional<Expression> elementIndex(const VariableInfo& variable) {
    // The expression parser knows how to fold the dimensions: it is asked for the element, and the
    // last instruction, which reads it, is left to the statement.
    std::string text = "[";
    std::size_t depth = 0;
    std::size_t end = m_at + 1;
    for (; end < m_text.size() && (m_text[end] != ']' || depth > 0); ++end) {
      depth += m_text[end] == '[' ? 1 : 0;
      depth -= m_text[end] == ']' ? 1 : 0;
    }
    const std::string inside =
        end < m_text.size() ? m_text.substr(m_at + 1, end - m_at - 1) : std::string();
    std::string folded;
    std::size_t begin = 0;
    std::size_t dimension = 0;
    depth = 0;
    for (std::size_t i = 0; i <= inside.size(); ++i) {
      const char c = i < inside.size() ? inside[i] : ',';
      depth += c == '[' || c == '(' ? 1 : 0;
      depth -= c == ']' || c == ')' ? 1 : 0;
      if (c != ',' || depth > 0) {
        continue;
      }
      const std::string part = "(" + inside.substr(begin, i - begin) + ")";
      if (dimension >= variable.sizes.size()) {
        alarm(kTypeMismatch, "An array has fewer dimensions than are given.");
        return std::nullopt;
      }
      folded = dimension == 0 ? part
                              : fmt::format("({}*{}+{})", folded, variable.sizes[dimension], part);
      begin = i + 1;
      ++dimension;
    }
    if (dimension != variable.sizes.size() || end >= m_text.size()) {
      alarm(kTypeMismatch, "An array needs one index per dimension in brackets.");
      return std::nullopt;
    }
    std::string problem;
    std::optional<ParsedExpression> parsed =
        parseExpression(folded, problem, &m_program.m_variables);
    if (!parsed) {
      alarm(kSyntaxError, fmt::format("Syntax error: {}.", problem));
      return std::nullopt;
    }
    m_at = end + 1;
    return std::move(parsed->expression);
  }

  bool localAssignment(const VariableInfo& variable) {
    std::optional<Expression> element;
    skipBlanks();
    if (!variable.sizes.empty() && !variable.isString) {
      if (peek() != '[') {
        return alarm(kSyntaxError, "Syntax error: an array needs its index in brackets.");
      }
      element = elementIndex(variable);
      if (!element) {
        return false;
      }
    }
    if (!expect('=')) {
      return false;
    }
    if (variable.isString) {
      return string().has_value();
    }
    std::optional<Expression> value = expression();
    return value &&
           (emit(LocalAssignStatement{variable.slot, std::move(element), std::move(*value)}), true);
  }

  std::optional<std::string> string() {
    skipBlanks();
    const std::size_t close = peek() == '"' ? m_text.find('"', m_at + 1) : std::string::npos;
    if (close == std::string::npos) {
      alarm(kTypeMismatch, "A text in quotes is expected; strings are not computed with here.");
      return std::nullopt;
    }
    std::string text = m_text.substr(m_at + 1, close - m_at - 1);
    m_at = close + 1;
    return text;
  }

  /// DEF type name [= value] {, name [= value]}.
  bool definition() {
    const std::string type = takeName();
    static constexpr std::array<std::string_view, 5> kTypes{"INT", "REAL", "BOOL", "CHAR",
                                                            "STRING"};
    if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) {
      return alarm(kUnknownName, fmt::format("The type \"{}\" is not known here.", type));
    }
    if (type == "STRING" && !sizes()) {
      return false;
    }
    do {
      const std::string variable = takeName();
      if (variable.empty()) {
        return alarm(kSyntaxError, "Syntax error: DEF needs a name.");
      }
      if (!define(variable, type)) {
        return false;
      }
      const VariableInfo info = m_program.m_variables.find(variable)->second;
      if (take('=') && !initialise(info)) {
        return false;
      }
    } while (take(','));
    return true;
  }

  std::optional<std::vector<int>> sizes() {
    std::vector<int> sizes;
    if (!take('[')) {
      return sizes;
    }
    long long elements = 1;
    do {
      skipBlanks();
      const std::optional<int> size = base::parseInteger(digits());
      if (!size || *size < 1 || (elements *= *size) > kElementsMax) {
        alarm(kSyntaxError, "The size of an array must be a whole number above 0.");
        return std::nullopt;
      }
      sizes.push_back(*size);
    } while (take(','));
    return expect(']') ? std::optional(sizes) : std::nullopt;
  }

  bool define(const std::string& variable, const std::string& type) {
    std::optional<std::vector<int>> dimensions = sizes();
    if (!dimensions) {
      return false;
    }
    VariableInfo info;
    info.slot = m_program.m_slotCount;
    info.sizes = std::move(*dimensions);
    info.isInteger = type == "INT" || type == "BOOL" || type == "CHAR";
    info.isString = type == "STRING";
    int elements = 1;
    for (const int size : info.sizes) {
      elements *= size;
    }
    m_program.m_slotCount += elements;
    m_program.m_variables[variable] = std::move(info);
    return true;
  }

  bool initialise(const VariableInfo& variable) {
    if (variable.isString) {
      return string().has_value();
    }
    FillStatement fill;
    fill.slot = variable.slot;
    const bool set = takeWord("SET");
    if (set || takeWord("REP")) {
      fill.repeats = !set;
      if (!expect('(')) {
        return false;
      }
      do {
        skipBlanks();
        if (peek() == ',' || peek() == ')') {
          fill.values.emplace_back();  // left out: keeps its value
          continue;
        }
        std::optional<Expression> value = expression();
        if (!value) {
          return false;
        }
        fill.values.push_back(std::move(value));
      } while (take(','));
      if (!expect(')')) {
        return false;
      }
      if (fill.repeats) {
        fill.values.resize(1);  // REP(value, count): all are filled
      }
    } else {
      std::optional<Expression> value = expression();
      if (!value) {
        return false;
      }
      fill.values.push_back(std::move(value));
    }
    emit(std::move(fill));
    return true;
  }

  bool keyword(const std::string& word, MotionStatement& motion, bool& hasMotion) {
    m_at += word.size();
    if (const std::optional<bool> done = structure(word)) {
      return *done;
    }
    if (const std::optional<bool> done = motionWord(word, motion, hasMotion)) {
      return *done;
    }
    if (const std::optional<JumpDirection> direction = jumpDirection(word)) {
      return jump(std::nullopt, *direction);
    }
    if (word == "STOPRE") {
      emit(StopreStatement{});
      return true;
    }
    if (word == "MSG") {
      return message();
    }
    if (word == "DEF") {
      return definition();
    }
    if (word == "RET") {
      m_returns = true;
      return true;
    }
    if (word == "PROC") {
      return procedure();
    }
    if (word == "EXTERN") {
      m_at = m_text.size();
      return true;
    }
    if (word == "CALL" || word == "EXTCALL") {
      const bool inParentheses = take('(');
      const std::optional<std::string> program = string();
      return program && (!inParentheses || expect(')')) && call(base::toUpper(*program), {});
    }
    if (word == "CANCEL") {
      std::optional<Expression> id;
      return expect('(') && (id = expression()) && expect(')') &&
             (emit(CancelStatement{std::move(*id)}), true);
    }
    if (word == "TRANS" || word == "ATRANS" || word == "ROT" || word == "AROT") {
      return frame(word);
    }
    if (word == "ID" || word == "IDS" || word == "WHEN" || word == "WHENEVER" || word == "FROM" ||
        word == "EVERY" || word == "DO") {
      return syncAction(word);
    }
    if (isIgnoredWord(word)) {
      return true;
    }
    skipBlanks();
    if (peek() == '=' || peek() == '[') {
      return alarm(kUnknownName, fmt::format("The name \"{}\" is not defined.", word));
    }
    // What is none of the language's own words is the name of a program.
    if (peek() == '(') {
      return callWithArguments(word);
    }
    if (m_firstOfBlock && !hasMotion) {
      return call(word, {}, true);
    }
    return alarm(kUnknownName,
                 fmt::format("The name \"{}\" is not defined or the option is missing.", word));
  }

  std::optional<bool> motionWord(const std::string& word, MotionStatement& motion,
                                 bool& hasMotion) {
    const auto set = [&](auto& target, auto value) {
      hasMotion = true;
      return once(target, value);
    };
    if (word == "SOFT") {
      return set(motion.dynamics, Dynamics::Soft);
    }
    if (word == "BRISK" || word == "DRIVE") {
      return set(motion.dynamics, Dynamics::Brisk);
    }
    if (word == "CIP") {
      return set(motion.mode, PathMode::Through);
    }
    if (word == "ADIS" || word == "ADISPOS") {
      hasMotion = true;
      std::optional<Expression> value = addressValue();
      if (value && word == "ADIS") {
        motion.roundingMm = std::move(value);
        return true;
      }
      return value.has_value();
    }
    if (word == "CR") {
      hasMotion = true;
      return into(motion.radius, addressValue());
    }
    if (word == "AR") {
      hasMotion = true;
      return into(motion.openingAngle, addressValue());
    }
    if (word == "TURN") {
      hasMotion = true;
      return into(motion.fullTurns, addressValue());
    }
    return std::nullopt;
  }

  // --------------------------------------------------------------------- control structures

  bool open(Structure kind, std::optional<std::size_t> branch, std::size_t begin, int slot = 0) {
    if (m_open.size() == kNestingMax) {
      return alarm(kSyntaxError, "Control structures are nested more than 16 deep.");
    }
    m_open.push_back({kind, branch, begin, slot, m_line});
    return true;
  }

  /// Closes the innermost structure, which must be of this kind.
  std::optional<Open> close(Structure kind, std::string_view word) {
    if (m_open.empty() || m_open.back().kind != kind) {
      alarm(kSyntaxError, fmt::format("Syntax error: {} without {}.", word, nameOf(kind)));
      return std::nullopt;
    }
    const Open open = m_open.back();
    m_open.pop_back();
    return open;
  }

  std::size_t here() const { return m_program.m_statements.size(); }

  std::optional<bool> structure(const std::string& word) {
    if (word == "IF") {
      return ifWord();
    }
    if (word == "ELSE") {
      const std::optional<Open> open = close(Structure::If, word);
      if (!open) {
        return false;
      }
      const std::size_t jump = emit(BranchStatement{});
      patch(*open->branch);
      return this->open(Structure::If, jump, 0);
    }
    if (word == "ENDIF") {
      const std::optional<Open> open = close(Structure::If, word);
      return open && (patch(*open->branch), true);
    }
    if (word == "WHILE") {
      std::optional<Expression> condition = expression();
      if (!condition) {
        return false;
      }
      const std::size_t begin = emit(BranchStatement{std::move(condition), 0});
      return open(Structure::While, begin, begin);
    }
    if (word == "LOOP") {
      return open(Structure::Loop, std::nullopt, here());
    }
    if (word == "FOR") {
      return forWord();
    }
    if (word == "ENDWHILE" || word == "ENDLOOP") {
      const std::optional<Open> open =
          close(word == "ENDWHILE" ? Structure::While : Structure::Loop, word);
      if (!open) {
        return false;
      }
      emit(BranchStatement{std::nullopt, open->begin});
      if (open->branch) {
        patch(*open->branch);
      }
      return true;
    }
    if (word == "ENDFOR") {
      const std::optional<Open> open = close(Structure::For, word);
      if (!open) {
        return false;
      }
      emit(LocalAssignStatement{open->slot, std::nullopt,
                                Expression::next(Expression::local(open->slot))});
      emit(BranchStatement{std::nullopt, open->begin});
      patch(*open->branch);
      return true;
    }
    if (word == "REPEAT") {
      return repeat();
    }
    if (word == "UNTIL") {
      const std::optional<Open> open = close(Structure::Repeat, word);
      std::optional<Expression> condition = open ? expression() : std::nullopt;
      return condition && (emit(BranchStatement{std::move(condition), open->begin}), true);
    }
    if (word == "CASE") {
      return caseWord();
    }
    return std::nullopt;
  }

  bool ifWord() {
    std::optional<Expression> condition = expression();
    if (!condition) {
      return false;
    }
    skipBlanks();
    const std::string word = name();
    if (const std::optional<JumpDirection> direction = jumpDirection(word)) {
      m_at += word.size();
      return jump(std::move(condition), *direction);
    }
    if (!atEnd()) {
      return alarm(kSyntaxError, "Syntax error: after IF comes a jump or the end of the block.");
    }
    const std::size_t branch = emit(BranchStatement{std::move(condition), 0});
    return open(Structure::If, branch, 0);
  }

  bool forWord() {
    const std::string variable = takeName();
    const auto found = m_program.m_variables.find(variable);
    if (found == m_program.m_variables.end() || !found->second.sizes.empty() ||
        found->second.isString) {
      return alarm(kUnknownName,
                   fmt::format("FOR needs a variable that is defined, not \"{}\".", variable));
    }
    const int slot = found->second.slot;
    std::optional<Expression> first = expect('=') ? expression() : std::nullopt;
    if (!first) {
      return false;
    }
    if (!takeWord("TO")) {
      return alarm(kSyntaxError, "Syntax error: FOR needs TO.");
    }
    const std::optional<Expression> last = expression();
    if (!last) {
      return false;
    }
    emit(LocalAssignStatement{slot, std::nullopt, std::move(*first)});
    const std::size_t begin =
        emit(BranchStatement{Expression::notAbove(Expression::local(slot), *last), 0});
    return open(Structure::For, begin, begin, slot);
  }

  /// REPEAT alone begins a loop; with a label it repeats what stands there.
  bool repeat() {
    const std::string label = takeName();
    if (label.empty()) {
      return open(Structure::Repeat, std::nullopt, here());
    }
    RepeatStatement repeat{label, std::nullopt};
    if (takeWord("P") || (!atEnd() && peek() == 'P' && (++m_at, true))) {
      repeat.times = addressValue();
      if (!repeat.times) {
        return false;
      }
    }
    emit(std::move(repeat));
    return true;
  }

  /// CASE(x) OF c GOTOF l ... DEFAULT GOTOF l: one conditional jump after another.
  bool caseWord() {
    std::optional<Expression> value = expression();
    if (!value || !takeWord("OF")) {
      return value ? alarm(kSyntaxError, "Syntax error: CASE needs OF.") : false;
    }
    while (!atEnd()) {
      std::optional<Expression> condition;
      if (!takeWord("DEFAULT")) {
        const std::optional<Expression> constant = expression();
        if (!constant) {
          return false;
        }
        condition = Expression::equals(*value, *constant);
      }
      const std::string word = takeName();
      const std::optional<JumpDirection> direction = jumpDirection(word);
      if (!direction) {
        return alarm(kSyntaxError, "Syntax error: CASE needs a jump behind each value.");
      }
      if (!jump(std::move(condition), *direction)) {
        return false;
      }
    }
    return true;
  }

  static std::optional<JumpDirection> jumpDirection(std::string_view word) {
    static constexpr std::array<std::pair<std::string_view, JumpDirection>, 5> kWords{
        {{"GOTO", JumpDirection::ForwardThenBackward},
         {"GOTOF", JumpDirection::Forward},
         {"GOTOB", JumpDirection::Backward},
         {"GOTOC", JumpDirection::ForwardNoAlarm},
         {"GOTOS", JumpDirection::Start}}};
    const auto found = std::find_if(kWords.begin(), kWords.end(),
                                    [word](const auto& entry) { return entry.first == word; });
    return found == kWords.end() ? std::nullopt : std::optional(found->second);
  }

  bool jump(std::optional<Expression> condition, JumpDirection direction) {
    std::string label;
    if (direction != JumpDirection::Start) {
      label = takeName();
      if (label.empty()) {
        return alarm(kSyntaxError, "Syntax error: the jump has no destination.");
      }
      if (isDigit(label[0])) {
        label = "N" + label;  // a block number
      }
    }
    emit(JumpStatement{std::move(condition), direction, label});
    return true;
  }

  // ---------------------------------------------------------------------------- subprograms

  bool call(std::string program, std::vector<Expression> arguments, bool isPlainName = false) {
    CallStatement statement{std::move(program), isPlainName, std::nullopt, std::move(arguments)};
    skipBlanks();
    if (peek() == 'P' && (isDigit(peek(1)) || peek(1) == '=')) {
      ++m_at;
      statement.times = addressValue();
      if (!statement.times) {
        return false;
      }
    }
    emit(std::move(statement));
    return true;
  }

  bool callWithArguments(const std::string& program) {
    std::vector<Expression> arguments;
    if (!expect('(')) {
      return false;
    }
    if (!take(')')) {
      do {
        std::optional<Expression> argument = expression();
        if (!argument) {
          return false;
        }
        arguments.push_back(std::move(*argument));
      } while (take(','));
      if (!expect(')')) {
        return false;
      }
    }
    return call(program, std::move(arguments), true);
  }

  /// PROC name(type name, ...): the parameters are variables like others.
  bool procedure() {
    takeName();
    if (take('(') && !take(')')) {
      do {
        const std::string type = takeName();
        const std::string parameter = takeName();
        if (type == "VAR" || type == "STRING" || parameter.empty() || !define(parameter, type)) {
          return alarm(kSyntaxError, "PROC takes parameters of type INT, REAL and BOOL here.");
        }
        m_program.m_parameters.push_back(m_program.m_variables.find(parameter)->second.slot);
      } while (take(','));
      if (!expect(')')) {
        return false;
      }
    }
    m_at = m_text.size();
    return true;
  }

  // ------------------------------------------------------------- frames, messages, actions

  bool frame(const std::string& word) {
    FrameStatement frame;
    frame.kind =
        word.ends_with("ROT") ? FrameStatement::Kind::Rotate : FrameStatement::Kind::Translate;
    frame.additive = word[0] == 'A';
    while (!atEnd()) {
      if (takeWord("RPL")) {
        if (!into(frame.inPlane, addressValue())) {
          return false;
        }
        continue;
      }
      const char axis = peek();
      ++m_at;
      if (axis >= 'X' && axis <= 'Z') {
        if (!into(frame.axes[static_cast<std::size_t>(axis - 'X')], addressValue())) {
          return false;
        }
      } else if (std::string_view("ABCUVW").find(axis) == std::string_view::npos ||
                 !addressValue()) {
        return alarm(kUnknownName, fmt::format("{} takes no word '{}'.", word, axis));
      }
    }
    emit(std::move(frame));
    return true;
  }

  bool message() {
    if (!expect('(')) {
      return false;
    }
    if (take(')')) {
      emit(MessageStatement{});
      return true;
    }
    std::optional<std::string> text = string();
    return text && expect(')') && (emit(MessageStatement{std::move(*text)}), true);
  }

  bool syncAction(std::string word) {
    m_inSyncAction = true;
    const bool done = readSyncAction(std::move(word));
    m_inSyncAction = false;
    return done;
  }

  bool readSyncAction(std::string word) {
    SyncAction action;
    if (word == "ID" || word == "IDS") {
      action.isStatic = word == "IDS";
      skipBlanks();
      const bool hasNumber = take('=');
      skipBlanks();
      const std::optional<int> id = hasNumber ? base::parseInteger(digits()) : std::nullopt;
      if (!id || *id < 1 || *id > 255) {
        return alarm(kSyntaxError, "A synchronized action needs a number from 1 to 255.");
      }
      action.id = *id;
      word = takeName();
    }
    static constexpr std::array<std::pair<std::string_view, SyncTrigger>, 4> kTriggers{
        {{"WHEN", SyncTrigger::When},
         {"WHENEVER", SyncTrigger::Whenever},
         {"FROM", SyncTrigger::From},
         {"EVERY", SyncTrigger::Every}}};
    for (const auto& [name, trigger] : kTriggers) {
      if (word == name) {
        action.trigger = trigger;
        action.condition = expression();
        if (!action.condition) {
          return false;
        }
        word = takeName();
        break;
      }
    }
    if (word != "DO") {
      return alarm(kSyntaxError, "Syntax error: a synchronized action needs DO.");
    }
    while (!atEnd()) {
      if (!syncAssignment(action)) {
        return false;
      }
    }
    if (action.assignments.empty()) {
      return alarm(kSyntaxError, "A synchronized action has nothing to do.");
    }
    emit(SyncStatement{std::move(action)});
    return true;
  }

  /// $R5=..., $AC_OVR=..., $AA_OFF[X]=...
  bool syncAssignment(SyncAction& action) {
    SyncAssignment assignment;
    const std::size_t equals = m_text.find('=', m_at);
    if (peek() != '$' || equals == std::string::npos) {
      return alarm(kSyntaxError,
                   "A synchronized action assigns to $R and variables of the main "
                   "run only.");
    }
    std::string target(base::trim(std::string_view(m_text).substr(m_at, equals - m_at)));
    std::string index;
    if (const std::size_t bracket = target.find('['); bracket != std::string::npos) {
      if (target.back() != ']') {
        return alarm(kSyntaxError, "Syntax error: ']' is missing.");
      }
      index = target.substr(bracket + 1, target.size() - bracket - 2);
      target = std::string(base::trim(target.substr(0, bracket)));
    } else if (target.size() > 2 && target.starts_with("$R") && isDigit(target[2])) {
      index = target.substr(2);
      target = "$R";
    }
    if (target != "$R") {
      assignment.variable = systemVariableOf(target);
      if (!assignment.variable) {
        return alarm(kUnknownName,
                     fmt::format("{} cannot be written by a synchronized action.", target));
      }
    }
    if (index.size() == 1 && std::string_view("XYZ").find(index[0]) != std::string_view::npos) {
      assignment.index = Expression::number(index[0] - 'X');
    } else if (index.empty()) {
      assignment.index = Expression::number(0.0);
    } else {
      std::string problem;
      std::optional<ParsedExpression> parsed =
          parseExpression(index, problem, &m_program.m_variables);
      if (!parsed) {
        return alarm(kSyntaxError, fmt::format("Syntax error: {}.", problem));
      }
      assignment.index = std::move(parsed->expression);
    }
    m_at = equals + 1;
    std::optional<Expression> value = expression();
    if (!value) {
      return false;
    }
    assignment.value = std::move(*value);
    action.assignments.push_back(std::move(assignment));
    return true;
  }

  NcProgram& m_program;
  base::LineNumber m_line;
  std::string m_text;
  std::size_t m_at = 0;
  bool m_firstOfBlock = true;
  bool m_readsMainRun = false;
  bool m_inSyncAction = false;
  bool m_dwell = false;
  bool m_ends = false;
  bool m_returns = false;
  std::vector<Open> m_open;
};

NcProgram NcProgram::compile(std::string_view text) {
  NcProgram program;
  NcCompiler compiler(program);
  base::LineNumber number;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find('\n');
    compiler.line(text.substr(0, end), number);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  compiler.finish();
  return program;
}

int NcProgram::elementsOf(int slot) const {
  for (const auto& [name, variable] : m_variables) {
    if (variable.slot == slot) {
      int elements = 1;
      for (const int size : variable.sizes) {
        elements *= size;
      }
      return elements;
    }
  }
  return 0;
}

bool NcProgram::isInteger(int slot) const {
  return std::any_of(m_variables.begin(), m_variables.end(), [slot](const auto& entry) {
    return entry.second.slot == slot && entry.second.isInteger;
  });
}

std::optional<std::size_t> NcProgram::findLabel(const std::string& name, JumpDirection direction,
                                                std::size_t from) const {
  if (direction == JumpDirection::Start) {
    return 0;
  }
  // Labels are stored in program order; a label at `from` itself lies behind the jump.
  const auto after = std::find_if(m_labels.begin(), m_labels.end(), [&](const Label& label) {
    return label.statement > from && label.name == name;
  });
  const auto before = std::find_if(m_labels.rbegin(), m_labels.rend(), [&](const Label& label) {
    return label.statement <= from && label.name == name;
  });
  if (direction != JumpDirection::Backward && after != m_labels.end()) {
    return after->statement;
  }
  if (direction != JumpDirection::Forward && before != m_labels.rend()) {
    return before->statement;
  }
  return std::nullopt;
}

}  // namespace rivulet::machine
