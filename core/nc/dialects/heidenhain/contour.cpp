// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rivulet::nc::heidenhain {

namespace {

/// Lengths below are rounding.
constexpr double kTiny = 1e-9;
/// Sine of the angle below which elements count as tangent.
constexpr double kTangent = 1e-6;

/// An element moved sideways by `distance` to its left: a line through `point`, or a circle.
struct Offset {
  bool isArc = false;
  Flat point;
  Flat direction;
  Flat centre;
  double radius = 0.0;
};

Offset offsetOf(const Element& element, double distance) {
  Offset made;
  made.isArc = element.isArc;
  if (element.isArc) {
    made.centre = element.centre;
    // To the left of a counterclockwise arc lies its centre.
    made.radius = norm(element.start - element.centre) + (element.clockwise ? distance : -distance);
  } else {
    made.direction = unit(element.end - element.start);
    made.point = element.start + distance * leftOf(made.direction);
  }
  return made;
}

using Points = std::array<std::optional<Flat>, 2>;

Points lineAndCircle(const Offset& line, const Offset& circle) {
  const Flat foot = line.point + dot(circle.centre - line.point, line.direction) * line.direction;
  const double away = norm(foot - circle.centre);
  const double squares = circle.radius * circle.radius - away * away;
  if (squares < 0.0) {
    return {};
  }
  const double along = std::sqrt(squares);
  return {foot + along * line.direction, foot - along * line.direction};
}

Points meet(const Offset& a, const Offset& b) {
  if (!a.isArc && !b.isArc) {
    const double sine = cross(a.direction, b.direction);
    return {a.point + (cross(b.point - a.point, b.direction) / sine) * a.direction, std::nullopt};
  }
  if (!a.isArc || !b.isArc) {
    return a.isArc ? lineAndCircle(b, a) : lineAndCircle(a, b);
  }
  const Flat between = b.centre - a.centre;
  const double distance = norm(between);
  if (distance < kTiny) {
    return {};
  }
  const double along =
      (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2.0 * distance);
  const double squares = a.radius * a.radius - along * along;
  if (squares < 0.0) {
    return {};
  }
  const Flat direction = (1.0 / distance) * between;
  const Flat foot = a.centre + along * direction;
  return {foot + std::sqrt(squares) * leftOf(direction),
          foot - std::sqrt(squares) * leftOf(direction)};
}

/// Where an arc about `centre` touches the element.
Flat touch(const Element& element, Flat centre) {
  if (element.isArc) {
    return element.centre + norm(element.start - element.centre) * unit(centre - element.centre);
  }
  const Flat direction = unit(element.end - element.start);
  return element.start + dot(centre - element.start, direction) * direction;
}

/// Radians from the start of an arc to a point of it, in its sense.
double angleTo(const Element& arc, Flat point) {
  const Flat from = arc.start - arc.centre;
  const Flat to = point - arc.centre;
  const double angle = std::atan2(cross(from, to), dot(from, to)) * (arc.clockwise ? -1.0 : 1.0);
  return angle < -kTiny ? angle + 2.0 * std::numbers::pi : std::max(angle, 0.0);
}

bool lies(const Element& element, Flat point) {
  if (element.isArc) {
    return angleTo(element, point) <= angleTo(element, element.end) + kTiny;
  }
  const Flat way = element.end - element.start;
  const double share = dot(point - element.start, way) / dot(way, way);
  return share >= -kTiny && share <= 1.0 + kTiny;
}

}  // namespace

double norm(Flat a) {
  return std::hypot(a.x, a.y);
}

Flat unit(Flat a) {
  return (1.0 / norm(a)) * a;
}

Flat turned(Flat a, double degrees) {
  const double angle = degrees / kDegreesPerRadian;
  return {a.x * std::cos(angle) - a.y * std::sin(angle),
          a.x * std::sin(angle) + a.y * std::cos(angle)};
}

std::optional<Flat> Element::startDirection() const {
  const Flat along = isArc ? leftOf(start - centre) : end - start;
  if (!(norm(along) > kTiny)) {
    return std::nullopt;
  }
  return isArc && clockwise ? unit(-1.0 * along) : unit(along);
}

std::optional<Flat> Element::endDirection() const {
  if (!isArc) {
    return startDirection();
  }
  const Flat along = leftOf(end - centre);
  if (!(norm(along) > kTiny)) {
    return std::nullopt;
  }
  return clockwise ? unit(-1.0 * along) : unit(along);
}

std::optional<Element> tangentArc(Flat start, Flat direction, Flat end) {
  const Flat chord = end - start;
  const double length = norm(chord);
  Element made = Element::line(start, end);
  if (!(length > kTiny)) {
    return std::nullopt;
  }
  const double sine = cross(direction, chord) / length;
  if (std::abs(sine) < kTiny) {
    return dot(direction, chord) > 0.0 ? std::optional(made) : std::nullopt;
  }
  // Its centre lies across the direction, as far from the end as from the start.
  const double radius = length / (2.0 * sine);  // < 0: to the right
  made.isArc = true;
  made.clockwise = radius < 0.0;
  made.centre = start + radius * leftOf(direction);
  return made;
}

std::optional<Corner> roundedCorner(const Element& before, const Element& after, double radius) {
  const std::optional<Flat> in = before.endDirection();
  const std::optional<Flat> out = after.startDirection();
  if (!in || !out || !(radius > 0.0)) {
    return std::nullopt;
  }
  const double turn = cross(*in, *out);
  if (std::abs(turn) < kTangent) {
    return std::nullopt;
  }
  const double side = turn > 0.0 ? radius : -radius;
  const Offset first = offsetOf(before, side);
  const Offset second = offsetOf(after, side);
  if (first.radius < 0.0 || second.radius < 0.0) {
    return std::nullopt;
  }
  std::optional<Flat> centre;
  for (const std::optional<Flat>& point : meet(first, second)) {
    if (point && (!centre || norm(*point - before.end) < norm(*centre - before.end))) {
      centre = point;
    }
  }
  if (!centre) {
    return std::nullopt;
  }
  Corner made{before, {}, after};
  made.before.end = touch(before, *centre);
  made.after.start = touch(after, *centre);
  if (!lies(before, made.before.end) || !lies(after, made.after.start)) {
    return std::nullopt;
  }
  made.between = {made.before.end, made.after.start, true, turn < 0.0, *centre};
  return made;
}

std::optional<Corner> chamferedCorner(const Element& before, const Element& after, double length) {
  const std::optional<Flat> in = before.endDirection();
  const std::optional<Flat> out = after.startDirection();
  const bool fits = in && out && !before.isArc && !after.isArc && length > 0.0 &&
                    length <= norm(before.end - before.start) + kTiny &&
                    length <= norm(after.end - after.start) + kTiny;
  if (!fits || std::abs(cross(*in, *out)) < kTangent) {
    return std::nullopt;
  }
  Corner made{before, {}, after};
  made.before.end = before.end - length * *in;
  made.after.start = after.start + length * *out;
  made.between = Element::line(made.before.end, made.after.start);
  return made;
}

}  // namespace rivulet::nc::heidenhain
