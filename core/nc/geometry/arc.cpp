// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/geometry/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/contract.h"

namespace rivulet::nc {

namespace {

/// Closer than this, start and end are the same point: coordinates carry at most 6 decimals, and
/// sums of increments are off by far less.
constexpr double kSamePointMm = 1e-7;

/// A quarter circle is never one chord, whatever the tolerance: a full circle keeps its shape.
constexpr double kChordAngleMax = std::numbers::pi / 2.0;

constexpr double kFullCircle = 2.0 * std::numbers::pi;

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

double chordCount(double sweepRad, double radiusMm, double chordToleranceMm) {
  // A chord over the angle a is r(1 - cos(a/2)) = 2 r sin²(a/4) away from its arc.
  const double ratio = std::min(1.0, chordToleranceMm / (2.0 * std::max(radiusMm, 1e-12)));
  const double chordAngle = std::min(kChordAngleMax, 4.0 * std::asin(std::sqrt(ratio)));
  // A sweep that is a whole number of chords but for rounding needs no chord more.
  return std::max(1.0, std::ceil(sweepRad / chordAngle - 1e-9));
}

std::string_view describe(ArcProblem problem) {
  static constexpr std::array<std::string_view, 6> kClauses{
      "the arc fits",
      "the arc has neither a centre nor a radius that fits its ends",
      "the centre lies outside the plane",
      "the arc has a centre and a radius",
      "the radii at the start and at the end differ",
      "the radius is too small to reach the end"};
  return kClauses[static_cast<std::size_t>(problem)];
}

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

double arcSweep(const Arc& arc) {
  const Plane plane = planeOf(arc);
  const auto angleOf = [&](base::Vec3 point) {
    return std::atan2(point[plane.second] - arc.centreMm[plane.second],
                      point[plane.first] - arc.centreMm[plane.first]);
  };
  double sweep = kFullCircle;
  if (distanceInPlane(plane, arc.startMm, arc.endMm) > kSamePointMm) {
    sweep = angleOf(arc.endMm) - angleOf(arc.startMm);
    sweep = arc.clockwise ? -sweep : sweep;
    while (sweep <= 0.0) {
      sweep += kFullCircle;
    }
    while (sweep > kFullCircle) {
      sweep -= kFullCircle;
    }
  }
  return sweep + kFullCircle * arc.turns;
}

SpaceArc inSpace(const Arc& arc) {
  SpaceArc made;
  made.centreMm = arc.centreMm;
  made.axis.set((arc.firstAxis + 2) % base::kAxisCount, arc.clockwise ? -1.0 : 1.0);
  made.sweepRad = arcSweep(arc);
  return made;
}

double arcLength(const Arc& arc) {
  const Plane plane = planeOf(arc);
  const ArcRadii radii = arcRadii(arc);
  // The mean radius stands for the spiral: exact for a circle, and a spiral within the tolerance
  // of the radii differs by less than the rounding that made it one.
  const double turnMm = 0.5 * (radii.startMm + radii.endMm) * arcSweep(arc);
  const double riseMm = arc.endMm[plane.third] - arc.startMm[plane.third];
  return std::hypot(turnMm, std::isfinite(riseMm) ? riseMm : 0.0, radii.endMm - radii.startMm);
}

ArcWords readAs(CentreReading reading, ArcWords words) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!words.centre[axis]) {
      continue;
    }
    if (reading == CentreReading::Absolute) {
      words.centreIsAbsolute[axis] = true;
    } else if (reading == CentreReading::StartMinusCentre && !words.centreIsAbsolute[axis]) {
      *words.centre[axis] *= -1.0;
    }
  }
  return words;
}

ResolvedArc resolveArc(Arc arc, const ArcWords& words, double radiusToleranceMm) {
  const Plane plane = planeOf(arc);
  ResolvedArc resolved{arc, ArcProblem::None, 0.0, 0.0, plane.third};
  const auto failed = [&resolved](ArcProblem problem) {
    resolved.problem = problem;
    return resolved;
  };
  const std::optional<double>& across = words.centre[plane.third];
  if (across && (words.centreIsAbsolute[plane.third] ? false : *across != 0.0)) {
    // With TURN= or on some controls this is the pitch of a helix; here it is not known.
    return failed(ArcProblem::CentreOutsidePlane);
  }
  const bool hasCentre = words.centre[plane.first] || words.centre[plane.second];
  if (hasCentre && words.radius) {
    return failed(ArcProblem::CentreAndRadius);
  }
  const double chord = distanceInPlane(plane, arc.startMm, arc.endMm);
  resolved.halfChord = chord / 2.0;
  if (words.radius || (words.degrees && !hasCentre)) {
    if (chord == 0.0) {
      // Any centre at the right distance would do: the control refuses this as well.
      return failed(ArcProblem::CentreMissing);
    }
    double radius = words.radius.value_or(0.0);
    if (!words.radius) {
      const double degrees = *words.degrees;
      const double half = degrees * std::numbers::pi / 360.0;
      if (!(degrees > 0.0 && degrees < 360.0)) {
        return failed(ArcProblem::CentreMissing);
      }
      radius = chord / (2.0 * std::sin(half)) * (degrees > 180.0 ? -1.0 : 1.0);
    }
    if (radius == 0.0 || resolved.halfChord - std::abs(radius) > radiusToleranceMm) {
      resolved.mismatch = std::abs(radius);
      return failed(ArcProblem::RadiusTooSmall);
    }
    resolved.arc.centreMm = arcCentre(arc, radius);
    return resolved;
  }
  if (!hasCentre) {
    return failed(ArcProblem::CentreMissing);
  }
  resolved.arc.centreMm = arc.startMm;
  for (const std::size_t axis : {plane.first, plane.second}) {
    const double given = words.centre[axis].value_or(0.0);
    resolved.arc.centreMm.set(axis, words.centre[axis] && words.centreIsAbsolute[axis]
                                        ? given
                                        : arc.startMm[axis] + given);
  }
  if (words.degrees && !words.endIsGiven) {
    const double turn = *words.degrees * std::numbers::pi / 180.0 * (arc.clockwise ? -1.0 : 1.0);
    const double first = arc.startMm[plane.first] - resolved.arc.centreMm[plane.first];
    const double second = arc.startMm[plane.second] - resolved.arc.centreMm[plane.second];
    resolved.arc.endMm.set(plane.first, resolved.arc.centreMm[plane.first] +
                                            first * std::cos(turn) - second * std::sin(turn));
    resolved.arc.endMm.set(plane.second, resolved.arc.centreMm[plane.second] +
                                             first * std::sin(turn) + second * std::cos(turn));
  }
  const ArcRadii radii = arcRadii(resolved.arc);
  resolved.mismatch = std::abs(radii.endMm - radii.startMm);
  if (!(resolved.mismatch <= radiusToleranceMm)) {
    return failed(ArcProblem::RadiusMismatch);
  }
  if (!(std::min(radii.startMm, radii.endMm) > 0.0)) {
    return failed(ArcProblem::CentreMissing);
  }
  return resolved;
}

