// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/eval/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/contract.h"
#include "base/text.h"

namespace rivulet::nc {

namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr double kIndexMax = 1e6;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::int64_t asBits(double value) {
  return static_cast<std::int64_t>(std::clamp(value, -9.0e18, 9.0e18));
}

double fromBits(std::int64_t bits) {
  return static_cast<double>(bits);
}

double truth(bool holds) {
  return holds ? 1.0 : 0.0;
}

double notNegative(double value, double period) {
  return value < 0.0 ? value + period : value;
}

/// 16 of decimal digits of four bits each is 10, and back. NaN: not such a number.
double fromBcd(double value) {
  double result = 0.0;
  double place = 1.0;
  for (std::int64_t bits = asBits(std::round(value)); bits > 0; bits /= 16, place *= 10.0) {
    if (bits % 16 > 9) {
      return kNone;
    }
    result += place * static_cast<double>(bits % 16);
  }
  return value < 0.0 ? kNone : result;
}

double toBcd(double value) {
  double result = 0.0;
  double place = 1.0;
  for (std::int64_t digits = asBits(std::round(value)); digits > 0; digits /= 10, place *= 16.0) {
    result += place * static_cast<double>(digits % 10);
  }
  return value < 0.0 ? kNone : result;
}

double atan2Deg(double y, double x) {
  return std::atan2(y, x) / kRadPerDegree;
}

/// What needs nothing but its numbers, in the order of `Op`. What has no value gives NaN.
struct Computation {
  Op op;
  double (*of)(double a, double b, double c);
};
// clang-format off
constexpr std::array kComputations{
    Computation{Op::Negate, [](double a, double, double) { return -a; }},
    Computation{Op::Not, [](double a, double, double) { return truth(a == 0.0); }},
    Computation{Op::BitNot, [](double a, double, double) { return fromBits(~asBits(a)); }},
    Computation{Op::Or, [](double a, double b, double) { return truth(a != 0.0 || b != 0.0); }},
    Computation{Op::Xor, [](double a, double b, double) { return truth((a != 0.0) != (b != 0.0)); }},
    Computation{Op::And, [](double a, double b, double) { return truth(a != 0.0 && b != 0.0); }},
    Computation{Op::BitOr, [](double a, double b, double) { return fromBits(asBits(a) | asBits(b)); }},
    Computation{Op::BitXor, [](double a, double b, double) { return fromBits(asBits(a) ^ asBits(b)); }},
    Computation{Op::BitAnd, [](double a, double b, double) { return fromBits(asBits(a) & asBits(b)); }},
    Computation{Op::Add, [](double a, double b, double) { return a + b; }},
    Computation{Op::Subtract, [](double a, double b, double) { return a - b; }},
    Computation{Op::Multiply, [](double a, double b, double) { return a * b; }},
    Computation{Op::Divide, [](double a, double b, double) { return a / b; }},
    Computation{Op::IntegerDivide, [](double a, double b, double) { return std::trunc(a / b); }},
    Computation{Op::Modulo, [](double a, double b, double) { return std::fmod(a, b); }},
    Computation{Op::WholeModulo, [](double a, double b, double) { return std::fmod(std::round(a), std::round(b)); }},
    Computation{Op::FloorModulo, [](double a, double b, double) { return notNegative(std::fmod(a, b), std::abs(b)); }},
    Computation{Op::Power, [](double a, double b, double) { return std::pow(a, b); }},
    Computation{Op::Sin, [](double a, double, double) { return std::sin(a * kRadPerDegree); }},
    Computation{Op::Cos, [](double a, double, double) { return std::cos(a * kRadPerDegree); }},
    Computation{Op::Tan, [](double a, double, double) { return std::tan(a * kRadPerDegree); }},
    Computation{Op::Asin, [](double a, double, double) { return std::asin(a) / kRadPerDegree; }},
    Computation{Op::AsinPositive, [](double a, double, double) { return notNegative(std::asin(a) / kRadPerDegree, 360.0); }},
    Computation{Op::Acos, [](double a, double, double) { return std::acos(a) / kRadPerDegree; }},
    Computation{Op::Atan2, [](double a, double b, double) { return atan2Deg(a, b); }},
    Computation{Op::AtanPositive, [](double a, double b, double) { return notNegative(atan2Deg(a, b), 360.0); }},
    Computation{Op::Atan, [](double a, double, double) { return std::atan(a) / kRadPerDegree; }},
    Computation{Op::Sqrt, [](double a, double, double) { return std::sqrt(a); }},
    Computation{Op::Square, [](double a, double, double) { return a * a; }},
    Computation{Op::Abs, [](double a, double, double) { return std::abs(a); }},
    Computation{Op::Truncate, [](double a, double, double) { return std::trunc(a); }},
    Computation{Op::Round, [](double a, double, double) { return std::round(a); }},
    Computation{Op::RoundToIncrement, [](double a, double increment, double) { return std::round(a / increment) * increment; }},
    Computation{Op::AwayFromZero, [](double a, double, double) { return a < 0.0 ? std::floor(a) : std::ceil(a); }},
    Computation{Op::RoundUp, [](double a, double, double) { return std::ceil(a); }},
    Computation{Op::RoundDown, [](double a, double, double) { return std::floor(a); }},
    Computation{Op::FromBcd, [](double a, double, double) { return fromBcd(a); }},
    Computation{Op::ToBcd, [](double a, double, double) { return toBcd(a); }},
    Computation{Op::Ln, [](double a, double, double) { return a > 0.0 ? std::log(a) : kNone; }},
    Computation{Op::Exp, [](double a, double, double) { return std::exp(a); }},
    Computation{Op::MinVal, [](double a, double b, double) { return std::min(a, b); }},
    Computation{Op::MaxVal, [](double a, double b, double) { return std::max(a, b); }},
    Computation{Op::Bound, [](double a, double b, double c) { return c > b ? b : std::max(a, c); }},  // Bound: least, most, value
};
// clang-format on

double compute(Op op, double a, double b, double c) {
  const Computation& computation =
      kComputations[static_cast<std::size_t>(op) - static_cast<std::size_t>(Op::Negate)];
  RIVULET_ASSERT(computation.op == op);
  return computation.of(a, b, c);
}

bool isComparison(Op op) {
  return op >= Op::Equal && op <= Op::GreaterEqual;
}

/// @param order  < 0, 0, > 0 as the left operand lies below, at or above the right one
/// @param equal  the control takes them for equal
bool compares(Op op, double order, bool equal, bool strictExcludesEqual) {
  switch (op) {
    case Op::Equal:
      return equal;
    case Op::Unequal:
      return !equal;
    case Op::Less:
      return order < 0.0 && !(strictExcludesEqual && equal);
    case Op::LessEqual:
      return order < 0.0 || equal;
    case Op::Greater:
      return order > 0.0 && !(strictExcludesEqual && equal);
    default:
      return order > 0.0 || equal;
  }
}

tl::unexpected<Fault> placed(Fault fault, Place place) {
  if (fault.place.line.value == 0 && fault.place.column == 1) {
    fault.place = place;
  }
  return fail(std::move(fault));
}

/// The number by which R, $R and # are called.
Expected<int> numberOfLeaf(const Expression& node, const ValueSource& source,
                           const Semantics& semantics) {
  const Expected<double> number = evaluateNumber(node.operands.front(), source, semantics);
  if (!number) {
    return fail(number.error());
  }
  const double rounded = std::round(*number);
  if (!(rounded >= 0.0 && rounded < kIndexMax)) {
    return node.op == Op::Hash ? fail(FaultCode::VariableNumberMissing)
                               : fail(FaultCode::NoSuchR, base::formatNumber(*number));
  }
  return static_cast<int>(rounded);
}

/// A leaf that may be a text or vacant, or whose value comes with a name.
Expected<Value> leaf(const Expression& node, const ValueSource& source,
                     const Semantics& semantics) {
  switch (node.op) {
    case Op::Number:
      return node.number;
    case Op::Text:
      return node.name;
    case Op::Exists:
      return source.exists(node.operands.front().name) ? 1.0 : 0.0;
    case Op::System: {
      Expected<std::vector<Value>> indices = systemIndices(node, source, semantics);
      return indices ? source.system(node.name, *indices) : fail(indices.error());
    }
    case Op::Variable: {
      std::array<int, 3> indices{};
      if (node.operands.size() > indices.size()) {
        return fail(FaultCode::ArrayTooManyIndices);
      }
      for (std::size_t i = 0; i < node.operands.size(); ++i) {
        const Expected<int> index = evaluateIndex(node.operands[i], source, semantics);
        if (!index) {
          return fail(index.error());
        }
        indices[i] = *index;
      }
      return source.variable(node.name, std::span(indices).first(node.operands.size()));
    }
    default:
      break;
  }
  const Expected<int> number = numberOfLeaf(node, source, semantics);
  return number ? source.numbered(*number) : fail(number.error());
}

/// The value of R or $R.
Expected<double> rValue(const Expression& node, const ValueSource& source,
                        const Semantics& semantics) {
  const Expected<int> number = numberOfLeaf(node, source, semantics);
  if (!number) {
    return placed(number.error(), node.place);
  }
  Expected<double> value = node.op == Op::R ? source.r(*number) : source.mainR(*number);
  if (!value) {
    return placed(std::move(value.error()), node.place);
  }
  return std::isfinite(*value) ? value : fail(FaultCode::ValueUnknown, {}, node.place);
}

double numberOf(const Value& value) {
  const auto* const number = std::get_if<double>(&value);
  return number != nullptr ? *number : 0.0;
}

double comparedNumbers(Op op, double a, double b, const Semantics& semantics) {
  return truth(compares(op, a < b ? -1.0 : (a > b ? 1.0 : 0.0), areEqual(a, b, semantics),
                        semantics.strictExcludesEqual));
}

Expected<double> comparedValues(const Expression& node, const Value& a, const Value& b,
                                const Semantics& semantics) {
  const bool isText = std::holds_alternative<std::string>(a);
  if (isText != std::holds_alternative<std::string>(b)) {
    return fail(FaultCode::TextCalculated, {}, node.place);
  }
  const bool isVacant = std::holds_alternative<Vacant>(a);
  if (node.op <= Op::Unequal && (isVacant || std::holds_alternative<Vacant>(b))) {
    // One that is vacant is not 0 here, and is nothing but vacant.
    return truth((a.index() == b.index()) == (node.op == Op::Equal));
  }
  if (const auto* text = std::get_if<std::string>(&a)) {
    const int order = text->compare(std::get<std::string>(b));
    return compares(node.op, order, order == 0, true) ? 1.0 : 0.0;
  }
  return comparedNumbers(node.op, numberOf(a), numberOf(b), semantics);
}

/// What combines numbers to a number.
bool isComputation(Op op) {
  return op > Op::GreaterEqual;
}

/// Whether a value of a node can be nothing but a number.
bool isNumeric(const Expression& node) {
  return (node.op == Op::Number && std::isfinite(node.number)) || node.op == Op::R ||
         node.op == Op::MainR || isComputation(node.op) || isComparison(node.op);
}

std::string called(const Expression& node, double a) {
  static constexpr auto kWord = [](Op op) {
    for (const Notation* notation : {&sinumerikNotation(), &hashNotation()}) {
      for (const FunctionWord& function : notation->functions) {
        if (function.op == op) {
          return function.word;
        }
      }
    }
    return std::string_view(op == Op::FromBcd ? "BIN" : op == Op::ToBcd ? "BCD" : "the power");
  };
  return fmt::format("{}({})", kWord(node.op), base::formatNumber(a));
}

Expected<double> computed(const Expression& node, const ValueSource& source,
                          const Semantics& semantics) {
  std::array<double, 3> operands{};
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    const Expected<double> operand = evaluateNumber(node.operands[i], source, semantics);
    if (!operand) {
      return fail(operand.error());
    }
    operands[i] = *operand;
  }
  if (node.op == Op::RoundToIncrement) {
    operands[1] = source.leastIncrement();
  }
  const bool divides = node.op >= Op::Divide && node.op <= Op::FloorModulo;
  if (divides &&
      (operands[1] == 0.0 || (node.op == Op::WholeModulo && std::round(operands[1]) == 0.0))) {
    return fail(FaultCode::DivisionByZero, {}, node.place);
  }
  const double result = compute(node.op, operands[0], operands[1], operands[2]);
  if (std::isnan(result)) {
    return fail(FaultCode::OutOfDomain, called(node, operands[0]), node.place);
  }
  if (!std::isfinite(result)) {
    return fail(FaultCode::NotFinite, {}, node.place);
  }
  return result;
}

