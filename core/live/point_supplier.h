// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the points of a run come from: a method with windows pulls window after window from here,
/// and knows nothing else of it. A list that is complete before the run is a supplier, points that
/// arrive meanwhile are another (`PointStream`). @threadsafety one object, on the thread of the
/// run.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "gcode/trajectory.h"
#include "live/summary.h"

namespace rivulet::live {

/// What a method makes windows of.
struct WindowPlan {
  std::size_t pointsMax = 1;   ///< >= 1
  std::size_t windowsMax = 1;  ///< that may wait or move on the control, for the theory
  bool feedPerPoint = false;   ///< else a window ends where the feed changes
  /// No window takes longer, s, without acceleration; a longer move is divided. 0: any.
  double secondsMax = 0.0;
  int packedAxes = 0;  ///< whose coordinates share a cell; 0: each has its own
};

/// The run for which points are wanted.
struct SupplyStart {
  base::AxisPosition tool;                    ///< where it begins
  double feedMmPerMin = 0.0;                  ///< of points without one of their own
  std::array<bool, base::kAxisCount> axes{};  ///< that are streamed
  base::RotarySet rotaryAxes{};
  WindowPlan plan;
};

class PointSupplier {
 public:
  PointSupplier() = default;
  PointSupplier(const PointSupplier&) = delete;
  PointSupplier& operator=(const PointSupplier&) = delete;
  virtual ~PointSupplier() = default;

  /// The program on the control waits for the first window.
  virtual void begin(const SupplyStart& /*start*/, base::Instant /*now*/) {}
  /// Often, as long as the run wants points.
  virtual void turn(base::Instant /*now*/) {}

  /// The next window, if it is time for it: its points follow in `points` on those of the windows
  /// before. @return number of points, at least 1; nothing: not now
  [[nodiscard]] virtual std::optional<std::size_t> takeWindow(base::Instant now) = 0;
  /// At least those of the windows that were taken, at the same place as long as the run lasts.
  [[nodiscard]] virtual const std::vector<gcode::StreamPoint>& points() const = 0;
  /// First point of each window that was taken, and the number of their points at the end.
  [[nodiscard]] virtual const std::vector<std::size_t>& windowBegins() const = 0;
  /// No window comes after those that were taken.
  [[nodiscard]] virtual bool isDry() const = 0;
  /// Every window is there before the run, so that it starts with all slots filled.
  [[nodiscard]] virtual bool isComplete() const { return false; }

  /// The machine is to wait although it could move on.
  [[nodiscard]] virtual bool wantsHold(base::Instant /*now*/) const { return false; }
  /// The window after those that move or have been executed begins to move.
  virtual void windowMoves(base::Instant /*now*/) {}
  /// @param points  executed so far
  virtual void executed(std::size_t /*points*/) {}
  /// @param outcome  of the run, "completed" @param error  may be empty
  virtual void finish(std::string_view /*outcome*/, const std::string& /*error*/) {}

  /// Points that are known so far.
  [[nodiscard]] virtual std::size_t accepted() const { return points().size(); }
  [[nodiscard]] virtual Summary summary() const { return {}; }
  [[nodiscard]] virtual Level level() const { return {}; }
};

}  // namespace rivulet::live
