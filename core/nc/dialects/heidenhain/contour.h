// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Corners and tangents of a contour in the working plane: what RND, CHF, CT, APPR and DEP make of
/// the straight lines and arcs beside them. One unit for all lengths. @threadsafety pure.
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>

#include "base/vec3.h"

namespace rivulet::nc::heidenhain {

/// A point or direction in the plane.
struct Flat {
  double x = 0.0;
  double y = 0.0;

  friend constexpr Flat operator+(Flat a, Flat b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Flat operator-(Flat a, Flat b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Flat operator*(double k, Flat a) { return {k * a.x, k * a.y}; }
};
[[nodiscard]] constexpr double dot(Flat a, Flat b) {
  return a.x * b.x + a.y * b.y;
}
/// > 0: b lies to the left of a.
[[nodiscard]] constexpr double cross(Flat a, Flat b) {
  return a.x * b.y - a.y * b.x;
}
[[nodiscard]] constexpr Flat leftOf(Flat a) {
  return {-a.y, a.x};
}
[[nodiscard]] double norm(Flat a);
inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// Of length 1. @pre not zero
[[nodiscard]] Flat unit(Flat a);
[[nodiscard]] Flat turned(Flat a, double degrees);

/// A straight line or an arc of less than a full circle.
struct Element {
  Flat start;
  Flat end;
  bool isArc = false;
  bool clockwise = false;
  Flat centre;

  [[nodiscard]] static Element line(Flat start, Flat end) { return {start, end, false, false, {}}; }
  /// Unit vectors; nothing where a line has no length.
  [[nodiscard]] std::optional<Flat> startDirection() const;
  [[nodiscard]] std::optional<Flat> endDirection() const;
};

/// The arc that leaves `start` in `direction` and ends at `end`; a line where that is one.
/// @return nothing if it would have to turn back
[[nodiscard]] std::optional<Element> tangentArc(Flat start, Flat direction, Flat end);

/// What is put in between two elements, whose ends it shortens.
struct Corner {
  Element before;
  Element between;
  Element after;
};
/// @pre before.end = after.start  @return nothing if the radius or length has no room, or if the
/// elements turn back
[[nodiscard]] std::optional<Corner> roundedCorner(const Element& before, const Element& after,
                                                  double radius);
/// Both lines. @param length  taken from each of them
[[nodiscard]] std::optional<Corner> chamferedCorner(const Element& before, const Element& after,
                                                    double length);

}  // namespace rivulet::nc::heidenhain
