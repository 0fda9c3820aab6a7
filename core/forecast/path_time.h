// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The time of a program on a machine, computed with the look-ahead of the virtual machine, with a
/// standstill at each pause of the streaming method. @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gcode/feeds.h"
#include "gcode/trajectory.h"
#include "machine/config.h"

namespace rivulet::forecast {

struct PathTimeOptions {
  double feedMmPerS = 0.0;  ///< of all points, as a method streams them; 0: as programmed
  /// Instead of `feedMmPerS`: as a method streams them with the feeds of the program.
  std::optional<gcode::ProgramFeeds> programFeeds;
  /// Streamed points (those that do not repeat their predecessor) with a STOPRE after them,
  /// ascending. A STOPRE after the last point does not count: the program ends there.
  std::vector<std::uint32_t> pausesBehind;
  double pauseS = 0.0;  ///< standstill at each, in addition to braking and accelerating
  /// For less work: hundreds of blocks are planned at once, and of a trajectory with more points
  /// than this, so many are followed, in stretches spread evenly over it. What lies between takes
  /// as much longer than its length at its feed as they do. Nothing: all are, block by block.
  std::optional<std::size_t> followedMax{};
  /// Called now and then with the share done; false: cancel.
  std::function<bool(double share)> progress;
};

struct PathTime {
  std::vector<float> atS;  ///< when each point of the trajectory is passed, from the start
  double totalS = 0.0;
  double standingS = 0.0;  ///< part of it that is standstill in the pauses
  std::size_t pauses = 0;
};

/// Rapids are at the machine's rapid speed unless a method streams them as G1 (`feedMmPerS`).
/// @param trajectory  points with unknown coordinates start at `startMm`
/// @return nothing if it was cancelled
[[nodiscard]] std::optional<PathTime> pathTime(const gcode::Trajectory& trajectory,
                                               base::Vec3 startMm,
                                               const machine::MachineConfig& config,
                                               const PathTimeOptions& options);

}  // namespace rivulet::forecast
