// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Circular and helical moves as chords. @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vec3.h"

namespace rivulet::gcode {

/// Difference of an arc's start and end radius that is rounding in the CAM system, mm: the arc
/// becomes a spiral. A larger one is an error, as on the control.
inline constexpr double kArcRadiusToleranceMm = 0.02;

/// An arc in its plane, or a helix across it. Workpiece frame.
struct Arc {
  base::Vec3 startMm;
  base::Vec3 endMm;
  base::Vec3 centreMm;        ///< only the two coordinates in the plane are used
  std::size_t firstAxis = 0;  ///< of the plane: 0 (G17: X Y), 2 (G18: Z X), 1 (G19: Y Z)
  bool clockwise = false;     ///< G2, seen against the third axis
};

/// Start and end radius, mm.
struct ArcRadii {
  double startMm = 0.0;
  double endMm = 0.0;
};
[[nodiscard]] ArcRadii arcRadii(const Arc& arc);

/// Centre of the arc through start and end with a given radius. The smaller of the two arcs for
/// a positive radius, the larger one for a negative. Only the coordinates in the plane are set.
/// @param arc       without centre; start and end differ in the plane
/// @param radiusMm  not 0; if shorter than half the chord, the arc becomes a half circle
[[nodiscard]] base::Vec3 arcCentre(const Arc& arc, double radiusMm);

/// Appends the corner points of the chords after the start; the last is exactly `endMm`.
/// If start and end coincide in the plane, the arc is a full circle. The radius runs linearly
/// over the angle from its value at the start to its value at the end, the third axis likewise.
/// @param chordToleranceMm  greatest distance of a chord from the arc, > 0
/// @return true length of the arc, mm
double flattenArc(const Arc& arc, double chordToleranceMm, std::vector<base::Vec3>& points);

}  // namespace rivulet::gcode