std::optional<SpaceArc> arcThrough(base::Vec3 startMm, base::Vec3 middleMm, base::Vec3 endMm) {
  const base::Vec3 a = middleMm - startMm;
  const base::Vec3 b = endMm - startMm;
  const base::Vec3 normal = base::cross(a, b);
  const double squares = base::dot(normal, normal);
  // Three points that are as good as on a line have no circle to speak of.
  if (!(std::sqrt(squares) > 1e-9 * base::norm(a) * base::norm(b)) || squares == 0.0) {
    return std::nullopt;
  }
  const base::Vec3 toCentre = (1.0 / (2.0 * squares)) * (base::dot(a, a) * base::cross(b, normal) +
                                                         base::dot(b, b) * base::cross(normal, a));
  SpaceArc arc;
  arc.centreMm = startMm + toCentre;
  arc.axis = (1.0 / std::sqrt(squares)) * normal;
  // Seen against the normal of start, middle, end the turn is always counterclockwise.
  const base::Vec3 from = startMm - arc.centreMm;
  const base::Vec3 to = endMm - arc.centreMm;
  double sweep = std::atan2(base::dot(arc.axis, base::cross(from, to)), base::dot(from, to));
  arc.sweepRad = sweep <= 0.0 ? sweep + kFullCircle : sweep;
  return arc;
}

std::optional<SpaceArc> tangentArc(base::Vec3 startMm, base::Vec3 direction, base::Vec3 endMm) {
  const base::Vec3 chord = endMm - startMm;
  const double directionNorm = base::norm(direction);
  const double chordMm = base::norm(chord);
  if (!(directionNorm > 0.0) || !(chordMm > 0.0)) {
    return std::nullopt;
  }
  const base::Vec3 tangent = (1.0 / directionNorm) * direction;
  base::Vec3 normal = base::cross(tangent, chord);
  const double sine = base::norm(normal) / chordMm;
  if (!(sine > 1e-9)) {
    return std::nullopt;
  }
  normal = (1.0 / base::norm(normal)) * normal;
  SpaceArc arc;
  arc.axis = normal;
  arc.centreMm = startMm + (chordMm / (2.0 * sine)) * base::cross(normal, tangent);
  const base::Vec3 from = startMm - arc.centreMm;
  const base::Vec3 to = endMm - arc.centreMm;
  const double sweep = std::atan2(base::dot(normal, base::cross(from, to)), base::dot(from, to));
  arc.sweepRad = sweep <= 0.0 ? sweep + kFullCircle : sweep;
  return arc;
}

double flattenSpaceArc(const SpaceArc& arc, base::Vec3 startMm, base::Vec3 endMm,
                       double chordToleranceMm, std::vector<base::Vec3>& points) {
  RIVULET_ASSERT(chordToleranceMm > 0.0);
  const base::Vec3 from = startMm - arc.centreMm;
  const base::Vec3 across = base::cross(arc.axis, from);
  const double radiusMm = base::norm(from);
  const auto chords =
      static_cast<std::size_t>(chordCount(arc.sweepRad, radiusMm, chordToleranceMm));
  for (std::size_t chord = 1; chord < chords; ++chord) {
    const double angle = arc.sweepRad * static_cast<double>(chord) / static_cast<double>(chords);
    points.push_back(arc.centreMm + std::cos(angle) * from + std::sin(angle) * across);
  }
  points.push_back(endMm);
  return radiusMm * arc.sweepRad;
}

double flattenArc(const Arc& arc, double chordToleranceMm, std::vector<base::Vec3>& points) {
  RIVULET_ASSERT(chordToleranceMm > 0.0);
  const Plane plane = planeOf(arc);
  const ArcRadii radii = arcRadii(arc);
  const double startAngle = std::atan2(arc.startMm[plane.second] - arc.centreMm[plane.second],
                                       arc.startMm[plane.first] - arc.centreMm[plane.first]);
  const double sweep = arcSweep(arc);
  const auto chords = static_cast<std::size_t>(
      chordCount(sweep, std::max(radii.startMm, radii.endMm), chordToleranceMm));
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
  return arcLength(arc);
}

}  // namespace rivulet::nc
