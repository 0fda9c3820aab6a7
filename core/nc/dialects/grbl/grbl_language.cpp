// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/grbl/grbl.h"

#include "nc/dialects/linuxcnc/linuxcnc.h"

namespace rivulet::nc::grbl {

Language language() {
  Language made = rs274Language(Dialect::Grbl);
  made.assignsBehindBlock = true;
  made.knownNumber = linuxcnc::knownNumber;
  return made;
}

}  // namespace rivulet::nc::grbl
