// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "second_evaluator.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <utility>

#include "base/text.h"

namespace rivulet::tests {

using base::isDigit;
using base::Vec3;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr std::size_t kStepsMax = 400'000;
constexpr std::string_view kAxes = "XYZ";
constexpr std::string_view kAcross = "987";  ///< G19, G18, G17: the axis across the plane

/// A word that is not followed.
struct Stop {
  std::string word;
};
void check(bool follows, const std::string& word) {
  if (!follows) {
    throw Stop{word};
  }
}

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}
std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> words(1);
  for (const char c : list) {
    c == ' ' ? static_cast<void>(words.emplace_back()) : words.back().push_back(c);
  }
  return words;
}
/// "G1" in "G0 G1 G2".
bool isIn(const std::string& word, std::string_view list) {
  const std::vector<std::string> words = split(list);
  return !word.empty() && std::count(words.begin(), words.end(), word) > 0;
}
std::string trimmed(std::string_view text) {
  return std::string(base::trim(text));
}

struct Value {
  double number = 0.0;
  bool vacant = false;
};
using Values = std::map<std::string, Value>;

int whole(const Value& value) {
  return static_cast<int>(std::lround(value.number));
}

struct Word {
  std::string name;
  Value value;
  char reference = 0;  ///< A, I, D, P, N: AC IC DC ACP ACN; I of Heidenhain's IX
};
using Words = std::vector<Word>;

const Word* find(const Words& words, std::string_view name) {
  const auto found = std::find_if(words.rbegin(), words.rend(),
                                  [name](const Word& each) { return each.name == name; });
  return found == words.rend() ? nullptr : &*found;
}
std::optional<double> valueOf(const Words& words, std::string_view name) {
  const Word* const word = find(words, name);
  return word == nullptr ? std::nullopt : std::optional(word->value.number);
}
std::size_t axisOf(const Word& word, std::string_view axes = kAxes) {
  return word.name.size() == 1 ? axes.find(word.name[0]) : std::string_view::npos;
}
std::string_view axisName(std::size_t axis) {
  return kAxes.substr(axis, 1);
}

/// Of one program: the last one has the structure "%".
struct Line {
  std::size_t number = 0;
  std::string label;  ///< "N10", "START", "3" of LBL 3
  std::string text;
  std::string structure;   ///< IF, ELSE, ENDWHILE …
  std::size_t behind = 0;  ///< that word
  std::size_t next = 0;    ///< where the structure goes on: ELSE, ENDIF, ENDWHILE
  std::size_t back = 0;    ///< where it began
};

/// Programmed coordinates to those of the workpiece.
struct Frame {
  std::array<Vec3, 3> columns{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 origin;

  [[nodiscard]] Vec3 linear(Vec3 v) const {
    return v.x * columns[0] + v.y * columns[1] + v.z * columns[2];
  }
  [[nodiscard]] Vec3 to(Vec3 p) const { return linear(p) + origin; }
  [[nodiscard]] Vec3 from(Vec3 p) const {
    const auto along = [v = p - origin](Vec3 c) { return base::dot(v, c) / base::dot(c, c); };
    return {along(columns[0]), along(columns[1]), along(columns[2])};
  }
  /// One scale for all axes: a circle stays one.
  [[nodiscard]] bool isEven() const {
    const double size = base::norm(columns[0]);
    return std::abs(base::norm(columns[1]) - size) + std::abs(base::norm(columns[2]) - size) < 1e-9;
  }
  void shift(Vec3 by) { origin = to(by); }
  void scale(std::size_t axis, double factor) { columns[axis] = factor * columns[axis]; }
  void turn(std::size_t axis, double degrees) {
    check(isEven(), "a turn after a scale");
    Vec3& first = columns[(axis + 1) % 3];
    Vec3& second = columns[(axis + 2) % 3];
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    const Vec3 turned = c * first + s * second;
    second = c * second - s * first;
    first = turned;
  }
};

/// What PROC SAVE and M70 keep.
struct Modal {
  double unit = 1.0;
  double feedUnit = 1.0;
  bool relative = false;
  bool centreAbsolute = false;
  bool diameter = false;
  bool polar = false;  ///< G16
  std::size_t across = 2;
  char feedMode = '4';  ///< of G94 per minute, G93 inverse time, G95 per revolution
  double feed = 0.0;
  double speed = 0.0;
  Frame frame;
};

/// A program that runs: what it has of its own, and where it goes on.
struct Level {
  std::size_t at = 0;  ///< the next line
  Values variables;
  bool saves = false;
  bool shares = false;                     ///< M98: the variables are those of the caller
  std::map<std::size_t, double> counters;  ///< of loops, by their line
};

class Evaluator {
 public:
  using Beside = std::function<std::optional<std::string>(std::string_view)>;

  /// @param letter  of the name of the control; that of Fanuc for Haas
  Evaluator(char letter, const Beside& beside) : m_letter(letter), m_beside(beside) {}

  Evaluation run(std::string_view text) {
    Evaluation result;
    try {
      readTexts(text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0));
      m_levels.emplace_back();
      for (std::size_t steps = 0; !m_ended; ++steps) {
        check(steps < kStepsMax, "a loop without an end");
        const Line line = m_lines[level().at++];
        m_line = line.number;
        begin(line.text, line.behind);
        if (line.structure == "%") {
          leave();
        } else if (!line.text.empty() && !structured(line) && !steers(line)) {
          m_isPlain ? plainBlock(line.text) : execute(wordsOf(line.text));
        }
      }
    } catch (const Stop& stopped) {
      result.cannotFollow = stopped.word;
    }
    result.moves = std::move(m_moves);
    return result;
  }

 private:
  // --- text -------------------------------------------------------------------------------------

  /// Capital, without comments; without blanks where they mean nothing.
  [[nodiscard]] std::string cleaned(std::string_view line) const {
    std::string made;
    bool quoted = false;
    bool comment = false;
    for (const char c : line) {
      quoted = c == '"' && !comment ? !quoted : quoted;
      if (!quoted && !comment && c == ';') {
        break;
      }
      comment = m_hasBrackets && (comment ? c != ')' : c == '(');
      if (!comment && !(m_hasBrackets && (c == ' ' || c == '\t' || c == ')'))) {
        made += m_isPlain && c == ',' ? '.' : base::toUpper(c);
      }
    }
    return trimmed(made);
  }

