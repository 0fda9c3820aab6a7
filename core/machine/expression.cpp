// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/contract.h"
#include "base/text.h"

namespace rivulet::machine {

namespace {

constexpr std::size_t kStackDepth = 64;
constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr double kEqualityTolerance = 1e-12;  // relative, as on the control

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool equal(double a, double b) {
  return std::abs(a - b) <= kEqualityTolerance * std::max(std::abs(a), std::abs(b));
}

std::int64_t asBits(double value) {
  return static_cast<std::int64_t>(std::clamp(value, -9.0e18, 9.0e18));
}

}  // namespace

std::optional<SystemVariable> systemVariableOf(std::string_view name) {
  using enum SystemVariable;
  static constexpr std::array<std::pair<std::string_view, SystemVariable>, 13> kNames{
      {{"$AA_IM", AaIm},
       {"$AA_IW", AaIw},
       {"$AA_DTEW", AaDtew},
       {"$AA_OFF", AaOff},
       {"$AA_OFF_VAL", AaOffVal},
       {"$MA_AA_OFF_MODE", MaAaOffMode},
       {"$AC_DTEW", AcDtew},
       {"$AC_PATHN", AcPathn},
       {"$AC_OVR", AcOvr},
       {"$AC_TIMER", AcTimer},
       {"$AC_MARKER", AcMarker},
       {"$AC_PARAM", AcParam},
       {"$AC_IPO_BUF", AcIpoBuf}}};
  const auto found = std::find_if(kNames.begin(), kNames.end(),
                                  [name](const auto& entry) { return entry.first == name; });
  return found == kNames.end() ? std::nullopt : std::optional(found->second);
}

/// Recursive descent, one level per priority.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, const VariableNames* names)
      : m_text(text), m_names(names) {}

  std::optional<ParsedExpression> parse(std::string& problem) {
    if (!level(0)) {
      problem = m_problem;
      return std::nullopt;
    }
    return ParsedExpression{std::move(m_expression), m_at};
  }

 private:
  using Op = Expression::Op;
  struct BinaryWord {
    std::string_view word;
    Op op;
  };

  static constexpr std::size_t kLevels = 9;

  /// Operators per level, weakest first; longer ones before their prefixes.
  static const std::array<std::vector<BinaryWord>, kLevels>& operators() {
    static const std::array<std::vector<BinaryWord>, kLevels> table{{
        {{"==", Op::Equal},
         {"<>", Op::Unequal},
         {"<=", Op::LessEqual},
         {">=", Op::GreaterEqual},
         {"<", Op::Less},
         {">", Op::Greater}},
        {{"OR", Op::Or}},
        {{"XOR", Op::Xor}},
        {{"AND", Op::And}},
        {{"B_OR", Op::BitOr}},
        {{"B_XOR", Op::BitXor}},
        {{"B_AND", Op::BitAnd}},
        {{"+", Op::Add}, {"-", Op::Subtract}},
        {{"*", Op::Multiply}, {"/", Op::Divide}, {"DIV", Op::IntegerDivide}, {"MOD", Op::Modulo}},
    }};
    return table;
  }

  bool fail(std::string problem) {
    if (m_problem.empty()) {
      m_problem = std::move(problem);
    }
    return false;
  }

