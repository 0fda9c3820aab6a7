// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A point or direction of the geometry axes X, Y, Z. Units as the variable's name says.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rivulet::base {

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  [[nodiscard]] constexpr double operator[](std::size_t axis) const {
    return axis == 0 ? x : (axis == 1 ? y : z);
  }
  constexpr void set(std::size_t axis, double value) {
    (axis == 0 ? x : (axis == 1 ? y : z)) = value;
  }
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator*(double k, Vec3 a) { return {k * a.x, k * a.y, k * a.z}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

inline constexpr std::size_t kAxisCount = 3;
inline constexpr std::array<char, kAxisCount> kAxisNames{'X', 'Y', 'Z'};

[[nodiscard]] constexpr double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double norm(Vec3 a) {
  return std::sqrt(dot(a, a));
}
[[nodiscard]] inline double distance(Vec3 a, Vec3 b) {
  return norm(b - a);
}
/// Distance of a point from the straight line between two others.
[[nodiscard]] inline double distanceToSegment(Vec3 point, Vec3 from, Vec3 to) {
  const Vec3 along = to - from;
  const double squares = dot(along, along);
  const double share =
      squares == 0.0 ? 0.0 : std::clamp(dot(point - from, along) / squares, 0.0, 1.0);
  return distance(point, from + share * along);
}
[[nodiscard]] inline bool isFinite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace rivulet::base