  /// The programs in one file, behind those that have been read.
  void readTexts(std::string_view text) {
    std::string line;
    std::size_t number = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool ends = text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n");
      // ";" ends a block of Fanuc, and begins a comment of others.
      if (ends || (text[i] == ';' && m_isFanuc)) {
        addLine(cleaned(std::exchange(line, "")), number);
        number += ends ? 1 : 0;
      } else if (text[i] != '\r') {
        line += text[i];
      }
    }
    addLine(cleaned(line), number);
    m_lines.emplace_back().structure = "%";
  }

  /// Of the lines before a heading and a second "%".
  void endProgram() {
    if (!m_lines.empty() && m_lines.back().structure != "%") {
      m_lines.emplace_back().structure = "%";
    }
  }

  void addLine(std::string block, std::size_t number) {
    const bool isNumbered = m_isFanuc && block.size() > 1 && block[0] == 'O' && isDigit(block[1]);
    if (isNumbered || (m_isSinumerik && block.starts_with("%_N_"))) {
      endProgram();
      m_programs[isNumbered ? std::to_string(std::atoi(&block[1]))
                            : block.substr(4, block.rfind('_') - 4)] = m_lines.size();
      return;
    }
    block.erase(0, block.starts_with('/') ? 1 : 0);
    if (block.empty() || block[0] == '%') {
      if (!block.empty() && (m_isLinux || m_letter == 'G')) {
        endProgram();
      }
      return;
    }
    Line line;
    line.number = number;
    line.text = block;
    if (m_isPlain || (block[0] == 'N' && block.size() > 1 && isDigit(block[1]))) {
      line.label = m_isPlain ? "" : "N" + std::to_string(std::atoi(&block[1]));
      line.text = trimmed(block.substr(digitsEnd(block, m_isPlain ? 0 : 1)));
    }
    const std::size_t colon = line.text.find(':');
    if (m_isSinumerik && colon < line.text.find_first_of(" =(\"")) {
      line.label = line.text.substr(0, colon);
      line.text = trimmed(line.text.substr(colon + 1));
    } else if (m_isPlain && line.text.starts_with("LBL")) {
      line.label = trimmed(line.text.substr(3));
    }
    findStructure(line);
    m_lines.push_back(line);
  }

  static std::size_t digitsEnd(const std::string& text, std::size_t from) {
    return std::min(text.find_first_not_of("0123456789", from), text.size());
  }
  /// Of O100 and O<NAME>.
  [[nodiscard]] std::size_t keyEnd(const std::string& line) const {
    const bool isName = line.compare(0, 2, "O<") == 0;
    return !m_isLinux || line[0] != 'O' ? 0 : isName ? line.find('>') + 1 : digitsEnd(line, 1);
  }

  /// Which lines decide and repeat, and which belong together.
  void findStructure(Line& line) {
    const std::size_t key = keyEnd(line.text);
    std::size_t to = key;
    while (isLetter(line.text[to])) {
      ++to;
    }
    const std::string word = line.text.substr(key, to - key);
    const bool jumps = line.text.find("GOTO") != std::string::npos ||
                       line.text.find("THEN") != std::string::npos ||
                       (m_isSinumerik && word == "REPEAT" && to < line.text.size());
    const bool begins =
        isIn(word, m_isLinux ? "IF WHILE REPEAT DO SUB" : "IF WHILE FOR LOOP REPEAT DO");
    const bool goesOn = isIn(word, "ELSE ELSEIF");
    bool ends = isIn(word, "END ENDIF ENDFOR ENDWHILE ENDLOOP UNTIL ENDREPEAT ENDSUB");
    if (jumps || m_isPlain || (m_isLinux && key == 0) || !(begins || goesOn || ends)) {
      return;
    }
    line.behind = to;
    line.structure = word;
    ends |=
        m_isLinux && word == "WHILE" && !m_open.empty() && m_lines[m_open.back()].structure == "DO";
    if (goesOn || ends) {
      check(!m_open.empty(), line.text);
      m_lines[m_open.back()].next = m_lines.size();
      line.back = m_open.back();
      m_open.pop_back();
    }
    if (!ends) {
      m_open.push_back(m_lines.size());
    }
    if (word == "SUB") {
      check(m_open.size() == 1, "a subprogram inside another");
      m_programs[line.text.substr(0, key)] = m_lines.size() + 1;
    }
  }

  /// Where the program begins.
  std::optional<std::size_t> findProgram(const std::string& name) {
    if (m_programs.count(name) == 0) {
      const std::optional<std::string> text = m_beside ? m_beside(name) : std::nullopt;
      if (!text) {
        return std::nullopt;
      }
      m_programs[name] = m_lines.size();
      readTexts(*text);
    }
    return m_programs[name];
  }

  // --- expressions, of m_rest from m_i on --------------------------------------------------------

  void begin(const std::string& text, std::size_t from = 0) {
    m_rest = text;
    m_i = from;
  }
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return m_i + ahead < m_rest.size() ? m_rest[m_i + ahead] : '\0';
  }
  bool blanks() {
    while (peek() == ' ' || peek() == '\t') {
      ++m_i;
    }
    return m_i < m_rest.size();
  }
  bool accept(std::string_view what) {
    blanks();
    const char next = peek(what.size());
    const bool goesOn = isLetter(what.back()) && (isLetter(next) || isDigit(next));
    const bool accepts = m_rest.compare(m_i, what.size(), what) == 0 && !(goesOn && m_isSinumerik);
    m_i += accepts ? what.size() : 0;
    return accepts;
  }
  void expect(std::string_view what) {
    check(accept(what), "'" + std::string(what) + "' missing in " + m_rest);
  }
  /// @param digits  it may have digits behind its first letter
  std::string identifier(bool digits = true) {
    blanks();
    std::string name;
    while (isLetter(peek()) || (digits && !name.empty() && isDigit(peek()))) {
      name += m_rest[m_i++];
    }
    return name;
  }
  std::string restOfLine() { return trimmed(m_rest.substr(m_i)); }

  double number() {
    accept("+");
    double value = 0.0;
    const char* const from = m_rest.data() + std::min(m_i, m_rest.size());
    const auto [end, error] =
        std::from_chars(from, m_rest.data() + m_rest.size(), value, std::chars_format::fixed);
    check(error == std::errc() && isDigit(end[-1] == '.' ? end[-2] : end[-1]),
          "number in " + m_rest);
    m_i += static_cast<std::size_t>(end - from);
    const bool scales = m_isSinumerik && peek() == 'E' && peek(1) == 'X';
    m_i += scales ? 2 : 0;
    return value * (scales ? std::pow(10.0, number()) : 1.0);
  }

  Value& variable(const std::string& name) {
    Values& own = level().variables;
    if (own.count(name) > 0) {
      return own[name];
    }
    if (name[0] != '#') {  // what DEF of another program defines is not seen
      check(m_isPlain || (name[0] == 'R' && name.size() > 1 && isDigit(name[1])), name);
      return m_globals[name];
    }
    if (name[1] == '<') {
      return (name[2] == '_' ? m_globals : own)[name];
    }
    const int index = std::atoi(&name[1]);
    check(index < (m_isFanuc ? 1000 : 5001), name);  // those of the control
    if (m_isFanuc && index == 0) {
      return m_vacant = {0.0, true};
    }
    Values& where = index <= (m_isFanuc ? 33 : 30) ? own : m_globals;
    return where.try_emplace(name, Value{0.0, m_isFanuc}).first->second;
  }

  /// #5, #[#1+2], #<name>; behind "#".
  std::string hashName() {
    if (!accept("<")) {
      return "#" + std::to_string(whole(primary()));
    }
    const std::size_t from = std::exchange(m_i, m_rest.find('>', m_i) + 1);
    return "#<" + m_rest.substr(from, m_i - from);
  }

  Value function(const std::string& name) {
    struct Function {
      double (*of)(double);
      double in = 1.0;  ///< what its argument is multiplied with, and its result
      double out = 1.0;
    };
    static const std::map<std::string, Function> kFunctions{
        {"SIN", {std::sin, kDegree}}, {"COS", {std::cos, kDegree}},
        {"TAN", {std::tan, kDegree}}, {"ASIN", {std::asin, 1.0, 1.0 / kDegree}},
        {"SQRT", {std::sqrt}},        {"ACOS", {std::acos, 1.0, 1.0 / kDegree}},
        {"ABS", {std::abs}},          {"EXP", {std::exp}},
        {"LN", {std::log}},           {"TRUNC", {std::trunc}},
        {"ROUNDUP", {std::ceil}},     {"POT", {[](double x) { return x * x; }}}};
    std::vector<double> a;
    if (m_isPlain) {
      a.push_back(primary().number);
    } else {
      expect(m_isSinumerik ? "(" : "[");
      do {
        a.push_back(expression().number);
      } while (accept(","));
      expect(m_isSinumerik ? ")" : "]");
    }
    if (const auto found = kFunctions.find(name); found != kFunctions.end()) {
      return {found->second.of(a[0] * found->second.in) * found->second.out};
    }
    if (name == "ROUND") {  // in a word of Fanuc to the least input increment
      return {std::round(a[0] / m_step) * m_step};
    }
    if (name == "FIX" || name == "FUP") {  // towards and from zero, LinuxCNC down and up
      const bool down = (name == "FIX") == (m_isLinux || a[0] >= 0.0);
      return {down ? std::floor(a[0]) : std::ceil(a[0])};
    }
    if (name == "ATAN" && !m_isSinumerik && accept("/")) {
      const double angle = std::atan2(a[0], primary().number) / kDegree;
      return {m_isFanuc && angle < 0.0 ? angle + 360.0 : angle};
    }
    check(m_isSinumerik && a.size() == 2 && name == "ATAN2", name);
    return {std::atan2(a[0], a[1]) / kDegree};
  }

  Value primary() {
    if (accept("-")) {
      const Value value = primary();
      return {-value.number, value.vacant};
    }
    accept("+");
    blanks();
    if (isDigit(peek()) || peek() == '.') {
      return {number()};
    }
    if (accept(m_hasBrackets ? "[" : "(")) {
      const Value value = expression();
      expect(m_hasBrackets ? "]" : ")");
      return value;
    }
    if (accept("#")) {
      return variable(hashName());
    }
    std::string name = identifier(!m_hasBrackets);
    check(!name.empty(), "value in " + m_rest);
    if (m_isSinumerik && isIn(name, "NOT TRUE FALSE")) {
      return {name == "TRUE" || (name == "NOT" && primary().number == 0.0) ? 1.0 : 0.0};
    }
    if (name == "R" && accept("[")) {
      name += std::to_string(whole(expression()));
      expect("]");
    }
    check(peek() != '[' || m_hasBrackets, name + "[]");
    blanks();
    const bool isVariable = m_isSinumerik ? peek() != '(' : m_isPlain && isDigit(name.back());
    return isVariable ? variable(name) : function(name);
  }

  [[nodiscard]] Value operate(const std::string& op, Value a, Value b) const {
    const double x = a.number;
    const double y = b.number;
    // SINUMERIK compares with a relative tolerance, LinuxCNC with 1e-6.
    const double near = m_isFanuc       ? 0.0
                        : m_isSinumerik ? 1e-12 * std::max(std::abs(x), std::abs(y))
                                        : 1e-6;
    const bool tie = std::abs(x - y) <= near;
    const bool same = m_isFanuc && (a.vacant || b.vacant) ? a.vacant == b.vacant : tie;
    const bool more = x > y && !tie;
    const bool less = x < y && !tie;
    const bool bits = m_isFanuc || op.starts_with("B_");
    const auto p = static_cast<unsigned>(bits ? std::lround(x) : x != 0.0);
    const auto q = static_cast<unsigned>(bits ? std::lround(y) : y != 0.0);
    const double rest = std::fmod(x, y);
    const double positive = m_isLinux && rest < 0.0 ? rest + std::abs(y) : rest;
    const double whole = m_isPlain ? x / y : std::trunc(x / y);
    check(op != "/" || y != 0.0, "division by zero");
    const std::map<std::string_view, double> results{
        {"+", x + y},           {"-", x - y},          {"*", x * y},        {"/", x / y},
        {"**", std::pow(x, y)}, {"^", std::pow(x, y)}, {"DIV", whole},      {"MOD", positive},
        {"AND", p & q},         {"OR", p | q},         {"XOR", p ^ q},      {"EQ", same},
        {"EQU", same},          {"==", same},          {"NE", !same},       {"<>", !same},
        {"GT", more},           {">", more},           {"LT", less},        {"<", less},
        {"GE", more || tie},    {">=", more || tie},   {"LE", less || tie}, {"<=", less || tie}};
    return {results.at(op.starts_with("B_") ? op.substr(2) : op)};
  }

  /// Operators by their rank, those that bind least first; equal ranks from left to right.
  Value expression(std::size_t rank = 0) {
    using Ranks = std::vector<std::string_view>;
    static const Ranks kSinumerik{"== <> >= <= > <", "OR",    "XOR", "AND",        "B_OR",
                                  "B_XOR",           "B_AND", "+ -", "* / DIV MOD"};
    static const Ranks kFanuc{"EQ NE GT GE LT LE", "+ - OR XOR", "* / AND MOD"};
    static const Ranks kLinux{"AND OR XOR", "EQ NE GT GE LT LE", "+ -", "* / MOD", "**"};
    static const Ranks kPlain{"EQU NE GT LT", "+ -", "* / DIV", "^"};
    const Ranks& ranks = m_isSinumerik ? kSinumerik
                         : m_isFanuc   ? kFanuc
                         : m_isPlain   ? kPlain
                                       : kLinux;
    if (rank == ranks.size()) {
      return primary();
    }
    Value value = expression(rank + 1);
    const std::vector<std::string> operators = split(ranks[rank]);
    for (;;) {
      const auto op =
          std::find_if(operators.begin(), operators.end(), [this](const std::string& each) {
            return !(each == "*" && m_rest.compare(m_i, 2, "**") == 0) && accept(each);
          });
      if (op == operators.end()) {
        return value;
      }
      value = operate(*op, value, expression(rank + 1));
    }
  }

  // --- flow --------------------------------------------------------------------------------------

  Level& level() { return m_levels.back(); }

  /// @param direction  1: only forward, -1: only back, 0: forward, then back
  void jump(const std::string& label, int direction = 0) {
    std::size_t& at = level().at;
    const auto isEnd = [this](std::size_t line) { return m_lines[line].structure == "%"; };
    const auto is = [&, this](std::size_t line) { return m_lines[line].label == label; };
    std::size_t ahead = at;
    while (!isEnd(ahead) && !is(ahead)) {
      ++ahead;
    }
    std::size_t back = at;  // the line before it
    while (back > 0 && !isEnd(back - 1) && !is(back - 1)) {
      --back;
    }
    const bool isAhead = direction >= 0 && !isEnd(ahead);
    check(isAhead || (direction <= 0 && back > 0 && !isEnd(back - 1)), "no label " + label);
    at = isAhead ? ahead : back - 1;
  }

  void call(std::size_t at, const Values variables, int times, bool saves = false,
            bool shares = false) {
    check(m_levels.size() < 1000, "calls too deep");
    for (; times > 0; --times) {
      m_levels.push_back({at, variables, saves, shares, {}});
    }
    if (saves) {
      m_saved.push_back(m_modal);
    }
  }

  void leave() {
    m_ended = m_levels.size() == 1;
    if (m_ended) {
      return;
    }
    const Level left = std::move(level());
    m_levels.pop_back();
    level().variables = left.shares ? left.variables : level().variables;
    if (left.saves) {
      restore();
    }
  }

  void restore() {
    check(!m_saved.empty(), "nothing saved");
    const Modal now = std::exchange(m_modal, m_saved.back());
    const Frame frame = std::exchange(m_modal.frame, now.frame);
    // rs274 writes what has changed into a block: F with one decimal, S with none.
    const auto written = [this](double value, double before, double digits) {
      return m_isLinux && value != before ? std::nearbyint(value * digits) / digits : value;
    };
    m_modal.feed = written(m_modal.feed / m_modal.feedUnit, now.feed / m_modal.feedUnit, 10.0) *
                   m_modal.feedUnit;
    m_modal.speed = written(m_modal.speed, now.speed, 1.0);
    setFrame(m_isSinumerik ? frame : now.frame);
    m_saved.pop_back();
  }

  bool condition() { return (m_hasBrackets ? primary() : expression()).number != 0.0; }

  /// @return true if the line belongs to a structure
  bool structured(const Line& line) {
    const std::string& word = line.structure;
    const bool arrives = std::exchange(m_arrives, false);  // from an IF that does not hold
    const bool endsDo = word == "WHILE" && line.next == 0;
    std::size_t& at = level().at;
    bool enters = word != "SUB";
    if (word.starts_with("ELSE")) {
      enters = arrives && (word == "ELSE" || condition());
    } else if (isIn(word, "IF WHILE UNTIL")) {
      enters = condition();
    } else if (word == "FOR") {
      const std::string name = identifier();
      const double from = (expect("="), expression().number);
      Value& counter = variable(name);
      counter.number = level().counters.erase(at - 1) != 0 ? counter.number + 1.0 : from;
      expect("TO");
      enters = counter.number <= expression().number;
    } else if (word == "REPEAT" && m_isLinux) {
      enters = isAgain(whole(primary()));
    } else if (word == "ENDSUB") {
      returnLinux();
      return true;
    } else if (word.starts_with("END") && word != "ENDIF") {
      at = line.back;
      if (word == "ENDFOR") {
        level().counters[line.back] = 1.0;
      }
    }
    if (endsDo || word == "UNTIL") {
      at = enters == endsDo ? line.back + 1 : at;
    } else if (!enters) {
      const bool goesOn = m_lines[line.next].structure.starts_with("ELSE");
      m_arrives = goesOn && (word == "IF" || arrives);
      at = line.next + (goesOn ? 0 : 1);
    }
    return !word.empty();
  }

  /// True so many times, then false, in the line that has just been read.
  bool isAgain(double times) {
    double& left = level().counters.try_emplace(level().at - 1, times).first->second;
    const bool again = left-- >= 1.0;
    if (!again) {
      level().counters.erase(level().at - 1);
    }
    return again;
  }

  /// Jumps, calls and definitions. @return true if the line was one
  bool steers(const Line& line) {
    if (m_isPlain && accept("FN")) {  // FN 1: Q5 = +Q1 + +2, FN 9: IF +Q1 EQU +Q2 GOTO LBL 5
      const int kind = static_cast<int>(number());
      check(kind < 5 || (kind > 8 && kind < 13), "FN " + std::to_string(kind));
      expect(":");
    }
    if (m_isLinux || m_letter == 'G') {
      return keyEnd(line.text) > 0 && steersLinux(line.text);
    }
    const bool decides = accept("IF");
    const bool holds = !decides || condition();
    const int direction = accept("GOTOF") ? 1 : accept("GOTOB") ? -1 : accept("GOTO") ? 0 : 2;
    if (direction < 2) {
      accept("LBL");
      const std::string label = m_isFanuc   ? "N" + std::to_string(whole(primary()))
                                : m_isPlain ? restOfLine()
                                            : identifier();
      check(holds || !m_isSinumerik || !blanks(), "IF");
      if (holds) {
        jump(label, direction);
      }
    } else if (decides) {
      expect("THEN");
      if (holds) {
        execute(wordsOf(restOfLine()));
      }
    } else {
      return m_isSinumerik ? steersSinumerik() : m_isPlain && steersPlain(line);
    }
    return true;
  }

  bool steersSinumerik() {
    if (accept("REPEAT")) {
      const std::string label = identifier();
      const bool again = isAgain(accept("P") ? (accept("="), expression().number) : 1.0);
      check(!blanks(), "REPEAT between labels");
      if (again) {
        jump(label, -1);
      }
    } else if (accept("DEF")) {
      const std::string type = identifier();
      do {
        declare(type, level().variables, {0.0, true});
      } while (accept(","));
    } else {
      return accept("EXTERN") || accept("PROC");
    }
    return true;
  }

  /// DEF REAL A = 5, PROC NAME(INT N = 2): behind the type.
  void declare(const std::string& type, Values& variables, Value given) {
    const std::string name = identifier();
    check(isIn(type, "REAL INT BOOL") && !accept("["), "DEF " + type);
    variables[name] = {};
    const double otherwise = accept("=") ? expression().number : 0.0;
    const double value = given.vacant ? otherwise : given.number;
    variables[name] = {type == "INT" ? std::round(value) : value};
  }

  /// NAME, NAME(1,2), L100, with P3 behind.
  void callSinumerik(const std::string& name) {
    const auto program = findProgram(name);
    check(program.has_value(), name);
    std::vector<Value> given;
    if (accept("(")) {
      while (!accept(")")) {
        blanks();
        given.push_back(peek() == ',' || peek() == ')' ? Value{0.0, true} : expression());
        accept(",");
      }
    }
    const int times = accept("P") ? (accept("="), whole(expression())) : 1;
    const std::string rest = std::exchange(m_rest, m_lines[*program].text);
    const std::size_t at = std::exchange(m_i, 0);
    Values variables;
    const bool isProc = accept("PROC");
    const bool saves = isProc && m_rest.find("SAVE") != std::string::npos;
    identifier();
    for (std::size_t i = 0; isProc && accept(i == 0 ? "(" : ","); ++i) {
      declare(identifier(), variables, i < given.size() ? given[i] : Value{0.0, true});
    }
    begin(rest, at);
    call(*program, variables, times, saves);
  }

  /// O100 CALL [1] [2], and O100 RETURN.
  bool steersLinux(const std::string& line) {
    m_i = keyEnd(line);
    const std::string key = line.substr(0, m_i);
    check(key.size() > 1, "O with a calculated number");
    if (accept("RETURN")) {
      returnLinux();
      return true;
    }
    check(accept("CALL"), line);
    Values variables;
    for (int i = 1; accept("["); ++i) {
      variables["#" + std::to_string(i)] = expression();
      expect("]");
    }
    if (!findProgram(key)) {
      findProgram(key[1] == '<' ? key.substr(2, key.size() - 3) : key.substr(1));
    }
    check(findProgram(key).has_value(), key + " CALL");
    call(*findProgram(key), variables, 1);
    return true;
  }

  void returnLinux() {
    m_globals["#<_VALUE>"] = peek() == '[' ? primary() : Value{};
    leave();
  }

  /// Labels of plain text, and calculations.
  bool steersPlain(const Line& line) {
    if (accept("LBL")) {
      if (line.label == "0" && m_levels.size() > 1) {
        leave();
      }
    } else if (accept("CALL LBL")) {
      const std::size_t rep = m_rest.find("REP");
      const std::string label = trimmed(m_rest.substr(m_i, rep - std::min(m_i, rep)));
      if (rep == std::string::npos) {
        call(level().at, {}, 1);
        jump(label);
      } else if (m_i = rep + 3; isAgain(number())) {
        jump(label, -1);
      }
    } else if (blanks() && peek() == 'Q' && isDigit(peek(1))) {
      const std::string name = identifier();
      expect("=");
      variable(name) = expression();
      check(!blanks(), m_rest);
    } else {
      return false;
    }
    return true;
  }

  // --- blocks ------------------------------------------------------------------------------------

  Words wordsOf(const std::string& line) {
    begin(line);
    Words words;
    while (blanks()) {
      Word word;
      if (m_isPlain) {
        plainWord(word);
      } else if (m_isSinumerik) {
        sinumerikWord(word);
      } else if (accept("#")) {
        const std::string name = hashName();
        expect("=");
        m_deferred.emplace_back(name, expression());  // holds behind the block
      } else {
        word.name = m_rest[m_i++];
        m_step = m_isFanuc ? (m_modal.unit == 1.0 ? 0.001 : 0.0001) : 1.0;
        word.value = primary();
        m_step = 1.0;
      }
      if (!word.name.empty() && (!m_isFanuc || !word.value.vacant || word.name == "G")) {
        words.push_back(word);
      }
    }
    return words;
  }

  /// X+10, IX+Q1, FMAX, DR-.
  void plainWord(Word& word) {
    while (isLetter(peek()) && (peek() != 'Q' || word.name.empty())) {
      word.name += m_rest[m_i++];
    }
    check(!word.name.empty(), m_rest.substr(m_i));
    if (word.name.size() > 1 && word.name[0] == 'I') {
      word.name.erase(0, 1);
      word.reference = 'I';
    }
    word.name = word.name == "PR" ? "RP" : word.name == "PA" ? "AP" : word.name;
    if (word.name == "DR") {
      word.value.number = m_rest[m_i++] == '+' ? 1.0 : -1.0;
    } else if (peek() != ' ' && peek() != '\0') {
      word.value = primary();
    } else if (word.name == "F") {
      word.name = "F AUTO";
    }
  }

  static constexpr std::string_view kFrames = "TRANS ATRANS ROT AROT SCALE ASCALE MIRROR AMIRROR";

  /// X10, X=10, X=AC(10), CR=5, TRANS, NAME(1,2), R1=5.
  void sinumerikWord(Word& word) {
    const std::size_t from = m_i++;
    const bool isLong = isLetter(m_rest[from]) && isLetter(peek());
    while (isDigit(peek()) || (isLong && isLetter(peek()))) {
      ++m_i;
    }
    std::string name = m_rest.substr(from, m_i - from);
    const bool isName =
        isIn(name, kFrames) || isIn(name, "CIP CT RET DIAMON DIAMOF CR AR AP RP RPL I1 J1 K1");
    if (accept("=")) {
      for (const std::string reference : {"ACP", "ACN", "AC", "IC", "DC"}) {
        if (word.reference == 0 && accept(reference + "(")) {
          m_i -= 1;
          word.reference = reference.size() > 2 ? reference[2] : reference[0];
        }
      }
      const bool isText = accept("\"");  // T="MILL"
      m_i = isText ? m_rest.find('"', m_i) + 1 : m_i;
      word.value = isText ? Value{} : expression();
      const bool isOfSpindle =
          name.size() > 1 && isDigit(name[1]) && isIn(name.substr(0, 1), "M S");
      if (name.size() == 1 || isName || isOfSpindle) {
        word.name = name;
      } else {
        variable(name) = word.value;
      }
    } else if (!isLong) {
      m_i = from + 1;
      word = {name.substr(0, 1), {number()}};
      if (word.name == "L") {
        callSinumerik(m_rest.substr(from, m_i - from));
      }
    } else if (isIn(name, "MSG STOPRE SOFT BRISK FFWON FFWOF COMPOF CFC NORM KONT")) {
      m_i = name == "MSG" ? m_rest.size() : m_i;
    } else if (isName) {
      word.name = name;
    } else {
      callSinumerik(name);
    }
  }

  /// What a G or M function or a name does.
  struct Row {
    std::string_view words;
    std::string_view controls;  ///< their letters
    void (*act)(Evaluator& e, const std::string& word, const Words& all);
    bool takes = false;  ///< the other words of the block belong to it
  };

  static const std::vector<Row>& rows() {
    using E = Evaluator;
    using W = const std::string&;
    static const std::vector<Row> kRows{
        {"G0 G1 G2 G3 CIP CT", "SFLG", [](E& e, W w, auto&) { e.m_motion = w; }},
        {"G17 G18 G19", "SFLG", [](E& e, W w, auto&) { e.m_modal.across = kAcross.find(w[2]); }},
        {"G90 G91", "SFLG", [](E& e, W w, auto&) { e.m_modal.relative = w == "G91"; }},
        {"G90.1 G91.1", "L", [](E& e, W w, auto&) { e.m_modal.centreAbsolute = w == "G90.1"; }},
        {"G20 G21", "FLG", [](E& e, W w, auto&) { e.setUnit(w == "G20", true); }},
        {"G70 G71", "S", [](E& e, W w, auto&) { e.setUnit(w == "G70", false); }},
        {"G700 G710", "S", [](E& e, W w, auto&) { e.setUnit(w == "G700", true); }},
        {"G93 G94 G95", "SFLG", [](E& e, W w, auto&) { e.setFeedMode(w.back()); }},
        {"G7 G8", "L", [](E& e, W w, auto&) { e.m_modal.diameter = w == "G7"; }},
        {"DIAMON DIAMOF", "S", [](E& e, W w, auto&) { e.m_modal.diameter = w == "DIAMON"; }},
        {"G15 G16", "F", [](E& e, W w, auto&) { e.m_modal.polar = w == "G16"; }},
        {"G54 G55 G56 G57 G58 G59", "SFLG", [](E& e, W w, auto&) { e.setWorkOffset(w); }},
        {"G110 G111 G112", "S", [](E& e, W w, auto& all) { e.setPole(w, all); }, true},
        {"G52 G92", "FLG", [](E& e, W w, auto& all) { e.setOffset(w, all); }, true},
        {"G92.1 G92.2 G92.3", "LG", [](E& e, W w, auto& all) { e.setOffset(w, all); }, true},
        {"G68 G69 G51 G50 G51.1 G50.1", "F", [](E& e, W w, auto& a) { e.setOffset(w, a); }, true},
        {kFrames, "S", [](E& e, W w, auto& all) { e.frameStatement(w, all); }, true},
        {"G65", "F", [](E& e, W, auto& all) { e.callMacro(all); }, true},
        {"G4", "SFG", [](E&, W, auto&) {}, true},
        {"G9 G40 G49 G60 G61 G64 G80", "SFLG", [](E&, W, auto&) {}},
        {"G500 G601 G602 G603 G641 G642 G643 G450", "S", [](E&, W, auto&) {}},
        {"G43 G91.1", "FLG", [](E&, W, auto&) {}},
        {"G67", "F", [](E&, W, auto&) {}},
        {"G97 G98 G99", "G", [](E&, W, auto&) {}},
        {"G4 G97 G98 G99", "L", [](E&, W, auto&) {}},
        {"M0 M1 M3 M4 M5 M6 M7 M8 M9 M13 M19", "SFLGH", [](E&, W, auto&) {}},
        {"M2 M30", "SFLGH", [](E& e, W, auto&) { e.m_ended = true; }},
        {"M17 RET", "S", [](E& e, W, auto&) { e.leave(); }},
        {"M98", "F", [](E& e, W, auto& all) { e.callNumber(all, e.level().variables, true); }},
        {"M99", "F", [](E& e, W, auto& all) { e.leaveTo(all); }},
        {"M70 M73", "L", [](E& e, W w, auto&) { e.save(w == "M73"); }},
        {"M72", "L", [](E& e, W, auto&) { e.restore(); }}};
    return kRows;
  }

  /// "G92.1" of the word G with this value; other words as they are.
  static std::string written(const Word& word) {
    const long tenths = std::lround(word.value.number * 10.0);
    const std::string decimal = tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "";
    return isIn(word.name, "G M") ? word.name + std::to_string(tenths / 10) + decimal : word.name;
  }

  /// Null: the word is an address of the block.
  [[nodiscard]] const Row* rowOf(const Word& word) const {
    const std::string name = written(word);
    for (const Row& row : rows()) {
      if (isIn(name, row.words) && row.controls.find(m_letter) != std::string_view::npos) {
        return &row;
      }
    }
    check(!isIn(word.name, "G M"), name);
    return nullptr;
  }

  void execute(const Words& words) {
    static constexpr std::string_view kAddresses = "G F S T D H M N X Y Z A B C I J K R @ ^ L";
    m_blockFeed = 0.0;
    bool taken = false;
    bool hasP = false;
    for (const Word& word : words) {
      const Row* const row = rowOf(word);
      hasP |= isIn(written(word), "M98 M99 G4 G61 G64");
      taken |= row != nullptr && row->takes;
      if (row != nullptr && !isIn(word.name, "M RET")) {
        row->act(*this, written(word), words);
      }
    }
    m_modal.speed = valueOf(words, "S").value_or(m_modal.speed);
    for (const Word& word : words) {
      const bool isKnown = word.name.size() > 1 || isIn(word.name, kAddresses);
      check(taken || isKnown || (hasP && isIn(word.name, "P Q")), word.name);
    }
    if (!taken) {
      m_blockFeed = valueOf(words, "F").value_or(0.0);
      const double unit = m_modal.feedMode == '3' ? 1.0 : m_modal.feedUnit;
      m_modal.feed = find(words, "F") != nullptr ? m_blockFeed * unit : m_modal.feed;
      move(words);
    }
    for (const auto& [name, value] : std::exchange(m_deferred, {})) {
      variable(name) = value;
    }
    for (const Word& word : words) {
      if (isIn(word.name, "M RET")) {
        rowOf(word)->act(*this, written(word), words);
      }
    }
  }

  void setUnit(bool isInch, bool ofFeed) {
    m_modal.unit = isInch ? 25.4 : 1.0;
    m_modal.feedUnit = isInch && ofFeed ? 25.4 : 1.0;
  }
  void setFeedMode(char mode) {
    m_modal.feed = mode == m_modal.feedMode ? m_modal.feed : 0.0;
    m_modal.feedMode = mode;
  }
  void setWorkOffset(const std::string& g) {
    check(m_moves.empty() || m_workOffset == g, g);  // its values are not in the program
    m_workOffset = g;
  }
  void save(bool untilEnd) {
    m_saved.push_back(m_modal);
    level().saves = untilEnd;
  }

  /// M98 and G65.
  void callNumber(const Words& words, const Values& variables, bool shares) {
    const Word* const p = find(words, "P");
    const auto program = p == nullptr ? std::nullopt : findProgram(std::to_string(whole(p->value)));
    check(program.has_value(), "a call without its program");
    const int times = static_cast<int>(valueOf(words, "L").value_or(1.0));
    call(*program, variables, times, false, shares);
  }

  /// M99, M99 P10.
  void leaveTo(const Words& words) {
    check(m_levels.size() > 1, "M99");
    leave();
    if (const Word* const p = find(words, "P")) {
      jump("N" + std::to_string(whole(p->value)));
    }
  }

  /// G65: A B C … are #1 #2 #3 …, the second I J K are #7 #8 #9.
  void callMacro(const Words& words) {
    static const std::string kLetters = "ABCIJKDEF_H_M___QRSTUVWXYZ";
    Values variables;
    char last = 0;
    int triple = 0;
    for (const Word& word : words) {
      const std::size_t at = kLetters.find(word.name);
      const bool isTriple = isIn(word.name, "I J K");
      triple += isTriple && word.name[0] <= last ? 3 : 0;
      last = isTriple ? word.name[0] : last;
      if (at != std::string::npos) {
        const int index = static_cast<int>(at) + 1 + (isTriple ? triple : 0);
        variables["#" + std::to_string(index)] = word.value;
      }
    }
    callNumber(words, variables, false);
  }

  // --- frames ------------------------------------------------------------------------------------

  /// The tool stays where it is.
  void setFrame(const Frame& frame) {
    m_at = frame.from(m_modal.frame.to(m_at));
    m_modal.frame = frame;
    m_stale.fill(m_isSinumerik);
  }

  /// Of controls that know which offset, scale and turn hold, about which place.
  void rebuildFrame() {
    Frame frame;
    frame.shift(m_set + m_local + m_centre);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      frame.scale(axis, m_scale[axis]);
    }
    frame.turn(m_modal.across, m_turnedBy);
    frame.shift(-1.0 * m_centre);
    setFrame(frame);
  }

  template <class Each>
  static void forAxes(const Words& words, const Each& each) {
    for (const Word& word : words) {
      if (const std::size_t axis = axisOf(word); axis < 3) {
        each(axis, word);
      }
    }
  }

  void frameStatement(const std::string& name, const Words& words) {
    const std::string kind = name.substr(name[0] == 'A' ? 1 : 0);
    Frame frame = name[0] == 'A' ? m_modal.frame : Frame{};
    Vec3 shift;
    int turns = 0;
    for (const Word& word : words) {
      const std::size_t axis = axisOf(word);
      const double value = word.value.number;
      check(axis < 3 || word.name == name || word.name == "RPL", name + " " + word.name);
      if (kind == "ROT" && word.name != name) {
        frame.turn(axis < 3 ? axis : m_modal.across, value);
        check(++turns < 2, "ROT about two axes");
      } else if (axis < 3 && kind == "TRANS") {
        shift.set(axis, value * m_modal.unit);
      } else if (axis < 3) {
        frame.scale(axis, kind == "MIRROR" ? -1.0 : value);
      }
    }
    frame.shift(shift);
    setFrame(frame);
  }

  /// A coordinate that is no increment, in mm.
  [[nodiscard]] double length(std::size_t axis, double value) const {
    return value * m_modal.unit * (axis == 0 && m_modal.diameter ? 0.5 : 1.0);
  }

  /// G52, G92 to G92.3 of controls that follow RS-274, G68 to G50.1 of Fanuc.
  void setOffset(const std::string& g, const Words& words) {
    check(!find(words, "A") && !find(words, "B") && !find(words, "C"), g);
    Vec3& local = m_isFanuc ? m_local : m_set;
    forAxes(words, [&](std::size_t axis, const Word& word) {
      const double value = length(axis, word.value.number);
      check(g != "G92" || (m_known[axis] && !m_changes), "G92");
      if (g == "G52") {
        local.set(axis, value);
      } else if (g == "G92") {
        m_set.set(axis, m_set[axis] + m_at[axis] - value);
      }
    });
    if (isIn(g, "G68 G51 G51.1")) {
      takeChange(g, words);
    } else if (isIn(g, "G69 G50 G50.1")) {
      m_changes = false;
      m_scale = Vec3{1, 1, 1};
      m_turnedBy = 0.0;
    }
    m_kept = g == "G92.2" ? m_set : g == "G92.1" ? Vec3{} : m_kept;
    m_set = isIn(g, "G92.1 G92.2") ? Vec3{} : g == "G92.3" ? m_kept : m_set;
    rebuildFrame();
  }

  /// G68 X Y R, G51 X Y Z P1.5, G51.1 X Y of Fanuc, about a place in the coordinates of the
  /// program.
  void takeChange(const std::string& g, const Words& words) {
    const auto amount = valueOf(words, g == "G68" ? "R" : "P");
    const bool hasPoint = m_rest.find('.', m_rest.find('P')) != std::string::npos;
    check(!m_changes && !m_modal.relative && (g != "G51" || hasPoint), g);
    check(g == "G51.1" || amount.has_value(), g);
    m_changes = true;
    m_turnedBy = g == "G68" ? *amount : 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto named = valueOf(words, axisName(axis));
      const bool counts = g == "G51" || (g == "G68" && axis != m_modal.across);
      check(named || !counts || m_known[axis], g);
      m_centre.set(axis, named ? *named * m_modal.unit : counts ? m_at[axis] : 0.0);
      m_scale.set(axis, g == "G51" ? *amount : g == "G51.1" && named ? -1.0 : 1.0);
    }
  }

  /// G110 counts from the tool, G111 from the zero, G112 from the pole before.
  void setPole(const std::string& g, const Words& words) {
    m_pole = g == "G110" ? m_at : g == "G112" ? m_pole : Vec3{};
    const Vec3 from = m_pole;
    forAxes(words, [&](std::size_t axis, const Word& word) {
      m_pole.set(axis, from[axis] + word.value.number * m_modal.unit);
    });
    m_polarAngle = kNaN;
  }

  // --- moves -------------------------------------------------------------------------------------

  /// A place in the working plane.
  using Flat = std::complex<double>;

  [[nodiscard]] std::size_t first() const { return (m_modal.across + 1) % 3; }
  [[nodiscard]] std::size_t second() const { return (m_modal.across + 2) % 3; }
  [[nodiscard]] Flat flat(Vec3 place) const { return {place[first()], place[second()]}; }
  [[nodiscard]] Vec3 lifted(Flat place, Vec3 like) const {
    like.set(first(), place.real());
    like.set(second(), place.imag());
    return like;
  }
  [[nodiscard]] bool isIncrement(const Word& word) const {
    return word.reference == 'I' || (m_modal.relative && word.reference == 0);
  }

  /// Where the block goes, programmed coordinates.
  Vec3 target(const Words& words) {
    Vec3 to = m_at;
    std::optional<double> radius;
    std::optional<double> angle;
    const auto reaches = [this](std::size_t axis) {
      m_stale[axis] = false;
      m_known[axis] = true;
    };
    for (const Word& word : words) {
      const std::size_t axis = axisOf(word);
      const double value = word.value.number;
      const bool adds = isIncrement(word);
      if (isIn(word.name, "RP @") || (m_modal.polar && axis == first())) {
        check(!adds, word.name + " as an increment");
        radius = value * m_modal.unit;
      } else if (isIn(word.name, "AP ^") || (m_modal.polar && axis == second())) {
        check(!adds || !std::isnan(m_polarAngle), word.name + " as an increment");
        angle = value + (adds ? m_polarAngle : 0.0);
      } else if (axis < 3) {
        check(!adds || (m_known[axis] && !m_stale[axis]), "an increment from an unknown place");
        to.set(axis, length(axis, value) + (adds ? m_at[axis] : 0.0));
        reaches(axis);
      }
    }
    if (radius || angle) {
      const Flat pole = m_hasBrackets ? Flat{} : flat(m_pole);
      check(angle || m_isSinumerik, "a radius without an angle");
      m_polarAngle = angle ? *angle : std::isnan(m_polarAngle) ? 0.0 : m_polarAngle;
      to = lifted(pole + radius.value_or(std::abs(flat(m_at) - pole)) *
                             std::polar(1.0, m_polarAngle * kDegree),
                  to);
      reaches(first());
      reaches(second());
    }
    return to;
  }

  void turnAxes(const Words& words) {
    const auto positive = [](double angle) { return std::fmod(std::fmod(angle, 360) + 360, 360); };
    for (const Word& word : words) {
      const std::size_t axis = axisOf(word, "ABC");
      if (axis < 3) {
        const double now = m_turned[axis];
        const char reference = word.reference;
        const double way = positive(word.value.number - now);
        const bool isBack = (reference == 'N' && way > 0.0) || (reference == 'D' && way > 180.0);
        const bool isWay = reference == 'P' || reference == 'N' || reference == 'D';
        m_turned[axis] = isWay               ? now + way - (isBack ? 360.0 : 0.0)
                         : isIncrement(word) ? word.value.number + now
                         : m_modulo[axis]    ? word.value.number + now - positive(now)
                                             : word.value.number;
        // An axis for which these have a meaning counts from 0 to 360.
        m_modulo[axis] |= isWay;
      }
    }
  }

  void move(const Words& words) {
    bool axes = false;
    bool centre = false;
    for (const Word& word : words) {
      axes |= isIn(word.name, "X Y Z A B C @ ^ AP RP");
      centre |= isIn(word.name, "I J K AR");
    }
    const bool isArc = m_motion == "G2" || m_motion == "G3";
    check(isArc || !centre, "I J K without an arc");
    if (!axes && !centre) {
      return;
    }
    if (m_isPlain) {  // IPA counts from where the tool stands
      m_polarAngle = std::arg(flat(m_at - m_pole)) / kDegree;
    }
    const Vec3 end = target(words);
    turnAxes(words);
    const bool counter = valueOf(words, "DR").value_or(m_motion == "G3" ? 1.0 : -1.0) > 0.0;
    if (m_motion == "C" || m_motion == "CP") {
      const Word* const angle = find(words, "AP");
      const bool counts = angle != nullptr && angle->reference == 'I';
      const double sweep = counts ? std::abs(angle->value.number) : 0.0;
      check(sweep <= 360.0, "more than a turn");
      arcAbout(flat(m_pole), end, counter, sweep == 360.0);
    } else if (isArc || m_motion == "CR") {
      arc(words, end, counter);
    } else if (m_motion == "CIP" || m_motion == "CT") {
      spaceArc(words, end);
    } else {
      straight(end, m_motion == "G0" || find(words, "FMAX") != nullptr);
    }
  }

  void straight(Vec3 end, bool rapid) {
    EvaluatedMove made;
    made.kind = rapid ? EvaluatedMove::Kind::Rapid : EvaluatedMove::Kind::Line;
    const double way = base::distance(m_modal.frame.to(end), m_modal.frame.to(m_at));
    m_direction = way > 0.0 ? end - m_at : m_direction;
    finish(made, end, way);
  }

  void finish(EvaluatedMove made, Vec3 end, double lengthMm) {
    const Vec3 place = m_modal.frame.to(end);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      made.end[axis] = m_known[axis] ? place[axis] : kNaN;
      made.end[axis + 3] = m_turned[axis];
    }
    made.feed = made.kind == EvaluatedMove::Kind::Rapid ? 0.0
                : m_modal.feedMode == '5'               ? m_modal.feed * m_modal.speed
                : m_modal.feedMode == '3'               ? m_blockFeed * lengthMm
                                                        : m_modal.feed;
    made.feed /= lengthMm == 0.0 && m_modal.feedMode == '4' ? m_modal.feedUnit : 1.0;  // degrees
    made.line = m_line;
    m_at = end;
    m_moves.push_back(made);
  }

  /// G2 and G3, from the words that say where the centre is.
  void arc(const Words& words, Vec3 end, bool counter) {
    const auto r = valueOf(words, m_isSinumerik ? "CR" : "R");
    const auto angle = valueOf(words, "AR");
    check(!find(words, "TURN") && !find(words, "P"), "more than a turn");
    check(m_known[first()] && m_known[second()], "an arc from an unknown place");
    Vec3 given = m_at;
    bool isGiven = false;
    for (const std::size_t axis : {first(), second()}) {
      if (const Word* const word = find(words, std::string(1, "IJK"[axis]))) {
        const bool absolute =
            word->reference == 'A' || (m_modal.centreAbsolute && word->reference == 0);
        given.set(axis, word->value.number * m_modal.unit + (absolute ? 0.0 : m_at[axis]));
        isGiven = true;
      }
    }
    Flat centre = flat(given);
    const Flat start = flat(m_at);
    const Flat way = flat(end) - start;
    const double half = std::abs(way) / 2.0;
    const double sign = counter ? 1.0 : -1.0;
    if (r || (angle && !isGiven)) {
      const double radius = r ? *r * m_modal.unit : half / std::sin(*angle * kDegree / 2.0);
      check(half > 0.0 && std::abs(radius) >= half - 0.01, "R");
      const bool large = r ? radius < 0.0 : *angle > 180.0;
      const double up = std::sqrt(std::max(0.0, radius * radius - half * half));
      centre = start + way * Flat(0.5, (large ? -sign : sign) * up / half / 2.0);
    } else if (find(words, "AP") != nullptr && !isGiven) {
      centre = flat(m_pole);
    } else {
      check(isGiven, "an arc without a centre");
      const Flat turned = (start - centre) * std::polar(1.0, sign * angle.value_or(0.0) * kDegree);
      end = angle ? lifted(centre + turned, end) : end;
    }
    arcAbout(centre, end, counter);
  }

  /// In the plane, from where the tool stands.
  void arcAbout(Flat centre, Vec3 end, bool counter, bool isFull = false) {
    isFull |= std::abs(flat(end) - flat(m_at)) < 1e-9;
    Vec3 axis;
    axis.set(m_modal.across, counter ? 1.0 : -1.0);
    circle(lifted(centre, m_at), axis, isFull ? lifted(flat(m_at), end) : end, isFull);
  }

  /// About an axis through the centre; the end may stand higher along it.
  void circle(Vec3 centre, Vec3 axis, Vec3 end, bool isFull) {
    const Frame& frame = m_modal.frame;
    check(frame.isEven(), "an arc that becomes an ellipse");
    const double scale = base::norm(frame.columns[0]);
    const Vec3 arm = m_at - centre;
    const double rise = base::dot(end - m_at, axis);
    const Vec3 to = end - centre - rise * axis;
    EvaluatedMove made;
    made.kind = EvaluatedMove::Kind::Arc;
    made.sweepDeg = std::atan2(base::dot(base::cross(arm, to), axis), base::dot(arm, to)) / kDegree;
    made.sweepDeg = isFull ? 360.0 : made.sweepDeg + (made.sweepDeg <= 0.0 ? 360.0 : 0.0);
    made.mismatch = std::abs(base::norm(arm) - base::norm(to));
    made.centre = frame.to(centre);
    const Vec3 hand = base::cross(frame.columns[0], frame.columns[1]);
    made.axis = (base::dot(hand, frame.columns[2]) > 0.0 ? 1.0 : -1.0) / scale * frame.linear(axis);
    m_direction = base::cross(axis, to);
    finish(made, end, scale * std::hypot(base::norm(arm) * made.sweepDeg * kDegree, rise));
  }

  /// CIP and CT: a circle in space, through a third point or tangent to the move before.
  void spaceArc(const Words& words, Vec3 end) {
    const Vec3 way = end - m_at;
    Vec3 middle = m_at;
    for (std::size_t i = 0; i < 3; ++i) {
      if (const Word* const word = find(words, std::string(1, "IJK"[i]) + "1")) {
        middle.set(i, word->value.number * m_modal.unit + (isIncrement(*word) ? m_at[i] : 0.0));
      }
    }
    const Vec3 a = m_motion == "CIP" ? middle - m_at : m_direction;
    const Vec3 axis = base::cross(a, way);
    check(base::norm(axis) > 0.0, m_motion + " without a circle");
    const Vec3 normal = base::cross(axis, a);
    const Vec3 centre =
        m_motion == "CIP"
            ? 1.0 / (2.0 * base::dot(axis, axis)) *
                  (base::dot(a, a) * base::cross(way, axis) + base::dot(way, way) * normal)
            : base::dot(way, way) / (2.0 * base::dot(normal, way)) * normal;
    circle(m_at + centre, 1.0 / base::norm(axis) * axis, end, false);
  }

  // --- Heidenhain --------------------------------------------------------------------------------

  void plainBlock(const std::string& line) {
    const std::string head = line.substr(0, line.find(' '));
    const std::string rest = line.substr(head.size());
    if (line.starts_with("BEGIN PGM")) {
      check(!line.ends_with("INCH"), "INCH");
    } else if (line.starts_with("TOOL CALL")) {
      const std::size_t axis = line.find_first_of(kAxes, 10);
      m_modal.across = axis == std::string::npos ? m_modal.across : kAxes.find(line[axis]);
      if (const std::size_t feed = line.find(" F"); feed != std::string::npos) {
        begin(line, feed + 2);
        m_modal.feed = number();
      }
    } else if (line.starts_with("CYCL DEF")) {
      plainFrame(trimmed(line.substr(8)));
    } else if (head == "CC") {
      const Words words = wordsOf(rest);
      m_pole = words.empty() ? m_at : m_pole;
      forAxes(words, [this](std::size_t axis, const Word& word) {
        m_pole.set(axis, word.value.number + (word.reference == 'I' ? m_at[axis] : 0.0));
      });
    } else if (isIn(head, "L LP C CP CR CT")) {
      m_motion = head;
      execute(wordsOf(rest));
    } else if (isIn(head, "M30 M2 M02 END")) {
      m_ended = true;
    } else {
      check(isIn(head, "BLK STOP M0 M1 M3 M4 M5 M8 M9") || head[0] == '*', head);
    }
  }

  /// CYCL DEF 7 (datum shift), 8 (mirror image), 10 (rotation): each holds until it is set again.
  void plainFrame(const std::string& text) {
    const std::string cycle = text.substr(0, digitsEnd(text, 0));
    check(isIn(cycle, "7 8 10"), "CYCL DEF " + cycle);
    m_scale = cycle == "8" ? Vec3{1, 1, 1} : m_scale;
    const bool isHead = text.starts_with(cycle + ".0");
    for (const Word& word :
         wordsOf(text.substr(isHead ? text.size() : std::min(text.size(), text.find(' '))))) {
      const std::size_t axis = axisOf(word);
      const bool adds = word.reference == 'I';
      check(axis < 3 || word.name == "ROT", "CYCL DEF " + word.name);
      if (cycle == "10") {
        m_turnedBy = word.value.number + (adds ? m_turnedBy : 0.0);
      } else if (cycle == "8") {
        m_scale.set(axis, -1.0);
      } else {
        m_local.set(axis, word.value.number + (adds ? m_local[axis] : 0.0));
      }
    }
    rebuildFrame();
  }

  char m_letter;
  bool m_isSinumerik = m_letter == 'S';
  bool m_isFanuc = m_letter == 'F';
  bool m_isLinux = m_letter == 'L';
  bool m_isPlain = m_letter == 'H';
  bool m_hasBrackets = !m_isSinumerik && !m_isPlain;
  const Beside& m_beside;
  std::vector<Line> m_lines;
  std::map<std::string, std::size_t> m_programs;  ///< their first lines
  std::vector<std::size_t> m_open;                ///< structures that have not ended
  bool m_arrives = false;                         ///< at ELSE, from its IF
  std::vector<Level> m_levels;
  std::vector<Modal> m_saved;
  Values m_globals;
  Value m_vacant;
  std::vector<std::pair<std::string, Value>> m_deferred;
  std::string m_rest;
  std::size_t m_i = 0;
  std::size_t m_line = 0;
  double m_step = 1.0;
  bool m_ended = false;
  // The machine.
  Modal m_modal;
  std::string m_motion;  ///< "G0" to "G3", "CIP", "CT"
  Vec3 m_at;             ///< programmed coordinates
  std::array<bool, 3> m_known{};
  std::array<bool, 3> m_stale{};  ///< an increment would count from before a change of the frame
  std::array<double, 3> m_turned{kNaN, kNaN, kNaN};
  std::array<bool, 3> m_modulo{};
  Vec3 m_direction;
  Vec3 m_pole;
  double m_polarAngle = kNaN;
  Vec3 m_set;              ///< G92, and G52 of LinuxCNC
  Vec3 m_kept;             ///< of G92.2
  Vec3 m_local;            ///< G52, CYCL DEF 7
  bool m_changes = false;  ///< G68, G51 or G51.1 holds
  Vec3 m_centre;
  Vec3 m_scale{1, 1, 1};
  double m_turnedBy = 0.0;
  std::string m_workOffset;
  double m_blockFeed = 0.0;
  std::vector<EvaluatedMove> m_moves;
};

}  // namespace

Evaluation evaluate(std::string_view control, std::string_view text,
                    const std::function<std::optional<std::string>(std::string_view)>& beside) {
  const char letter = control == "haas" ? 'F' : base::toUpper(control.front());
  return Evaluator(letter, beside).run(text);
}

}  // namespace rivulet::tests
