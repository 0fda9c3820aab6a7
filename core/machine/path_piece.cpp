// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/path_piece.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::machine {

using base::Vec3;

namespace {

/// Below this a corner is none: the turn is rounding of the coordinates' last bits.
constexpr double kTurnRadMin = 1e-7;
/// Beyond this the path practically turns back: no useful arc fits.
constexpr double kTurnRadMax = 3.0;
/// An arc shorter than this is no path but rounding.
constexpr double kCutMmMin = 1e-6;

}  // namespace

PathPiece PathPiece::line(Vec3 fromMm, Vec3 toMm) {
  PathPiece piece;
  piece.m_lengthMm = base::distance(fromMm, toMm);
  RIVULET_ASSERT(piece.m_lengthMm > 0.0);
  piece.m_originMm = fromMm;
  piece.m_course = (1.0 / piece.m_lengthMm) * (toMm - fromMm);
  return piece;
}

PathPiece PathPiece::turning(Vec3 fromMm, Vec3 toMm, double turnDeg) {
  RIVULET_ASSERT(turnDeg > 0.0);
  PathPiece piece;
  piece.m_lengthMm = turnDeg;
  piece.m_originMm = fromMm;
  piece.m_course = (1.0 / turnDeg) * (toMm - fromMm);
  return piece;
}

PathPiece PathPiece::arc(Vec3 fromMm, Vec3 toMm, const ArcPath& arc) {
  PathPiece piece;
  const Vec3 axis = arc.axis;
  const double startHeight = base::dot(fromMm - arc.centreMm, axis);
  piece.m_course = axis;
  piece.m_originMm = arc.centreMm + startHeight * axis;
  const Vec3 radial = fromMm - piece.m_originMm;
  piece.m_radiusMm = base::norm(radial);
  RIVULET_ASSERT(piece.m_radiusMm > 0.0);
  piece.m_radial = (1.0 / piece.m_radiusMm) * radial;
  piece.m_normal = base::cross(axis, piece.m_radial);
  const double endHeight = base::dot(toMm - arc.centreMm, axis);
  const double endRadiusMm = base::norm(toMm - arc.centreMm - endHeight * axis);
  piece.m_riseMmPerRad = (endHeight - startHeight) / arc.sweepRad;
  piece.m_radiusMmPerRad = (endRadiusMm - piece.m_radiusMm) / arc.sweepRad;
  const double drift = std::abs(piece.m_radiusMmPerRad);
  const double widestMm = std::max(piece.m_radiusMm, endRadiusMm);
  // With a drifting radius the speed along the path is nowhere higher than the one asked for.
  piece.m_mmPerRad = std::hypot(widestMm, piece.m_riseMmPerRad, drift);
  piece.m_lengthMm = arc.sweepRad * piece.m_mmPerRad;
  piece.m_curvaturePerMm = (widestMm + 2.0 * drift) / (piece.m_mmPerRad * piece.m_mmPerRad);
  return piece;
}

Vec3 PathPiece::at(double mm) const {
  if (isStraight()) {
    return m_originMm + mm * m_course;
  }
  const double angle = angleRad(mm);
  const double radius = m_radiusMm + m_radiusMmPerRad * angle;
  return m_originMm + (radius * std::cos(angle)) * m_radial +
         (radius * std::sin(angle)) * m_normal + (m_riseMmPerRad * angle) * m_course;
}

Vec3 PathPiece::tangent(double mm) const {
  if (isStraight()) {
    return m_course;
  }
  const double angle = angleRad(mm);
  const double radius = m_radiusMm + m_radiusMmPerRad * angle;
  const Vec3 outward = std::cos(angle) * m_radial + std::sin(angle) * m_normal;
  const Vec3 along = std::cos(angle) * m_normal - std::sin(angle) * m_radial;
  const Vec3 course = radius * along + m_radiusMmPerRad * outward + m_riseMmPerRad * m_course;
  return (1.0 / base::norm(course)) * course;
}

Vec3 PathPiece::curvature(double mm) const {
  if (isStraight()) {
    return {};
  }
  const double angle = angleRad(mm);
  return (-m_curvaturePerMm) * (std::cos(angle) * m_radial + std::sin(angle) * m_normal);
}

double PathPiece::axisShare(std::size_t axis) const {
  if (isStraight()) {
    return std::abs(m_course[axis]);
  }
  // A helix also moves along its axis; what the arc and the rise add up to bounds both.
  const double inPlane = std::sqrt(std::max(0.0, 1.0 - m_course[axis] * m_course[axis]));
  const double rise = std::abs(m_riseMmPerRad) / m_mmPerRad;
  return std::min(1.0, inPlane + rise * std::abs(m_course[axis]));
}

void PathPiece::trimStart(double mm) {
  m_lengthMm -= mm;
  if (isStraight()) {
    m_originMm = m_originMm + mm * m_course;
  } else {
    m_startRad += mm / m_mmPerRad;
  }
}

std::optional<CornerArc> roundCorner(Vec3 cornerMm, Vec3 courseBefore, Vec3 courseAfter,
                                     double cutMmMax, RoundingKind kind, double limitMm) {
  const Vec3 change = courseAfter - courseBefore;
  const double halfTurn = std::asin(std::min(1.0, 0.5 * base::norm(change)));
  if (2.0 * halfTurn < kTurnRadMin || 2.0 * halfTurn > kTurnRadMax || !(limitMm > 0.0)) {
    return std::nullopt;
  }
  // Deviation = radius·(1/cos(turn/2) - 1) and cut = radius·tan(turn/2), so that
  // cut = deviation·sin(turn/2)/(1 - cos(turn/2)) = deviation/tan(turn/4).
  double cutMm = limitMm;
  if (kind == RoundingKind::Deviation) {
    cutMm = limitMm / std::tan(0.5 * halfTurn);
  }
  cutMm = std::min(cutMm, cutMmMax);
  if (cutMm < kCutMmMin) {
    return std::nullopt;
  }
  CornerArc corner;
  corner.cutMm = cutMm;
  corner.radiusMm = cutMm / std::tan(halfTurn);
  const Vec3 inward = (1.0 / base::norm(change)) * change;
  const Vec3 normal = base::cross(courseBefore, courseAfter);
  ArcPath arc;
  arc.centreMm = cornerMm + (corner.radiusMm / std::cos(halfTurn)) * inward;
  arc.axis = (1.0 / base::norm(normal)) * normal;
  arc.sweepRad = halfTurn;
  const Vec3 startMm = cornerMm - cutMm * courseBefore;
  const Vec3 middleMm = arc.centreMm - corner.radiusMm * inward;
  const Vec3 endMm = cornerMm + cutMm * courseAfter;
  corner.firstHalf = PathPiece::arc(startMm, middleMm, arc);
  corner.secondHalf = PathPiece::arc(middleMm, endMm, arc);
  return corner;
}

}  // namespace rivulet::machine
