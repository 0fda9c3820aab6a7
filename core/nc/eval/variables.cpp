// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/eval/variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "base/contract.h"
#include "base/text.h"
#include "nc/limits.h"
#include "nc/unknown.h"

namespace rivulet::nc {

namespace {

constexpr double kIntMax = 2147483647.0;

bool holdsText(Type type) {
  return type == Type::String || type == Type::Axis || type == Type::Frame;
}

bool isGlobal(std::string_view name) {
  return name.starts_with("<_");
}

}  // namespace

// --- reading ----------------------------------------------------------------------------------

Expected<double> Variables::r(int index) const {
  const auto found = m_r.find(index);
  return found != m_r.end() ? Expected<double>(found->second)
                            : fail(FaultCode::RUnset, fmt::format("{}", index));
}

Expected<Value> Variables::variable(std::string_view name, std::span<const int> indices) const {
  const Binding* const found = binding(name);
  if (found == nullptr) {
    return name.starts_with('<') ? fail(FaultCode::OnlyOnControl, "#" + std::string(name))
                                 : fail(FaultCode::NotDefined, std::string(name));
  }
  const Expected<std::size_t> element = elementOf(*found, indices);
  return element ? Expected<Value>(found->variable->values[*element]) : fail(element.error());
}

Expected<Value> Variables::numbered(int number) const {
  const NumberKind kind = m_semantics.kindOf(number);
  number = m_semantics.canonical(number);
  const auto& numbers = kind == NumberKind::Local ? m_scopes.back().numbers : m_globals.numbers;
  const auto found = numbers.find(number);
  if (found != numbers.end()) {
    return found->second;
  }
  switch (kind) {
    case NumberKind::Nothing:
      return fail(FaultCode::NoSuchHash, fmt::format("#{}", number));
    case NumberKind::Kept:
    case NumberKind::Control:
    case NumberKind::Alarm:
      return ValueSource::numbered(number);
    default:
      return m_semantics.knowsVacant ? Value(Vacant{}) : Value(0.0);
  }
}

bool Variables::exists(std::string_view name) const {
  return binding(name) != nullptr;
}

const Binding* Variables::binding(std::string_view name) const {
  const Scope& scope = isGlobal(name) ? m_globals : m_scopes.back();
  const auto found = scope.names.find(name);
  return found == scope.names.end() ? nullptr : &found->second;
}

const Variable* Variables::find(std::string_view upperName) const {
  const Binding* const found = binding(upperName);
  return found == nullptr ? nullptr : found->variable.get();
}

Expected<std::size_t> Variables::elementOf(const Binding& binding,
                                           std::span<const int> indices) const {
  if (binding.element) {
    return indices.empty() ? Expected<std::size_t>(*binding.element)
                           : fail(FaultCode::ArrayTooManyIndices);
  }
  const std::vector<int>& sizes = binding.variable->sizes;
  if (indices.size() != sizes.size()) {
    return fail(indices.empty()                 ? FaultCode::ArrayIndexMissing
                : indices.size() > sizes.size() ? FaultCode::ArrayTooManyIndices
                                                : FaultCode::ArrayTooFewIndices);
  }
  std::size_t element = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (indices[i] < 0 || indices[i] >= sizes[i]) {
      return fail(FaultCode::IndexOutsideArray);
    }
    element = element * static_cast<std::size_t>(sizes[i]) + static_cast<std::size_t>(indices[i]);
  }
  return element;
}

Expected<std::size_t> Variables::elementOf(const Binding& binding, const Expression& target) const {
  std::vector<int> indices;
  for (const Expression& operand : target.operands) {
    const Expected<int> index = evaluateIndex(operand, *this, m_semantics);
    if (!index) {
      return fail(index.error());
    }
    indices.push_back(*index);
  }
  return elementOf(binding, indices);
}

// --- writing ----------------------------------------------------------------------------------

template <class T>
void Variables::store(T& slot, T value) {
  const auto isUnknown = [](const auto& each) {
    if constexpr (std::is_same_v<T, Value>) {
      const auto* const number = std::get_if<double>(&each);
      return number != nullptr && std::isnan(*number);
    } else {
      return std::isnan(each);
    }
  };
  m_changes += slot == value || (isUnknown(slot) && isUnknown(value)) ? 0 : 1;
  slot = std::move(value);
}

