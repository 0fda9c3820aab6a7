// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/nc_program.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace rivulet::machine {

namespace {

constexpr int kSyntaxError = 12080;
constexpr int kUnknownG = 12470;
constexpr int kUnknownName = 12550;

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Words that change nothing the virtual machine models.
bool isIgnoredWord(std::string_view word) {
  static constexpr std::array<std::string_view, 20> kWords{
      "SOFT",     "BRISK",      "DRIVE",     "FFWON",  "FFWOF",  "DYNNORM", "DYNPOS",
      "DYNROUGH", "DYNSEMIFIN", "DYNFINISH", "COMPOF", "ORIWKS", "ORIAXES", "STARTFIFO",
      "STOPFIFO", "CFC",        "CFTCP",     "CFIN",   "NORM",   "FNORM"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

/// G functions without effect on what the virtual machine models.
bool isIgnoredG(int number) {
  static constexpr std::array<int, 22> kNumbers{17,  18,  19,  40,  53,  54,  55,  56,
                                                57,  71,  94,  153, 450, 451, 500, 601,
                                                602, 603, 641, 642, 645, 710};
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
    m_text = upperOutsideStrings(raw);
    m_at = 0;
    skipBlanks();
    if (peek() == '%') {
      return;  // archive header of a transferred file
    }
    if (peek() == '/') {
      ++m_at;  // block skip is not active
      while (isDigit(peek())) {
        ++m_at;
      }
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
  }

  void finish() {
    for (const Open& open : m_open) {
      m_line = open.line;
      m_firstOfBlock = true;
      alarm(kSyntaxError, fmt::format("The {} of line {} is not closed.",
                                      open.isWhile ? "WHILE" : "IF", open.line.value));
      patch(open.branch);
    }
  }

 private:
  struct Open {
    bool isWhile = false;
    std::size_t branch = 0;
    base::LineNumber line;
  };

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

  [[nodiscard]] std::string name() const {
    std::size_t end = m_at;
    while (end < m_text.size() && (isLetter(m_text[end]) || isDigit(m_text[end]))) {
      ++end;
    }
    return m_text.substr(m_at, end - m_at);
  }

  /// Block number and label in front of a block.
  void prefix() {
    skipBlanks();
    if ((peek() == 'N' || peek() == ':') && isDigit(peek(1))) {
      std::size_t end = m_at + 1;
      while (end < m_text.size() && isDigit(m_text[end])) {
        ++end;
      }
      m_program.m_labels.push_back(
          {"N" + m_text.substr(m_at + 1, end - m_at - 1), m_program.m_statements.size()});
      m_at = end;
      skipBlanks();
    }
    const std::string label = name();
    if (label.size() >= 2 && isLetter(label[0]) && isLetter(label[1]) &&
        peek(label.size()) == ':') {
      m_program.m_labels.push_back({label, m_program.m_statements.size()});
      m_at += label.size() + 1;
    }
  }

  template <class What>
  std::size_t emit(What what) {
    m_program.m_statements.push_back({m_line, std::move(what), m_firstOfBlock});
    m_firstOfBlock = false;
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
        parseExpression(std::string_view(m_text).substr(m_at), problem);
    if (!parsed) {
      alarm(kSyntaxError, fmt::format("Syntax error: {}.", problem));
      return std::nullopt;
    }
    m_at += parsed->length;
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

  /// @return false if the rest of the line is not to be read
  bool word(MotionStatement& motion, bool& hasMotion) {
    const std::string word = name();
    if (word.empty()) {
      return alarm(kSyntaxError, fmt::format("Syntax error at '{}'.", peek()));
    }
    if (word[0] == 'R' && (word == "R" || isDigit(word[1]))) {
      return assignment();
    }
    if (word.size() >= 2 && isLetter(word[1])) {
      return keyword(word);
    }
    ++m_at;
    switch (word[0]) {
      case 'X':
      case 'Y':
      case 'Z': {
        std::optional<Expression> value = addressValue();
        if (!value) {
          return false;
        }
        motion.axes[static_cast<std::size_t>(word[0] - 'X')] = std::move(value);
        hasMotion = true;
        return true;
      }
      case 'F': {
        std::optional<Expression> value = addressValue();
        if (!value) {
          return false;
        }
        if (m_dwell) {
          m_dwell = false;
          emit(DwellStatement{std::move(*value)});
        } else {
          motion.feedMmPerMin = std::move(value);
          hasMotion = true;
        }
        return true;
      }
      case 'G':
        return gFunction(motion, hasMotion);
      case 'M':
        return mFunction();
      case 'S':
      case 'T':
      case 'D':
      case 'H':
        return addressValue().has_value();
      default:
        return alarm(kUnknownName, fmt::format("The name \"{}\" is not defined.", word));
    }
  }

  std::optional<int> plainNumber() {
    std::size_t end = m_at;
    while (end < m_text.size() && isDigit(m_text[end])) {
      ++end;
    }
    const std::optional<int> value =
        base::parseInteger(std::string_view(m_text).substr(m_at, end - m_at));
    m_at = end;
    return value;
  }

  bool gFunction(MotionStatement& motion, bool& hasMotion) {
    const std::optional<int> number = plainNumber();
    if (!number) {
      return alarm(kSyntaxError, "Syntax error: G needs a number.");
    }
    hasMotion = true;
    switch (*number) {
      case 0:
        motion.rapid = true;
        return true;
      case 1:
        motion.rapid = false;
        return true;
      case 4:
        m_dwell = true;
        hasMotion = false;
        return true;
      case 9:
        motion.exactStopOnce = true;
        return true;
      case 60:
        motion.exactStop = true;
        return true;
      case 64:
        motion.exactStop = false;
        return true;
      case 90:
        motion.absolute = true;
        return true;
      case 91:
        motion.absolute = false;
        return true;
      default:
        return isIgnoredG(*number) ||
               alarm(kUnknownG, fmt::format("G{} is not known to this machine.", *number));
    }
  }

  bool mFunction() {
    const std::optional<int> number = plainNumber();
    if (!number) {
      return alarm(kSyntaxError, "Syntax error: M needs a number.");
    }
    if (*number == 2 || *number == 17 || *number == 30) {
      emit(EndStatement{});
      return false;
    }
    return true;  // spindle, coolant and the like move no axis
  }

  bool assignment() {
    ++m_at;
    Expression index;
    if (isDigit(peek())) {
      std::string problem;
      std::size_t end = m_at;
      while (end < m_text.size() && isDigit(m_text[end])) {
        ++end;
      }
      index =
          parseExpression(std::string_view(m_text).substr(m_at, end - m_at), problem)->expression;
      m_at = end;
    } else {
      skipBlanks();
      if (peek() != '[') {
        return alarm(kSyntaxError, "Syntax error: R needs a number or an index in brackets.");
      }
      ++m_at;
      std::optional<Expression> inner = expression();
      skipBlanks();
      if (!inner || peek() != ']') {
        return inner ? alarm(kSyntaxError, "Syntax error: ']' is missing.") : false;
      }
      ++m_at;
      index = std::move(*inner);
    }
    skipBlanks();
    if (peek() != '=') {
      return alarm(kSyntaxError, "Syntax error: an R-parameter needs '='.");
    }
    ++m_at;
    std::optional<Expression> value = expression();
    if (!value) {
      return false;
    }
    emit(AssignStatement{std::move(index), std::move(*value)});
    return true;
  }

  bool keyword(const std::string& word) {
    m_at += word.size();
    if (word == "STOPRE") {
      emit(StopreStatement{});
      return true;
    }
    if (word == "MSG") {
      return message();
    }
    if (word == "IF") {
      return ifWord();
    }
    if (word == "ELSE") {
      if (m_open.empty() || m_open.back().isWhile) {
        return alarm(kSyntaxError, "Syntax error: ELSE without IF.");
      }
      const std::size_t jump = emit(BranchStatement{});
      patch(m_open.back().branch);
      m_open.back().branch = jump;
      return true;
    }
    if (word == "ENDIF") {
      if (m_open.empty() || m_open.back().isWhile) {
        return alarm(kSyntaxError, "Syntax error: ENDIF without IF.");
      }
      patch(m_open.back().branch);
      m_open.pop_back();
      return true;
    }
    if (word == "WHILE") {
      std::optional<Expression> condition = expression();
      if (!condition) {
        return false;
      }
      m_open.push_back({true, emit(BranchStatement{std::move(condition), 0}), m_line});
      return true;
    }
    if (word == "ENDWHILE") {
      if (m_open.empty() || !m_open.back().isWhile) {
        return alarm(kSyntaxError, "Syntax error: ENDWHILE without WHILE.");
      }
      emit(BranchStatement{std::nullopt, m_open.back().branch});
      patch(m_open.back().branch);
      m_open.pop_back();
      return true;
    }
    if (const std::optional<JumpDirection> direction = jumpDirection(word)) {
      return jump(std::nullopt, *direction);
    }
    if (isIgnoredWord(word)) {
      return true;
    }
    return alarm(kUnknownName,
                 fmt::format("The name \"{}\" is not defined or the option is missing.", word));
  }

  static std::optional<JumpDirection> jumpDirection(std::string_view word) {
    if (word == "GOTO") {
      return JumpDirection::ForwardThenBackward;
    }
    if (word == "GOTOF") {
      return JumpDirection::Forward;
    }
    if (word == "GOTOB") {
      return JumpDirection::Backward;
    }
    if (word == "GOTOC") {
      return JumpDirection::ForwardNoAlarm;
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
    m_open.push_back({false, emit(BranchStatement{std::move(condition), 0}), m_line});
    return true;
  }

  bool jump(std::optional<Expression> condition, JumpDirection direction) {
    skipBlanks();
    const std::string label = name();
    if (label.empty()) {
      return alarm(kSyntaxError, "Syntax error: the jump has no destination.");
    }
    m_at += label.size();
    emit(JumpStatement{std::move(condition), direction, label});
    return true;
  }

  bool message() {
    skipBlanks();
    const std::size_t open = m_text.find('(', m_at);
    const std::size_t close = m_text.rfind(')');
    if (open != m_at || close == std::string::npos || close < open) {
      return alarm(kSyntaxError, "Syntax error: MSG needs its text in parentheses.");
    }
    std::string_view text = base::trim(std::string_view(m_text).substr(open + 1, close - open - 1));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
      text = text.substr(1, text.size() - 2);
    } else if (!text.empty()) {
      return alarm(kSyntaxError, "Syntax error: MSG needs its text in quotes.");
    }
    m_at = close + 1;
    emit(MessageStatement{std::string(text)});
    return true;
  }

  NcProgram& m_program;
  base::LineNumber m_line;
  std::string m_text;
  std::size_t m_at = 0;
  bool m_firstOfBlock = true;
  bool m_dwell = false;
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

std::optional<std::size_t> NcProgram::findLabel(const std::string& name, JumpDirection direction,
                                                std::size_t from) const {
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
