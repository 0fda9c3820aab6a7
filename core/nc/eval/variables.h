// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The variables of a running NC program: DEF, parameters by value and by reference, R-parameters,
/// # variables. Each subprogram has a scope of its own. @threadsafety one object, one thread.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nc/eval/evaluate.h"

namespace rivulet::nc {

struct Variable {
  Type type = Type::Real;
  std::vector<int> sizes;     ///< of an array, at most three; empty: none
  std::vector<Value> values;  ///< one, or all of the array row by row
};

/// What a name stands for: a variable, or through a VAR parameter that of the caller.
struct Binding {
  std::shared_ptr<Variable> variable;
  std::optional<std::size_t> element;  ///< one element of an array is given by reference
  bool isReference = false;
};

/// The variables of one program or subprogram.
struct Scope {
  std::map<std::string, Binding, std::less<>> names;  ///< upper case
  std::map<int, double> numbers;                      ///< # variables of its own; else vacant
};

/// By itself it knows no variable of the control and no R-parameter that was not assigned: a
/// derived class answers for the machine.
class Variables : public ValueSource {
 public:
  explicit Variables(const Semantics& semantics) : m_semantics(semantics), m_scopes(1) {}

  [[nodiscard]] Expected<double> r(int index) const override;
  [[nodiscard]] Expected<Value> variable(std::string_view name,
                                         std::span<const int> indices) const override;
  [[nodiscard]] Expected<Value> numbered(int number) const override;
  [[nodiscard]] bool exists(std::string_view name) const override;

  [[nodiscard]] const Semantics& semantics() const { return m_semantics; }
  [[nodiscard]] Expected<double> number(const Expression& expression) const {
    return evaluateNumber(expression, *this, m_semantics);
  }

  /// After a failure the target has no value: what is made of it fails as well.
  [[nodiscard]] Expected<void> assign(const Assignment& assignment);
  [[nodiscard]] Expected<void> assign(const Expression& target, Value value);
  [[nodiscard]] Expected<void> define(const Definition& definition);

  [[nodiscard]] const Variable* find(std::string_view upperName) const;

  /// The scope a subprogram begins with: values and variables of the caller, which is the present
  /// scope. @param arguments  nothing: left out, 0 or what PROC says
  [[nodiscard]] Expected<Scope> passed(std::span<const Definition> parameters,
                                       std::span<const std::optional<Expression>> arguments) const;
  /// The scope may be entered again: its values are copied, its references are not.
  void enter(const Scope& scope);
  /// @pre entered
  void leave();
  [[nodiscard]] Scope& scope() { return m_scopes.back(); }
  [[nodiscard]] std::size_t depth() const { return m_scopes.size(); }
  /// Counts the values that were changed, and those read that change by themselves.
  [[nodiscard]] std::uint64_t changes() const { return m_changes; }

 protected:
  /// Of a value that is not the program's own.
  void noteChange() const { ++m_changes; }
  /// @param value  NaN: not known
  [[nodiscard]] virtual Expected<void> setR(int index, double value);
  [[nodiscard]] Expected<void> setNumbered(int number, const Value& value);
  [[nodiscard]] virtual Expected<void> setMainR(int index, double value);
  [[nodiscard]] virtual Expected<void> setSystem(std::string_view name,
                                                 std::span<const Value> indices, double value);

 private:
  [[nodiscard]] const Binding* binding(std::string_view name) const;
  [[nodiscard]] Expected<std::size_t> elementOf(const Binding& binding,
                                                std::span<const int> indices) const;
  [[nodiscard]] Expected<std::size_t> elementOf(const Binding& binding,
                                                const Expression& target) const;
  [[nodiscard]] Expected<Value> converted(Type type, Value value) const;
  [[nodiscard]] Expected<void> fill(Variable& variable, std::size_t first, const Initial& initial);
  [[nodiscard]] Expected<Value> valueFor(Type type, const Expression& expression) const;
  [[nodiscard]] Expected<Variable> made(const Definition& definition) const;
  /// In place of what was there before.
  template <class T>
  void store(T& slot, T value);

  const Semantics& m_semantics;
  std::vector<Scope> m_scopes;
  mutable std::uint64_t m_changes = 0;
  std::size_t m_elements = 0;  ///< of variables with names
  Scope m_globals;             ///< # variables of all programs, #<_name>
  std::map<int, double> m_r;   ///< those assigned
};

}  // namespace rivulet::nc
