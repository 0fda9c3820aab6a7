// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/fanuc/fanuc.h"

namespace rivulet::nc::fanuc {

Language language() {
  Language made = rs274Language(Dialect::Fanuc, macroNotation(), macroSemantics());
  // The operator's manuals write ";" for the end-of-block code, keep the unit of the last program
  // ("Inch/metric conversion"), and leave numbers without a point to a parameter ("Decimal point
  // programming").
  made.semicolonEndsBlock = true;
  made.unitIsOfMachine = true;
  made.mayCountIncrements = true;
  made.hasArgumentSets = true;
  made.hasModalMacros = true;
  made.packsRounds = true;
  made.returnTo = ReturnTo::Caller;
  made.knownNumber = knownNumber;
  made.hasTurningCycles = true;
  made.dwellInMilliseconds = true;
  made.setsListedOffsets = true;
  made.hasCommaWords = true;
  return made;
}

}  // namespace rivulet::nc::fanuc
