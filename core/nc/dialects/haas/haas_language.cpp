// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/haas/haas.h"

#include "nc/dialects/fanuc/fanuc.h"

namespace rivulet::nc::haas {

Language language() {
  Language made = rs274Language(Dialect::Haas, macroNotation(), macroSemantics());
  made.hasArgumentSets = true;
  made.keepsArguments = true;
  made.returnTo = ReturnTo::Itself;
  made.knownNumber = fanuc::knownNumber;
  made.hasTurningCycles = true;
  made.dwellInMilliseconds = true;
  return made;
}

}  // namespace rivulet::nc::haas
