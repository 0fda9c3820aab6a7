// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A machine that gives the client little time: it knows no jerk, passes short blocks at full
/// feed, and its accesses scatter more. On it both methods fail at moderate feeds.
#pragma once

#include "machine/config.h"

namespace rivulet::tests {

inline machine::MachineConfig hardMachine() {
  machine::MachineConfig machine = *machine::loadPreset("dmu75");
  machine.resetDynamics = machine::Dynamics::Brisk;
  machine.blocksPerCycleMax = 0.0;
  machine.relatch = std::chrono::milliseconds{30};
  machine.access.nodeTimeDeviation = std::chrono::milliseconds{2};
  machine.access.readOverhead = std::chrono::microseconds{900};
  return machine;
}

}  // namespace rivulet::tests
