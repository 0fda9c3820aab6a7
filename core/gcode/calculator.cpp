// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/calculator.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "base/contract.h"
#include "base/text.h"

namespace rivulet::gcode {

namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr int kDepthMax = 60;
constexpr int kArrayElementsMax = 100'000;
constexpr double kSinumerikEquality = 1e-12;  // relative, as on the control
constexpr double kLinuxCncEquality = 1e-4;    // absolute, as in RS-274/NGC
constexpr int kLocalNumberMax = 33;

/// What a variable holds whose value could not be computed: all that is made of it fails as well.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

using base::isBlank;
using base::isDigit;
using base::isNameLetter;

std::int64_t asBits(double value) {
  return std::isnan(value) ? 0 : static_cast<std::int64_t>(std::clamp(value, -9.0e18, 9.0e18));
}

enum class Op : unsigned char {
  Or,
  Xor,
  And,
  BitOr,
  BitXor,
  BitAnd,
  Equal,
  Unequal,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Add,
  Subtract,
  Multiply,
  Divide,
  IntegerDivide,
  Modulo,
  Power,
};

struct OpWord {
  std::string_view word;
  Op op;
};

/// Weakest level first; longer words before their beginnings.
using Level = std::span<const OpWord>;

constexpr std::array kComparisons{OpWord{"==", Op::Equal},     OpWord{"<>", Op::Unequal},
                                  OpWord{"<=", Op::LessEqual}, OpWord{">=", Op::GreaterEqual},
                                  OpWord{"<", Op::Less},       OpWord{">", Op::Greater}};
constexpr std::array kOr{OpWord{"OR", Op::Or}};
constexpr std::array kXor{OpWord{"XOR", Op::Xor}};
constexpr std::array kAnd{OpWord{"AND", Op::And}};
constexpr std::array kBitOr{OpWord{"B_OR", Op::BitOr}};
constexpr std::array kBitXor{OpWord{"B_XOR", Op::BitXor}};
constexpr std::array kBitAnd{OpWord{"B_AND", Op::BitAnd}};
constexpr std::array kSums{OpWord{"+", Op::Add}, OpWord{"-", Op::Subtract}};
constexpr std::array kProducts{OpWord{"*", Op::Multiply}, OpWord{"/", Op::Divide},
                               OpWord{"DIV", Op::IntegerDivide}, OpWord{"MOD", Op::Modulo}};
constexpr std::array<Level, 9> kSinumerikLevels{kComparisons, kOr,     kXor,  kAnd,     kBitOr,
                                                kBitXor,      kBitAnd, kSums, kProducts};

constexpr std::array kIsoLogic{OpWord{"AND", Op::And}, OpWord{"XOR", Op::Xor},
                               OpWord{"OR", Op::Or}};
constexpr std::array kIsoComparisons{OpWord{"EQ", Op::Equal},     OpWord{"NE", Op::Unequal},
                                     OpWord{"LE", Op::LessEqual}, OpWord{"GE", Op::GreaterEqual},
                                     OpWord{"LT", Op::Less},      OpWord{"GT", Op::Greater}};
constexpr std::array kPowers{OpWord{"**", Op::Power}};
constexpr std::array<Level, 5> kIsoLevels{kIsoLogic, kIsoComparisons, kSums, kProducts, kPowers};

}  // namespace

/// Recursive descent, evaluated on the way.
class Calculator::Parser {
 public:
  Parser(Calculator& owner, std::string_view text)
      : m_owner(owner),
        m_text(text),
        m_names(owner.m_dialect == Dialect::Sinumerik),
        m_levels(m_names ? std::span<const Level>(kSinumerikLevels)
                         : std::span<const Level>(kIsoLevels)) {}

  std::optional<double> expression() { return level(0); }
  [[nodiscard]] std::string_view rest() const { return m_text.substr(m_at); }

  void skipBlanks() {
    while (m_at < m_text.size() && isBlank(m_text[m_at])) {
      ++m_at;
    }
  }

  [[nodiscard]] char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

  bool take(char c) {
    skipBlanks();
    if (peek() != c) {
      return false;
    }
    ++m_at;
    return true;
  }

