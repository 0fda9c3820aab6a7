// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/grbl/grbl.h"

namespace rivulet::nc::grbl {

Language language() {
  Language made = rs274Language(Dialect::Grbl);
  // gcode.c of Grbl 1.1: a line is letters with numbers; errors 26, 28, 31 and 32.
  made.hasCalculations = false;
  made.cycleOffEndsMotion = true;
  made.arcsNameEnd = true;
  made.dwellNeedsP = true;
  return made;
}

}  // namespace rivulet::nc::grbl
