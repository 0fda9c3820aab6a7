// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/grbl/grbl.h"

namespace rivulet::nc::grbl {

Language language() {
  Language made = rs274Language(Dialect::Grbl);
  // gcode.c of Grbl 1.1: a line is letters with numbers; errors 26, 28, 31 and 32.
  made.hasCalculations = false;
  made.keepsFeedOverUnits = true;  // in mm/min
  made.cycleOffEndsMotion = true;
  made.arcsNameEnd = true;
  made.dwellNeedsP = true;
  return made;
}

namespace {

/// TOLERANCE_EQUAL in Expression.cpp of FluidNC.
const Semantics& fluidNcSemantics() {
  static const Semantics semantics = [] {
    Semantics made = hashSemantics();
    made.equalAbsolute = 1e-5;
    return made;
  }();
  return semantics;
}

}  // namespace

/// Expression.cpp, Parameters.cpp and Flowcontrol.cpp of FluidNC: calculations, parameters that are
/// set behind their block, and O words as in RS-274/NGC.
Language fluidNcLanguage() {
  Language made = rs274Language(Dialect::FluidNc, hashNotation(), fluidNcSemantics());
  made.keepsFeedOverUnits = true;  // as Grbl
  made.hasOStatements = true;
  made.hasCommentsBehindOWords = true;
  made.assignsBehindBlock = true;
  made.cycleOffEndsMotion = true;
  made.arcsNameEnd = true;
  made.dwellNeedsP = true;
  return made;
}

}  // namespace rivulet::nc::grbl
