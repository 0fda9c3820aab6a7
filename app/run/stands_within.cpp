// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run/stands_within.h"

#include "machine/braking.h"
#include "permission/permission.h"

namespace rivulet::run {

base::Duration standsWithin(const machine::MachineConfig& machine,
                            const feasibility::TurnSize& turn, base::Duration perNode,
                            double feedMmPerS) {
  constexpr double kPercent = 100.0;
  const int nodes = feasibility::turnOf(turn).charged + 1;
  const double fastestMmPerS =
      feedMmPerS * permission::overridePercentMax(permission::Role::Engineer) / kPercent;
  return nodes * perNode + machine::brakingTime(machine, fastestMmPerS) +
         2 * machine.interpolationCycle;
}

}  // namespace rivulet::run
