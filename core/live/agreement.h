// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a live source and this run have agreed on. Nothing else moves the machine: the first line
/// that is outside ends the stream after the point before it.
/// @threadsafety plain values; one object, one thread.
#pragma once

#include <optional>

#include "base/axes.h"
#include "base/id.h"
#include "base/result.h"
#include "gcode/trajectory.h"
#include "live/line.h"

namespace rivulet::live {

struct Agreement {
  base::Vec3 lowestMm{-10.0, -10.0, -10.0};  ///< the box of all points, workpiece frame
  base::Vec3 highestMm{10.0, 10.0, 10.0};
  double stepMmMax = 5.0;           ///< between two points, > 0
  double turnDegMax = 5.0;          ///< the same of each rotary axis, > 0
  double feedMmPerMinMax = 1000.0;  ///< > 0
  double distanceMmMin = 0.001;     ///< points that are closer are merged, >= 0
  double startMmMax = 1.0;          ///< from the tool to the first point, >= 0

  friend bool operator==(const Agreement&, const Agreement&) = default;
};

/// A first point that is near enough to the tool can be in the box.
[[nodiscard]] bool reaches(const Agreement& agreement, const base::Vec3& toolMm);
/// With a box of the same size around the tool; its bounds are whole millimetres.
[[nodiscard]] Agreement around(Agreement agreement, const base::Vec3& toolMm);

/// Lets pass what has been agreed.
class Gate {
 public:
  /// @param tool  where the run begins
  /// @param feedMmPerMin  of points before the first F; not above the agreed one
  /// @param axes, rotaryAxes  that are streamed  @param packs  points lie on whole steps of
  ///        `base::Packing`
  Gate(const Agreement& agreement, const base::AxisPosition& tool, double feedMmPerMin,
       std::array<bool, base::kAxisCount> axes, base::RotarySet rotaryAxes, bool packs = false);

  /// @param line  a point
  /// @return the point; nothing: it is merged with the one before, which is too close; or why the
  ///         stream ends
  [[nodiscard]] base::Result<std::optional<gcode::StreamPoint>> take(const Line& line,
                                                                     base::LineNumber number);

 private:
  [[nodiscard]] base::Result<void> takeFeed(const Line& line);
  [[nodiscard]] base::Result<void> requireAxes(const Line& line) const;
  [[nodiscard]] base::Result<void> requireInside(base::Vec3 pointMm) const;
  [[nodiscard]] base::Result<void> requireNear(const base::AxisPosition& point) const;

  Agreement m_agreement;
  base::AxisPosition m_last;   ///< the point before; at first the tool
  base::AxisPosition m_named;  ///< what a line does not name is here
  double m_feedMmPerMin;
  std::array<bool, base::kAxisCount> m_axes;
  base::RotarySet m_rotaryAxes;
  bool m_packs;
  bool m_isFirst = true;
};

}  // namespace rivulet::live