  std::nullopt_t fail(std::string problem) {
    if (m_owner.m_problem.empty()) {
      m_owner.m_problem = std::move(problem);
    }
    return std::nullopt;
  }

  std::string name() {
    skipBlanks();
    std::size_t end = m_at;
    while (end < m_text.size() &&
           (isNameLetter(m_text[end]) || (end > m_at && isDigit(m_text[end])))) {
      ++end;
    }
    std::string found = base::toUpper(m_text.substr(m_at, end - m_at));
    m_at = end;
    return found;
  }

  /// #5, ##2, #[expr], #<name>: the variable itself. @return null if there is none; see problem
  double* hashVariable(bool create) {
    if (!take('#')) {
      fail("a variable begins with #");
      return nullptr;
    }
    skipBlanks();
    if (peek() == '<') {
      const std::size_t end = m_text.find('>', m_at);
      if (end == std::string_view::npos) {
        fail("the name of a variable is not closed with >");
        return nullptr;
      }
      std::string key;
      for (const char c : m_text.substr(m_at + 1, end - m_at - 1)) {
        if (!isBlank(c)) {
          key += c;
        }
      }
      key = "<" + base::toUpper(key) + ">";
      m_at = end + 1;
      Scope& scope = key.rfind("<_", 0) == 0 ? m_owner.m_globals : m_owner.scope();
      auto found = scope.names.find(key);
      if (found == scope.names.end()) {
        if (!create) {
          return system("#" + key);
        }
        found = scope.names.emplace(key, Variable{{}, {0.0}, {}, false, false}).first;
      }
      return found->second.values.data();
    }
    std::optional<double> index;
    if (peek() == '#') {
      const double* const inner = hashVariable(false);
      index = inner == nullptr ? std::nullopt : std::optional(*inner);
    } else if (take('[')) {
      index = level(0);
      if (index && !take(']')) {
        index = fail("a bracket is not closed");
      }
    } else {
      if (isNameLetter(peek())) {
        fail(fmt::format("#{} is no variable", name()));
        return nullptr;
      }
      index = number();
    }
    if (!index || !(*index >= 0.0 && *index < 100000.0)) {
      fail("the number of a variable is missing or too large");
      return nullptr;
    }
    const int number = static_cast<int>(std::lround(*index));
    double* const value = m_owner.numbered(number, create);
    if (value == nullptr) {
      return system(fmt::format("#{}", number));
    }
    return value;
  }

  /// [1,2] behind an array's name: the place of the element. @return -1: see problem
  int element(const Variable& variable) {
    int index = 0;
    if (!take('[')) {
      fail("an array needs its index in brackets");
      return -1;
    }
    for (std::size_t dimension = 0; dimension < variable.sizes.size(); ++dimension) {
      if (dimension > 0 && !take(',')) {
        fail("the array has more dimensions");
        return -1;
      }
      const std::optional<double> value = level(0);
      if (!value || !(*value > -0.5 && *value < variable.sizes[dimension] - 0.5)) {
        fail("the index lies outside the array");
        return -1;
      }
      index = index * variable.sizes[dimension] + static_cast<int>(std::lround(*value));
    }
    if (!take(']')) {
      fail("a bracket is not closed");
      return -1;
    }
    return index;
  }

 private:
  double* system(const std::string& key) {
    const std::optional<double> value =
        m_owner.m_systemValues ? m_owner.m_systemValues(key) : std::nullopt;
    if (!value) {
      fail(fmt::format("the value of {} is known on the control only", key));
      return nullptr;
    }
    m_system = *value;
    return &m_system;
  }

  std::optional<double> level(std::size_t index) {
    if (index == m_levels.size()) {
      return unary();
    }
    std::optional<double> left = level(index + 1);
    while (left) {
      const auto found = std::find_if(m_levels[index].begin(), m_levels[index].end(),
                                      [this](const OpWord& word) { return takeWord(word.word); });
      if (found == m_levels[index].end()) {
        return left;
      }
      const std::optional<double> right = level(index + 1);
      if (!right) {
        return fail("an operand is missing");
      }
      left = apply(found->op, *left, *right);
    }
    return left;
  }

