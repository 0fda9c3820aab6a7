// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the machine stands for a moment because of the method: at the STOPREs of the program on
/// the control. Method window may choose: its windows are cut, as far as their size allows, where
/// the path stands or turns anyway.
///
/// Off the cut is a pause at the end of a point where one of these holds:
/// - the move to it is a rapid, so the tool is out of the material;
/// - the move to it is a retract, straight up along Z with no rotary axis turned: what was cut lies
///   below the tool;
/// - the path turns there by `kCornerDegrees` or more. The look-ahead brakes for such a corner
///   without any STOPRE: docs/methods.md says to which speed;
/// - it is the last point.
/// Everywhere else a pause is in the cut: the tool would have gone on at its speed. The end of a
/// cut from which a rapid goes straight on is in the cut, too.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/method_kind.h"
#include "gcode/trajectory.h"

namespace rivulet::streaming {

/// A change of direction for which the path slows down to next to nothing, with G64 too. Degrees.
inline constexpr double kCornerDegrees = 45.0;

struct PausePlacement {
  std::vector<std::size_t> begins;  ///< first point of each window; the first is 0
  std::size_t inCut = 0;            ///< pauses that are not off the cut

  [[nodiscard]] std::size_t windows() const { return begins.size(); }
  /// The end of the last window is the end of the run.
  [[nodiscard]] std::size_t pauses() const { return begins.empty() ? 0 : begins.size() - 1; }
};

/// True if a pause at the end of point i is off the cut (see above).
[[nodiscard]] std::vector<bool> harmlessPauses(std::span<const gcode::StreamPoint> points);

/// Of all ways to cut the points into windows of at most M, one with the fewest pauses in the cut,
/// and among those one with the fewest windows. Exact: no other has fewer.
/// @param points at least 1  @param pointsPerWindow M, >= 1  @threadsafety pure; O(points).
[[nodiscard]] PausePlacement placePauses(std::span<const gcode::StreamPoint> points,
                                         std::size_t pointsPerWindow);

/// Windows of M points each, the last one shorter.
[[nodiscard]] PausePlacement evenPauses(std::span<const gcode::StreamPoint> points,
                                        std::size_t pointsPerWindow);

/// `placePauses` or `evenPauses`. Client and resume cut a run with the same call.
[[nodiscard]] PausePlacement cutWindows(std::span<const gcode::StreamPoint> points,
                                        std::size_t pointsPerWindow, bool place);

/// One pause of a run that is still to come.
struct PlannedPause {
  std::uint32_t point = 0;  ///< index of the point at whose end the axes stand
  bool inCut = false;
  friend bool operator==(const PlannedPause&, const PlannedPause&) = default;
};

/// Every pause of a run, in order: of methods window and file between its windows, of method
/// position behind each loop, of method signal behind each half of a loop. There is none behind the
/// last point, and none with method credit as long as the client is on time.
/// @param points         at least 1
/// @param pointsPerLoop  N, >= 1; method window: M
/// @param place          methods window and file: `cutWindows`
[[nodiscard]] std::vector<PlannedPause> plannedPauses(std::span<const gcode::StreamPoint> points,
                                                      base::MethodKind method,
                                                      std::size_t pointsPerLoop, bool place = true);

[[nodiscard]] std::size_t pausesInCut(std::span<const PlannedPause> pauses);

}  // namespace rivulet::streaming
