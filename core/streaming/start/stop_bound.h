// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How far a run goes on after a stop that only its run cell tells: where the program has no feed
/// cell, or the control has not proved it. @threadsafety pure.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/id.h"
#include "base/vec3.h"
#include "gcode/feeds.h"
#include "gcode/trajectory.h"
#include "streaming/control/machine_facts.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

/// The motion between two places at which the program looks at its run cell.
struct StopBound {
  double seconds = 0.0;  ///< the longest, at an override of 100 %, without acceleration
  double mm = 0.0;       ///< the longest; not necessarily the same motion
  /// A single move that takes longer than windows may (`RunSettings::windowSMax`), the longest one:
  /// the first, from where the tool stands, or one of a whole job, which are not divided. Nothing:
  /// there is none, or windows may take any time.
  struct Move {
    base::LineNumber line;
    double seconds = 0.0;
    bool isFirst = false;  ///< from where the tool stands
  };
  std::optional<Move> longMove;
};

/// @param points  of the run; of live points nothing is known  @param settings  of the run
/// @param toolMm  where the tool stands; nothing: the way to the first point does not count
[[nodiscard]] StopBound stopBound(std::span<const gcode::StreamPoint> points,
                                  std::optional<base::Vec3> toolMm, const RunSettings& settings);

/// "Stop: the control still executes ...", with the reason. @param hasFeedCell  of the program
[[nodiscard]] std::string describe(const StopBound& bound, FeedProof proof, bool hasFeedCell);

/// What the program of a run is read with: its tolerance, and by what its moves are divided so that
/// none is longer than a window. No limit: the method has no windows, or they may take any time.
[[nodiscard]] gcode::MoveRules moveRules(const RunSettings& settings);

/// How long a window may take in a run on this control: see `RunSettings::windowSMax`.
/// @param limitS  of its machine, see `stopLimitS`  @return 0: any
[[nodiscard]] double windowSMaxOf(FeedProof proof, templates::TargetControl target, double limitS);

}  // namespace rivulet::streaming