Expected<double> compared(const Expression& node, const ValueSource& source,
                          const Semantics& semantics) {
  const Expression& left = node.operands[0];
  const Expression& right = node.operands[1];
  if (isNumeric(left) && isNumeric(right)) {
    const Expected<double> a = evaluateNumber(left, source, semantics);
    const Expected<double> b = a ? evaluateNumber(right, source, semantics) : a;
    return b ? Expected<double>(comparedNumbers(node.op, *a, *b, semantics)) : b;
  }
  const Expected<Value> a = evaluate(left, source, semantics);
  const Expected<Value> b = a ? evaluate(right, source, semantics) : a;
  return b ? comparedValues(node, *a, *b, semantics) : fail(b.error());
}

}  // namespace

const Semantics& sinumerikSemantics() {
  static constexpr Semantics semantics{1e-12, 0.0, true};
  return semantics;
}

/// LinuxCNC, G-code overview, "Numbered Parameters": 1 to 30 belong to a subroutine, 31 to 5000 to
/// the user, those up to 5602 to the control. The interpreter compares with 1e-4.
const Semantics& hashSemantics() {
  static constexpr std::array kNumbers{NumberRange{1, 30, NumberKind::Local},
                                       NumberRange{31, 5000, NumberKind::Common},
                                       NumberRange{5001, 5602, NumberKind::Control}};
  static constexpr Semantics semantics{0.0, 1e-4, false, false, kNumbers};
  return semantics;
}

