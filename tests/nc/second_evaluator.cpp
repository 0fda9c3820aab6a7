// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "second_evaluator.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "base/text.h"

namespace rivulet::tests {

using base::isDigit;
using base::Vec3;

namespace {

/// The number that a text begins with, with a point in every language of the user; 0: none.
double numberAt(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" +"), text.size()));
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr std::size_t kStepsMax = 400'000;
constexpr std::string_view kAxes = "XYZ";

/// A word that is not followed.
struct Stop {
  std::string word;
};
void check(bool follows, const std::string& word) {
  if (!follows) {
    throw Stop{word};
  }
}

struct Value {
  double number = 0.0;
  bool vacant = false;
};
using Values = std::map<std::string, Value>;

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}
bool startsWith(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}
bool isOneOf(const std::string& word, const std::vector<std::string>& words) {
  return std::count(words.begin(), words.end(), word) > 0;
}
int whole(const Value& value) {
  return static_cast<int>(std::lround(value.number));
}
std::string trimmed(std::string_view text) {
  return std::string(base::trim(text));
}
std::string gName(int tenths) {
  return "G" + std::to_string(tenths / 10) +
         (tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "");
}

struct Line {
  std::size_t number = 0;
  std::string label;  ///< "N10", "START", "3" of LBL 3
  std::string text;
  std::string_view structure;  ///< IF, ELSE, ENDWHILE …
  std::size_t behind = 0;      ///< that word
  std::size_t next = 0;        ///< where the structure goes on: ELSE, ENDIF, ENDWHILE
  std::size_t back = 0;        ///< where it began
};
struct Text {
  std::string name;
  std::vector<Line> lines;
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
    const Vec3 first = columns[(axis + 1) % 3];
    const Vec3 second = columns[(axis + 2) % 3];
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    check(isEven(), "a turn after a scale");
    columns[(axis + 1) % 3] = c * first + s * second;
    columns[(axis + 2) % 3] = c * second - s * first;
  }
};

struct Word {
  std::string name;
  Value value;
  bool hasValue = false;
  char reference = 0;  ///< A, I, D, P, N: AC IC DC ACP ACN; I of Heidenhain's IX
};
using Words = std::vector<Word>;

const Word* find(const Words& words, std::string_view name) {
  const auto found = std::find_if(words.rbegin(), words.rend(),
                                  [name](const Word& each) { return each.name == name; });
  return found == words.rend() ? nullptr : &*found;
}
const Word* find(const Words& words, char name) {
  return find(words, std::string_view(&name, 1));
}
std::size_t axisOf(const Word& word, std::string_view axes = kAxes) {
  return word.name.size() == 1 ? axes.find(word.name[0]) : std::string_view::npos;
}

/// What PROC SAVE and M70 keep.
struct Modal {
  double unit = 1.0;
  double feedUnit = 1.0;
  bool relative = false;
  bool centreAbsolute = false;
  bool diameter = false;
  bool polar = false;  ///< G16
  std::size_t across = 2;
  char feedMode = 'M';  ///< per minute, I: inverse time, R: per revolution
  double feed = 0.0;
  double speed = 0.0;
  Frame frame;
};

/// A program that runs: what it has of its own, and where it goes on.
struct Level {
  const Text* text = nullptr;
  std::size_t at = 0;  ///< the next line
  Values variables;
  std::map<std::size_t, double> counters;  ///< of loops, by their line
  int repeats = 0;                         ///< calls that are still to come
  std::size_t begin = 0;
  bool saves = false;
  bool shares = false;  ///< M98: the variables are those of the caller
};

enum class Control : unsigned char { Sinumerik, Fanuc, Haas, LinuxCnc, Grbl, Heidenhain };

class Evaluator {
 public:
  using Beside = std::function<std::optional<std::string>(std::string_view)>;

  Evaluator(Control control, const Beside& beside) : m_control(control), m_beside(beside) {}

  Evaluation run(std::string_view text) {
    Evaluation result;
    try {
      readTexts(startsWith(text, "\xEF\xBB\xBF") ? text.substr(3) : text, "");
      m_levels.emplace_back().text = m_texts.front().get();
      for (std::size_t steps = 0; !m_ended; ++steps) {
        check(steps < kStepsMax, "a loop without an end");
        if (level().at >= level().text->lines.size()) {
          leave();
          continue;
        }
        const Line& line = level().text->lines[level().at++];
        m_line = line.number;
        if (!line.text.empty() && !flow(line)) {
          isPlain() ? plainBlock(line.text) : execute(wordsOf(line.text));
        }
      }
    } catch (const Stop& stopped) {
      result.cannotFollow = stopped.word;
    }
    result.moves = std::move(m_moves);
    return result;
  }

 private:
  [[nodiscard]] bool isSinumerik() const { return m_control == Control::Sinumerik; }
  [[nodiscard]] bool isPlain() const { return m_control == Control::Heidenhain; }
  [[nodiscard]] bool isLinux() const { return m_control == Control::LinuxCnc; }
  [[nodiscard]] bool isFanuc() const {
    return m_control == Control::Fanuc || m_control == Control::Haas;
  }
  [[nodiscard]] bool hasBrackets() const { return !isSinumerik() && !isPlain(); }

  // --- text -------------------------------------------------------------------------------------

  /// Capital, without comments; without blanks where they mean nothing.
  [[nodiscard]] std::string cleaned(std::string_view line) const {
    std::string made;
    bool quoted = false;
    bool comment = false;
    for (const char c : line) {
      quoted = c == '"' && !comment ? !quoted : quoted;
      if (!quoted && !comment && c == ';' && !isFanuc()) {
        break;
      }
      comment = hasBrackets() && (comment ? c != ')' : c == '(');
      if (!comment && !(hasBrackets() && (c == ' ' || c == '\t' || c == ')'))) {
        made += base::toUpper(c);
      }
    }
    return trimmed(made);
  }

