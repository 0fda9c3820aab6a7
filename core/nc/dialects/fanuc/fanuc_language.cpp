// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/fanuc/fanuc.h"

namespace rivulet::nc::fanuc {

Language language() {
  Language made = rs274Language(Dialect::Fanuc);
  made.hasTurningCycles = true;
  made.dwellInMilliseconds = true;
  made.setsListedOffsets = true;
  made.hasCommaWords = true;
  return made;
}

}  // namespace rivulet::nc::fanuc
