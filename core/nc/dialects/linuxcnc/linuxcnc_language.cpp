// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/linuxcnc/linuxcnc.h"

namespace rivulet::nc::linuxcnc {

Language language() {
  Language made = rs274Language(Dialect::LinuxCnc);
  made.unitIsOfMachine = true;  // [TRAJ] LINEAR_UNITS
  made.hasRepeatedSigns = true;
  made.hasPolarSigns = true;
  made.lengthIsOfTool = true;
  made.hasTurnsInP = true;
  made.sharesOffset = true;
  made.speedLimitIsD = true;
  made.savesFeedAndSpeed = true;
  return made;
}

}  // namespace rivulet::nc::linuxcnc