const NumberRange* Semantics::rangeOf(int number) const {
  const auto range = std::find_if(
      numbers.begin(), numbers.end(),
      [number](const NumberRange& each) { return number >= each.first && number <= each.last; });
  return range == numbers.end() ? nullptr : &*range;
}

NumberKind Semantics::kindOf(int number) const {
  const NumberRange* const range = rangeOf(number);
  return range == nullptr ? NumberKind::Nothing : range->kind;
}

int Semantics::canonical(int number) const {
  const NumberRange* const range = rangeOf(number);
  return range == nullptr || range->sameAs == 0 ? number : range->sameAs + number - range->first;
}

bool areEqual(double a, double b, const Semantics& semantics) {
  const double difference = std::abs(a - b);
  return difference <= semantics.equalRelative * std::max(std::abs(a), std::abs(b)) ||
         difference < semantics.equalAbsolute;
}

Expected<Value> ValueSource::variable(std::string_view name,
                                      std::span<const int> /*indices*/) const {
  return fail(FaultCode::NotDefined, std::string(name));
}

Expected<Value> ValueSource::numbered(int number) const {
  return fail(FaultCode::OnlyOnControl, fmt::format("#{}", number));
}

Expected<Value> ValueSource::system(std::string_view name, std::span<const Value> indices) const {
  std::string text(name);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    text += (i == 0 ? "[" : ",") + textOf(indices[i]);
  }
  return fail(FaultCode::OnlyOnControl, indices.empty() ? text : text + "]");
}

