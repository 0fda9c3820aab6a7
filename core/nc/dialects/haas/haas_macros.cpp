// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Macros of Haas: Mill Operator's Manual 96-8000, chapter "Macros", sections "Macro variables",
// "Functions", "Notes on functions" and "Operators".

#include <array>

#include "nc/dialects/fanuc/fanuc.h"
#include "nc/dialects/haas/haas.h"

namespace rivulet::nc::haas {

namespace {

constexpr std::array kFunctions{
    FunctionWord{"SIN", Op::Sin, 1},     FunctionWord{"COS", Op::Cos, 1},
    FunctionWord{"TAN", Op::Tan, 1},     FunctionWord{"ASIN", Op::Asin, 1},
    FunctionWord{"ACOS", Op::Acos, 1},   FunctionWord{"ATAN", Op::AtanPositive, 2, Op::Atan},
    FunctionWord{"SQRT", Op::Sqrt, 1},   FunctionWord{"ABS", Op::Abs, 1},
    FunctionWord{"ROUND", Op::Round, 1}, FunctionWord{"FIX", Op::Truncate, 1}};

/// All variables but the local ones are saved when the control is switched off. Newer controls know
/// the old numbers as well: #100 is #10000, #500 is #10500, #800 is #10800.
constexpr std::array kNumbers{NumberRange{0, 0, NumberKind::Vacant},
                              NumberRange{1, 33, NumberKind::Local},
                              NumberRange{100, 199, NumberKind::Kept},
                              NumberRange{500, 699, NumberKind::Kept},
                              NumberRange{700, 799, NumberKind::Control},
                              NumberRange{800, 999, NumberKind::Kept},
                              NumberRange{1000, 2999, NumberKind::Control},
                              NumberRange{3000, 3000, NumberKind::Alarm},
                              NumberRange{3001, 9999, NumberKind::Control},
                              NumberRange{10000, 10099, NumberKind::Kept, 100},
                              NumberRange{10100, 10199, NumberKind::Kept},
                              NumberRange{10200, 10499, NumberKind::Kept},
                              NumberRange{10500, 10699, NumberKind::Kept, 500},
                              NumberRange{10700, 10799, NumberKind::Kept},
                              NumberRange{10800, 10999, NumberKind::Kept, 800},
                              NumberRange{11000, 999999, NumberKind::Control}};

}  // namespace

const Notation& macroNotation() {
  static const Notation notation{
      fanuc::macroNotation().levels, kFunctions, '[', ']', false, true, true};
  return notation;
}

const Semantics& macroSemantics() {
  static constexpr Semantics semantics{0.0, 0.0, false, true, kNumbers};
  return semantics;
}

}  // namespace rivulet::nc::haas