  bool takeWord(std::string_view word) {
    std::size_t begin = m_at;
    while (begin < m_text.size() && isBlank(m_text[begin])) {
      ++begin;
    }
    if (m_text.size() - begin < word.size()) {
      return false;
    }
    for (std::size_t i = 0; i < word.size(); ++i) {
      const char c = m_text[begin + i];
      if ((c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c) != word[i]) {
        return false;
      }
    }
    const std::size_t end = begin + word.size();
    // "MODE" is not MOD; "*" of "**" is not a product. In ISO programs "EQ2" is EQ and 2.
    if (m_names && isNameLetter(word.back()) && end < m_text.size() &&
        (isNameLetter(m_text[end]) || isDigit(m_text[end]))) {
      return false;
    }
    if (word == "*" && end < m_text.size() && m_text[end] == '*') {
      return false;
    }
    m_at = end;
    return true;
  }

  [[nodiscard]] bool equal(double a, double b) const {
    return m_names ? std::abs(a - b) <= kSinumerikEquality * std::max(std::abs(a), std::abs(b))
                   : std::abs(a - b) < kLinuxCncEquality;
  }

  std::optional<double> apply(Op op, double a, double b) {
    const auto truth = [](bool value) { return std::optional(value ? 1.0 : 0.0); };
    const bool divides = op == Op::Divide || op == Op::IntegerDivide || op == Op::Modulo;
    if (divides && b == 0.0) {
      return fail("a division by zero");
    }
    switch (op) {
      case Op::Or:
        return truth(a != 0.0 || b != 0.0);
      case Op::Xor:
        return truth((a != 0.0) != (b != 0.0));
      case Op::And:
        return truth(a != 0.0 && b != 0.0);
      case Op::BitOr:
        return static_cast<double>(asBits(a) | asBits(b));
      case Op::BitXor:
        return static_cast<double>(asBits(a) ^ asBits(b));
      case Op::BitAnd:
        return static_cast<double>(asBits(a) & asBits(b));
      case Op::Equal:
        return truth(equal(a, b));
      case Op::Unequal:
        return truth(!equal(a, b));
      case Op::Less:
        return truth(a < b && !(m_names && equal(a, b)));
      case Op::LessEqual:
        return truth(a < b || equal(a, b));
      case Op::Greater:
        return truth(a > b && !(m_names && equal(a, b)));
      case Op::GreaterEqual:
        return truth(a > b || equal(a, b));
      case Op::Add:
        return a + b;
      case Op::Subtract:
        return a - b;
      case Op::Multiply:
        return a * b;
      case Op::Divide:
        return a / b;
      case Op::IntegerDivide:
        return std::trunc(a / b);
      case Op::Modulo: {
        const double rest = std::fmod(a, b);
        // RS-274/NGC gives a rest that is never negative.
        return !m_names && rest < 0.0 ? rest + std::abs(b) : rest;
      }
      case Op::Power:
        return std::pow(a, b);
    }
    base::contractViolated("every operator has a meaning", __FILE__, __LINE__);
  }

  std::optional<double> unary() {
    if (++m_depth > kDepthMax) {
      return fail("the calculation is nested too deeply");
    }
    const std::optional<double> value = unaryInner();
    --m_depth;
    return value;
  }

  std::optional<double> unaryInner() {
    if (take('-')) {
      const std::optional<double> value = unary();
      return value ? std::optional(-*value) : std::nullopt;
    }
    if (take('+')) {
      return unary();
    }
    if (m_names && takeWord("B_NOT")) {
      const std::optional<double> value = unary();
      return value ? std::optional(static_cast<double>(~asBits(*value))) : std::nullopt;
    }
    if (m_names && takeWord("NOT")) {
      const std::optional<double> value = unary();
      return value ? std::optional(*value == 0.0 ? 1.0 : 0.0) : std::nullopt;
    }
    return primary();
  }

