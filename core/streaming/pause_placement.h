// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Method window: where one window ends and the next begins. The machine stands there for a moment;
/// so the windows are cut, as far as their size allows, where the path stands or turns anyway.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gcode/trajectory.h"

namespace rivulet::streaming {

/// A change of direction from which on a stand-still leaves no mark that the corner would not: with
/// G64 the path slows down there anyway. Degrees.
inline constexpr double kCornerDegrees = 30.0;

struct PausePlacement {
  std::vector<std::size_t> begins;  ///< first point of each window; the first is 0
  std::size_t inCut = 0;            ///< pauses at places where the path neither stands nor turns

  [[nodiscard]] std::size_t windows() const { return begins.size(); }
  /// The end of the last window is the end of the run.
  [[nodiscard]] std::size_t pauses() const { return begins.empty() ? 0 : begins.size() - 1; }
};

/// True if a pause at the end of point i does no harm: a rapid ends or begins there, or the path
/// turns by `kCornerDegrees` or more. The last point counts as such a place.
[[nodiscard]] std::vector<bool> harmlessPauses(std::span<const gcode::StreamPoint> points);

/// Of all ways to cut the points into windows of at most M, one with the fewest pauses in the cut,
/// and among those one with the fewest windows. Exact: no other has fewer.
/// @param points at least 1  @param pointsPerWindow M, >= 1  @threadsafety pure; O(points · M).
[[nodiscard]] PausePlacement placePauses(std::span<const gcode::StreamPoint> points,
                                         std::size_t pointsPerWindow);

/// Windows of M points each, the last one shorter.
[[nodiscard]] PausePlacement evenPauses(std::span<const gcode::StreamPoint> points,
                                        std::size_t pointsPerWindow);

/// `placePauses` or `evenPauses`. Client and resume cut a run with the same call.
[[nodiscard]] PausePlacement cutWindows(std::span<const gcode::StreamPoint> points,
                                        std::size_t pointsPerWindow, bool place);

}  // namespace rivulet::streaming
