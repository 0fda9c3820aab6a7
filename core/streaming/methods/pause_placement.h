// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the machine pauses because of the method: at the STOPREs of the program on the control.
/// Method window has a choice: as far as the size of its windows allows, it ends them where the
/// path stops or turns anyway. Where a window has one feed for all its points, it also ends where
/// the feed changes.
///
/// A pause is off the cut if it is at the end of a point for which one of these holds:
/// - the move to it is a rapid, so the tool is out of the material;
/// - the move to it is a retract, straight up along Z with no rotary axis turned: the cut is below
///   the tool;
/// - the path turns there by `kCornerDegrees` or more. The look-ahead brakes for such a corner
///   without any STOPRE: docs/methods.md says to which speed;
/// - it is the last point. Everywhere else a pause is in the cut: without it the tool would have
/// kept its speed. The end of a cut from which a rapid goes straight on is in the cut, too.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/method_kind.h"
#include "gcode/trajectory.h"

namespace rivulet::streaming {

/// Change of direction at which the path nearly stops, also with G64; degrees.
inline constexpr double kCornerDegrees = 45.0;

/// How a run is cut into windows.
struct WindowCut {
  bool place = true;          ///< end them where a pause does least harm, else as late as possible
  bool feedPerPoint = false;  ///< windows need not end where the feed changes
  /// Windows that take longer are divided, as far as they have several moves; s, without
  /// acceleration; 0: any.
  double secondsMax = 0.0;
  double feedMmPerS = 0.0;  ///< of points without one of their own; > 0 with `secondsMax`
  /// Axes whose coordinates share a cell: no point of a window is further from its first than fits
  /// (`base::Packing`); 0: each has its own.
  int packedAxes = 0;

  friend bool operator==(const WindowCut&, const WindowCut&) = default;
};

struct PausePlacement {
  std::vector<std::size_t> begins;  ///< first point of each window; the first is 0
  std::size_t inCut = 0;            ///< pauses that are not off the cut

  [[nodiscard]] std::size_t windows() const { return begins.size(); }
  /// The end of the last window is the end of the run.
  [[nodiscard]] std::size_t pauses() const { return begins.empty() ? 0 : begins.size() - 1; }
};

/// True if a pause at the end of point i is off the cut (see above).
[[nodiscard]] std::vector<bool> harmlessPauses(std::span<const gcode::StreamPoint> points);

/// Time of a straight move at its feed, without acceleration, s.
/// @param feedMmPerS  of a point without a feed of its own; > 0 then
[[nodiscard]] double moveS(const gcode::StreamPoint& from, const gcode::StreamPoint& to,
                           double feedMmPerS);

/// Of all ways to cut the points into windows of at most M, one with the fewest pauses in the cut,
/// and among those one with the fewest windows. Exact: no other has fewer. Windows end where the
/// feed changes, unless each point has its own.
/// @param points at least 1  @param pointsPerWindow M, >= 1  @threadsafety pure; O(points).
[[nodiscard]] PausePlacement placePauses(std::span<const gcode::StreamPoint> points,
                                         std::size_t pointsPerWindow, bool feedPerPoint = false);

/// Windows of M points each; the last one, and those that end where the feed changes, are shorter.
[[nodiscard]] PausePlacement evenPauses(std::span<const gcode::StreamPoint> points,
                                        std::size_t pointsPerWindow, bool feedPerPoint = false);

/// `placePauses` or `evenPauses`, with windows that are no longer than they may be. How long the
/// move to the first point takes is not known here: it does not count. Client and resume cut a run
/// with the same call.
[[nodiscard]] PausePlacement cutWindows(std::span<const gcode::StreamPoint> points,
                                        std::size_t pointsPerWindow, WindowCut cut);

/// One pause of a run that is still to come.
struct PlannedPause {
  std::uint32_t point = 0;  ///< index of the point at whose end the axes stop
  bool inCut = false;
  friend bool operator==(const PlannedPause&, const PlannedPause&) = default;
};

/// Every pause of a run, in order: with methods window and file between windows, with method
/// position after each loop, with method signal after each half of a loop. There is none after the
/// last point, and none with method credit as long as the client is on time.
/// @param points         at least 1
/// @param pointsPerLoop  N, >= 1; method window: M
/// @param cut            methods with windows: `cutWindows`
[[nodiscard]] std::vector<PlannedPause> plannedPauses(std::span<const gcode::StreamPoint> points,
                                                      base::MethodKind method,
                                                      std::size_t pointsPerLoop,
                                                      WindowCut cut = {});

[[nodiscard]] std::size_t pausesInCut(std::span<const PlannedPause> pauses);

}  // namespace rivulet::streaming