  std::optional<double> primary() {
    skipBlanks();
    const char c = peek();
    if (isDigit(c) || c == '.') {
      return number();
    }
    if (c == (m_names ? '(' : '[')) {
      ++m_at;
      const std::optional<double> value = level(0);
      return !value || take(m_names ? ')' : ']') ? value : fail("a bracket is not closed");
    }
    if (c == '#' && !m_names) {
      const double* const value = hashVariable(false);
      return value == nullptr ? std::nullopt : std::optional(*value);
    }
    if (c == '$') {
      return systemVariable();
    }
    if (c == '\'') {
      return bits();
    }
    if (!isNameLetter(c)) {
      return fail(c == '\0' ? "a value is missing" : fmt::format("\"{}\" is no value", c));
    }
    return named();
  }

  std::optional<double> number() {
    const std::size_t from = m_at;
    while (m_at < m_text.size() && (isDigit(m_text[m_at]) || m_text[m_at] == '.')) {
      ++m_at;
    }
    std::string literal(m_text.substr(from, m_at - from));
    // The exponent is written EX: 8.2EX-3.
    if (m_names && m_at + 1 < m_text.size() && base::toUpper(m_text.substr(m_at, 2)) == "EX") {
      std::size_t end = m_at + 2;
      if (end < m_text.size() && (m_text[end] == '-' || m_text[end] == '+')) {
        ++end;
      }
      while (end < m_text.size() && isDigit(m_text[end])) {
        ++end;
      }
      literal += "e" + std::string(m_text.substr(m_at + 2, end - m_at - 2));
      m_at = end;
    }
    const std::optional<double> value = base::parseNumber(literal);
    return value ? value : fail(fmt::format("\"{}\" is no number", literal));
  }

  /// $AA_IW[X], $P_EP[Y]
  std::optional<double> systemVariable() {
    std::string key(1, m_text[m_at++]);
    key += name();
    if (take('[')) {
      const std::size_t end = m_text.find(']', m_at);
      key += "[" + base::toUpper(base::trim(m_text.substr(m_at, end - m_at))) + "]";
      m_at = end == std::string_view::npos ? m_text.size() : end + 1;
    }
    const double* const value = system(key);
    return value == nullptr ? std::nullopt : std::optional(*value);
  }

  /// 'H1F' and 'B101'.
  std::optional<double> bits() {
    const std::size_t end = m_text.find('\'', m_at + 1);
    const std::string digits =
        base::toUpper(m_text.substr(m_at + 1, end == std::string_view::npos ? 0 : end - m_at - 1));
    const std::size_t base = digits.size() < 2 ? 0
                                               : (digits[0] == 'H'   ? 16
                                                  : digits[0] == 'B' ? 2
                                                                     : 0);
    double value = 0.0;
    for (std::size_t i = 1; i < digits.size(); ++i) {
      const std::size_t digit = std::string_view("0123456789ABCDEF").find(digits[i]);
      if (digit >= base) {
        return fail("a constant in quotes has digits it must not have");
      }
      value = static_cast<double>(base) * value + static_cast<double>(digit);
    }
    if (base == 0) {
      return fail("a constant in quotes begins with H or B");
    }
    m_at = end + 1;
    return value;
  }

  std::optional<double> named() {
    const std::size_t from = m_at;
    const std::string key = name();
    if (m_names) {
      if (key == "TRUE" || key == "FALSE") {
        return key == "TRUE" ? 1.0 : 0.0;
      }
      if (key == "R" ||
          (key.size() > 1 && key[0] == 'R' && std::all_of(key.begin() + 1, key.end(), isDigit))) {
        if (m_owner.find(key) == nullptr) {
          return rParameter(key);
        }
      }
      if (const Variable* variable = m_owner.find(key)) {
        return valueOf(*variable);
      }
    }
    if (const std::optional<double> value = function(key)) {
      return value;
    }
    m_at = m_at == from ? from + 1 : m_at;
    return fail(fmt::format("{} is no variable and no function", key));
  }

