// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The geometry the look-ahead works with: straight lines and arcs, each a function of the path
/// length, and the arc that rounds a corner. Frame: workpiece, mm. @threadsafety plain values.
#pragma once

#include <optional>

#include "base/vec3.h"
#include "machine/prepared.h"

namespace rivulet::machine {

/// A straight line or an arc (circle, helix; the radius may drift by what the control tolerates
/// between start and end point).
class PathPiece {
 public:
  PathPiece() = default;
  /// @param fromMm, toMm  different points
  [[nodiscard]] static PathPiece line(base::Vec3 fromMm, base::Vec3 toMm);
  /// Where the path is measured by the turn of the rotary axes: X Y Z go straight along with it.
  /// All lengths of this piece are degrees then, and `tangent` is mm per degree.
  [[nodiscard]] static PathPiece turning(base::Vec3 fromMm, base::Vec3 toMm, double turnDeg);
  /// @param arc  its axis must not contain `fromMm` or `toMm`
  [[nodiscard]] static PathPiece arc(base::Vec3 fromMm, base::Vec3 toMm, const ArcPath& arc);

  [[nodiscard]] double lengthMm() const { return m_lengthMm; }
  [[nodiscard]] bool isStraight() const { return m_radiusMm == 0.0; }
  /// @param mm  path length from the start, 0 to lengthMm
  [[nodiscard]] base::Vec3 at(double mm) const;
  /// Unit vector of the course (but see `turning`).
  [[nodiscard]] base::Vec3 tangent(double mm) const;
  /// Second derivative of the position by the path length, 1/mm: centripetal acceleration at
  /// speed 1. Zero for a line.
  [[nodiscard]] base::Vec3 curvature(double mm) const;
  /// Greatest length of `curvature`.
  [[nodiscard]] double curvaturePerMm() const { return m_curvaturePerMm; }
  /// Largest share of motion along the path, or across it in the plane of the arc, that falls on
  /// one axis: |cos| of a line's course; for an arc what the tilt of its plane leaves.
  [[nodiscard]] double axisShare(std::size_t axis) const;

  /// Cuts `mm` off the start or the end. @param mm  less than lengthMm
  void trimStart(double mm);
  void trimEnd(double mm) { m_lengthMm -= mm; }

 private:
  [[nodiscard]] double angleRad(double mm) const { return m_startRad + mm / m_mmPerRad; }

  base::Vec3 m_originMm;  ///< start of a line; centre of an arc, in the plane of its start
  base::Vec3 m_course;    ///< unit: direction of a line; axis of an arc
  double m_lengthMm = 0.0;
  // Arcs only.
  base::Vec3 m_radial;  ///< unit, from the axis to the start point
  base::Vec3 m_normal;  ///< axis × radial
  double m_radiusMm = 0.0;
  double m_radiusMmPerRad = 0.0;  ///< drift
  double m_riseMmPerRad = 0.0;    ///< helix
  double m_mmPerRad = 1.0;        ///< path length
  double m_startRad = 0.0;        ///< of what is left after trimStart
  double m_curvaturePerMm = 0.0;
};

/// How two straight lines are rounded into each other: an arc that leaves the first one `cutMm`
/// before the corner and meets the second one as far behind it.
struct CornerArc {
  double cutMm = 0.0;
  double radiusMm = 0.0;
  PathPiece firstHalf;  ///< up to the middle, which is nearest to the corner
  PathPiece secondHalf;
};

/// @param cutMmMax  what both lines can spare
/// @param limitMm   see RoundingKind
/// @return nothing if the lines run on straight, turn back, or there is no room
[[nodiscard]] std::optional<CornerArc> roundCorner(base::Vec3 cornerMm, base::Vec3 courseBefore,
                                                   base::Vec3 courseAfter, double cutMmMax,
                                                   RoundingKind kind, double limitMm);

}  // namespace rivulet::machine
