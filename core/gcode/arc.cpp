// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/contract.h"

namespace rivulet::gcode {

namespace {

/// Closer than this, start and end are the same point: coordinates carry at most 6 decimals, and
/// sums of increments are off by far less.
constexpr double kSamePointMm = 1e-7;

/// A quarter circle is never one chord, whatever the tolerance: a full circle keeps its shape.
constexpr double kChordAngleMax = std::numbers::pi / 2.0;

struct Plane {
  std::size_t first;
  std::size_t second;
  std::size_t third;
};

Plane planeOf(const Arc& arc) {
  return {arc.firstAxis, (arc.firstAxis + 1) % base::kAxisCount,
          (arc.firstAxis + 2) % base::kAxisCount};
}

double distanceInPlane(const Plane& plane, base::Vec3 a, base::Vec3 b) {
  return std::hypot(b[plane.first] - a[plane.first], b[plane.second] - a[plane.second]);
}

}  // namespace

ArcRadii arcRadii(const Arc& arc) {
  const Plane plane = planeOf(arc);
  return {distanceInPlane(plane, arc.centreMm, arc.startMm),
          distanceInPlane(plane, arc.centreMm, arc.endMm)};
}

base::Vec3 arcCentre(const Arc& arc, double radiusMm) {
  const Plane plane = planeOf(arc);
  const double chordFirst = arc.endMm[plane.first] - arc.startMm[plane.first];
  const double chordSecond = arc.endMm[plane.second] - arc.startMm[plane.second];
  const double chordMm = std::hypot(chordFirst, chordSecond);
  RIVULET_ASSERT(chordMm > 0.0);
  const double halfMm = chordMm / 2.0;
  const double magnitudeMm = std::abs(radiusMm);
  // Factored, so that a half circle does not lose its digits to cancellation.
  const double heightMm = std::sqrt(std::max(0.0, (magnitudeMm - halfMm) * (magnitudeMm + halfMm)));
  // The centre of the smaller arc lies to the right of the chord for G2, to the left for G3.
  const double side = (arc.clockwise ? -1.0 : 1.0) * (radiusMm < 0.0 ? -1.0 : 1.0);
  base::Vec3 centreMm = arc.startMm;
  centreMm.set(plane.first, arc.startMm[plane.first] + chordFirst / 2.0 -
                                side * heightMm * chordSecond / chordMm);
  centreMm.set(plane.second, arc.startMm[plane.second] + chordSecond / 2.0 +
                                 side * heightMm * chordFirst / chordMm);
  return centreMm;
}

double flattenArc(const Arc& arc, double chordToleranceMm, std::vector<base::Vec3>& points) {
  RIVULET_ASSERT(chordToleranceMm > 0.0);
  const Plane plane = planeOf(arc);
  const ArcRadii radii = arcRadii(arc);
  const auto angleOf = [&](base::Vec3 point) {
    return std::atan2(point[plane.second] - arc.centreMm[plane.second],
                      point[plane.first] - arc.centreMm[plane.first]);
  };
  const double startAngle = angleOf(arc.startMm);
  constexpr double kFullCircle = 2.0 * std::numbers::pi;
  double sweep = kFullCircle;
  if (distanceInPlane(plane, arc.startMm, arc.endMm) > kSamePointMm) {
    sweep = angleOf(arc.endMm) - startAngle;
    sweep = arc.clockwise ? -sweep : sweep;
    while (sweep <= 0.0) {
      sweep += kFullCircle;
    }
    while (sweep > kFullCircle) {
      sweep -= kFullCircle;
    }
  }

  // A chord over the angle a is r(1 - cos(a/2)) = 2 r sin²(a/4) away from its arc.
  const double radiusMm = std::max(radii.startMm, radii.endMm);
  const double ratio = std::min(1.0, chordToleranceMm / (2.0 * std::max(radiusMm, 1e-12)));
  const double chordAngle = std::min(kChordAngleMax, 4.0 * std::asin(std::sqrt(ratio)));
  // A sweep that is a whole number of chords but for rounding needs no chord more.
  const auto chords = static_cast<std::size_t>(std::max(1.0, std::ceil(sweep / chordAngle - 1e-9)));

  const double riseMm = arc.endMm[plane.third] - arc.startMm[plane.third];
  for (std::size_t chord = 1; chord < chords; ++chord) {
    const double share = static_cast<double>(chord) / static_cast<double>(chords);
    const double angle = startAngle + (arc.clockwise ? -sweep : sweep) * share;
    const double atRadiusMm = radii.startMm + (radii.endMm - radii.startMm) * share;
    base::Vec3 point = arc.endMm;
    point.set(plane.first, arc.centreMm[plane.first] + atRadiusMm * std::cos(angle));
    point.set(plane.second, arc.centreMm[plane.second] + atRadiusMm * std::sin(angle));
    point.set(plane.third, arc.startMm[plane.third] + riseMm * share);
    points.push_back(point);
  }
  points.push_back(arc.endMm);

  // The mean radius stands for the spiral: exact for a circle, and a spiral within the tolerance
  // of the radii differs by less than the rounding that made it one.
  const double turnMm = 0.5 * (radii.startMm + radii.endMm) * sweep;
  const double climbMm = std::isfinite(riseMm) ? riseMm : 0.0;
  return std::hypot(turnMm, climbMm, radii.endMm - radii.startMm);
}

}  // namespace rivulet::gcode
