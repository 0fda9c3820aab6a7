// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/arc_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rivulet::machine {

using base::Vec3;

namespace {

constexpr int kEndPointError = 14040;
/// Difference of the radii at start and end that is let pass (MD21000).
constexpr double kRadiusToleranceMm = 0.01;
constexpr double kSamePointMm = 1e-9;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// Angle from `from` to `to` counterclockwise about `axis`, in [0, 2π).
double angleAbout(Vec3 axis, Vec3 from, Vec3 to) {
  const double angle = std::atan2(base::dot(base::cross(from, to), axis), base::dot(from, to));
  return angle < 0.0 ? angle + kFullTurn : angle;
}

Vec3 inPlane(Vec3 vector, Vec3 normal) {
  return vector - base::dot(vector, normal) * normal;
}

}  // namespace

Vec3 normalOf(Plane plane) {
  switch (plane) {
    case Plane::ZX:
      return {0.0, 1.0, 0.0};
    case Plane::YZ:
      return {1.0, 0.0, 0.0};
    case Plane::XY:
      break;
  }
  return {0.0, 0.0, 1.0};
}

std::variant<ArcPath, Alarm> arcAboutCentre(const ArcEnds& ends, Vec3 centreMm) {
  const Vec3 normal = normalOf(ends.plane);
  const Vec3 start = inPlane(ends.startMm - centreMm, normal);
  const Vec3 end = inPlane(ends.endMm - centreMm, normal);
  const double startRadius = base::norm(start);
  const double endRadius = base::norm(end);
  if (startRadius < kSamePointMm || std::abs(startRadius - endRadius) > kRadiusToleranceMm) {
    return Alarm{kEndPointError,
                 fmt::format("Circle end-point error: radius {:.4f} mm at the start, "
                             "{:.4f} mm at the end.",
                             startRadius, endRadius)};
  }
  ArcPath arc;
  arc.centreMm = centreMm;
  arc.axis = ends.clockwise ? -1.0 * normal : normal;
  arc.sweepRad = angleAbout(arc.axis, start, end);
  if (base::distance(start, end) < kSamePointMm) {
    arc.sweepRad = kFullTurn;
  }
  arc.sweepRad += kFullTurn * ends.fullTurns;
  return arc;
}

std::variant<ArcPath, Alarm> arcWithRadius(const ArcEnds& ends, double radiusMm) {
  const Vec3 normal = normalOf(ends.plane);
  const Vec3 chord = inPlane(ends.endMm - ends.startMm, normal);
  const double half = 0.5 * base::norm(chord);
  const double radius = std::abs(radiusMm);
  if (half < kSamePointMm || half > radius + kRadiusToleranceMm) {
    return Alarm{kEndPointError, fmt::format("Circle end-point error: radius {:.4f} mm, ends "
                                             "{:.4f} mm apart.",
                                             radius, 2.0 * half)};
  }
  const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
  // To the left of the chord lies the centre of a counterclockwise arc of less than half a circle.
  const Vec3 left = (1.0 / (2.0 * half)) * base::cross(normal, chord);
  const bool centreLeft = ends.clockwise != (radiusMm > 0.0);
  const Vec3 centre = ends.startMm + 0.5 * chord + (centreLeft ? height : -height) * left;
  return arcAboutCentre(ends, centre);
}

std::variant<ArcPath, Alarm> arcWithAngle(const ArcEnds& ends, double degrees) {
  const double half = 0.5 * degrees * std::numbers::pi / 180.0;
  const Vec3 chord = inPlane(ends.endMm - ends.startMm, normalOf(ends.plane));
  if (!(degrees > 0.0 && degrees < 360.0)) {
    return Alarm{kEndPointError, fmt::format("The opening angle {} is no angle between 0 and 360 "
                                             "degrees.",
                                             degrees)};
  }
  const double radius = 0.5 * base::norm(chord) / std::sin(half);
  return arcWithRadius(ends, degrees > 180.0 ? -radius : radius);
}

std::variant<ArcPath, Alarm> arcThrough(Vec3 startMm, Vec3 throughMm, Vec3 endMm) {
  const Vec3 a = throughMm - startMm;
  const Vec3 b = endMm - startMm;
  const Vec3 across = base::cross(a, b);
  const double area = base::dot(across, across);
  if (area < 1e-12 * std::max(1.0, base::dot(a, a) * base::dot(b, b))) {
    return Alarm{kEndPointError, "Circle end-point error: the three points lie on a line."};
  }
  const Vec3 towards = base::dot(b, b) * base::cross(a, across);
  const Vec3 back = base::dot(a, a) * base::cross(across, b);
  ArcPath arc;
  // Circumcentre: equally far from all three.
  arc.centreMm = startMm + (-1.0 / (2.0 * area)) * (towards + back);
  arc.axis = (1.0 / std::sqrt(area)) * across;
  arc.sweepRad = angleAbout(arc.axis, startMm - arc.centreMm, endMm - arc.centreMm);
  return arc;
}

}  // namespace rivulet::machine
