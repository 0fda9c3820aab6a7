// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A recorded program, planned by the look-ahead of the virtual machine with the limits of the
/// machine that was recorded. @threadsafety pure.
#pragma once

#include <vector>

#include "base/vec3.h"
#include "machine/config.h"
#include "training/recorded_run.h"

namespace rivulet::papers {

/// With exact stops the recorded planner uses this share of the axes' acceleration.
inline constexpr double kExactStopShare = 0.9;

/// The machine that was recorded: its limits are part of the recordings' description.
[[nodiscard]] machine::MachineConfig recordedMachine(double accelerationShare);

struct PlannedRun {
  double seconds = 0.0;
  std::vector<base::Vec3> commandsMm;  ///< after each interpolation cycle
  std::vector<double> speeds;          ///< of the path, mm/s, likewise
};

[[nodiscard]] PlannedRun planRun(const std::vector<machine::PreparedMotion>& blocks,
                                 base::Vec3 startMm, const machine::MachineConfig& config);

}  // namespace rivulet::papers