  void skipBlanks() {
    while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t')) {
      ++m_at;
    }
  }

  bool takeWord(std::string_view word) {
    std::size_t begin = m_at;
    while (begin < m_text.size() && (m_text[begin] == ' ' || m_text[begin] == '\t')) {
      ++begin;
    }
    if (m_text.substr(begin, word.size()) != word) {
      return false;  // blanks in front of what is not ours stay unread
    }
    const std::size_t end = begin + word.size();
    if (isLetter(word.back()) && end < m_text.size() &&
        (isLetter(m_text[end]) || isDigit(m_text[end]))) {
      return false;  // the front of a longer name
    }
    m_at = end;
    return true;
  }

  void emit(Op op, double number = 0.0) { m_expression.m_code.push_back({op, number}); }

  bool level(std::size_t index) {
    if (index == kLevels) {
      return unary();
    }
    if (!level(index + 1)) {
      return false;
    }
    for (;;) {
      const auto& candidates = operators()[index];
      const auto found = std::find_if(candidates.begin(), candidates.end(),
                                      [this](const BinaryWord& w) { return takeWord(w.word); });
      if (found == candidates.end()) {
        return true;
      }
      if (!level(index + 1)) {
        return fail("an operand is missing");
      }
      emit(found->op);
    }
  }

  bool unary() {
    if (++m_depth > kStackDepth / 2) {
      return fail("the expression is nested too deeply");
    }
    const bool done = unaryInner();
    --m_depth;
    return done;
  }

  bool unaryInner() {
    if (takeWord("-")) {
      if (!unary()) {
        return false;
      }
      emit(Op::Negate);
      return true;
    }
    if (takeWord("+")) {
      return unary();
    }
    if (takeWord("B_NOT")) {
      if (!unary()) {
        return false;
      }
      emit(Op::BitNot);
      return true;
    }
    if (takeWord("NOT")) {
      if (!unary()) {
        return false;
      }
      emit(Op::Not);
      return true;
    }
    return primary();
  }

  bool primary() {
    skipBlanks();
    if (m_at >= m_text.size()) {
      return fail("a value is missing");
    }
    const char c = m_text[m_at];
    if (isDigit(c) || c == '.') {
      return number();
    }
    if (c == '(') {
      ++m_at;
      return level(0) && close(')');
    }
    if (c == 'R' && m_at + 1 < m_text.size() && isDigit(m_text[m_at + 1])) {
      std::size_t end = m_at + 1;
      while (end < m_text.size() && isDigit(m_text[end])) {
        ++end;
      }
      const std::optional<int> index = base::parseInteger(m_text.substr(m_at + 1, end - m_at - 1));
      if (!index) {
        return fail("the number of an R-parameter is too large");
      }
      m_at = end;
      emit(Op::Number, *index);
      emit(Op::R);
      return true;
    }
    if (takeWord("R")) {
      skipBlanks();
      if (m_at >= m_text.size() || m_text[m_at] != '[') {
        return fail("R needs a number or an index in brackets");
      }
      ++m_at;
      if (!level(0) || !close(']')) {
        return false;
      }
      emit(Op::R);
      return true;
    }
    if (takeWord("TRUE")) {
      emit(Op::Number, 1.0);
      return true;
    }
    if (takeWord("FALSE")) {
      emit(Op::Number, 0.0);
      return true;
    }
    if (takeWord("$PI")) {
      emit(Op::Number, std::numbers::pi);
      return true;
    }
    if (c == '$') {
      return systemVariable();
    }
    if (c == '\'') {
      return bits();
    }
    if (const VariableInfo* variable = takeVariable()) {
      return local(*variable);
    }
    return function();
  }

  /// $R5, $R[expr], $AA_IM[X], $AC_PATHN, $AC_MARKER[1].
  bool systemVariable() {
    if (m_text.substr(m_at, 2) == "$R" && m_at + 2 < m_text.size() &&
        (isDigit(m_text[m_at + 2]) || m_text[m_at + 2] == '[')) {
      ++m_at;
      if (!primary()) {
        return false;
      }
      m_expression.m_code.back().op = Op::MainR;
      return true;
    }
    std::size_t end = m_at + 1;
    while (end < m_text.size() && (isLetter(m_text[end]) || isDigit(m_text[end]))) {
      ++end;
    }
    const std::string_view name = m_text.substr(m_at, end - m_at);
    const std::optional<SystemVariable> variable = systemVariableOf(name);
    if (!variable) {
      return fail(fmt::format("the system variable {} is not known to this machine", name));
    }
    m_at = end;
    return systemIndex(*variable);
  }

  bool systemIndex(SystemVariable variable) {
    const auto number = static_cast<double>(variable);
    skipBlanks();
    if (variable == SystemVariable::AcDtew || variable == SystemVariable::AcPathn ||
        variable == SystemVariable::AcOvr || variable == SystemVariable::AcIpoBuf) {
      emit(Op::System, 8.0 * number);
      return true;
    }
    if (m_at >= m_text.size() || m_text[m_at] != '[') {
      return fail("the variable needs an axis or an index in brackets");
    }
    ++m_at;
    skipBlanks();
    if (variable == SystemVariable::AcTimer || variable == SystemVariable::AcMarker ||
        variable == SystemVariable::AcParam) {
      if (!level(0) || !close(']')) {
        return false;
      }
      emit(Op::SystemElement, number);
      return true;
    }
    const std::size_t axis =
        m_at < m_text.size() ? std::string_view("XYZ").find(m_text[m_at]) : std::string_view::npos;
    if (axis == std::string_view::npos) {
      return fail("the axis must be X, Y or Z");
    }
    ++m_at;
    emit(Op::System, 8.0 * number + static_cast<double>(axis));
    return close(']');
  }

  /// 'H1F' and 'B101'.
  bool bits() {
    const std::size_t end = m_text.find('\'', m_at + 1);
    const std::string_view text =
        end == std::string_view::npos ? "" : m_text.substr(m_at + 1, end - m_at - 1);
    const int base = text.empty() ? 0 : (text[0] == 'H' ? 16 : text[0] == 'B' ? 2 : 0);
    double value = 0.0;
    for (std::size_t i = 1; i < text.size(); ++i) {
      const std::size_t digit = std::string_view("0123456789ABCDEF").find(text[i]);
      if (digit >= static_cast<std::size_t>(base)) {
        return fail("the constant has digits it must not have");
      }
      value = base * value + static_cast<double>(digit);
    }
    if (base == 0 || text.size() < 2) {
      return fail("a constant in quotes begins with H or B");
    }
    m_at = end + 1;
    emit(Op::Number, value);
    return true;
  }

  const VariableInfo* takeVariable() {
    if (m_names == nullptr || !isLetter(m_text[m_at])) {
      return nullptr;
    }
    std::size_t end = m_at;
    while (end < m_text.size() && (isLetter(m_text[end]) || isDigit(m_text[end]))) {
      ++end;
    }
    const auto found = m_names->find(m_text.substr(m_at, end - m_at));
    if (found == m_names->end()) {
      return nullptr;
    }
    m_at = end;
    return &found->second;
  }

  bool local(const VariableInfo& variable) {
    if (variable.isString) {
      return fail("a string cannot be calculated with");
    }
    if (variable.sizes.empty()) {
      emit(Op::Local, variable.slot);
      return true;
    }
    skipBlanks();
    if (m_at >= m_text.size() || m_text[m_at] != '[') {
      return fail("an array needs its index in brackets");
    }
    ++m_at;
    // Row by row: ((i·n2 + j)·n3 + k).
    for (std::size_t dimension = 0; dimension < variable.sizes.size(); ++dimension) {
      if (dimension > 0) {
        emit(Op::Number, variable.sizes[dimension]);
        emit(Op::Multiply);
        if (!close(',')) {
          return false;
        }
      }
      if (!level(0)) {
        return false;
      }
      if (dimension > 0) {
        emit(Op::Add);
      }
    }
    emit(Op::LocalElement, variable.slot);
    return close(']');
  }

  bool number() {
    std::size_t end = m_at;
    while (end < m_text.size() && (isDigit(m_text[end]) || m_text[end] == '.')) {
      ++end;
    }
    std::string literal(m_text.substr(m_at, end - m_at));
    // The exponent is written EX: 8.2EX-3.
    if (m_text.substr(end, 2) == "EX") {
      std::size_t digits = end + 2;
      if (digits < m_text.size() && (m_text[digits] == '-' || m_text[digits] == '+')) {
        ++digits;
      }
      const std::size_t from = digits;
      while (digits < m_text.size() && isDigit(m_text[digits])) {
        ++digits;
      }
      if (digits == from) {
        return fail("the exponent has no digits");
      }
      literal += "e" + std::string(m_text.substr(end + 2, digits - end - 2));
      end = digits;
    }
    const std::optional<double> value = base::parseNumber(literal);
    if (!value) {
      return fail(fmt::format("\"{}\" is not a number", literal));
    }
    m_at = end;
    emit(Op::Number, *value);
    return true;
  }

  bool function() {
    struct Function {
      std::string_view name;
      Op op;
      int arguments;
    };
    static constexpr std::array<Function, 17> kFunctions{{
        {"SIN", Op::Sin, 1},
        {"COS", Op::Cos, 1},
        {"TAN", Op::Tan, 1},
        {"ASIN", Op::Asin, 1},
        {"ACOS", Op::Acos, 1},
        {"ATAN2", Op::Atan2, 2},
        {"SQRT", Op::Sqrt, 1},
        {"POT", Op::Pot, 1},
        {"ABS", Op::Abs, 1},
        {"TRUNC", Op::Trunc, 1},
        {"ROUNDUP", Op::RoundUp, 1},
        {"ROUND", Op::Round, 1},
        {"LN", Op::Ln, 1},
        {"EXP", Op::Exp, 1},
        {"MINVAL", Op::MinVal, 2},
        {"MAXVAL", Op::MaxVal, 2},
        {"BOUND", Op::Bound, 3},
    }};
    for (const Function& candidate : kFunctions) {
      if (!takeWord(candidate.name)) {
        continue;
      }
      skipBlanks();
      if (m_at >= m_text.size() || m_text[m_at] != '(') {
        return fail(fmt::format("{} needs its argument in parentheses", candidate.name));
      }
      ++m_at;
      for (int argument = 0; argument < candidate.arguments; ++argument) {
        if ((argument > 0 && !close(',')) || !level(0)) {
          return fail(fmt::format("{} takes {} argument(s)", candidate.name, candidate.arguments));
        }
      }
      if (!close(')')) {
        return false;
      }
      emit(candidate.op);
      return true;
    }
    std::size_t end = m_at;
    while (end < m_text.size() && (isLetter(m_text[end]) || isDigit(m_text[end]))) {
      ++end;
    }
    return fail(fmt::format("\"{}\" is not known here",
                            m_text.substr(m_at, std::max<std::size_t>(end - m_at, 1))));
  }

  bool close(char c) {
    skipBlanks();
    if (m_at >= m_text.size() || m_text[m_at] != c) {
      return fail(fmt::format("'{}' is missing", c));
    }
    ++m_at;
    return true;
  }

  std::string_view m_text;
  const VariableNames* m_names;
  std::size_t m_at = 0;
  std::size_t m_depth = 0;
  Expression m_expression;
  std::string m_problem;
};