Expected<Value> Variables::converted(Type type, Value value) const {
  const bool isText = std::holds_alternative<std::string>(value);
  if (holdsText(type)) {
    return isText || type == Type::Frame
               ? Expected<Value>(std::move(value))
               : fail(FaultCode::TypeMismatch, std::string(typeName(type)));
  }
  if (isText) {
    const std::string& text = std::get<std::string>(value);
    if (type == Type::Char && text.size() == 1) {
      return static_cast<double>(static_cast<unsigned char>(text[0]));
    }
    return type == Type::Bool ? Expected<Value>(text.empty() ? 0.0 : 1.0)
                              : fail(FaultCode::TypeMismatch, std::string(typeName(type)));
  }
  const auto* const known = std::get_if<double>(&value);
  const double number = known != nullptr ? *known : 0.0;
  if (type == Type::Bool) {
    return number != 0.0 ? 1.0 : 0.0;
  }
  if (type == Type::Real) {
    return number;
  }
  const double rounded = std::round(number);
  const bool fits = type == Type::Char ? rounded >= 0.0 && rounded <= 255.0
                                       : rounded >= -kIntMax - 1.0 && rounded <= kIntMax;
  return fits ? Expected<Value>(rounded) : fail(FaultCode::OutOfRange, std::string(typeName(type)));
}

Expected<Value> Variables::valueFor(Type type, const Expression& expression) const {
  // The name of an axis stands for itself.
  const bool isName = type == Type::Axis && expression.op == Op::Variable &&
                      expression.operands.empty() && binding(expression.name) == nullptr;
  Expected<Value> value =
      isName ? Expected<Value>(expression.name) : evaluate(expression, *this, m_semantics);
  if (!value) {
    return value;
  }
  Expected<Value> result = converted(type, std::move(*value));
  if (!result) {
    result.error().place = expression.place;
  }
  return result;
}

Expected<void> Variables::fill(Variable& variable, std::size_t first, const Initial& initial) {
  const std::size_t room = variable.values.size() - first;
  if (initial.kind == Initial::Kind::Set) {
    if (initial.values.size() > room) {
      return fail(FaultCode::TooManyValues);
    }
    for (std::size_t i = 0; i < initial.values.size(); ++i) {
      if (!initial.values[i]) {
        continue;
      }
      Expected<Value> value = valueFor(variable.type, *initial.values[i]);
      store(variable.values[first + i], value ? *value : Value(kUnknown));
      if (!value) {
        return fail(value.error());
      }
    }
    return {};
  }
  if (initial.values.empty() || initial.values.size() > 2 || !initial.values[0]) {
    return fail(FaultCode::ListMalformed);
  }
  std::size_t count = initial.kind == Initial::Kind::One ? 1 : room;
  if (initial.values.size() == 2 && initial.values[1]) {
    const Expected<int> times = evaluateIndex(*initial.values[1], *this, m_semantics);
    if (!times) {
      return fail(times.error());
    }
    count = std::min(room, static_cast<std::size_t>(std::max(0, *times)));
  }
  const Expected<Value> value = valueFor(variable.type, *initial.values[0]);
  for (std::size_t i = first; i < first + count; ++i) {
    store(variable.values[i], value ? *value : Value(kUnknown));
  }
  return value ? Expected<void>() : fail(value.error());
}

Expected<void> Variables::assign(const Assignment& assignment) {
  const Expression& target = assignment.target;
  if (assignment.reference != Reference::Modal) {
    // Only the coordinate of an axis counts from somewhere.
    const bool isIncrement = assignment.reference == Reference::Incremental;
    return fail(FaultCode::NameUnknown, isIncrement ? "IC" : "AC", target.place);
  }
  if (target.op == Op::Variable && binding(target.name) != nullptr) {
    const Binding& bound = *binding(target.name);
    const Expected<std::size_t> element = elementOf(bound, target);
    if (!element) {
      Fault fault = element.error();
      fault.place = target.place;
      return fail(std::move(fault));
    }
    if (bound.element && assignment.initial.kind != Initial::Kind::One) {
      return fail(FaultCode::ListMalformed, {}, target.place);
    }
    return fill(*bound.variable, *element, assignment.initial);
  }
  if (assignment.initial.kind != Initial::Kind::One) {
    return fail(FaultCode::ListMalformed, {}, target.place);
  }
  Expected<Value> value = evaluate(*assignment.initial.values.front(), *this, m_semantics);
  Expected<void> done = assign(target, value ? *value : Value(kUnknown));
  if (value && !done && done.error().code == FaultCode::AlarmRaised && !assignment.text.empty()) {
    done.error().argument += " (" + assignment.text + ")";
  }
  return value ? done : fail(value.error());
}