  std::optional<double> rParameter(const std::string& key) {
    std::optional<double> index;
    if (key == "R") {
      if (!take('[')) {
        return fail("R needs a number or an index in brackets");
      }
      index = level(0);
      if (!index || !take(']')) {
        return fail("the index of R is not closed");
      }
    } else {
      index = base::parseNumber(std::string_view(key).substr(1));
    }
    if (!index || !(*index > -0.5 && *index < 1e6)) {
      return fail("the index of R is out of range");
    }
    const int number = static_cast<int>(std::lround(*index));
    const auto found = m_owner.m_r.find(number);
    if (found == m_owner.m_r.end()) {
      return fail(
          fmt::format("R{} is read before the program sets it: only the control knows it", number));
    }
    return found->second;
  }

  std::optional<double> valueOf(const Variable& variable) {
    if (variable.isString) {
      return fail("a text is calculated with");
    }
    if (variable.sizes.empty()) {
      return variable.values.front();
    }
    const int index = element(variable);
    return index < 0 ? std::nullopt
                     : std::optional(variable.values[static_cast<std::size_t>(index)]);
  }

  std::optional<double> function(const std::string& key) {
    struct Function {
      std::string_view name;
      int arguments;
    };
    static constexpr std::array kSinumerik{
        Function{"SIN", 1},  Function{"COS", 1},   Function{"TAN", 1},    Function{"ASIN", 1},
        Function{"ACOS", 1}, Function{"ATAN2", 2}, Function{"SQRT", 1},   Function{"POT", 1},
        Function{"ABS", 1},  Function{"TRUNC", 1}, Function{"ROUND", 1},  Function{"ROUNDUP", 1},
        Function{"LN", 1},   Function{"EXP", 1},   Function{"MINVAL", 2}, Function{"MAXVAL", 2},
        Function{"BOUND", 3}};
    static constexpr std::array kIso{Function{"SIN", 1},  Function{"COS", 1},   Function{"TAN", 1},
                                     Function{"ASIN", 1}, Function{"ACOS", 1},  Function{"ATAN", 2},
                                     Function{"SQRT", 1}, Function{"ABS", 1},   Function{"FIX", 1},
                                     Function{"FUP", 1},  Function{"ROUND", 1}, Function{"LN", 1},
                                     Function{"EXP", 1},  Function{"EXISTS", 1}};
    const std::span<const Function> functions =
        m_names ? std::span<const Function>(kSinumerik) : std::span<const Function>(kIso);
    const auto found = std::find_if(functions.begin(), functions.end(),
                                    [&key](const Function& f) { return f.name == key; });
    if (found == functions.end()) {
      return std::nullopt;
    }
    if (key == "EXISTS") {
      return exists();
    }
    std::array<double, 3> arguments{};
    const char open = m_names ? '(' : '[';
    const char close = m_names ? ')' : ']';
    if (!take(open)) {
      return fail(fmt::format("{} needs its argument in brackets", key));
    }
    for (int i = 0; i < found->arguments; ++i) {
      // ATAN[y]/[x] of the ISO dialects.
      if (i > 0 && !(m_names ? take(',') : (take(']') && take('/') && take('[')))) {
        if (key == "ATAN") {
          return fail("ATAN is written ATAN[y]/[x]");
        }
        return fail(fmt::format("{} needs more arguments", key));
      }
      const std::optional<double> argument = level(0);
      if (!argument) {
        return std::nullopt;
      }
      arguments[static_cast<std::size_t>(i)] = *argument;
    }
    if (!take(close)) {
      return fail("a bracket is not closed");
    }
    return computed(key, arguments);
  }

  std::optional<double> exists() {
    const bool opened = take('[');
    const std::size_t end = m_text.find(']', m_at);
    if (!opened || end == std::string_view::npos) {
      return fail("EXISTS is written EXISTS[#<name>]");
    }
    std::string key = base::toUpper(base::trim(m_text.substr(m_at, end - m_at)));
    m_at = end + 1;
    key = key.empty() ? key : key.substr(1);
    return m_owner.scope().names.count(key) + m_owner.m_globals.names.count(key) > 0 ? 1.0 : 0.0;
  }

