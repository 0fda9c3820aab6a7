// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How long a machine takes for a program: the look-ahead of the virtual machine runs over it, and
/// stands where the streaming method makes it stand. @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gcode/trajectory.h"
#include "machine/config.h"

namespace rivulet::experiments {

struct PathTimeOptions {
  double feedMmPerS = 0.0;  ///< of all points, as a method streams them; 0: as programmed
  /// Streamed points (those that do not repeat their predecessor) with a STOPRE behind them,
  /// ascending. One behind the last point is none: the program ends there.
  std::vector<std::uint32_t> pausesBehind;
  double pauseS = 0.0;  ///< what the axes stand at each, beyond braking and accelerating
  /// Told now and then the share done; false: give up.
  std::function<bool(double share)> progress;
};

struct PathTime {
  std::vector<float> atS;  ///< when each point of the trajectory is passed, from the start
  double totalS = 0.0;
  double standingS = 0.0;  ///< of it, in the pauses
  std::size_t pauses = 0;
};

/// Rapids run with the machine's rapid speed unless a method streams them as G1 (`feedMmPerS`).
/// @param trajectory  points with unknown coordinates start at `startMm`
/// @return nothing if it was given up
[[nodiscard]] std::optional<PathTime> pathTime(const gcode::Trajectory& trajectory,
                                               base::Vec3 startMm,
                                               const machine::MachineConfig& config,
                                               const PathTimeOptions& options);

}  // namespace rivulet::experiments