bool Expression::isConstant() const {
  return std::none_of(m_code.begin(), m_code.end(), [](const Instruction& i) {
    return i.op == Op::R || i.op == Op::MainR || i.op == Op::Local || i.op == Op::LocalElement ||
           i.op == Op::System || i.op == Op::SystemElement;
  });
}

bool Expression::readsMainRun() const {
  return std::any_of(m_code.begin(), m_code.end(), [](const Instruction& i) {
    // The fill level of the buffer is known to the pre-run itself.
    constexpr double kIpoBuf = 8.0 * static_cast<double>(SystemVariable::AcIpoBuf);
    return i.op == Op::MainR || (i.op == Op::System && i.number != kIpoBuf) ||
           i.op == Op::SystemElement;
  });
}

bool Expression::freeze(const ValueSource& source, Alarm& alarm) {
  std::vector<Instruction> frozen;
  for (const Instruction& instruction : m_code) {
    std::optional<double> value;
    if (instruction.op == Op::R && !frozen.empty() && frozen.back().op == Op::Number) {
      value = source.value(static_cast<int>(std::lround(frozen.back().number)));
      frozen.pop_back();
    } else if (instruction.op == Op::Local) {
      value = source.local(static_cast<int>(instruction.number), 0);
    } else if (instruction.op == Op::R || instruction.op == Op::LocalElement) {
      alarm = {12150, "A synchronized action reads R or an array by a computed index: use $R."};
      return false;
    } else {
      frozen.push_back(instruction);
      continue;
    }
    if (!value) {
      alarm = {17020, "A synchronized action reads what does not exist."};
      return false;
    }
    frozen.push_back({Op::Number, *value});
  }
  m_code = std::move(frozen);
  return true;
}

