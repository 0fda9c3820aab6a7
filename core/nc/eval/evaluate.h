// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Computes expressions. Where the values of variables come from is a `ValueSource`: the variables
/// of a program that is read for its path, or the R-parameters and the main run of the virtual
/// machine. @threadsafety pure.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nc/fault.h"
#include "nc/syntax/expression.h"

namespace rivulet::nc {

/// A number (truth: 1 and 0) or a text (STRING, CHAR in quotes, the name of an axis).
using Value = std::variant<double, std::string>;

/// How the control compares.
struct Semantics {
  double equalRelative = 0.0;  ///< of the larger value
  double equalAbsolute = 0.0;
  bool strictExcludesEqual = false;  ///< < and > do not hold for what counts as equal
};
/// Relative 1e-12 for all six comparisons.
[[nodiscard]] const Semantics& sinumerikSemantics();
/// RS-274/NGC: 1e-4 for EQ NE LE GE, exact for LT and GT.
[[nodiscard]] const Semantics& hashSemantics();

[[nodiscard]] bool areEqual(double a, double b, const Semantics& semantics);

/// Gives the values an evaluation asks for, or says why there is none. What is not finite stands
/// for a value that an earlier fault has left unknown.
class ValueSource {
 public:
  virtual ~ValueSource() = default;
  [[nodiscard]] virtual Expected<double> r(int index) const = 0;
  /// $R: the R-parameter as the main run sees it.
  [[nodiscard]] virtual Expected<double> mainR(int index) const { return r(index); }
  /// @param name  upper case; "<NAME>" for #<name>
  [[nodiscard]] virtual Expected<Value> variable(std::string_view name,
                                                 std::span<const int> indices) const;
  /// #5.
  [[nodiscard]] virtual Expected<double> numbered(int number) const;
  /// @param name  "$AA_IW"  @param indices  numbers, or names of axes as texts
  [[nodiscard]] virtual Expected<Value> system(std::string_view name,
                                               std::span<const Value> indices) const;
  [[nodiscard]] virtual bool exists(std::string_view name) const;
};

[[nodiscard]] Expected<Value> evaluate(const Expression& expression, const ValueSource& source,
                                       const Semantics& semantics);
/// @return fault TextCalculated for a text
[[nodiscard]] Expected<double> evaluateNumber(const Expression& expression,
                                              const ValueSource& source,
                                              const Semantics& semantics);
/// Rounds as the control rounds an index. @return fault IndexOutsideArray beyond 1e6
[[nodiscard]] Expected<int> evaluateIndex(const Expression& expression, const ValueSource& source,
                                          const Semantics& semantics);
/// The indices of a system variable: names that are not variables are axes.
[[nodiscard]] Expected<std::vector<Value>> systemIndices(const Expression& system,
                                                         const ValueSource& source,
                                                         const Semantics& semantics);

/// "12.5", or the text itself.
[[nodiscard]] std::string textOf(const Value& value);

/// True if the expression asks for no variable at all.
[[nodiscard]] bool isConstant(const Expression& expression);

/// Computes all that does not depend on `$` variables, which stay: for synchronized actions.
[[nodiscard]] Expected<Expression> freeze(const Expression& expression, const ValueSource& source,
                                          const Semantics& semantics);

}  // namespace rivulet::nc
