// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Custom macro B: FANUC Series 30i Operator's Manual B-63944EN, chapter "Custom macro", sections
// "Variables", "System variables" and "Arithmetic and logic operation".

#include <array>
#include <cmath>

#include "nc/dialects/fanuc/fanuc.h"
#include "nc/modal/state.h"

namespace rivulet::nc::fanuc {

namespace {

constexpr std::array kComparisons{
    OperatorWord{"EQ", Op::Equal},     OperatorWord{"NE", Op::Unequal},
    OperatorWord{"LE", Op::LessEqual}, OperatorWord{"GE", Op::GreaterEqual},
    OperatorWord{"LT", Op::Less},      OperatorWord{"GT", Op::Greater}};
/// OR and XOR rank with the sum, AND with the product; all three work bit by bit.
constexpr std::array kSums{OperatorWord{"+", Op::Add}, OperatorWord{"-", Op::Subtract},
                           OperatorWord{"OR", Op::BitOr}, OperatorWord{"XOR", Op::BitXor}};
constexpr std::array kProducts{OperatorWord{"*", Op::Multiply}, OperatorWord{"/", Op::Divide},
                               OperatorWord{"AND", Op::BitAnd},
                               OperatorWord{"MOD", Op::WholeModulo}};
constexpr std::array<std::span<const OperatorWord>, 3> kLevels{kComparisons, kSums, kProducts};

/// The ranges of ASIN and of ATAN with two values are those of parameter 6004#0 as delivered.
constexpr std::array kFunctions{FunctionWord{"SIN", Op::Sin, 1},
                                FunctionWord{"COS", Op::Cos, 1},
                                FunctionWord{"TAN", Op::Tan, 1},
                                FunctionWord{"ASIN", Op::AsinPositive, 1},
                                FunctionWord{"ACOS", Op::Acos, 1},
                                FunctionWord{"ATAN", Op::AtanPositive, 2, Op::Atan},
                                FunctionWord{"ATN", Op::AtanPositive, 2, Op::Atan},
                                FunctionWord{"SQRT", Op::Sqrt, 1},
                                FunctionWord{"SQR", Op::Sqrt, 1},
                                FunctionWord{"ABS", Op::Abs, 1},
                                FunctionWord{"ROUND", Op::Round, 1},
                                FunctionWord{"RND", Op::Round, 1},
                                FunctionWord{"FIX", Op::Truncate, 1},
                                FunctionWord{"FUP", Op::AwayFromZero, 1},
                                FunctionWord{"BIN", Op::FromBcd, 1},
                                FunctionWord{"BCD", Op::ToBcd, 1},
                                FunctionWord{"LN", Op::Ln, 1},
                                FunctionWord{"EXP", Op::Exp, 1},
                                FunctionWord{"POW", Op::Power, 2}};

/// #100 and on are vacant when the control is switched on, #500 and on keep their values.
constexpr std::array kNumbers{
    NumberRange{0, 0, NumberKind::Vacant},         NumberRange{1, 33, NumberKind::Local},
    NumberRange{100, 199, NumberKind::Common},     NumberRange{500, 999, NumberKind::Kept},
    NumberRange{1000, 2999, NumberKind::Control},  NumberRange{3000, 3000, NumberKind::Alarm},
    NumberRange{3001, 999999, NumberKind::Control}};

}  // namespace

const Notation& macroNotation() {
  static constexpr Notation notation{kLevels, kFunctions, '[', ']', false, true, true};
  return notation;
}

const Semantics& macroSemantics() {
  static constexpr Semantics semantics{0.0, 0.0, false, true, kNumbers};
  return semantics;
}

std::optional<double> knownNumber(int number, const ModalState& state, const PositionOf& position) {
  constexpr int kFirstPosition = 5001;
  if (number >= kFirstPosition && number < kFirstPosition + static_cast<int>(base::kAxisCount)) {
    // Where the last block ended, without the offsets of the tool.
    return state.diameter
               ? std::nullopt
               : position(base::kAxisNames[static_cast<std::size_t>(number - kFirstPosition)]);
  }
  switch (number) {
    case 4001:
      return state.motion <= Motion::ArcCounter && !state.motionAssumed
                 ? std::optional(static_cast<double>(state.motion))
                 : std::nullopt;
    case 4002:
      return state.planeFirstAxis == 0 ? 17.0 : (state.planeFirstAxis == 2 ? 18.0 : 19.0);
    case 4003:
      return state.isLathe ? std::nullopt : std::optional(state.relative ? 91.0 : 90.0);
    default:
      return std::nullopt;
  }
}

}  // namespace rivulet::nc::fanuc
