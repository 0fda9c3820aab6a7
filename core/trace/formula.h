// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Calculations with signals, such as `hypot(x_act - x_set, y_act - y_set)`: numbers, names of
/// signals, + - * / ^, brackets and functions. A name that is no word stands in single quotes:
/// 'Spindle load'. @threadsafety plain values.
///
/// Functions: abs sqrt exp ln; sin cos tan, atan2(y, x) in degrees; hypot, min, max of any number
/// of arguments; d(x), the change per second since the sample before; per_min(x), a value per
/// second as one per minute.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/instant.h"
#include "base/result.h"

namespace rivulet::trace {

enum class FormulaError {
  NotUnderstood = 1,  ///< the context is what is not understood
  NotComplete,
  UnknownFunction,  ///< the context is its name
  UnknownSignal,    ///< the context is its name
};

[[nodiscard]] std::error_code make_error_code(FormulaError code);

class Formula {
 public:
  /// @return error NotUnderstood, NotComplete, UnknownFunction
  [[nodiscard]] static base::Result<Formula> parse(std::string_view text);

  /// Of the signals it needs, in the order in which they occur.
  [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }
  /// It is the signal itself: there is nothing to calculate.
  [[nodiscard]] bool isName() const {
    return m_steps.size() == 1 && m_steps.front().operation == Operation::Name;
  }

  /// @param at  instants of the samples, ascending
  /// @param signalValues  for each of `names()` one value per instant
  /// @return one value per instant; NaN: not defined there
  [[nodiscard]] std::vector<double> evaluate(
      const std::vector<base::Instant>& at,
      const std::vector<std::vector<double>>& signalValues) const;

  enum class Operation {
    Number,
    Name,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Abs,
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Atan2,
    Hypot,
    Min,
    Max,
    Derivative,
    PerMinute,
  };

 private:
  friend class FormulaParser;

  /// In the order of a stack machine.
  struct Step {
    Operation operation = Operation::Number;
    double number = 0.0;
    std::size_t name = 0;
  };

  std::vector<Step> m_steps;
  std::vector<std::string> m_names;
};

}  // namespace rivulet::trace

template <>
struct std::is_error_code_enum<rivulet::trace::FormulaError> : std::true_type {};