Expected<void> Variables::assign(const Expression& target, Value value) {
  const auto placed = [&target](Fault fault) {
    fault.place = target.place;
    return fail(std::move(fault));
  };
  if (target.op == Op::Variable) {
    const Binding* found = binding(target.name);
    if (found == nullptr && target.name.starts_with('<')) {
      if (m_elements >= kElementsMax) {
        return fail(FaultCode::TooManyVariables, fmt::format("{}", kElementsMax), target.place);
      }
      ++m_elements;
      Scope& owner = isGlobal(target.name) ? m_globals : scope();
      auto fresh = std::make_shared<Variable>();
      fresh->values = {0.0};
      found = &owner.names.emplace(target.name, Binding{std::move(fresh), {}, false}).first->second;
    }
    if (found == nullptr) {
      return fail(FaultCode::NotDefined, target.name, target.place);
    }
    const Expected<std::size_t> element = elementOf(*found, target);
    if (!element) {
      return placed(element.error());
    }
    Expected<Value> fitting = converted(found->variable->type, std::move(value));
    store(found->variable->values[*element], fitting ? *fitting : Value(kUnknown));
    return fitting ? Expected<void>() : placed(fitting.error());
  }
  if (std::holds_alternative<std::string>(value)) {
    return fail(FaultCode::TypeMismatch, std::string(typeName(Type::Real)), target.place);
  }
  const auto* const known = std::get_if<double>(&value);
  const double number = known != nullptr ? *known : 0.0;
  if (target.op == Op::System) {
    const Expected<std::vector<Value>> indices = systemIndices(target, *this, m_semantics);
    if (!indices) {
      return fail(indices.error());
    }
    const Expected<void> done = setSystem(target.name, *indices, number);
    return done ? done : placed(done.error());
  }
  RIVULET_ASSERT(target.op == Op::R || target.op == Op::MainR || target.op == Op::Hash);
  const Expected<double> at = this->number(target.operands.front());
  if (!at) {
    return fail(at.error());
  }
  const double rounded = std::round(*at);
  if (!(rounded >= 0.0 && rounded < 1e6)) {
    return fail(target.op == Op::Hash ? FaultCode::VariableNumberMissing : FaultCode::NoSuchR,
                fmt::format("{}", *at), target.place);
  }
  const int index = static_cast<int>(rounded);
  const Expected<void> done = target.op == Op::Hash ? setNumbered(index, value)
                              : target.op == Op::R  ? setR(index, number)
                                                    : setMainR(index, number);
  return done ? done : placed(done.error());
}

Expected<void> Variables::setR(int index, double value) {
  const auto [r, isNew] = m_r.emplace(index, value);
  m_changes += isNew ? 1 : 0;
  store(r->second, value);
  return {};
}

Expected<void> Variables::setNumbered(int number, const Value& value) {
  const NumberKind kind = m_semantics.kindOf(number);
  number = m_semantics.canonical(number);
  switch (kind) {
    case NumberKind::Local:
    case NumberKind::Common:
    case NumberKind::Kept:
      break;
    case NumberKind::Nothing:
      return fail(FaultCode::NoSuchHash, fmt::format("#{}", number));
    case NumberKind::Alarm:
      return fail(FaultCode::AlarmRaised, fmt::format("#{}={}", number, textOf(value)));
    default:
      return fail(FaultCode::NumberNotWritable, fmt::format("#{}", number));
  }
  auto& numbers = (kind == NumberKind::Local ? scope() : m_globals).numbers;
  const auto* const written = std::get_if<double>(&value);
  if (written == nullptr) {
    // Vacant again. One that is kept would not be known any more: as far as this program goes, it
    // is.
    m_changes += numbers.erase(number);
    return {};
  }
  if (numbers.size() >= kNumbersMax && !numbers.contains(number)) {
    return fail(FaultCode::TooManyVariables, fmt::format("{}", kNumbersMax));
  }
  const auto [slot, isNew] = numbers.emplace(number, *written);
  m_changes += isNew ? 1 : 0;
  store(slot->second, *written);
  return {};
}

Expected<void> Variables::setMainR(int /*index*/, double /*value*/) {
  return fail(FaultCode::ControlWritten);
}

Expected<void> Variables::setSystem(std::string_view /*name*/, std::span<const Value> /*indices*/,
                                    double /*value*/) {
  return fail(FaultCode::ControlWritten);
}

// --- definitions and scopes -------------------------------------------------------------------

