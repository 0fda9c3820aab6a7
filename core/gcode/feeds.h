// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The feeds of a program as a run commands them: each move with the feed of its own block, scaled
/// by one override, and never above the limits of the machine. @threadsafety pure.
#pragma once

#include <optional>

#include "base/id.h"
#include "gcode/trajectory.h"

namespace rivulet::gcode {

/// Range of the override: that of the path override of a control ($AC_OVR, OVR=).
inline constexpr double kOverrideMin = 0.01;
inline constexpr double kOverrideMax = 2.0;

/// The moves keep the proportions of their feeds.
struct ProgramFeeds {
  double overrideFactor = 1.0;  ///< `kOverrideMin` to `kOverrideMax`; scales rapids, too
  double rapidMmPerS = 0.0;     ///< of rapids at 100 %, and their limit; > 0
  double feedMmPerSMax = 0.0;   ///< no move is commanded faster; > 0

  friend bool operator==(const ProgramFeeds&, const ProgramFeeds&) = default;
};

/// Tolerances of streamed moves, mm and degrees: where steps are coarser the path is another.
inline constexpr double kStreamToleranceMax = 1.0;

/// What becomes of the straight moves of a program before they are streamed. Belongs to a run, so
/// that the same points come out when it is resumed. See `applyRules`.
struct MoveRules {
  /// How long a single one may take: what stops before the next window does not stop within a
  /// move. At an override of 100 %, without acceleration; 0: any.
  double secondsMax = 0.0;
  double feedMmPerS = 0.0;            ///< of all moves
  std::optional<ProgramFeeds> feeds;  ///< each move has the feed of its own block instead
  /// Fewer moves take the place of many within it, mm and degrees, up to `kStreamToleranceMax`; 0:
  /// the program's own.
  double tolerance = 0.0;
  bool onSteps = false;  ///< their ends are going to be moved to whole steps (`base::Packing`)

  friend bool operator==(const MoveRules&, const MoveRules&) = default;
};

/// The feed that is commanded for the move to this point; mm/s, or deg/s if it only turns.
/// @return 0 if the program gives the move no feed
[[nodiscard]] double commandedMmPerS(const TrajectoryPoint& point, const ProgramFeeds& feeds);

/// The first line that moves at a feed which is not known: F is missing, G95 without a spindle
/// speed, G93 where the length of the move is not known. Rapids need none. @return nothing: all are
/// known
[[nodiscard]] std::optional<base::LineNumber> lineWithoutFeed(const Trajectory& trajectory);

}  // namespace rivulet::gcode