bool ValueSource::exists(std::string_view name) const {
  return variable(name, {}).has_value();
}

Expected<Value> evaluate(const Expression& node, const ValueSource& source,
                         const Semantics& semantics) {
  if (node.op != Op::Number && isNumeric(node)) {
    const Expected<double> number = evaluateNumber(node, source, semantics);
    return number ? Expected<Value>(*number) : fail(number.error());
  }
  if (node.op == Op::Concatenate) {
    const Expected<Value> a = evaluate(node.operands[0], source, semantics);
    const Expected<Value> b = a ? evaluate(node.operands[1], source, semantics) : a;
    return b ? Expected<Value>(textOf(*a) + textOf(*b)) : b;
  }
  Expected<Value> value = leaf(node, source, semantics);
  if (!value) {
    return placed(std::move(value.error()), node.place);
  }
  if (const auto* number = std::get_if<double>(&*value);
      number != nullptr && !std::isfinite(*number)) {
    return fail(FaultCode::ValueUnknown, {}, node.place);
  }
  return value;
}

Expected<double> evaluateNumber(const Expression& expression, const ValueSource& source,
                                const Semantics& semantics) {
  if (expression.op == Op::Number) {
    return expression.number;
  }
  if (expression.op == Op::R || expression.op == Op::MainR) {
    return rValue(expression, source, semantics);
  }
  if (isComputation(expression.op)) {
    return computed(expression, source, semantics);
  }
  if (isComparison(expression.op)) {
    return compared(expression, source, semantics);
  }
  const Expected<Value> value = evaluate(expression, source, semantics);
  if (!value) {
    return fail(value.error());
  }
  return std::holds_alternative<std::string>(*value)
             ? fail(FaultCode::TextCalculated, {}, expression.place)
             : Expected<double>(numberOf(*value));
}

