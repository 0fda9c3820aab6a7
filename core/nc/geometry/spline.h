// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// B-splines and Bézier curves as chords. @threadsafety pure.
#pragma once

#include <vector>

#include "base/vec3.h"

namespace rivulet::nc {

/// A rational B-spline. Workpiece frame or any other: the curve is where its points are.
struct Spline {
  int degree = 3;  ///< >= 1
  /// At least degree + 1. NaN along an axis in all of them: there the curve stays where it is.
  std::vector<base::Vec3> controlMm;
  std::vector<double> weights;  ///< one per control point, > 0
  std::vector<double> knots;    ///< control points + degree + 1, ascending
};

/// Knots of equal distance with the ends repeated, so that the curve begins at the first control
/// point and ends at the last. @pre points > degree
[[nodiscard]] std::vector<double> clampedKnots(std::size_t points, int degree);

/// True if it can be drawn: as many knots as it needs, ascending, and the curve begins at the first
/// control point and ends at the last.
[[nodiscard]] bool isClamped(const Spline& spline);

/// The point at a parameter between the knots degree and points.
[[nodiscard]] base::Vec3 splinePoint(const Spline& spline, double parameter);

/// Appends the corner points of the chords after the start; the last is the last control point.
/// Halves each span until three points of it in between lie within the tolerance of their chord.
/// @param chordToleranceMm > 0
/// @return length of the chords, mm
double flattenSpline(const Spline& spline, double chordToleranceMm,
                     std::vector<base::Vec3>& points);

}  // namespace rivulet::nc
