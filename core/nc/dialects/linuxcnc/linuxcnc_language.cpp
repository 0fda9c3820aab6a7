// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/linuxcnc/linuxcnc.h"

#include "base/vec3.h"

namespace rivulet::nc::linuxcnc {

/// #5420 and on: the position. LinuxCNC, G-code overview, "Numbered Parameters".
std::optional<double> knownNumber(int number, const ModalState& /*state*/,
                                  const PositionOf& position) {
  constexpr int kFirst = 5420;
  return number >= kFirst && number < kFirst + static_cast<int>(base::kAxisCount)
             ? position(base::kAxisNames[static_cast<std::size_t>(number - kFirst)])
             : std::nullopt;
}

Language language() {
  Language made = rs274Language(Dialect::LinuxCnc);
  made.unitIsOfMachine = true;       // [TRAJ] LINEAR_UNITS
  made.feedComesBeforeUnits = true;  // G-code overview, "Order of Execution"
  made.keepsFeedOverUnits = true;
  made.hasRepeatedSigns = true;
  made.hasOStatements = true;
  made.assignsBehindBlock = true;
  made.returnsValues = true;
  made.knownNumber = knownNumber;
  made.hasPolarSigns = true;
  made.lengthIsOfTool = true;
  made.hasTurnsInP = true;
  made.sharesOffset = true;
  made.dwellsBesideMove = true;
  made.dwellNeedsP = true;
  made.hasCannedCycles = true;
  made.needsMotion = true;
  made.cycleOffEndsMotion = true;
  made.hasParameterE = true;
  made.leavesSplines = true;
  made.speedLimitIsD = true;
  made.savesFeedAndSpeed = true;
  return made;
}

}  // namespace rivulet::nc::linuxcnc
