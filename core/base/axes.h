// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The rotary axes A, B, C beside the geometry axes X, Y, Z of vec3.h. Degrees and millimetres
/// never share a number: code that uses only X, Y, Z does not need this file. Angles are not
/// reduced to one turn: 370 deg is one turn and ten degrees. @threadsafety plain values.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/vec3.h"

namespace rivulet::base {

inline constexpr std::size_t kRotaryAxisCount = 3;
inline constexpr std::array<char, kRotaryAxisCount> kRotaryAxisNames{'A', 'B', 'C'};

/// Largest number of axes, of all kinds, that one template moves.
inline constexpr std::size_t kStreamedAxesMax = 5;

/// Angles of A, B, C in degrees; 0 for an axis that is not there.
using RotaryDeg = std::array<double, kRotaryAxisCount>;

/// Which of A, B, C.
using RotarySet = std::array<bool, kRotaryAxisCount>;

/// Positions of all axes.
struct AxisPosition {
  Vec3 mm;
  RotaryDeg deg{};
};

[[nodiscard]] constexpr bool any(const RotarySet& set) {
  return set[0] || set[1] || set[2];
}
[[nodiscard]] constexpr std::size_t count(const RotarySet& set) {
  return static_cast<std::size_t>(set[0]) + static_cast<std::size_t>(set[1]) +
         static_cast<std::size_t>(set[2]);
}
/// True if every axis of `inner` is one of `outer`.
[[nodiscard]] constexpr bool contains(const RotarySet& outer, const RotarySet& inner) {
  return (outer[0] || !inner[0]) && (outer[1] || !inner[1]) && (outer[2] || !inner[2]);
}
/// "AC".
[[nodiscard]] inline std::string rotaryNames(const RotarySet& set) {
  std::string names;
  for (std::size_t axis = 0; axis < kRotaryAxisCount; ++axis) {
    if (set[axis]) {
      names += kRotaryAxisNames[axis];
    }
  }
  return names;
}

/// How far the axes turn between two places: the root of the sum of squares, deg.
[[nodiscard]] inline double turnDeg(const RotaryDeg& from, const RotaryDeg& to) {
  return norm({to[0] - from[0], to[1] - from[1], to[2] - from[2]});
}
/// Above this many degrees per mm, the turn is the length of a path.
inline constexpr double kDegPerMmMax = 100.0;
/// The length that the feed of a straight move refers to: mm of X Y Z, or degrees if (practically)
/// only rotary axes turn. F is then mm/min or deg/min.
[[nodiscard]] constexpr double wayAlongFeed(double lengthMm, double turnDeg) {
  return lengthMm * kDegPerMmMax < turnDeg ? turnDeg : lengthMm;
}
/// Largest difference of these axes, deg.
[[nodiscard]] inline double differenceDeg(const RotaryDeg& a, const RotaryDeg& b,
                                          const RotarySet& of) {
  double largest = 0.0;
  for (std::size_t axis = 0; axis < kRotaryAxisCount; ++axis) {
    if (of[axis]) {
      largest = std::max(largest, std::abs(a[axis] - b[axis]));
    }
  }
  return largest;
}

}  // namespace rivulet::base
