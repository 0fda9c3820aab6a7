// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Expressions of the SINUMERIK language over R-parameters. Compiled once when a program is
/// loaded, evaluated by the pre-run each time the block is interpreted. @threadsafety pure.
///
/// Priorities, strongest first: NOT B_NOT and the sign; * / DIV MOD; + -; B_AND; B_XOR; B_OR;
/// AND; XOR; OR; comparisons. Equal rank goes left to right; angles are in degrees; 0 is FALSE.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/alarm.h"

namespace rivulet::machine {

/// Gives the value of R[index] during an evaluation; nothing if there is no such parameter.
class RSource {
 public:
  virtual ~RSource() = default;
  [[nodiscard]] virtual std::optional<double> value(int index) const = 0;
};

/// A compiled expression: instructions for a small stack machine.
class Expression {
 public:
  /// @return nothing where the value cannot be computed; `alarm` then says why
  [[nodiscard]] std::optional<double> evaluate(const RSource& source, Alarm& alarm) const;

  /// True for a plain number.
  [[nodiscard]] bool isConstant() const;

 private:
  friend class ExpressionParser;
  enum class Op : unsigned char {
    Number,
    R,
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

/// Result of reading an expression from the front of a text.
struct ParsedExpression {
  Expression expression;
  std::size_t length = 0;  ///< characters read
};

/// Reads the longest expression at the front of `text` (upper case, leading blanks allowed).
/// @return nothing if there is none or it is malformed; `problem` then says why
[[nodiscard]] std::optional<ParsedExpression> parseExpression(std::string_view text,
                                                              std::string& problem);

}  // namespace rivulet::machine
