// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Computes expressions. Where the values of variables come from is a `ValueSource`: the variables
/// of a program that is read for its path, or the R-parameters and the main run of the virtual
/// machine. @threadsafety pure.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nc/fault.h"
#include "nc/syntax/expression.h"

namespace rivulet::nc {

/// Of a # variable that nobody has assigned, and of #0: an address with it is left out. It equals
/// itself alone; in all other operations it is 0.
struct Vacant {
  friend bool operator==(Vacant, Vacant) = default;
};

/// A number (truth: 1 and 0) or a text (STRING, CHAR in quotes, the name of an axis).
using Value = std::variant<double, std::string, Vacant>;

/// What a # variable is, by its number.
enum class NumberKind : std::uint8_t {
  Nothing,  ///< there is none of this number
  Vacant,   ///< #0: always, and not to be written
  Local,    ///< each level of calls has its own; vacant at its beginning, or 0
  Common,   ///< of all programs; vacant before it is assigned, or 0
  Kept,     ///< the same, and kept when the control is switched off: unknown before it is assigned
  Control,  ///< belongs to the control: positions, offsets, outputs
  Alarm,    ///< stops the program with the text behind it when it is written
};
struct NumberRange {
  int first;
  int last;
  NumberKind kind;
  int sameAs = 0;  ///< the number by which `first` is known as well; 0: it has one
};

/// How the control calculates.
struct Semantics {
  double equalRelative = 0.0;  ///< of the larger value
  double equalAbsolute = 0.0;
  bool strictExcludesEqual = false;        ///< < and > do not hold for what counts as equal
  bool knowsVacant = false;                ///< else a variable without a value is 0
  std::span<const NumberRange> numbers{};  ///< ascending

  [[nodiscard]] NumberKind kindOf(int number) const;
  /// The one number of a variable that has two.
  [[nodiscard]] int canonical(int number) const;

 private:
  [[nodiscard]] const NumberRange* rangeOf(int number) const;
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
  /// #5: a number, or vacant.
  [[nodiscard]] virtual Expected<Value> numbered(int number) const;
  /// Of an address with a length or an angle, in its unit.
  [[nodiscard]] virtual double leastIncrement() const { return 1e-3; }
  /// @param name  "$AA_IW"  @param indices  numbers, or names of axes as texts
  [[nodiscard]] virtual Expected<Value> system(std::string_view name,
                                               std::span<const Value> indices) const;
  [[nodiscard]] virtual bool exists(std::string_view name) const;
};

[[nodiscard]] Expected<Value> evaluate(const Expression& expression, const ValueSource& source,
                                       const Semantics& semantics);
/// What is vacant is 0. @return fault TextCalculated for a text
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