  std::optional<double> computed(std::string_view key, const std::array<double, 3>& a) {
    const double x = a[0];
    if (key == "SIN") {
      return std::sin(x * kRadPerDegree);
    }
    if (key == "COS") {
      return std::cos(x * kRadPerDegree);
    }
    if (key == "TAN") {
      return std::tan(x * kRadPerDegree);
    }
    if (key == "ASIN" || key == "ACOS") {
      if (!(std::abs(x) <= 1.0)) {
        return fail(fmt::format("{} of a number outside -1 to 1", key));
      }
      return (key == "ASIN" ? std::asin(x) : std::acos(x)) / kRadPerDegree;
    }
    if (key == "ATAN2" || key == "ATAN") {
      const double degrees = std::atan2(x, a[1]) / kRadPerDegree;
      return key == "ATAN" && degrees < 0.0 ? degrees + 360.0 : degrees;
    }
    if (key == "SQRT") {
      return x >= 0.0 ? std::optional(std::sqrt(x)) : fail("the root of a negative number");
    }
    if (key == "LN") {
      return x > 0.0 ? std::optional(std::log(x)) : fail("the logarithm of zero or less");
    }
    if (key == "POT") {
      return x * x;
    }
    if (key == "ABS") {
      return std::abs(x);
    }
    if (key == "TRUNC") {
      return std::trunc(x);
    }
    if (key == "ROUND") {
      return std::round(x);
    }
    if (key == "ROUNDUP" || key == "FUP") {
      return std::ceil(x);
    }
    if (key == "FIX") {
      return std::floor(x);
    }
    if (key == "EXP") {
      return std::exp(x);
    }
    if (key == "MINVAL") {
      return std::min(x, a[1]);
    }
    if (key == "MAXVAL") {
      return std::max(x, a[1]);
    }
    return std::min(std::max(a[2], x), a[1]);  // BOUND(least, most, value)
  }

  Calculator& m_owner;
  std::string_view m_text;
  std::size_t m_at = 0;
  bool m_names;
  std::span<const Level> m_levels;
  int m_depth = 0;
  double m_system = 0.0;
};

Calculator::Calculator(Dialect dialect, SystemValues systemValues)
    : m_dialect(dialect), m_systemValues(std::move(systemValues)), m_scopes(1) {
}

std::optional<double> Calculator::take(std::string_view& text) {
  m_problem.clear();
  Parser parser(*this, text);
  const std::optional<double> value = parser.expression();
  if (value && !std::isfinite(*value)) {
    m_problem = "a value it needs is not known";
    return std::nullopt;
  }
  text = parser.rest();
  return value;
}

std::optional<double> Calculator::evaluate(std::string_view text) {
  const std::optional<double> value = take(text);
  if (value && !base::trim(text).empty()) {
    m_problem = fmt::format("\"{}\" is not understood", base::trim(text));
    return std::nullopt;
  }
  return value;
}

std::string_view Calculator::valuePart(std::string_view word) {
  // X=..., or one letter and a value in brackets.
  std::size_t end = 0;
  while (end < word.size() && (isNameLetter(word[end]) || (end > 0 && isDigit(word[end])))) {
    ++end;
  }
  while (end < word.size() && isBlank(word[end])) {
    ++end;
  }
  return end < word.size() && word[end] == '=' ? word.substr(end + 1)
                                               : word.substr(std::min<std::size_t>(1, word.size()));
}

const Variable* Calculator::find(std::string_view upperName) const {
  for (const Scope* const scope : {&m_scopes.back(), &m_globals}) {
    if (const auto found = scope->names.find(upperName); found != scope->names.end()) {
      return &found->second;
    }
  }
  return nullptr;
}

Variable* Calculator::find(std::string_view upperName) {
  return const_cast<Variable*>(std::as_const(*this).find(upperName));
}

double* Calculator::numbered(int number, bool create) {
  auto& numbers = number <= kLocalNumberMax ? scope().numbers : m_globals.numbers;
  const auto found = numbers.find(number);
  if (found != numbers.end()) {
    return &found->second;
  }
  // Variables above 5000 are the control's own; others are 0 until they are set.
  constexpr int kFirstOfControl = 5000;
  if (!create && number >= kFirstOfControl) {
    return nullptr;
  }
  return &numbers.emplace(number, 0.0).first->second;
}

