// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Circular and helical moves as chords. @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace rivulet::nc {

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
  int turns = 0;              ///< full circles on top (TURN=)
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

/// What a block says about its arc. One unit for all lengths.
struct ArcWords {
  std::array<std::optional<double>, base::kAxisCount> centre;  ///< I J K
  std::array<bool, base::kAxisCount> centreIsAbsolute{};       ///< I=AC(), G90.1
  std::optional<double> radius;                                ///< CR=, R
  std::optional<double> degrees;                               ///< AR=: opening angle, > 0
  bool endIsGiven = true;  ///< false: the block names no axis of the plane
};

enum class ArcProblem {
  None,
  CentreMissing,
  CentreOutsidePlane,
  CentreAndRadius,
  RadiusMismatch,
  RadiusTooSmall,
};

/// What I, J and K of an arc are: post-processors differ.
enum class CentreReading : unsigned char {
  AsProgrammed,      ///< as the dialect has it: centre minus start, or absolute by G90.1, AC()
  Absolute,          ///< the centre itself
  StartMinusCentre,  ///< the other way round, as on some older controls
};
/// The same words read as their writer may have meant the centre; AC() means what it says.
[[nodiscard]] ArcWords readAs(CentreReading reading, ArcWords words);

/// One English clause: "the arc has neither centre nor radius".
[[nodiscard]] std::string_view describe(ArcProblem problem);

struct ResolvedArc {
  Arc arc;
  ArcProblem problem = ArcProblem::None;
  double mismatch = 0.0;  ///< RadiusMismatch: of the radii; RadiusTooSmall: radius
  double halfChord = 0.0;
  std::size_t axis = 0;  ///< CentreOutsidePlane
};

/// The arc a block describes. Any unit.
/// @param arc  start, end, plane, direction and turns; the centre is found here. With AR= and a
///        centre the end in the plane is found as well
/// @param radiusToleranceMm  what may lie between the radii at the start and at the end
[[nodiscard]] ResolvedArc resolveArc(Arc arc, const ArcWords& words,
                                     double radiusToleranceMm = kArcRadiusToleranceMm);

/// True length. @pre resolved without problem
[[nodiscard]] double arcLength(const Arc& arc);

/// Angle swept, radians, > 0, turns included.
[[nodiscard]] double arcSweep(const Arc& arc);

/// The circle through three points in space (CIP). @return nothing if they lie on a line
struct SpaceArc {
  base::Vec3 centreMm;
  base::Vec3 axis;        ///< unit vector; the turn is counterclockwise seen against it
  double sweepRad = 0.0;  ///< > 0; more than a full circle with TURN=
};
/// An arc in its plane, or a helix across it, seen that way. The centre lies on the axis.
[[nodiscard]] SpaceArc inSpace(const Arc& arc);
[[nodiscard]] std::optional<SpaceArc> arcThrough(base::Vec3 startMm, base::Vec3 middleMm,
                                                 base::Vec3 endMm);
/// The arc that leaves `startMm` in a direction and ends at `endMm` (CT).
/// @return nothing if it would be a straight line
[[nodiscard]] std::optional<SpaceArc> tangentArc(base::Vec3 startMm, base::Vec3 direction,
                                                 base::Vec3 endMm);
/// As `flattenArc`. @return length, mm
double flattenSpaceArc(const SpaceArc& arc, base::Vec3 startMm, base::Vec3 endMm,
                       double chordToleranceMm, std::vector<base::Vec3>& points);

/// How many chords an arc becomes, so that none is further from it than the tolerance.
[[nodiscard]] double chordCount(double sweepRad, double radiusMm, double chordToleranceMm);

/// Appends the corner points of the chords after the start; the last is exactly `endMm`.
/// If start and end coincide in the plane, the arc is a full circle. The radius runs linearly
/// over the angle from its value at the start to its value at the end, the third axis likewise.
/// @param chordToleranceMm  greatest distance of a chord from the arc, > 0
/// @return true length of the arc, mm
double flattenArc(const Arc& arc, double chordToleranceMm, std::vector<base::Vec3>& points);

}  // namespace rivulet::nc