  /// The programs in one file; the first is the one that runs.
  void readTexts(std::string_view text, const std::string& name) {
    const std::size_t first = m_texts.size();
    m_marks = 0;
    beginText(name);
    std::size_t number = 0;
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t end = std::min(text.find_first_of("\r\n;", from), text.size());
      // ";" ends a block of Fanuc, and begins a comment of others.
      const bool splits = end < text.size() && text[end] == ';' && isFanuc();
      const std::size_t last =
          splits ? end : std::min(text.find_first_of("\r\n", from), text.size());
      addLine(cleaned(text.substr(from, last - from)), number + 1);
      number += splits ? 0 : 1;
      from = last + 1;
      from += !splits && from < text.size() && text[last] == '\r' && text[from] == '\n' ? 1 : 0;
    }
    for (std::size_t i = first; i < m_texts.size(); ++i) {
      link(*m_texts[i]);
    }
  }

  void beginText(const std::string& name) {
    m_texts.push_back(std::make_unique<Text>(Text{name, {}}));
    m_current = m_texts.back().get();
  }

  void addLine(std::string block, std::size_t number) {
    const bool isIso = isFanuc() && block.size() > 1 && block[0] == 'O' && isDigit(block[1]);
    if (isIso || (isSinumerik() && startsWith(block, "%_N_"))) {
      if (!m_current->lines.empty() || !m_current->name.empty()) {
        beginText("");
      }
      m_current->name = isIso ? std::to_string(std::atoi(block.c_str() + 1))
                              : block.substr(4, block.rfind('_') - 4);
      return;
    }
    block.erase(0, !block.empty() && block[0] == '/' ? 1 : 0);
    m_marks += hasBrackets() && !isFanuc() && startsWith(block, "%") ? 1 : 0;
    if (block.empty() || block[0] == '%' || m_marks > 1) {
      return;
    }
    Line line;
    line.number = number;
    line.text = block;
    const std::size_t digits = block.find_first_not_of("0123456789", isPlain() ? 0 : 1);
    const std::size_t end = std::min(digits, block.size());
    if (isPlain() || (block[0] == 'N' && block.size() > 1 && isDigit(block[1]))) {
      line.label = isPlain() ? "" : "N" + std::to_string(std::atoi(block.c_str() + 1));
      line.text = trimmed(block.substr(end));
    }
    const std::size_t colon = line.text.find(':');
    if (isSinumerik() && colon != std::string::npos && line.text.find_first_of(" =(\"") > colon) {
      line.label = line.text.substr(0, colon);
      line.text = trimmed(line.text.substr(colon + 1));
    } else if (isPlain() && startsWith(line.text, "LBL")) {
      line.label = trimmed(line.text.substr(3));
    }
    // O100 SUB begins a program of its own inside another one.
    const std::size_t key = isLinux() && line.text[0] == 'O' ? keyEnd(line.text) : 0;
    if (key > 0 && line.text.substr(key) == "SUB") {
      m_outer = m_current;
      beginText(line.text.substr(0, key));
      return;
    }
    m_current->lines.push_back(line);
    m_current = key > 0 && startsWith(line.text.substr(key), "ENDSUB") ? m_outer : m_current;
  }

  const Text* findText(const std::string& name) {
    for (const std::unique_ptr<Text>& each : m_texts) {
      if (each->name == name) {
        return each.get();
      }
    }
    const std::optional<std::string> text = m_beside ? m_beside(name) : std::nullopt;
    const std::size_t at = m_texts.size();
    if (text) {
      readTexts(*text, isFanuc() ? "" : name);
      m_texts[at]->name = name;
    }
    return text ? m_texts[at].get() : nullptr;
  }

  // --- expressions, of m_rest from m_i on --------------------------------------------------------

  void begin(const std::string& text) {
    m_rest = text;
    m_i = 0;
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
    if (m_rest.compare(m_i, what.size(), what) != 0 || (goesOn && isSinumerik())) {
      return false;
    }
    m_i += what.size();
    return true;
  }
  void expect(std::string_view what) {
    check(accept(what), "'" + std::string(what) + "' missing in " + m_rest);
  }
  std::string identifier() {
    blanks();
    std::string name;
    while (isLetter(peek()) || (!name.empty() && isDigit(peek()))) {
      name += m_rest[m_i++];
    }
    return name;
  }
  double number() {
    blanks();
    std::string digits;
    while (isDigit(peek()) || peek() == '.' || (isPlain() && peek() == ',') ||
           (digits.empty() && (peek() == '+' || peek() == '-'))) {
      digits += peek() == ',' ? '.' : peek();
      ++m_i;
    }
    check(digits.find_first_of("0123456789") != std::string::npos, "number in " + m_rest);
    const bool scales = isSinumerik() && peek() == 'E' && peek(1) == 'X';
    m_i += scales ? 2 : 0;
    return numberAt(digits) * (scales ? std::pow(10.0, number()) : 1.0);
  }

  Value& variable(const std::string& name) {
    Values& own = level().variables;
    if (const auto local = own.find(name); local != own.end()) {
      return local->second;
    }
    if (isSinumerik() || isPlain()) {
      // What DEF of another program defines is not seen.
      check(isPlain() || (name[0] == 'R' && name.size() > 1 && isDigit(name[1])), name);
      return m_globals[name];
    }
    if (name[1] == '<') {
      return name[2] == '_' ? m_globals[name] : own[name];
    }
    const int index = std::atoi(name.c_str() + 1);
    check(index < (isFanuc() ? 1000 : 5001), name);  // those of the control
    m_vacant = {0.0, true};
    Values& where = index <= (isFanuc() ? 33 : 30) ? own : m_globals;
    return isFanuc() && index == 0 ? m_vacant
                                   : where.try_emplace(name, Value{0.0, isFanuc()}).first->second;
  }

  /// #5, #[#1+2], #<name>; behind "#".
  std::string hashName() {
    if (accept("<")) {
      const std::size_t end = m_rest.find('>', m_i);
      const std::string name = m_rest.substr(m_i, end - m_i);
      m_i = end + 1;
      return "#<" + name + ">";
    }
    return "#" + std::to_string(whole(primary()));
  }

  Value function(const std::string& name) {
    using Of = double (*)(double);
    // clang-format off
    static const std::map<std::string, Of> kFunctions{
        {"SIN", [](double x) { return std::sin(x * kDegree); }}, {"COS", [](double x) { return std::cos(x * kDegree); }},
        {"TAN", [](double x) { return std::tan(x * kDegree); }}, {"ASIN", [](double x) { return std::asin(x) / kDegree; }},
        {"ACOS", [](double x) { return std::acos(x) / kDegree; }}, {"SQRT", [](double x) { return std::sqrt(x); }},
        {"ABS", [](double x) { return std::abs(x); }}, {"EXP", [](double x) { return std::exp(x); }},
        {"LN", [](double x) { return std::log(x); }}, {"ROUND", [](double x) { return std::round(x); }},
        {"POT", [](double x) { return x * x; }}, {"TRUNC", [](double x) { return std::trunc(x); }},
        {"ROUNDUP", [](double x) { return std::ceil(x); }}, {"FIX", [](double x) { return std::trunc(x); }},
        {"FUP", [](double x) { return std::copysign(std::ceil(std::abs(x)), x); }}};  // LinuxCNC goes down and up
    // clang-format on
    std::vector<double> a;
    if (isPlain()) {
      a.push_back(primary().number);
    } else {
      expect(isSinumerik() ? "(" : "[");
      do {
        a.push_back(expression().number);
      } while (accept(","));
      expect(isSinumerik() ? ")" : "]");
    }
    if (const auto found = kFunctions.find(name); found != kFunctions.end()) {
      const bool isOwn = !isLinux() || (name != "FIX" && name != "FUP");
      if (name == "ROUND") {  // in a word of Fanuc to the least input increment
        return {std::round(a[0] / m_step) * m_step};
      }
      return {isOwn ? found->second(a[0]) : name == "FIX" ? std::floor(a[0]) : std::ceil(a[0])};
    }
    if (name == "ATAN" && !isSinumerik() && accept("/")) {
      const double angle = std::atan2(a[0], primary().number) / kDegree;
      return {isFanuc() && angle < 0.0 ? angle + 360.0 : angle};
    }
    check(isSinumerik() && a.size() == 2 && name == "ATAN2", name);
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
    if (accept(hasBrackets() ? "[" : "(")) {
      const Value value = expression();
      expect(hasBrackets() ? "]" : ")");
      return value;
    }
    if (accept("#")) {
      return variable(hashName());
    }
    std::string name;
    while (isLetter(peek()) || (!name.empty() && isDigit(peek()) && !hasBrackets())) {
      name += m_rest[m_i++];
    }
    check(!name.empty(), "value in " + m_rest);
    if (isSinumerik() && name == "NOT") {
      return {primary().number == 0.0 ? 1.0 : 0.0};
    }
    if (isSinumerik() && name == "R" && accept("[")) {
      name += std::to_string(whole(expression()));
      expect("]");
    }
    check(peek() != '[' || hasBrackets(), name + "[]");
    blanks();
    const bool isVariable = isSinumerik() ? peek() != '(' : isPlain() && isDigit(name.back());
    if (isVariable && (name == "TRUE" || name == "FALSE")) {
      return {name == "TRUE" ? 1.0 : 0.0};
    }
    return isVariable ? variable(name) : function(name);
  }

  [[nodiscard]] Value operate(const std::string& op, Value a, Value b) const {
    const double x = a.number;
    const double y = b.number;
    // SINUMERIK compares with a relative tolerance, LinuxCNC with 1e-6.
    const double near = isSinumerik() ? 1e-12 * std::max(std::abs(x), std::abs(y)) : 1e-6;
    const bool same = isFanuc() && (a.vacant || b.vacant)
                          ? a.vacant == b.vacant
                          : std::abs(x - y) <= (isFanuc() ? 0.0 : near);
    const bool bits = isFanuc() || startsWith(op, "B_");
    const bool tie = isFanuc() ? x == y : same;
    const auto p = static_cast<unsigned>(bits ? std::lround(x) : x != 0.0);
    const auto q = static_cast<unsigned>(bits ? std::lround(y) : y != 0.0);
    const double rest = op == "MOD" ? std::fmod(x, y) : 0.0;
    const bool more = x > y && (isFanuc() || !same);
    const bool less = x < y && (isFanuc() || !same);
    check(op != "/" || y != 0.0, "division by zero");
    // clang-format off
    const std::map<std::string, double> results{
        {"+", x + y}, {"-", x - y}, {"*", x * y}, {"/", x / y}, {"**", std::pow(x, y)}, {"^", std::pow(x, y)},
        {"DIV", isPlain() ? x / y : std::trunc(x / y)}, {"MOD", isLinux() && rest < 0.0 ? rest + std::abs(y) : rest},
        {"EQ", same}, {"EQU", same}, {"==", same}, {"NE", !same}, {"<>", !same}, {"GT", more}, {">", more},
        {"LT", less}, {"<", less}, {"GE", more || tie}, {">=", more || tie}, {"LE", less || tie}, {"<=", less || tie},
        {"AND", p & q}, {"OR", p | q}, {"XOR", p ^ q}};
    // clang-format on
    return {results.at(startsWith(op, "B_") ? op.substr(2) : op)};
  }

  /// Operators by their rank, those that bind least first; equal ranks from left to right.
  Value expression(std::size_t rank = 0) {
    using Ranks = std::vector<std::vector<std::string>>;
    // clang-format off
    static const Ranks kSinumerik{{"==", "<>", ">=", "<=", ">", "<"}, {"OR"}, {"XOR"}, {"AND"}, {"B_OR"}, {"B_XOR"}, {"B_AND"}, {"+", "-"}, {"*", "/", "DIV", "MOD"}};
    static const Ranks kFanuc{{"EQ", "NE", "GT", "GE", "LT", "LE"}, {"+", "-", "OR", "XOR"}, {"*", "/", "AND", "MOD"}};
    static const Ranks kLinux{{"AND", "OR", "XOR"}, {"EQ", "NE", "GT", "GE", "LT", "LE"}, {"+", "-"}, {"*", "/", "MOD"}, {"**"}};
    static const Ranks kPlain{{"EQU", "NE", "GT", "LT"}, {"+", "-"}, {"*", "/", "DIV"}, {"^"}};
    // clang-format on
    const Ranks& ranks = isSinumerik() ? kSinumerik
                         : isFanuc()   ? kFanuc
                         : isPlain()   ? kPlain
                                       : kLinux;
    if (rank == ranks.size()) {
      return primary();
    }
    Value value = expression(rank + 1);
    for (;;) {
      const auto op =
          std::find_if(ranks[rank].begin(), ranks[rank].end(), [this](const std::string& each) {
            return !(each == "*" && m_rest.compare(m_i, 2, "**") == 0) && accept(each);
          });
      if (op == ranks[rank].end()) {
        return value;
      }
      value = operate(*op, value, expression(rank + 1));
    }
  }

  // --- flow --------------------------------------------------------------------------------------

  Level& level() { return m_levels.back(); }

  /// @param direction  1: only forward, -1: only back, 0: forward, then from the beginning
  void jump(const std::string& label, int direction) {
    const std::vector<Line>& lines = level().text->lines;
    const auto is = [&label](const Line& line) { return line.label == label; };
    const auto here = lines.begin() + static_cast<std::ptrdiff_t>(level().at);
    auto found = direction >= 0 ? std::find_if(here, lines.end(), is) : lines.end();
    if (found == lines.end() && direction <= 0) {
      const auto back = std::find_if(std::make_reverse_iterator(here), lines.rend(), is);
      found = back == lines.rend() ? lines.end() : back.base() - 1;
    }
    check(found != lines.end(), "no label " + label);
    level().at = static_cast<std::size_t>(found - lines.begin());
  }

  void call(const Text* text, Values variables, int times, std::size_t at = 0, bool saves = false) {
    check(m_levels.size() < 60, "calls too deep");
    if (saves) {
      m_saved.push_back(m_modal);
    }
    if (times > 0) {
      m_levels.push_back({text, at, std::move(variables), {}, times - 1, at, saves, false});
    }
  }

  void leave() {
    if (m_levels.size() == 1) {
      m_ended = true;
      return;
    }
    if (level().repeats > 0) {
      --level().repeats;
      level().at = level().begin;
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
    const Frame frame = isSinumerik() ? m_saved.back().frame : m_modal.frame;
    const Modal now = m_modal;
    m_modal = m_saved.back();
    m_modal.frame = now.frame;
    // rs274 writes what has changed into a block: F with one decimal, S with none.
    const auto written = [this](double value, double before, double digits) {
      return isLinux() && value != before ? std::nearbyint(value * digits) / digits : value;
    };
    m_modal.feed = written(m_modal.feed / m_modal.feedUnit, now.feed / m_modal.feedUnit, 10.0) *
                   m_modal.feedUnit;
    m_modal.speed = written(m_modal.speed, now.speed, 1.0);
    setFrame(frame);
    m_saved.pop_back();
  }

  /// Which lines decide and repeat, and which belong together.
  void link(Text& text) const {
    static constexpr std::array<std::string_view, 16> kWords{
        "IF",  "WHILE", "FOR",    "LOOP",     "REPEAT",  "DO",    "ELSE",      "ELSEIF",
        "END", "ENDIF", "ENDFOR", "ENDWHILE", "ENDLOOP", "UNTIL", "ENDREPEAT", ""};
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
      Line& line = text.lines[i];
      const bool hasKey = isLinux() && line.text[0] == 'O';
      const std::size_t from = hasKey ? keyEnd(line.text) : 0;
      std::size_t to = from;
      while (to < line.text.size() && isLetter(line.text[to])) {
        ++to;
      }
      const std::string_view word = std::string_view(line.text).substr(from, to - from);
      const bool jumps = line.text.find("GOTO") != std::string::npos ||
                         line.text.find("THEN") != std::string::npos;
      const bool labels = isSinumerik() && word == "REPEAT" && to < line.text.size();
      const auto* const known = std::find(kWords.begin(), kWords.end() - 1, word);
      if (jumps || labels || known == kWords.end() - 1 || isPlain() || (isLinux() && !hasKey)) {
        continue;
      }
      line.behind = to;
      line.structure = *known;
      const auto rank = known - kWords.begin();
      const bool ends = rank >= 8 || (isLinux() && rank == 1 && !open.empty() &&
                                      text.lines[open.back()].structure == "DO");
      check(rank < 6 || !open.empty(), line.text);
      if (rank >= 6 || ends) {
        text.lines[open.back()].next = i;
        line.back = open.back();
        open.pop_back();
      }
      if (!ends) {
        open.push_back(i);
      }
    }
  }

  [[nodiscard]] static std::size_t keyEnd(const std::string& line) {
    return line.size() > 1 && line[1] == '<'
               ? line.find('>') + 1
               : std::min(line.find_first_not_of("0123456789", 1), line.size());
  }

  bool condition() { return (hasBrackets() ? primary() : expression()).number != 0.0; }

  /// @return true if the line was a statement of the flow
  bool flow(const Line& line) {
    const std::vector<Line>& lines = level().text->lines;
    const std::size_t here = level().at - 1;
    const std::string_view word = line.structure;
    begin(line.text);
    m_i = line.behind;
    if (word.empty()) {
      return isSinumerik() ? flowSinumerik()
             : isFanuc()   ? flowFanuc()
             : isLinux()   ? flowLinux(line.text)
                           : isPlain() && flowPlain(line.text);
    }
    if (word == "IF") {
      std::size_t at = here;
      while (!condition()) {
        at = lines[at].next;
        begin(lines[at].text);
        m_i = lines[at].behind;
        if (lines[at].structure != "ELSEIF") {
          break;
        }
      }
      level().at = at + 1;
    } else if (word == "ELSE" || word == "ELSEIF") {
      for (level().at = here; lines[level().at].next != 0; level().at = lines[level().at].next) {
      }
    } else if (word == "WHILE" && line.next == 0) {  // of DO
      level().at = condition() ? line.back + 1 : level().at;
    } else if (word == "UNTIL") {
      level().at = condition() ? level().at : line.back + 1;
    } else if (word == "WHILE") {
      level().at = condition() ? level().at : line.next + 1;
    } else if (word == "FOR") {
      Value& counter = variable(identifier());
      expect("=");
      const double from = expression().number;
      expect("TO");
      counter.number = level().counters.erase(here) != 0 ? counter.number + 1.0 : from;
      level().at = counter.number > expression().number ? line.next + 1 : level().at;
    } else if (word == "REPEAT" && isLinux()) {
      double& left = level().counters.try_emplace(here, whole(primary()) + 0.0).first->second;
      if (left-- < 1.0) {
        level().counters.erase(here);
        level().at = line.next + 1;
      }
    } else if (startsWith(word, "END") && word != "ENDIF") {
      level().at = line.back;
      if (word == "ENDFOR") {
        level().counters[line.back] = 1.0;
      }
    }
    return true;
  }

  std::optional<int> direction() {
    return accept("GOTOF")   ? std::optional(1)
           : accept("GOTOB") ? std::optional(-1)
           : accept("GOTO")  ? std::optional(0)
                             : std::nullopt;
  }

  /// REPEAT label P=3, CALL LBL 1 REP 3: back to the label so many times.
  void repeat(const std::string& label, double times) {
    const std::size_t here = level().at - 1;
    double& left = level().counters.try_emplace(here, times).first->second;
    if (left-- > 0.0) {
      jump(label, -1);
    } else {
      level().counters.erase(here);
    }
  }

  bool flowSinumerik() {
    if (accept("IF")) {
      const bool holds = condition();
      const std::optional<int> way = direction();
      const std::string label = identifier();
      check(way.has_value(), "IF");
      if (holds) {
        jump(label, *way);
      } else if (blanks()) {
        check(flowSinumerik(), m_rest);
      }
    } else if (const std::optional<int> way = direction()) {
      jump(identifier(), *way);
    } else if (accept("REPEAT")) {
      const std::string label = identifier();
      const double times = accept("P") ? (accept("="), expression().number) : 1.0;
      check(!blanks(), "REPEAT between labels");
      repeat(label, times);
    } else if (accept("DEF")) {
      const std::string type = identifier();
      check(isOneOf(type, {"REAL", "INT", "BOOL"}), "DEF " + type);
      do {
        const std::string name = identifier();
        check(!accept("["), "DEF " + name + "[]");
        level().variables[name] = {};
        const double value = accept("=") ? expression().number : 0.0;
        level().variables[name] = {type == "INT" ? std::round(value) : value};
      } while (accept(","));
    } else {
      return accept("EXTERN") || accept("PROC");
    }
    return true;
  }

  /// NAME, NAME(1,2), L100, with P3 behind.
  void callSinumerik(const std::string& name) {
    const Text* const text = findText(name);
    check(text != nullptr, name);
    std::vector<Value> given;
    if (accept("(")) {
      while (!accept(")")) {
        blanks();
        given.push_back(peek() == ',' || peek() == ')' ? Value{0.0, true} : expression());
        accept(",");
      }
    }
    const int times = accept("P") ? (accept("="), whole(expression())) : 1;
    const std::string rest = std::exchange(m_rest, text->lines.empty() ? "" : text->lines[0].text);
    const std::size_t at = std::exchange(m_i, 0);
    Values variables;
    const bool isProc = accept("PROC");
    const bool saves = isProc && m_rest.find("SAVE") != std::string::npos;
    identifier();
    for (std::size_t i = 0; isProc && accept(i == 0 ? "(" : ","); ++i) {
      const std::string type = identifier();
      check(type == "REAL" || type == "INT", "PROC " + type);
      const std::string own = identifier();
      const Value otherwise = accept("=") ? expression() : Value{};
      const Value value = i < given.size() && !given[i].vacant ? given[i] : otherwise;
      variables[own] = {type == "INT" ? std::round(value.number) : value.number};
    }
    m_rest = rest;
    m_i = at;
    call(text, std::move(variables), times, isProc ? 1 : 0, saves);
  }

  bool flowFanuc() {
    const bool decides = accept("IF");
    const bool holds = !decides || condition();
    if (accept("GOTO")) {
      const int to = whole(primary());
      if (holds) {
        jump("N" + std::to_string(to), 0);
      }
    } else if (decides) {
      expect("THEN");
      if (holds) {
        execute(wordsOf(m_rest.substr(m_i)));
      }
    }
    return decides || m_i > 0;
  }

  bool flowLinux(const std::string& line) {
    if (line[0] != 'O') {
      return false;
    }
    const std::string key = line.substr(0, keyEnd(line));
    check(key.size() > 1, "O with a calculated number");
    m_i = key.size();
    if (accept("ENDSUB") || accept("RETURN")) {
      m_globals["#<_VALUE>"] = peek() == '[' ? primary() : Value{};
      leave();
    } else if (accept("CALL")) {
      Values variables;
      for (int i = 1; accept("["); ++i) {
        variables["#" + std::to_string(i)] = expression();
        expect("]");
      }
      const Text* text = findText(key);
      if (text == nullptr &&
          findText(key[1] == '<' ? key.substr(2, key.size() - 3) : key.substr(1))) {
        text = findText(key);
      }
      check(text != nullptr, key + " CALL");
      call(text, variables, 1);
    } else {
      throw Stop{line};
    }
    return true;
  }

  bool flowPlain(const std::string& line) {
    if (accept("FN")) {  // FN 1: Q5 = +Q1 + +2, FN 9: IF +Q1 EQU +Q2 GOTO LBL 5
      const int kind = static_cast<int>(number());
      check(kind < 5 || (kind > 8 && kind < 13), "FN " + std::to_string(kind));
      expect(":");
    }
    if (accept("LBL")) {
      if (level().text->lines[level().at - 1].label == "0" && m_levels.size() > 1) {
        leave();
      }
    } else if (accept("CALL LBL")) {
      const std::size_t rep = line.find("REP");
      const std::string label = trimmed(line.substr(m_i, std::min(rep, line.size()) - m_i));
      if (rep != std::string::npos) {
        repeat(label, numberAt(line.substr(rep + 3)));
      } else {
        call(level().text, {}, 1, level().at);
        jump(label, 0);
      }
    } else if (accept("IF")) {
      const bool holds = expression().number != 0.0;
      expect("GOTO LBL");
      if (holds) {
        jump(trimmed(m_rest.substr(m_i)), 0);
      }
    } else if (blanks() && peek() == 'Q' && isDigit(peek(1))) {
      const std::string name = identifier();
      expect("=");
      const Value value = expression();
      check(!blanks(), m_rest);
      variable(name) = value;
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
      if (!hasBrackets()) {
        isPlain() ? plainWord(word) : sinumerikWord(word);
      } else if (accept("#")) {
        const std::string name = hashName();
        expect("=");
        m_deferred.emplace_back(name, expression());  // holds behind the block
        continue;
      } else {
        word.name = std::string(1, m_rest[m_i++]);
        m_step = isFanuc() ? (m_modal.unit == 1.0 ? 0.001 : 0.0001) : 1.0;
        word.value = primary();
        m_step = 1.0;
        word.hasValue = true;
      }
      if (!(isFanuc() && word.value.vacant && word.name != "G") && !word.name.empty()) {
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
    word.hasValue = peek() != ' ' && peek() != '\0';
    if (word.name == "DR") {
      word.value.number = m_rest[m_i++] == '+' ? 1.0 : -1.0;
    } else if (word.hasValue) {
      word.value = primary();
    }
  }

  /// X10, X=10, X=AC(10), CR=5, TRANS, NAME(1,2), R1=5.
  void sinumerikWord(Word& word) {
    static const std::vector<std::string> kNames{
        "TRANS",   "ATRANS", "ROT", "AROT", "SCALE",  "ASCALE", "MIRROR",
        "AMIRROR", "CIP",    "CT",  "RET",  "DIAMON", "DIAMOF", "CR",
        "AR",      "AP",     "RP",  "RPL",  "I1",     "J1",     "K1"};
    static const std::vector<std::string> kHarmless{"MSG",   "STOPRE", "SOFT", "BRISK", "FFWON",
                                                    "FFWOF", "COMPOF", "CFC",  "NORM",  "KONT"};
    const std::size_t from = m_i++;
    const bool isLong = isLetter(m_rest[from]) && isLetter(peek());
    while (isDigit(peek()) || (isLong && isLetter(peek()))) {
      ++m_i;
    }
    word.name = m_rest.substr(from, m_i - from);
    const bool assigns = accept("=");
    if (!assigns && !isLong) {
      m_i = from + 1;
      word = {m_rest.substr(from, 1), {number()}, true};
      if (word.name == "L") {
        callSinumerik(m_rest.substr(from, m_i - from));
      }
    } else if (!assigns && isOneOf(word.name, kHarmless)) {
      m_i = word.name == "MSG" ? m_rest.size() : m_i;
      word.name.clear();
    } else if (!assigns && !isOneOf(word.name, kNames)) {
      callSinumerik(word.name);
      word.name.clear();
    } else if (assigns) {
      for (const std::string reference : {"ACP", "ACN", "AC", "IC", "DC"}) {
        if (word.reference == 0 &&
            m_rest.compare(m_i, reference.size() + 1, reference + "(") == 0) {
          m_i += reference.size();
          word.reference = reference == "ACP" ? 'P' : reference == "ACN" ? 'N' : reference[0];
        }
      }
      const bool isText = accept("\"");  // T="MILL"
      m_i = isText ? m_rest.find('"', m_i) + 1 : m_i;
      word.value = isText ? Value{} : expression();
      word.hasValue = true;
      const bool isAddress =
          word.name.size() == 1 || isOneOf(word.name, kNames) ||
          (isDigit(word.name[1]) && (word.name[0] == 'M' || word.name[0] == 'S'));
      if (!isAddress) {
        variable(word.name) = word.value;
        word.name.clear();
      }
    }
  }

  void execute(const Words& words) {
    static const std::string kKnown = "GFSTDHMNXYZABCIJKR@^L";
    m_blockFeed = 0.0;
    bool taken = false;
    for (const Word& word : words) {
      if (word.name == "G") {
        taken |= gFunction(static_cast<int>(std::lround(word.value.number * 10.0)), words);
      } else if (word.name == "CIP" || word.name == "CT") {
        m_motion = word.name;
      } else if (isOneOf(word.name, {"TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR",
                                     "AMIRROR"})) {
        frameStatement(word.name, words);
        taken = true;
      } else if (word.name == "DIAMON" || word.name == "DIAMOF") {
        m_modal.diameter = word.name == "DIAMON";
      }
      m_modal.speed = word.name == "S" ? word.value.number : m_modal.speed;
    }
    const bool calls = std::any_of(words.begin(), words.end(), [](const Word& word) {
      const double number = word.value.number;
      return (word.name == "M" && (number == 98.0 || number == 99.0)) ||
             (word.name == "G" && number == 4.0);
    });
    for (const Word& word : words) {
      if (word.name == "F" && word.hasValue && !taken) {
        m_blockFeed = word.value.number;
        m_modal.feed = word.value.number * (m_modal.feedMode == 'I' ? 1.0 : m_modal.feedUnit);
      }
      const bool known = word.name.size() > 1 || kKnown.find(word.name) != std::string::npos;
      check(taken || known || (calls && (word.name == "P" || word.name == "L")), word.name);
    }
    if (!taken) {
      move(words);
    }
    for (const auto& [name, value] : std::exchange(m_deferred, {})) {
      variable(name) = value;
    }
    for (const Word& word : words) {
      if (word.name == "M") {
        mFunction(whole(word.value), words);
      } else if (word.name == "RET") {
        leave();
      }
    }
  }

  const Text* called(const Words& words) {
    const Word* const p = find(words, 'P');
    const Text* const text = p == nullptr ? nullptr : findText(std::to_string(whole(p->value)));
    check(text != nullptr, "a call without its program");
    return text;
  }
  static int timesOf(const Words& words) {
    const Word* const l = find(words, 'L');
    return l == nullptr ? 1 : whole(l->value);
  }

  /// @return true if the words of the block belong to it
  bool gFunction(int g, const Words& words) {
    const auto is = [g](std::initializer_list<int> each) {
      return std::find(each.begin(), each.end(), g) != each.end();
    };
    if (is({0, 10, 20, 30})) {
      m_motion = gName(g);
    } else if (is({170, 180, 190})) {
      m_modal.across = static_cast<std::size_t>((190 - g) / 10);
    } else if (is({900, 910})) {
      m_modal.relative = g == 910;
    } else if (isLinux() && is({901, 911})) {
      m_modal.centreAbsolute = g == 901;
    } else if (isSinumerik() ? is({700, 710, 7000, 7100}) : is({200, 210})) {
      m_modal.unit = is({200, 700, 7000}) ? 25.4 : 1.0;
      m_modal.feedUnit = is({200, 7000}) ? 25.4 : 1.0;
    } else if (is({930, 940, 950})) {
      const char mode = g == 930 ? 'I' : g == 940 ? 'M' : 'R';
      m_modal.feed = mode == m_modal.feedMode ? m_modal.feed : 0.0;
      m_modal.feedMode = mode;
    } else if (isLinux() && is({70, 80})) {
      m_modal.diameter = g == 70;
    } else if (isFanuc() && is({150, 160})) {
      m_modal.polar = g == 160;
    } else if (is({540, 550, 560, 570, 580, 590})) {
      check(m_moves.empty() || m_workOffset == g, gName(g));  // its values are not in the program
      m_workOffset = g;
    } else if (isSinumerik() && is({1100, 1110, 1120})) {
      setPole(g, words);
      return true;
    } else if (!isSinumerik() && (is({520, 920}) || (isFanuc() ? is({680, 690, 510, 500, 511, 501})
                                                               : is({921, 922, 923})))) {
      setOffset(g, words);
      return true;
    } else if (isFanuc() && g == 650) {
      callMacro(words);
      return true;
    } else {
      static const std::vector<int> kHarmless{40, 90, 400, 490, 600, 610, 640, 800};
      static const std::vector<int> kSinumerik{5000, 6010, 6020, 6030, 6410, 6420, 6430, 4500};
      static const std::vector<int> kOthers{430, 911, 670};
      static const std::vector<int> kLinux{430, 911, 970, 980, 990};
      const std::vector<int>& own = isSinumerik() ? kSinumerik : isFanuc() ? kOthers : kLinux;
      check(std::count(kHarmless.begin(), kHarmless.end(), g) +
                    std::count(own.begin(), own.end(), g) >
                0,
            gName(g));
      return (g == 40 && !isLinux()) || ((g == 640 || g == 610) && find(words, 'P') != nullptr);
    }
    return false;
  }

  /// G65: A B C … are #1 #2 #3 …, the second I J K are #7 #8 #9.
  void callMacro(const Words& words) {
    static const std::string kLetters = "ABCIJKDEF_H_M___QRSTUVWXYZ";
    Values variables;
    char last = 0;
    int triple = 0;
    for (const Word& word : words) {
      const char c = word.name[0];
      const std::size_t at = kLetters.find(c);
      const bool isTriple = c >= 'I' && c <= 'K';
      triple += isTriple && c <= last ? 3 : 0;
      last = isTriple ? c : last;
      if (at != std::string::npos) {
        const int index = static_cast<int>(at) + 1 + (isTriple ? triple : 0);
        variables["#" + std::to_string(index)] = word.value;
      }
    }
    call(called(words), variables, timesOf(words));
  }

  void mFunction(int number, const Words& words) {
    if (number == 2 || number == 30) {
      m_ended = true;
    } else if (isSinumerik() && number == 17) {
      leave();
    } else if (isFanuc() && number == 98) {
      call(called(words), level().variables, timesOf(words));
      level().shares = true;
    } else if (isFanuc() && number == 99) {
      check(m_levels.size() > 1, "M99");
      leave();
      if (const Word* const p = find(words, 'P')) {
        jump("N" + std::to_string(whole(p->value)), 0);
      }
    } else if (isLinux() && (number == 70 || number == 73)) {
      m_saved.push_back(m_modal);
      level().saves = number == 73;
    } else if (isLinux() && number == 72) {
      restore();
    } else {
      check(number < 10 || number == 13 || number == 19, "M" + std::to_string(number));
    }
  }

  // --- frames ------------------------------------------------------------------------------------

  /// The tool stays where it is.
  void setFrame(const Frame& frame) {
    m_at = frame.from(m_modal.frame.to(m_at));
    m_modal.frame = frame;
    m_stale.fill(isSinumerik());
  }

  void frameStatement(const std::string& name, const Words& words) {
    const std::string kind = name[0] == 'A' ? name.substr(1) : name;
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

  /// G52, G92 to G92.3 of controls that follow RS-274.
  void setOffset(int g, const Words& words) {
    check(!find(words, 'A') && !find(words, 'B') && !find(words, 'C'), gName(g));
    Vec3& local = isFanuc() ? m_local : m_set;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Word* const word = find(words, kAxes[axis]);
      const double half = axis == 0 && m_modal.diameter ? 0.5 : 1.0;
      const double value = word == nullptr ? 0.0 : word->value.number * m_modal.unit * half;
      if (g == 520 && word != nullptr) {
        local.set(axis, value);
      } else if (g == 920 && word != nullptr) {
        check(m_known[axis] && m_change == 0, "G92");
        m_set.set(axis, m_set[axis] + m_at[axis] - value);
      }
    }
    if (g == 680 || g == 510 || g == 511) {
      takeChange(g, words);
    }
    m_change = g == 690 || g == 500 || g == 501 ? 0 : m_change;
    m_kept = g == 922 ? m_set : g == 921 ? Vec3{} : m_kept;
    m_set = g == 921 || g == 922 ? Vec3{} : g == 923 ? m_kept : m_set;
    Frame frame;
    frame.shift(m_set + m_local);
    if (m_change != 0) {
      frame.shift(m_centre);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        frame.scale(axis, m_change == 510                       ? m_amount
                          : m_change == 511 && m_mirrored[axis] ? -1.0
                                                                : 1.0);
      }
      frame.turn(m_modal.across, m_change == 680 ? m_amount : 0.0);
      frame.shift(-1.0 * m_centre);
    }
    setFrame(frame);
  }

  /// G68 X Y R, G51 X Y Z P1.5, G51.1 X Y of Fanuc, about a place in the coordinates of the
  /// program.
  void takeChange(int g, const Words& words) {
    const Word* const amount = find(words, g == 680 ? 'R' : 'P');
    const bool hasPoint = m_rest.find('.', m_rest.find('P')) != std::string::npos;
    check(m_change == 0 && !m_modal.relative && (g == 680 || g == 511 || hasPoint), gName(g));
    check(g == 511 || amount != nullptr, gName(g));
    m_change = g;
    m_amount = amount != nullptr ? amount->value.number : 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Word* const word = find(words, kAxes[axis]);
      m_mirrored[axis] = word != nullptr;
      const bool counts = g != 680 || axis != m_modal.across;
      check(word != nullptr || !counts || m_known[axis] || g == 511, gName(g));
      m_centre.set(axis, word != nullptr      ? word->value.number * m_modal.unit
                         : counts && g != 511 ? m_at[axis]
                                              : 0.0);
    }
  }

  void setPole(int g, const Words& words) {
    Vec3 pole = g == 1100 ? m_at : g == 1120 ? m_pole : Vec3{};
    for (const Word& word : words) {
      const std::size_t axis = axisOf(word);
      check(axis < 3 || word.name == "G", gName(g) + " " + word.name);
      if (axis < 3) {
        pole.set(axis, pole[axis] + word.value.number * m_modal.unit);
      }
    }
    m_pole = pole;
    m_polarAngle = kNaN;
  }

  // --- moves -------------------------------------------------------------------------------------

  [[nodiscard]] std::size_t first() const { return (m_modal.across + 1) % 3; }
  [[nodiscard]] std::size_t second() const { return (m_modal.across + 2) % 3; }
  [[nodiscard]] bool isIncrement(const Word& word) const {
    return word.reference == 'I' || (m_modal.relative && word.reference == 0);
  }

  /// Where the block goes, programmed coordinates.
  Vec3 target(const Words& words) {
    Vec3 to = m_at;
    std::optional<double> radius;
    std::optional<double> angle;
    for (const Word& word : words) {
      const std::size_t axis = axisOf(word);
      const double value = word.value.number;
      if (word.name == "RP" || word.name == "@" || (m_modal.polar && axis == first())) {
        check(!isIncrement(word), word.name + " as an increment");
        radius = value * m_modal.unit;
      } else if (word.name == "AP" || word.name == "^" || (m_modal.polar && axis == second())) {
        check(!isIncrement(word) || !std::isnan(m_polarAngle), word.name + " as an increment");
        angle = value + (isIncrement(word) ? m_polarAngle : 0.0);
      } else if (axis < 3) {
        const double half = axis == 0 && m_modal.diameter ? 0.5 : 1.0;
        check(!isIncrement(word) || (m_known[axis] && !m_stale[axis]),
              "an increment from an unknown place");
        to.set(axis, value * m_modal.unit * half + (isIncrement(word) ? m_at[axis] : 0.0));
        m_stale[axis] = false;
        m_known[axis] = true;
      }
    }
    if (radius || angle) {
      const Vec3 pole = hasBrackets() ? Vec3{} : m_pole;
      const std::size_t u = first();
      const std::size_t v = second();
      const double length = radius.value_or(std::hypot(m_at[u] - pole[u], m_at[v] - pole[v]));
      check(angle || isSinumerik(), "a radius without an angle");
      m_polarAngle = angle ? *angle : std::isnan(m_polarAngle) ? 0.0 : m_polarAngle;
      to.set(u, pole[u] + length * std::cos(m_polarAngle * kDegree));
      to.set(v, pole[v] + length * std::sin(m_polarAngle * kDegree));
      m_stale[u] = m_stale[v] = false;
      m_known[u] = m_known[v] = true;
    }
    return to;
  }

  void turnAxes(const Words& words) {
    for (const Word& word : words) {
      const std::size_t axis = axisOf(word, "ABC");
      if (axis < 3) {
        const double now = m_turned[axis];
        const double way = std::fmod(std::fmod(word.value.number - now, 360.0) + 360.0, 360.0);
        const char reference = word.reference;
        const double shown = std::fmod(std::fmod(now, 360.0) + 360.0, 360.0);
        m_turned[axis] = reference == 'P'   ? now + way
                         : reference == 'N' ? now + way - (way > 0.0 ? 360.0 : 0.0)
                         : reference == 'D' ? now + way - (way > 180.0 ? 360.0 : 0.0)
                                            : word.value.number + (isIncrement(word) ? now
                                                                   : m_modulo[axis]  ? now - shown
                                                                                     : 0.0);
        // An axis for which these have a meaning counts from 0 to 360.
        m_modulo[axis] |= reference == 'P' || reference == 'N' || reference == 'D';
      }
    }
  }

  [[nodiscard]] static bool namesAxis(const Word& word) {
    return axisOf(word, "XYZABC@^") < 8 || word.name == "AP" || word.name == "RP";
  }

  void move(const Words& words) {
    const bool axes = std::any_of(words.begin(), words.end(), namesAxis);
    const bool isArc = m_motion == "G2" || m_motion == "G3";
    const bool centre =
        find(words, 'I') || find(words, 'J') || find(words, 'K') || find(words, "AR");
    check(isArc || !centre, "I J K without an arc");
    if (!axes && !centre) {
      return;
    }
    if (isPlain()) {  // IPA counts from where the tool stands
      const Vec3 arm = m_at - m_pole;
      m_polarAngle = std::atan2(arm[second()], arm[first()]) / kDegree;
    }
    const Vec3 end = target(words);
    turnAxes(words);
    const Word* const turn = find(words, "DR");
    const bool counter = turn != nullptr ? turn->value.number > 0.0 : m_motion == "G3";
    if (m_motion == "C" || m_motion == "CP") {
      const Word* const angle = find(words, "AP");
      const bool counts = angle != nullptr && angle->reference == 'I';
      const double sweep = counts ? std::abs(angle->value.number) : 0.0;
      check(sweep <= 360.0, "more than a turn");
      arcAbout(m_pole, end, counter, sweep == 360.0);
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
    const double length = base::distance(m_modal.frame.to(end), m_modal.frame.to(m_at));
    m_direction = length > 0.0 ? end - m_at : m_direction;
    finish(made, end, length);
  }

  void finish(EvaluatedMove made, Vec3 end, double lengthMm) {
    const Vec3 place = m_modal.frame.to(end);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      made.end[axis] = m_known[axis] ? place[axis] : kNaN;
      made.end[axis + 3] = m_turned[axis];
    }
    made.feed = made.kind == EvaluatedMove::Kind::Rapid ? 0.0
                : m_modal.feedMode == 'R'               ? m_modal.feed * m_modal.speed
                : m_modal.feedMode == 'I'               ? m_blockFeed * lengthMm
                                                        : m_modal.feed;
    made.feed /= lengthMm == 0.0 && m_modal.feedMode == 'M' ? m_modal.feedUnit : 1.0;  // degrees
    made.line = m_line;
    m_at = end;
    m_moves.push_back(made);
  }

  /// G2 and G3, from the words that say where the centre is.
  void arc(const Words& words, Vec3 end, bool counter) {
    const std::size_t u = first();
    const std::size_t v = second();
    const Word* const r = find(words, isSinumerik() ? "CR" : "R");
    const Word* const angle = find(words, "AR");
    check(!find(words, "TURN") && !find(words, 'P'), "more than a turn");
    check(m_known[u] && m_known[v], "an arc from an unknown place");
    Vec3 centre = m_at;
    bool given = false;
    for (const std::size_t axis : {u, v}) {
      if (const Word* const word = find(words, "IJK"[axis])) {
        const bool absolute =
            word->reference == 'A' || (m_modal.centreAbsolute && word->reference == 0);
        centre.set(axis, word->value.number * m_modal.unit + (absolute ? 0.0 : m_at[axis]));
        given = true;
      }
    }
    const Vec3 way = end - m_at;
    const double chord = std::hypot(way[u], way[v]);
    const double sign = counter ? 1.0 : -1.0;
    if (r != nullptr || (angle != nullptr && !given)) {
      const double half = angle != nullptr ? angle->value.number * kDegree / 2.0 : 0.0;
      const double radius =
          r != nullptr ? r->value.number * m_modal.unit : chord / 2.0 / std::sin(half);
      const double up = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4.0));
      check(chord > 0.0 && std::abs(radius) >= chord / 2.0 - 0.01, "R");
      const bool large = r != nullptr ? radius < 0.0 : angle->value.number > 180.0;
      const double side = (large ? -sign : sign) * up / chord;
      centre.set(u, m_at[u] + way[u] / 2.0 - way[v] * side);
      centre.set(v, m_at[v] + way[v] / 2.0 + way[u] * side);
    } else if (find(words, "AP") != nullptr && !given) {
      centre = m_pole;
    } else {
      check(given, "an arc without a centre");
      if (angle != nullptr) {
        Frame turn;
        turn.turn(m_modal.across, sign * angle->value.number);
        const Vec3 arm = turn.to(m_at - centre);
        end.set(u, centre[u] + arm[u]);
        end.set(v, centre[v] + arm[v]);
      }
    }
    arcAbout(centre, end, counter);
  }

  /// In the plane, from where the tool stands.
  void arcAbout(Vec3 centre, Vec3 end, bool counter, bool isFull = false) {
    const std::size_t u = first();
    const std::size_t v = second();
    isFull |= std::hypot(end[u] - m_at[u], end[v] - m_at[v]) < 1e-9;
    end.set(u, isFull ? m_at[u] : end[u]);
    end.set(v, isFull ? m_at[v] : end[v]);
    centre.set(m_modal.across, m_at[m_modal.across]);
    Vec3 axis;
    axis.set(m_modal.across, counter ? 1.0 : -1.0);
    circle(centre, axis, end, isFull);
  }

  /// About an axis through the centre; the end may stand higher along it.
  void circle(Vec3 centre, Vec3 axis, Vec3 end, bool isFull) {
    const Frame& frame = m_modal.frame;
    const double scale = base::norm(frame.columns[0]);
    const Vec3 arm = m_at - centre;
    const double rise = base::dot(end - m_at, axis);
    const Vec3 to = end - centre - rise * axis;
    check(frame.isEven(), "an arc that becomes an ellipse");
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
    Vec3 centre;
    Vec3 axis;
    if (m_motion == "CIP") {
      Vec3 middle = m_at;
      for (std::size_t i = 0; i < 3; ++i) {
        if (const Word* const word = find(words, std::string(1, "IJK"[i]) + "1")) {
          middle.set(i, word->value.number * m_modal.unit + (isIncrement(*word) ? m_at[i] : 0.0));
        }
      }
      const Vec3 a = middle - m_at;
      axis = base::cross(a, way);
      centre = m_at + 1.0 / (2.0 * base::dot(axis, axis)) *
                          (base::dot(a, a) * base::cross(way, axis) +
                           base::dot(way, way) * base::cross(axis, a));
    } else {
      axis = base::cross(m_direction, way);
      const Vec3 normal = base::cross(axis, m_direction);
      centre = m_at + base::dot(way, way) / (2.0 * base::dot(normal, way)) * normal;
    }
    check(base::norm(axis) > 0.0, m_motion + " without a circle");
    circle(centre, 1.0 / base::norm(axis) * axis, end, false);
  }

  // --- Heidenhain --------------------------------------------------------------------------------

  void plainBlock(const std::string& line) {
    const std::string head = line.substr(0, line.find(' '));
    const std::string rest = line.substr(std::min(head.size(), line.size()));
    if (startsWith(line, "BEGIN PGM")) {
      check(!line.ends_with("INCH"), "INCH");
    } else if (startsWith(line, "TOOL CALL")) {
      const std::size_t axis = line.find_first_of(kAxes, 10);
      m_modal.across = axis == std::string::npos ? m_modal.across : kAxes.find(line[axis]);
      const std::size_t feed = line.find(" F");
      m_modal.feed = feed == std::string::npos ? m_modal.feed : numberAt(line.substr(feed + 2));
    } else if (startsWith(line, "CYCL DEF")) {
      plainFrame(trimmed(line.substr(8)));
    } else if (head == "CC") {
      const Words words = wordsOf(rest);
      m_pole = words.empty() ? m_at : m_pole;
      for (const Word& word : words) {
        const std::size_t axis = axisOf(word);
        check(axis < 3, "CC " + word.name);
        m_pole.set(axis, word.value.number + (word.reference == 'I' ? m_at[axis] : 0.0));
      }
    } else if (isOneOf(head, {"L", "LP", "C", "CP", "CR", "CT"})) {
      m_motion = head;
      execute(wordsOf(rest));
    } else if (isOneOf(head, {"M30", "M2", "M02", "END"})) {
      m_ended = true;
    } else {
      check(isOneOf(head, {"BLK", "STOP", "M0", "M1", "M3", "M4", "M5", "M8", "M9"}) ||
                head[0] == '*',
            head);
    }
  }

  /// CYCL DEF 7 (datum shift), 8 (mirror image), 10 (rotation): each holds until it is set again.
  void plainFrame(const std::string& text) {
    const int cycle = std::atoi(text.c_str());
    check(cycle == 7 || cycle == 8 || cycle == 10, "CYCL DEF " + std::to_string(cycle));
    m_mirrored = cycle == 8 ? std::array<bool, 3>{} : m_mirrored;
    const std::size_t blank = text.find(' ');
    begin(startsWith(text, std::to_string(cycle) + ".0") || blank == std::string::npos
              ? ""
              : text.substr(blank));
    while (blanks()) {
      std::string name;
      while (isLetter(peek())) {
        name += m_rest[m_i++];
      }
      const std::size_t axis = kAxes.find(name.back());
      check(axis < 3 || name.ends_with("ROT"), "CYCL DEF " + name);
      if (cycle == 8) {
        m_mirrored.at(axis) = true;
      } else if (cycle == 7) {
        m_local.set(axis, primary().number + (name[0] == 'I' ? m_local[axis] : 0.0));
      } else {
        m_turnedBy = primary().number + (name[0] == 'I' ? m_turnedBy : 0.0);
      }
    }
    Frame frame;
    frame.shift(m_local);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      frame.scale(axis, m_mirrored[axis] ? -1.0 : 1.0);
    }
    frame.turn(m_modal.across, m_turnedBy);
    setFrame(frame);
  }

  Control m_control;
  const Beside& m_beside;
  std::vector<std::unique_ptr<Text>> m_texts;
  Text* m_current = nullptr;  ///< to which lines are added
  Text* m_outer = nullptr;
  int m_marks = 0;  ///< "%" begins and ends a text
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
  std::array<double, 3> m_turned{kNaN, kNaN, kNaN};
  std::array<bool, 3> m_modulo{};
  Vec3 m_direction;
  Vec3 m_pole;
  double m_polarAngle = kNaN;
  Vec3 m_set;        ///< G92, and G52 of LinuxCNC
  Vec3 m_kept;       ///< of G92.2
  Vec3 m_local;      ///< G52, CYCL DEF 7
  int m_change = 0;  ///< G68, G51 or G51.1 that holds
  Vec3 m_centre;
  double m_amount = 0.0;
  double m_turnedBy = 0.0;  ///< CYCL DEF 10
  std::array<bool, 3> m_mirrored{};
  int m_workOffset = 0;
  std::array<bool, 3> m_stale{};  ///< an increment would count from before a change of the frame
  double m_blockFeed = 0.0;
  std::vector<EvaluatedMove> m_moves;
};

}  // namespace

Evaluation evaluate(std::string_view control, std::string_view text,
                    const std::function<std::optional<std::string>(std::string_view)>& beside) {
  static const std::map<std::string_view, Control> kControls{
      {"sinumerik", Control::Sinumerik}, {"fanuc", Control::Fanuc},
      {"haas", Control::Haas},           {"linuxcnc", Control::LinuxCnc},
      {"grbl", Control::Grbl},           {"heidenhain", Control::Heidenhain}};
  return Evaluator(kControls.at(control), beside).run(text);
}

}  // namespace rivulet::tests