Expression Expression::number(double value) {
  Expression expression;
  expression.m_code = {{Op::Number, value}};
  return expression;
}

Expression Expression::local(int slot) {
  Expression expression;
  expression.m_code = {{Op::Local, static_cast<double>(slot)}};
  return expression;
}

Expression Expression::next(Expression left) {
  left.m_code.push_back({Op::Number, 1.0});
  left.m_code.push_back({Op::Add, 0.0});
  return left;
}

Expression Expression::notAbove(Expression left, const Expression& right) {
  left.m_code.insert(left.m_code.end(), right.m_code.begin(), right.m_code.end());
  left.m_code.push_back({Op::LessEqual, 0.0});
  return left;
}

Expression Expression::equals(Expression left, const Expression& right) {
  left.m_code.insert(left.m_code.end(), right.m_code.begin(), right.m_code.end());
  left.m_code.push_back({Op::Equal, 0.0});
  return left;
}

std::optional<double> Expression::evaluate(const ValueSource& source, Alarm& alarm) const {
  std::array<double, kStackDepth> stack{};
  std::size_t depth = 0;
  for (const auto& [op, number] : m_code) {
    if (op == Op::Number || op == Op::Local || op == Op::System) {
      if (depth == kStackDepth) {
        alarm = {14051, "The expression is too long."};
        return std::nullopt;
      }
      std::optional<double> value = number;
      if (op == Op::Local) {
        value = source.local(static_cast<int>(number), 0);
      } else if (op == Op::System) {
        const int code = static_cast<int>(number);
        value = source.system(static_cast<SystemVariable>(code / 8), code % 8);
      }
      if (!value) {
        alarm = {12550, "A variable cannot be read here."};
        return std::nullopt;
      }
      stack[depth++] = *value;
      continue;
    }
    RIVULET_ASSERT(depth >= 1);
    double& top = stack[depth - 1];
    // Unary operations work on the top, binary ones fold the top into the value below.
    const double b = top;
    const auto binary = [&](auto operation) {
      RIVULET_ASSERT(depth >= 2);
      --depth;
      stack[depth - 1] = operation(stack[depth - 1], b);
    };
    switch (op) {
      case Op::Number:
      case Op::Local:
      case Op::System:
        break;
      case Op::LocalElement:
      case Op::SystemElement: {
        const double rounded = std::round(b);
        const int index = std::abs(rounded) < 1e6 ? static_cast<int>(rounded) : -1;
        const std::optional<double> value =
            op == Op::LocalElement
                ? source.local(static_cast<int>(number), index)
                : source.system(static_cast<SystemVariable>(static_cast<int>(number)), index);
        if (!value) {
          alarm = {17020, fmt::format("There is no element {}.", b)};
          return std::nullopt;
        }
        top = *value;
        break;
      }
      case Op::MainR:
      case Op::R: {
        const double rounded = std::round(b);
        const std::optional<double> value =
            std::abs(rounded) < 1e6 ? source.value(static_cast<int>(rounded)) : std::nullopt;
        if (!value) {
          alarm = {17020, fmt::format("R[{}] does not exist.", b)};
          return std::nullopt;
        }
        top = *value;
        break;
      }
      case Op::Negate:
        top = -b;
        break;
      case Op::Not:
        top = b == 0.0 ? 1.0 : 0.0;
        break;
      case Op::BitNot:
        top = static_cast<double>(~asBits(b));
        break;
      case Op::Multiply:
        binary([](double x, double y) { return x * y; });
        break;
      case Op::Divide:
      case Op::IntegerDivide:
      case Op::Modulo:
        if (b == 0.0) {
          alarm = {14051, "Division by zero."};
          return std::nullopt;
        }
        if (op == Op::Divide) {
          binary([](double x, double y) { return x / y; });
        } else if (op == Op::IntegerDivide) {
          binary([](double x, double y) { return std::trunc(x / y); });
        } else {
          binary([](double x, double y) { return std::fmod(x, y); });
        }
        break;
      case Op::Add:
        binary([](double x, double y) { return x + y; });
        break;
      case Op::Subtract:
        binary([](double x, double y) { return x - y; });
        break;
      case Op::BitAnd:
        binary([](double x, double y) { return static_cast<double>(asBits(x) & asBits(y)); });
        break;
      case Op::BitXor:
        binary([](double x, double y) { return static_cast<double>(asBits(x) ^ asBits(y)); });
        break;
      case Op::BitOr:
        binary([](double x, double y) { return static_cast<double>(asBits(x) | asBits(y)); });
        break;
      case Op::And:
        binary([](double x, double y) { return x != 0.0 && y != 0.0 ? 1.0 : 0.0; });
        break;
      case Op::Xor:
        binary([](double x, double y) { return (x != 0.0) != (y != 0.0) ? 1.0 : 0.0; });
        break;
      case Op::Or:
        binary([](double x, double y) { return x != 0.0 || y != 0.0 ? 1.0 : 0.0; });
        break;
      case Op::Equal:
        binary([](double x, double y) { return equal(x, y) ? 1.0 : 0.0; });
        break;
      case Op::Unequal:
        binary([](double x, double y) { return equal(x, y) ? 0.0 : 1.0; });
        break;
      case Op::Less:
        binary([](double x, double y) { return x < y ? 1.0 : 0.0; });
        break;
      case Op::LessEqual:
        binary([](double x, double y) { return x <= y ? 1.0 : 0.0; });
        break;
      case Op::Greater:
        binary([](double x, double y) { return x > y ? 1.0 : 0.0; });
        break;
      case Op::GreaterEqual:
        binary([](double x, double y) { return x >= y ? 1.0 : 0.0; });
        break;
      case Op::Sin:
        top = std::sin(b * kRadPerDegree);
        break;
      case Op::Cos:
        top = std::cos(b * kRadPerDegree);
        break;
      case Op::Tan:
        top = std::tan(b * kRadPerDegree);
        break;
      case Op::Asin:
        top = std::asin(b) / kRadPerDegree;
        break;
      case Op::Acos:
        top = std::acos(b) / kRadPerDegree;
        break;
      case Op::Atan2:
        binary([](double y, double x) { return std::atan2(y, x) / kRadPerDegree; });
        break;
      case Op::Sqrt:
        top = std::sqrt(b);
        break;
      case Op::Pot:
        top = b * b;
        break;
      case Op::Abs:
        top = std::abs(b);
        break;
      case Op::Trunc:
        top = std::trunc(b);
        break;
      case Op::Round:
        top = std::round(b);
        break;
      case Op::RoundUp:
        top = std::ceil(b);
        break;
      case Op::Ln:
        top = std::log(b);
        break;
      case Op::Exp:
        top = std::exp(b);
        break;
      case Op::MinVal:
        binary([](double x, double y) { return std::min(x, y); });
        break;
      case Op::MaxVal:
        binary([](double x, double y) { return std::max(x, y); });
        break;
      case Op::Bound: {
        RIVULET_ASSERT(depth >= 3);
        const double min = stack[depth - 3];
        const double max = stack[depth - 2];
        depth -= 2;
        stack[depth - 1] = std::min(std::max(b, min), std::max(min, max));
        break;
      }
    }
    if (!std::isfinite(stack[depth - 1])) {
      alarm = {14051, "The result of a calculation is not a number."};
      return std::nullopt;
    }
  }
  RIVULET_ASSERT(depth == 1);
  return stack[0];
}

std::optional<ParsedExpression> parseExpression(std::string_view text, std::string& problem,
                                                const VariableNames* names) {
  return ExpressionParser(text, names).parse(problem);
}

}  // namespace rivulet::machine