bool Calculator::assign(std::string_view text) {
  m_problem.clear();
  Parser parser(*this, text);
  parser.skipBlanks();
  const auto takeValue = [&](bool isInteger) -> std::optional<double> {
    if (!parser.take('=')) {
      m_problem = m_problem.empty() ? "an equals sign is missing" : m_problem;
      return std::nullopt;
    }
    std::string_view rest = parser.rest();
    std::optional<double> value = evaluate(rest);
    return value && isInteger ? std::optional(std::round(*value)) : value;
  };
  if (parser.peek() == '#') {
    double* const target = parser.hashVariable(true);
    if (target == nullptr) {
      return false;
    }
    const std::optional<double> value = takeValue(false);
    *target = value.value_or(kUnknown);
    return value.has_value();
  }
  if (parser.peek() == '$') {
    m_problem = "a variable of the control is written";
    return false;
  }
  const std::string key = parser.name();
  Variable* const variable = find(key);
  const bool isR = key == "R" || (key.size() > 1 && key[0] == 'R' &&
                                  std::all_of(key.begin() + 1, key.end(), isDigit));
  if (variable == nullptr && isR && m_dialect == Dialect::Sinumerik) {
    std::optional<double> index;
    if (key == "R") {
      if (!parser.take('[')) {
        m_problem = "R needs a number or an index in brackets";
        return false;
      }
      index = parser.expression();
      if (!index || !parser.take(']')) {
        m_problem = m_problem.empty() ? "the index of R is not closed" : m_problem;
        return false;
      }
    } else {
      index = base::parseNumber(std::string_view(key).substr(1));
    }
    const std::optional<double> value = takeValue(false);
    if (index && !value) {
      m_r.erase(static_cast<int>(std::lround(*index)));
    }
    if (!value || !index || !(*index > -0.5 && *index < 1e6)) {
      m_problem = m_problem.empty() ? "the index of R is out of range" : m_problem;
      return false;
    }
    m_r[static_cast<int>(std::lround(*index))] = *value;
    return true;
  }
  if (variable == nullptr) {
    m_problem = fmt::format("{} is not defined", key);
    return false;
  }
  if (variable->isAxis) {
    // A1=(X) and A1=X.
    std::string name = base::toUpper(base::trim(parser.rest()));
    name.erase(
        std::remove_if(name.begin(), name.end(),
                       [](char c) { return isBlank(c) || c == '=' || c == '(' || c == ')'; }),
        name.end());
    const Variable* const other = find(name);
    variable->text = other != nullptr && other->isAxis ? other->text : name;
    return true;
  }
  if (variable->isString) {
    std::string_view rest = base::trim(parser.rest());
    const std::size_t open = rest.find('"');
    const std::size_t close = rest.rfind('"');
    if (open == std::string_view::npos || close == open ||
        rest.find("<<") != std::string_view::npos) {
      m_problem = "only a text in quotes can be given to a string";
      return false;
    }
    variable->text = rest.substr(open + 1, close - open - 1);
    return true;
  }
  std::size_t index = 0;
  if (!variable->sizes.empty()) {
    const int element = parser.element(*variable);
    if (element < 0) {
      return false;
    }
    index = static_cast<std::size_t>(element);
    parser.skipBlanks();
    const std::string_view rest = parser.rest();
    const std::string behind =
        base::toUpper(base::trim(rest.substr(std::min<std::size_t>(1, rest.size()))));
    const bool isSet = behind.rfind("SET", 0) == 0;
    if (isSet || behind.rfind("REP", 0) == 0) {
      // A list for the elements from here on; what the list leaves out stays.
      std::string_view list = behind;
      list.remove_prefix(3);
      list = base::trim(list);
      if (list.size() < 2 || list.front() != '(' || list.back() != ')') {
        m_problem = "SET and REP need a list in brackets";
        return false;
      }
      const std::string inner(list.substr(1, list.size() - 2));
      list = inner;
      std::vector<std::optional<double>> values;
      while (true) {
        list = base::trim(list);
        if (list.empty() || list.front() == ',') {
          values.emplace_back();
        } else {
          const std::optional<double> value = take(list);
          if (!value) {
            return false;
          }
          values.emplace_back(value);
          list = base::trim(list);
        }
        if (list.empty()) {
          break;
        }
        if (list.front() != ',') {
          m_problem = "the elements of the list are parted by commas";
          return false;
        }
        list.remove_prefix(1);
      }
      const std::size_t count =
          isSet ? std::min(values.size(), variable->values.size() - index)
                : (values.size() > 1 && values[1]
                       ? std::min(static_cast<std::size_t>(std::max(0.0, *values[1])),
                                  variable->values.size() - index)
                       : variable->values.size() - index);
      for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double>& value = isSet ? values[i] : values[0];
        if (value) {
          variable->values[index + i] = *value;
        }
      }
      return true;
    }
  }
  const bool isInteger = variable->isInteger;
  const std::optional<double> value = takeValue(isInteger);
  variable->values[index] = value.value_or(kUnknown);
  return value.has_value();
}

