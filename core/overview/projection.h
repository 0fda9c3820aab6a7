// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How a picture shows places of the workpiece: parallel projection, true to scale in the plane of
/// the picture. @threadsafety plain values.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/vec3.h"

namespace rivulet::overview {

/// A place in the plane of a picture: to the right and up, mm.
struct PlanePoint {
  double right = 0.0;
  double up = 0.0;
};

struct PlaneBox {
  double left = 0.0;
  double right = 0.0;
  double low = 0.0;
  double high = 0.0;

  void widen(const PlaneBox& by) {
    left = std::min(left, by.left);
    right = std::max(right, by.right);
    low = std::min(low, by.low);
    high = std::max(high, by.high);
  }
};

/// Along the axes of the workpiece, mm.
struct SpaceBox {
  std::array<float, base::kAxisCount> low{};
  std::array<float, base::kAxisCount> high{};
};

class Projection {
 public:
  /// Where one looks from. Top: X to the right, Y up.
  struct Angles {
    double turnDeg = 0.0;   ///< of the workpiece about Z, clockwise seen from above
    double tiltDeg = 90.0;  ///< above the XY plane; 90: from above, 0: from the front

    [[nodiscard]] Angles turned(double byDeg, double tiltByDeg) const {
      return {std::remainder(turnDeg + byDeg, 360.0), std::clamp(tiltDeg + tiltByDeg, -90.0, 90.0)};
    }
    friend bool operator==(const Angles&, const Angles&) = default;
  };
  /// How far a picture turns that is dragged by a pixel, or by an arrow key.
  static constexpr double kDegPerPx = 0.5;
  static constexpr double kKeyDeg = 5.0;
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
  /// The smallest box around the picture of a box.
  [[nodiscard]] PlaneBox operator()(const SpaceBox& boxMm) const {
    base::Vec3 middleMm;
    base::Vec3 halfMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double low = boxMm.low[axis];
      const double high = boxMm.high[axis];
      middleMm.set(axis, 0.5 * (low + high));
      halfMm.set(axis, 0.5 * (high - low));
    }
    const PlanePoint middle = (*this)(middleMm);
    const double right = std::abs(m_cosTurn) * halfMm.x + std::abs(m_sinTurn) * halfMm.y;
    const double back = std::abs(m_cosTurn) * halfMm.y + std::abs(m_sinTurn) * halfMm.x;
    const double up = std::abs(m_sinTilt) * back + std::abs(m_cosTilt) * halfMm.z;
    return {middle.right - right, middle.right + right, middle.up - up, middle.up + up};
  }

 private:
  static double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

  double m_cosTurn;
  double m_sinTurn;
  double m_cosTilt;
  double m_sinTilt;
};

}  // namespace rivulet::overview
