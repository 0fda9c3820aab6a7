// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The arc a block programs: from centre, radius, opening angle, or a point on the way.
/// Workpiece frame, mm. @threadsafety pure.
#pragma once

#include <optional>
#include <variant>

#include "base/vec3.h"
#include "machine/prepared.h"

namespace rivulet::machine {

/// G17: the circle lies in XY; G18: in ZX; G19: in YZ.
enum class Plane { XY, ZX, YZ };

[[nodiscard]] base::Vec3 normalOf(Plane plane);

struct ArcEnds {
  base::Vec3 startMm;
  base::Vec3 endMm;
  Plane plane = Plane::XY;
  bool clockwise = false;  ///< G2, seen against the normal of the plane
  int fullTurns = 0;       ///< TURN=
};

/// G2, G3 with I J K. @return alarm 14040 where the ends lie at different radii
[[nodiscard]] std::variant<ArcPath, Alarm> arcAboutCentre(const ArcEnds& ends, base::Vec3 centreMm);
/// G2, G3 with CR=; a negative radius: more than half a circle. @return alarm 14040
[[nodiscard]] std::variant<ArcPath, Alarm> arcWithRadius(const ArcEnds& ends, double radiusMm);
/// G2, G3 with AR=, the opening angle in degrees. @return alarm 14040
[[nodiscard]] std::variant<ArcPath, Alarm> arcWithAngle(const ArcEnds& ends, double degrees);
/// CIP with I1= J1= K1=. @return alarm 14040 where the three points lie on a line
[[nodiscard]] std::variant<ArcPath, Alarm> arcThrough(base::Vec3 startMm, base::Vec3 throughMm,
                                                      base::Vec3 endMm);

}  // namespace rivulet::machine