bool Calculator::define(std::string_view text) {
  m_problem.clear();
  Parser head(*this, text);
  std::string type = head.name();
  while (type == "NCK" || type == "CHAN" || type == "SYNR" || type == "SYNW" || type == "SYNRW") {
    type = head.name();
  }
  const bool isString = type == "STRING";
  static constexpr std::array<std::string_view, 7> kTypes{"INT",    "REAL", "BOOL", "CHAR",
                                                          "STRING", "AXIS", "FRAME"};
  if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) {
    m_problem = fmt::format("DEF {} is no type", type);
    return false;
  }
  std::string_view rest = head.rest();
  if (isString) {
    const std::size_t close = rest.find(']');
    rest.remove_prefix(close == std::string_view::npos ? 0 : close + 1);
  }
  while (!base::trim(rest).empty()) {
    Parser parser(*this, rest);
    const std::string key = parser.name();
    if (key.empty()) {
      m_problem = "the name of a variable is missing";
      return false;
    }
    Variable variable;
    variable.isAxis = type == "AXIS";
    variable.isString = isString || type == "AXIS" || type == "FRAME";
    variable.isInteger = type == "INT" || type == "BOOL" || type == "CHAR";
    double elements = 1.0;
    if (parser.take('[')) {
      do {
        const std::optional<double> size = parser.expression();
        if (!size || !(*size >= 1.0) || !((elements *= std::floor(*size)) <= kArrayElementsMax)) {
          m_problem = "the size of an array is missing or too large";
          return false;
        }
        variable.sizes.push_back(static_cast<int>(*size));
      } while (parser.take(','));
      if (!parser.take(']') || variable.sizes.size() > 3) {
        m_problem = "the size of an array is not closed";
        return false;
      }
    }
    variable.values.assign(static_cast<std::size_t>(elements), 0.0);
    const bool isArray = !variable.sizes.empty();
    const std::string zeros = variable.sizes.size() == 3   ? "[0,0,0]"
                              : variable.sizes.size() == 2 ? "[0,0]"
                                                           : "[0]";
    scope().names.insert_or_assign(key, std::move(variable));
    parser.skipBlanks();
    rest = parser.rest();
    // The value ends at a comma outside of brackets and quotes.
    std::size_t end = 0;
    int depth = 0;
    bool quoted = false;
    for (; end < rest.size(); ++end) {
      const char c = rest[end];
      quoted ^= c == '"';
      depth += !quoted && (c == '(' || c == '[') ? 1 : (!quoted && (c == ')' || c == ']') ? -1 : 0);
      if (c == ',' && depth == 0 && !quoted) {
        break;
      }
    }
    const std::string_view value = base::trim(rest.substr(0, end));
    if (!value.empty() && value.front() != '=') {
      m_problem = fmt::format("\"{}\" is not understood", value);
      return false;
    }
    if (!value.empty() && type != "FRAME" &&
        !assign(key + (isArray ? zeros : "") + std::string(value))) {
      return false;
    }
    rest.remove_prefix(std::min(rest.size(), end + 1));
  }
  return true;
}

void Calculator::enter(Scope scope) {
  m_scopes.push_back(std::move(scope));
}

void Calculator::leave() {
  RIVULET_ASSERT(m_scopes.size() > 1);
  m_scopes.pop_back();
}

}  // namespace rivulet::gcode
