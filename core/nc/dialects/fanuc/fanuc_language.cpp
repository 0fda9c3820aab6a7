// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/fanuc/fanuc.h"

#include <array>
#include <string_view>

namespace rivulet::nc::fanuc {

Language languageLike(Dialect dialect, const Notation& notation, const Semantics& semantics) {
  static constexpr std::array<std::string_view, 5> kSteering{"IF", "WHILE", "DO", "END", "GOTO"};
  Language made = rs274Language(dialect, notation, semantics);
  made.steering = kSteering;
  // The operator's manuals write ";" for the end-of-block code, keep the unit of the last program
  // ("Inch/metric conversion"), and leave numbers without a point to a parameter ("Decimal point
  // programming").
  made.semicolonEndsBlock = true;
  made.unitIsOfMachine = true;
  made.mayCountIncrements = true;
  made.hasArgumentSets = true;
  made.knownNumber = knownNumber;
  made.hasTurningCycles = true;
  made.dwellInMilliseconds = true;
  made.setsListedOffsets = true;
  made.hasCommaWords = true;
  // "Optional block skip": a slash within a block leaves out what stands behind it.
  made.skipsWithinBlocks = true;
  return made;
}

Language language() {
  Language made = languageLike(Dialect::Fanuc, macroNotation(), macroSemantics());
  made.packsRounds = true;
  made.returnTo = ReturnTo::Caller;
  made.arcMayBeLine = true;  // parameter 3403 (CIR)
  return made;
}

}  // namespace rivulet::nc::fanuc
