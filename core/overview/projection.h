// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How a picture shows places of the workpiece: parallel projection, true to scale in the plane of
/// the picture. @threadsafety plain values.
#pragma once

#include <cmath>
#include <numbers>

#include "base/vec3.h"
#include "overview/path_levels.h"

namespace rivulet::overview {

class Projection {
 public:
  /// Where one looks from. Top: X to the right, Y up.
  struct Angles {
    double turnDeg = 0.0;   ///< of the workpiece about Z, clockwise seen from above
    double tiltDeg = 90.0;  ///< above the XY plane; 90: from above, 0: from the front

    friend bool operator==(const Angles&, const Angles&) = default;
  };
  /// Seen from front, left and above alike: X to the lower right, Y to the upper right, Z up.
  [[nodiscard]] static Angles isometric() {
    return {45.0, std::asin(1.0 / std::numbers::sqrt3) * 180.0 / std::numbers::pi};
  }

  explicit Projection(const Angles& angles)
      : m_cosTurn(std::cos(radians(angles.turnDeg))),
        m_sinTurn(std::sin(radians(angles.turnDeg))),
        m_cosTilt(std::cos(radians(angles.tiltDeg))),
        m_sinTilt(std::sin(radians(angles.tiltDeg))) {}

  [[nodiscard]] PlanePoint operator()(base::Vec3 positionMm) const {
    const double back = m_cosTurn * positionMm.y - m_sinTurn * positionMm.x;
    return {m_cosTurn * positionMm.x + m_sinTurn * positionMm.y,
            m_sinTilt * back + m_cosTilt * positionMm.z};
  }

 private:
  static double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

  double m_cosTurn;
  double m_sinTurn;
  double m_cosTilt;
  double m_sinTilt;
};

}  // namespace rivulet::overview