Expected<int> evaluateIndex(const Expression& expression, const ValueSource& source,
                            const Semantics& semantics) {
  const Expected<double> value = evaluateNumber(expression, source, semantics);
  if (!value) {
    return fail(value.error());
  }
  if (!(std::abs(*value) <= kIndexMax)) {
    return fail(FaultCode::IndexOutsideArray, {}, expression.place);
  }
  return static_cast<int>(std::lround(*value));
}

Expected<std::vector<Value>> systemIndices(const Expression& system, const ValueSource& source,
                                           const Semantics& semantics) {
  std::vector<Value> indices;
  for (const Expression& operand : system.operands) {
    Expected<Value> index = evaluate(operand, source, semantics);
    if (!index && operand.op == Op::Variable && operand.operands.empty() &&
        index.error().code == FaultCode::NotDefined) {
      index = Value(operand.name);
    }
    if (!index) {
      return fail(index.error());
    }
    indices.push_back(std::move(*index));
  }
  return indices;
}

std::string textOf(const Value& value) {
  const auto* const text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : base::formatNumber(numberOf(value));
}

bool isConstant(const Expression& expression) {
  bool constant = true;
  forEachNode(expression, [&constant](const Expression& node) {
    constant = constant && (node.op == Op::Number || node.op == Op::Text || node.op > Op::Exists);
  });
  return constant;
}

Expected<Expression> freeze(const Expression& expression, const ValueSource& source,
                            const Semantics& semantics) {
  bool inMainRun = false;
  forEachNode(expression, [&inMainRun](const Expression& node) {
    inMainRun = inMainRun || node.op == Op::MainR || node.op == Op::System;
  });
  if (!inMainRun) {
    Expected<Value> value = evaluate(expression, source, semantics);
    if (!value) {
      return fail(value.error());
    }
    Expression frozen = expression;
    frozen.operands.clear();
    const auto* const text = std::get_if<std::string>(&*value);
    frozen.op = text == nullptr ? Op::Number : Op::Text;
    frozen.number = numberOf(*value);
    frozen.name = text == nullptr ? std::string() : *text;
    return frozen;
  }
  if (expression.op == Op::R || expression.op == Op::Variable) {
    // Its index is known in the main run only, but the value is asked for now.
    return fail(FaultCode::IndexFromMainRun, {}, expression.place);
  }
  Expression frozen = expression;
  for (Expression& operand : frozen.operands) {
    Expected<Expression> made = freeze(operand, source, semantics);
    if (!made && expression.op == Op::System && made.error().code == FaultCode::NotDefined) {
      continue;  // the name of an axis
    }
    if (!made) {
      return made;
    }
    operand = std::move(*made);
  }
  return frozen;
}

}  // namespace rivulet::nc