Expected<Variable> Variables::made(const Definition& definition) const {
  Variable variable;
  variable.type = definition.type;
  double elements = 1.0;
  for (const std::optional<Expression>& size : definition.sizes) {
    const Expected<double> value = size ? number(*size) : Expected<double>(0.0);
    if (!value) {
      return fail(value.error());
    }
    elements *= std::floor(*value);
    if (!(*value >= 1.0) || elements > static_cast<double>(kElementsMax)) {
      return fail(FaultCode::SizeMalformed, {}, definition.place);
    }
    variable.sizes.push_back(static_cast<int>(*value));
  }
  variable.values.assign(static_cast<std::size_t>(elements),
                         holdsText(definition.type) ? Value(std::string()) : Value(0.0));
  return variable;
}

Expected<void> Variables::define(const Definition& definition) {
  Expected<Variable> variable = made(definition);
  if (!variable) {
    return fail(variable.error());
  }
  const std::optional<int> r = definition.name.starts_with('R')
                                   ? base::parseInteger(definition.name.substr(1))
                                   : std::nullopt;
  if (r && definition.sizes.empty()) {
    // DEF REAL R0=5, as some programs have it: the R-parameter gets the value.
    const Expected<Value> value = definition.initial && definition.initial->values.front()
                                      ? valueFor(Type::Real, *definition.initial->values.front())
                                      : Expected<Value>(0.0);
    return value ? setR(*r, std::get<double>(*value)) : fail(value.error());  // Real is a number
  }
  m_elements += scope().names.contains(definition.name) ? 0 : variable->values.size();
  if (m_elements > kElementsMax) {
    return fail(FaultCode::TooManyVariables, fmt::format("{}", kElementsMax), definition.place);
  }
  auto owned = std::make_shared<Variable>(std::move(*variable));
  scope().names.insert_or_assign(definition.name, Binding{owned, {}, false});
  if (!definition.initial || definition.type == Type::Frame) {
    return {};
  }
  Expected<void> done = fill(*owned, 0, *definition.initial);
  if (!done && done.error().place.line.value == 0) {
    done.error().place = definition.place;
  }
  return done;
}

Expected<Scope> Variables::passed(std::span<const Definition> parameters,
                                  std::span<const std::optional<Expression>> arguments) const {
  if (arguments.size() > parameters.size()) {
    return fail(FaultCode::TooManyArguments, fmt::format("{}", parameters.size()));
  }
  Scope scope;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Definition& parameter = parameters[i];
    const Expression* const given = i < arguments.size() && arguments[i] ? &*arguments[i] : nullptr;
    const Binding* const of =
        given != nullptr && given->op == Op::Variable ? binding(given->name) : nullptr;
    Binding bound;
    if (given != nullptr && (parameter.isReference || !parameter.sizes.empty())) {
      if (of == nullptr) {
        return fail(FaultCode::ReferenceNeedsVariable, parameter.name, given->place);
      }
      bound = *of;
      if (!given->operands.empty()) {
        const Expected<std::size_t> element = elementOf(*of, *given);
        if (!element) {
          return fail(element.error());
        }
        bound.element = *element;
      }
      const std::size_t dimensions = bound.element ? 0 : of->variable->sizes.size();
      if (of->variable->type != parameter.type || dimensions != parameter.sizes.size()) {
        return fail(FaultCode::ReferenceTypeDiffers, parameter.name, given->place);
      }
      bound.isReference = parameter.isReference;
    } else {
      Definition local = parameter;
      for (std::optional<Expression>& size : local.sizes) {
        size = size ? std::move(size) : Expression::constant(1.0);
      }
      Expected<Variable> variable = made(local);
      if (!variable) {
        return fail(variable.error());
      }
      const std::optional<Initial>& initial = parameter.initial;
      const Expression* const source = given != nullptr ? given
                                       : initial && initial->kind == Initial::Kind::One
                                           ? &*initial->values.front()
                                           : nullptr;
      if (source != nullptr) {
        Expected<Value> value = valueFor(parameter.type, *source);
        if (!value) {
          return fail(value.error());
        }
        variable->values.front() = std::move(*value);
      }
      bound.variable = std::make_shared<Variable>(std::move(*variable));
    }
    scope.names.insert_or_assign(parameter.name, std::move(bound));
  }
  return scope;
}

void Variables::enter(const Scope& scope) {
  Scope own = scope;
  for (auto& [name, bound] : own.names) {
    if (!bound.isReference) {
      bound.variable = std::make_shared<Variable>(*bound.variable);
    }
  }
  m_scopes.push_back(std::move(own));
}

void Variables::leave() {
  RIVULET_ASSERT(m_scopes.size() > 1);
  for (const auto& [name, bound] : m_scopes.back().names) {
    m_elements -= bound.isReference ? 0 : std::min(m_elements, bound.variable->values.size());
  }
  m_scopes.pop_back();
}

}  // namespace rivulet::nc
