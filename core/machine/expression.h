// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Expressions of the SINUMERIK language over R-parameters, variables and the main run. Compiled
/// once when a program is loaded, evaluated by the pre-run each time the block is interpreted.
/// @threadsafety pure.
///
/// Priorities, strongest first: NOT B_NOT and the sign; * / DIV MOD; + -; B_AND; B_XOR; B_OR;
/// AND; XOR; OR; comparisons. Equal rank goes left to right; angles are in degrees; 0 is FALSE.
/// Strings are not computed with.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/alarm.h"
#include "machine/main_run.h"

namespace rivulet::machine {

/// Gives the values an evaluation asks for; nothing where there is no such thing.
class ValueSource {
 public:
  virtual ~ValueSource() = default;
  /// R[index].
  [[nodiscard]] virtual std::optional<double> value(int index) const = 0;
  /// Variable of the program. @param element  0 for one that is no array
  [[nodiscard]] virtual std::optional<double> local(int /*slot*/, int /*element*/) const {
    return std::nullopt;
  }
  /// Variable of the main run; see `readsMainRun`.
  [[nodiscard]] virtual std::optional<double> system(SystemVariable /*variable*/,
                                                     int /*index*/) const {
    return std::nullopt;
  }
};

/// Variables a program has defined, by name in upper case.
struct VariableInfo {
  int slot = 0;
  std::vector<int> sizes;  ///< empty: no array
  bool isInteger = false;  ///< INT, BOOL, CHAR: whole numbers
  bool isString = false;
};
using VariableNames = std::map<std::string, VariableInfo, std::less<>>;

/// A compiled expression: instructions for a small stack machine.
class Expression {
 public:
  /// @return nothing where the value cannot be computed; `alarm` then says why
  [[nodiscard]] std::optional<double> evaluate(const ValueSource& source, Alarm& alarm) const;

  /// True if it asks for nothing.
  [[nodiscard]] bool isConstant() const;
  /// True if it asks the main run: a program that does so waits until the axes stand.
  [[nodiscard]] bool readsMainRun() const;
  /// For synchronized actions: what is known at interpretation becomes a number, `$R` and the
  /// variables of the main run stay. @return false if an R index is computed; `alarm` says so
  [[nodiscard]] bool freeze(const ValueSource& source, Alarm& alarm);

  [[nodiscard]] static Expression number(double value);
  [[nodiscard]] static Expression local(int slot);
  /// left + 1, left <= right, left == right: what control structures are made of.
  [[nodiscard]] static Expression next(Expression left);
  [[nodiscard]] static Expression notAbove(Expression left, const Expression& right);
  [[nodiscard]] static Expression equals(Expression left, const Expression& right);

 private:
  friend class ExpressionParser;
  enum class Op : unsigned char {
    Number,
    R,
    MainR,          ///< $R[..]
    Local,          ///< number: slot
    LocalElement,   ///< number: slot; the element is on the stack
    System,         ///< number: variable·8 + axis
    SystemElement,  ///< number: variable; the element is on the stack
    Negate,
    Not,
    BitNot,
    Multiply,
    Divide,
    IntegerDivide,
    Modulo,
    Add,
    Subtract,
    BitAnd,
    BitXor,
    BitOr,
    And,
    Xor,
    Or,
    Equal,
    Unequal,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan2,
    Sqrt,
    Pot,
    Abs,
    Trunc,
    Round,
    RoundUp,
    Ln,
    Exp,
    MinVal,
    MaxVal,
    Bound,
  };
  struct Instruction {
    Op op;
    double number;
  };
  std::vector<Instruction> m_code;
};

/// The variable of the main run with this name ("$AC_OVR"); nothing if there is none.
[[nodiscard]] std::optional<SystemVariable> systemVariableOf(std::string_view name);

/// Result of reading an expression from the front of a text.
struct ParsedExpression {
  Expression expression;
  std::size_t length = 0;  ///< characters read
};

/// Reads the longest expression at the front of `text` (upper case, leading blanks allowed).
/// @return nothing if there is none or it is malformed; `problem` then says why
[[nodiscard]] std::optional<ParsedExpression> parseExpression(std::string_view text,
                                                              std::string& problem,
                                                              const VariableNames* names = nullptr);

}  // namespace rivulet::machine
