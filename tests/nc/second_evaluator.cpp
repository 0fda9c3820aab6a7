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

/// What G functions set.
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
  bool shares = false;  ///< M98: the variables are those of the caller
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
    const bool begins = isIn(word, m_isLinux ? "IF WHILE" : "IF WHILE LOOP REPEAT");
    const bool goesOn = isIn(word, "ELSE ELSEIF");
    const bool ends = isIn(word, "END ENDIF ENDWHILE ENDLOOP UNTIL");
    if (jumps || m_isPlain || (m_isLinux && key == 0) || !(begins || goesOn || ends)) {
      return;
    }
    line.behind = to;
    line.structure = word;
    if (goesOn || ends) {
      check(!m_open.empty(), line.text);
      m_lines[m_open.back()].next = m_lines.size();
      line.back = m_open.back();
      m_open.pop_back();
    }
    if (!ends) {
      m_open.push_back(m_lines.size());
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
    if (isIn(name, "SIN COS TAN")) {
      const double angle = a[0] * kDegree;
      return {name == "SIN" ? std::sin(angle) : name == "COS" ? std::cos(angle) : std::tan(angle)};
    }
    if (isIn(name, "ABS SQRT ROUND")) {  // in a word of Fanuc to the least input increment
      check(name != "ROUND" || !m_isInWord, "ROUND in a word");
      return {name == "ABS" ? std::abs(a[0]) : name == "SQRT" ? std::sqrt(a[0]) : std::round(a[0])};
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

  void call(std::size_t at, const Values& variables, int times, bool shares = false) {
    check(m_levels.size() < 1000, "calls too deep");
    for (; times > 0; --times) {
      m_levels.push_back({at, variables, shares});
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
  }

  bool condition() { return (m_hasBrackets ? primary() : expression()).number != 0.0; }

  /// @return true if the line belongs to a structure
  bool structured(const Line& line) {
    const std::string& word = line.structure;
    const bool arrives = std::exchange(m_arrives, false);  // from an IF that does not hold
    std::size_t& at = level().at;
    bool enters = true;
    if (word.starts_with("ELSE")) {
      enters = arrives && (word == "ELSE" || condition());
    } else if (isIn(word, "IF WHILE UNTIL")) {
      enters = condition();
    } else if (word.starts_with("END") && word != "ENDIF") {
      at = line.back;
    }
    if (word == "UNTIL") {
      at = enters ? at : line.back + 1;
    } else if (!enters) {
      const bool goesOn = m_lines[line.next].structure.starts_with("ELSE");
      m_arrives = goesOn && (word == "IF" || arrives);
      at = line.next + (goesOn ? 0 : 1);
    }
    return !word.empty();
  }

  /// Jumps, calls and definitions. @return true if the line was one
  bool steers(const Line& line) {
    if (m_isPlain && accept("FN")) {  // FN 1: Q5 = +Q1 + +2, FN 9: IF +Q1 EQU +Q2 GOTO LBL 5
      const int kind = static_cast<int>(number());
      check(kind < 5 || (kind > 8 && kind < 13), "FN " + std::to_string(kind));
      expect(":");
    }
    if (m_isLinux || m_letter == 'G') {
      check(keyEnd(line.text) == 0, line.text);
      return false;
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
    } else {
      check(!decides, line.text);
      check(!m_isSinumerik || !accept("REPEAT"), line.text);
      if (m_isSinumerik && accept("DEF")) {
        const std::string type = identifier();
        do {
          const std::string name = identifier();
          check(isIn(type, "REAL INT BOOL") && !accept("["), "DEF " + type);
          const double value = accept("=") ? expression().number : 0.0;
          level().variables[name] = {type == "INT" ? std::round(value) : value};
        } while (accept(","));
        return true;
      }
      return m_isSinumerik ? accept("EXTERN") || accept("PROC") : m_isPlain && steersPlain(line);
    }
    return true;
  }

  /// NAME, L100, with P3 behind.
  void callSinumerik(const std::string& name) {
    const auto program = findProgram(name);
    check(program.has_value() && !accept("("), name);
    const std::string head = m_lines[*program].text;
    check(!head.starts_with("PROC") || (head.find('(') & head.find(" SAVE")) == head.npos, head);
    call(*program, {}, accept("P") ? (accept("="), whole(expression())) : 1);
  }

  /// Labels of plain text, and calculations.
  bool steersPlain(const Line& line) {
    if (accept("LBL")) {
      if (line.label == "0" && m_levels.size() > 1) {
        leave();
      }
    } else if (accept("CALL LBL")) {
      check(m_rest.find("REP") == std::string::npos, "REP");
      call(level().at, {}, 1);
      jump(restOfLine());
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
        m_isInWord = m_isFanuc;
        word.value = primary();
        m_isInWord = false;
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
    const bool isName = isIn(name, kFrames) || isIn(name, "RET DIAMON DIAMOF CR AR AP RP RPL");
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
        {"G0 G1 G2 G3", "SFLG", [](E& e, W w, auto&) { e.m_motion = w; }},
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
        {"G110 G111 G112", "S", [](E& e, W w, auto& all) { e.setPole(w, all); }, true},
        {"G52 G92", "FLG", [](E& e, W w, auto& all) { e.setOffset(w, all); }, true},
        {"G92.1", "LG", [](E& e, W w, auto& all) { e.setOffset(w, all); }, true},
        {kFrames, "S", [](E& e, W w, auto& all) { e.frameStatement(w, all); }, true},
        {"G65", "F", [](E& e, W, auto& all) { e.callMacro(all); }, true},
        {"G4", "SFG", [](E&, W, auto&) {}, true},
        {"G9 G40 G49 G54 G60 G61 G64 G80", "SFLG", [](E&, W, auto&) {}},
        {"G500 G601 G602 G603 G641 G642 G643 G450", "S", [](E&, W, auto&) {}},
        {"G43 G91.1", "FLG", [](E&, W, auto&) {}},
        {"G67", "F", [](E&, W, auto&) {}},
        {"G97 G98 G99", "G", [](E&, W, auto&) {}},
        {"G4 G97 G98 G99", "L", [](E&, W, auto&) {}},
        {"M0 M1 M3 M4 M5 M6 M7 M8 M9 M13 M19", "SFLGH", [](E&, W, auto&) {}},
        {"M2 M30", "SFLGH", [](E& e, W, auto&) { e.m_ended = true; }},
        {"M17 RET", "S", [](E& e, W, auto&) { e.leave(); }},
        {"M98", "F", [](E& e, W, auto& all) { e.callNumber(all, e.level().variables, true); }},
        {"M99", "F", [](E& e, W, auto& all) { check(!find(all, "P"), "M99 P"), e.leave(); }}};
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
    const double formerUnit = m_modal.feedUnit;
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
      const double unit = m_isLinux ? formerUnit : m_modal.feedUnit;
      m_modal.feed = find(words, "F") != nullptr
                         ? m_blockFeed * (m_modal.feedMode == '3' ? 1.0 : unit)
                         : m_modal.feed;
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
  /// M98 and G65.
  void callNumber(const Words& words, const Values& variables, bool shares) {
    const Word* const p = find(words, "P");
    const auto program = p == nullptr ? std::nullopt : findProgram(std::to_string(whole(p->value)));
    check(program.has_value(), "a call without its program");
    const int times = static_cast<int>(valueOf(words, "L").value_or(1.0));
    call(*program, variables, times, shares);
  }

  /// G65: A B C … are #1 #2 #3 ….
  void callMacro(const Words& words) {
    static const std::string kLetters = "ABCIJKDEF_H_M___QRSTUVWXYZ";
    Values variables;
    for (const Word& word : words) {
      const std::size_t at = kLetters.find(word.name);
      if (at != std::string::npos) {
        const bool isNew = variables.emplace("#" + std::to_string(at + 1), word.value).second;
        check(isNew, "a second " + word.name);
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

  /// G52, G92 and G92.1 of controls that follow RS-274.
  void setOffset(const std::string& g, const Words& words) {
    check(!find(words, "A") && !find(words, "B") && !find(words, "C"), g);
    Vec3& local = m_isFanuc ? m_local : m_set;
    forAxes(words, [&](std::size_t axis, const Word& word) {
      const double value = length(axis, word.value.number);
      check(g != "G92" || m_known[axis], "G92");
      if (g == "G52") {
        local.set(axis, value);
      } else if (g == "G92") {
        m_set.set(axis, m_set[axis] + m_at[axis] - value);
      }
    });
    m_set = g == "G92.1" ? Vec3{} : m_set;
    Frame frame;
    frame.shift(m_set + m_local);
    setFrame(frame);
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
    if (m_motion == "C") {
      arcAbout(flat(m_pole), end, counter);
    } else if (isArc || m_motion == "CR") {
      arc(words, end, counter);
    } else {
      straight(end, m_motion == "G0" || find(words, "FMAX") != nullptr);
    }
  }

  void straight(Vec3 end, bool rapid) {
    EvaluatedMove made;
    made.kind = rapid ? EvaluatedMove::Kind::Rapid : EvaluatedMove::Kind::Line;
    const double way = base::distance(m_modal.frame.to(end), m_modal.frame.to(m_at));
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
    check(!find(words, "AR"), "AR");
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
    if (r) {
      const double radius = *r * m_modal.unit;
      check(half > 0.0 && std::abs(radius) >= half - 0.01, "R");
      const double up = std::sqrt(std::max(0.0, radius * radius - half * half));
      centre = start + way * Flat(0.5, (radius < 0.0 ? -sign : sign) * up / half / 2.0);
    } else if (find(words, "AP") != nullptr && !isGiven) {
      centre = flat(m_pole);
    } else {
      check(isGiven, "an arc without a centre");
    }
    arcAbout(centre, end, counter);
  }

  /// In the plane, from where the tool stands; the end may stand higher.
  void arcAbout(Flat centre, Vec3 end, bool counter) {
    const Frame& frame = m_modal.frame;
    check(frame.isEven(), "an arc that becomes an ellipse");
    const double scale = base::norm(frame.columns[0]);
    const double sign = counter ? 1.0 : -1.0;
    const bool isFull = std::abs(flat(end) - flat(m_at)) < 1e-9;
    const Flat arm = flat(m_at) - centre;
    const Flat to = isFull ? arm : flat(end) - centre;
    EvaluatedMove made;
    made.kind = EvaluatedMove::Kind::Arc;
    made.sweepDeg = isFull ? 360.0 : sign * std::arg(to / arm) / kDegree;
    made.sweepDeg += made.sweepDeg <= 0.0 ? 360.0 : 0.0;
    made.mismatch = std::abs(std::abs(arm) - std::abs(to));
    made.centre = frame.to(lifted(centre, m_at));
    const Vec3 hand = base::cross(frame.columns[0], frame.columns[1]);
    Vec3 axis;
    axis.set(m_modal.across, base::dot(hand, frame.columns[2]) > 0.0 ? sign : -sign);
    made.axis = 1.0 / scale * frame.linear(axis);
    const double rise = end[m_modal.across] - m_at[m_modal.across];
    finish(made, isFull ? lifted(flat(m_at), end) : end,
           scale * std::hypot(std::abs(arm) * made.sweepDeg * kDegree, rise));
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
    } else if (head == "CC") {
      const Words words = wordsOf(rest);
      m_pole = words.empty() ? m_at : m_pole;
      forAxes(words, [this](std::size_t axis, const Word& word) {
        m_pole.set(axis, word.value.number + (word.reference == 'I' ? m_at[axis] : 0.0));
      });
    } else if (isIn(head, "L LP C CR")) {
      m_motion = head;
      execute(wordsOf(rest));
    } else if (isIn(head, "M30 M2 M02 END")) {
      m_ended = true;
    } else {
      check(isIn(head, "BLK STOP M0 M1 M3 M4 M5 M8 M9") || head[0] == '*', head);
    }
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
  Values m_globals;
  Value m_vacant;
  std::vector<std::pair<std::string, Value>> m_deferred;
  std::string m_rest;
  std::size_t m_i = 0;
  std::size_t m_line = 0;
  bool m_isInWord = false;
  bool m_ended = false;
  // The machine.
  Modal m_modal;
  std::string m_motion;  ///< "G0" to "G3", "L" to "CR"
  Vec3 m_at;             ///< programmed coordinates
  std::array<bool, 3> m_known{};
  std::array<bool, 3> m_stale{};  ///< an increment would count from before a change of the frame
  std::array<double, 3> m_turned{kNaN, kNaN, kNaN};
  std::array<bool, 3> m_modulo{};
  Vec3 m_pole;
  double m_polarAngle = kNaN;
  Vec3 m_set;    ///< G92, and G52 of LinuxCNC
  Vec3 m_local;  ///< G52 of Fanuc
  double m_blockFeed = 0.0;
  std::vector<EvaluatedMove> m_moves;
};

}  // namespace

Evaluation evaluate(std::string_view control, std::string_view text,
                    const std::function<std::optional<std::string>(std::string_view)>& beside) {
  const char letter = control == "haas"      ? 'F'
                      : control == "fluidnc" ? 'L'
                                             : base::toUpper(control.front());
  return Evaluator(letter, beside).run(text);
}

}  // namespace rivulet::tests
