// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whether the tool is where the points that it may execute now can have brought it. A control that
/// executes old points again, leaves out points or moves for somebody else leaves this piece of the
/// path, or goes back on it. Two things remain hidden: points that are left out where the path is
/// straight, and old points beside the present ones. The trace of the control decides after the
/// run. @threadsafety plain values; one object, one thread.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "gcode/trajectory.h"

namespace rivulet::streaming {

/// What puts the tool beside the path, or behind the point that was passed, although nothing is
/// wrong.
struct PathSlack {
  double feedMmPerS = 10.0;   ///< of points without a feed of their own, > 0
  double correctionMm = 0.0;  ///< largest online correction of an axis, >= 0
  double passedMm = 0.0;      ///< a point counts as passed this far ahead of it, >= 0
};

class PathWatch {
 public:
  /// @param points  of the run; they outlive this object
  /// @param startMm  of the tool before the run
  PathWatch(std::span<const gcode::StreamPoint> points, base::Vec3 startMm, PathSlack slack);

  /// More points have arrived, which may have moved the others. @param points  all of the run
  void extend(std::span<const gcode::StreamPoint> points);

  /// Takes a position of the tool.
  /// @param passed  points known to be passed before the position was read
  /// @param sent  points that the control may have by now, >= passed
  /// @return distance to the path, mm, if this position and the one before are both off it
  [[nodiscard]] std::optional<double> add(base::Vec3 positionMm, std::size_t passed,
                                          std::size_t sent);

 private:
  /// 0: the start; otherwise the number of a point, from 1.
  [[nodiscard]] base::Vec3 placeMm(std::size_t place) const;
  /// Of the move to this place.
  [[nodiscard]] double feedMmPerS(std::size_t place) const;
  [[nodiscard]] double sideMm(std::size_t place) const;
  /// Follows the tool along the path. @param fromMm  along the path  @param to  last place
  /// @return distance of the tool to this piece
  double follow(base::Vec3 positionMm, double fromMm, std::size_t to);

  std::span<const gcode::StreamPoint> m_points;
  base::Vec3 m_startMm;
  PathSlack m_slack;
  std::vector<double> m_alongMm;  ///< of each place, along the path
  double m_reachedMm = 0.0;       ///< along the path: the tool has been here
  bool m_wasOff = false;
};

}  // namespace rivulet::streaming
