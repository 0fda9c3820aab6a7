// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/contour_corners.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/axes.h"

namespace rivulet::machine {

namespace {

constexpr int kCornerNotMade = 12550;
/// Directions that differ by less continue each other: there is no corner.
constexpr double kNoCornerRad = 1e-6;
constexpr double kNoWayMm = 1e-9;

/// A place or direction in the plane.
struct InPlane {
  double u = 0.0;
  double v = 0.0;

  friend InPlane operator+(InPlane a, InPlane b) { return {a.u + b.u, a.v + b.v}; }
  friend InPlane operator-(InPlane a, InPlane b) { return {a.u - b.u, a.v - b.v}; }
  friend InPlane operator*(double k, InPlane a) { return {k * a.u, k * a.v}; }
};
double dot(InPlane a, InPlane b) {
  return a.u * b.u + a.v * b.v;
}
double cross(InPlane a, InPlane b) {
  return a.u * b.v - a.v * b.u;
}
double norm(InPlane a) {
  return std::hypot(a.u, a.v);
}
InPlane left(InPlane a) {
  return {-a.v, a.u};
}

/// One side of a corner.
struct Side {
  InPlane from{};
  InPlane to{};
  InPlane centre{};   ///< of an arc
  double turn = 0.0;  ///< 1 counterclockwise, -1 clockwise, 0 a line
  double radius = 0.0;

  [[nodiscard]] bool isArc() const { return turn != 0.0; }
  [[nodiscard]] InPlane directionAt(InPlane place) const {
    const InPlane way = isArc() ? turn * left(place - centre) : to - from;
    return (1.0 / norm(way)) * way;
  }
};

std::optional<Side> sideOf(const PreparedMotion& motion, base::Vec3 fromMm, std::size_t first) {
  const std::size_t second = (first + 1) % base::kAxisCount;
  const std::size_t third = (first + 2) % base::kAxisCount;
  const auto point = [&](base::Vec3 place) { return InPlane{place[first], place[second]}; };
  Side side{.from = point(fromMm), .to = point(motion.targetMm)};
  if (motion.arc) {
    const double across = motion.arc->axis[third];
    if (std::abs(across) < 1.0 - 1e-9) {
      return std::nullopt;
    }
    side.turn = across > 0.0 ? 1.0 : -1.0;
    side.centre = point(motion.arc->centreMm);
    side.radius = norm(side.from - side.centre);
  }
  const bool moves = side.isArc() || norm(side.to - side.from) > kNoWayMm;
  return moves ? std::optional(side) : std::nullopt;
}

/// Where the middle of a rounding may lie so that it touches the side: a line or a circle.
struct Locus {
  InPlane point;  ///< of a line, or the centre
  InPlane direction;
  double radius = 0.0;  ///< 0: a line
};
Locus locusOf(const Side& side, double offset, InPlane corner) {
  return side.isArc() ? Locus{side.centre, {}, side.radius - side.turn * offset}
                      : Locus{corner + offset * left(side.directionAt(corner)),
                              side.directionAt(corner), 0.0};
}

/// The place common to both that is nearest to the corner.
std::optional<InPlane> meet(const Locus& a, const Locus& b, InPlane corner) {
  if (a.radius == 0.0 && b.radius == 0.0) {
    const double sine = cross(a.direction, b.direction);
    return std::abs(sine) < kNoCornerRad
               ? std::nullopt
               : std::optional(a.point +
                               (cross(b.point - a.point, b.direction) / sine) * a.direction);
  }
  if (a.radius == 0.0) {
    return meet(b, a, corner);
  }
  InPlane foot;  // between the two places
  InPlane across;
  double half = 0.0;
  if (b.radius == 0.0) {
    foot = b.point + dot(a.point - b.point, b.direction) * b.direction;
    across = b.direction;
    half = a.radius * a.radius - dot(foot - a.point, foot - a.point);
  } else {
    const InPlane way = b.point - a.point;
    const double apart = norm(way);
    if (apart < kNoWayMm) {
      return std::nullopt;
    }
    const double along =
        (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2.0 * apart);
    foot = a.point + (along / apart) * way;
    across = (1.0 / apart) * left(way);
    half = a.radius * a.radius - along * along;
  }
  if (half < 0.0) {
    return std::nullopt;
  }
  const InPlane one = foot + std::sqrt(half) * across;
  const InPlane other = foot - std::sqrt(half) * across;
  return norm(one - corner) < norm(other - corner) ? one : other;
}

InPlane touch(const Side& side, InPlane middle) {
  if (side.isArc()) {
    const InPlane way = middle - side.centre;
    return side.centre + (side.radius / norm(way)) * way;
  }
  const InPlane direction = side.directionAt(side.to);
  return side.from + dot(middle - side.from, direction) * direction;
}

/// How far along the side the place is, 0 at its beginning and 1 at its end.
double shareAt(const Side& side, InPlane place) {
  if (!side.isArc()) {
    const InPlane way = side.to - side.from;
    return dot(place - side.from, way) / dot(way, way);
  }
  const auto angleTo = [&](InPlane to) {
    const InPlane a = side.from - side.centre;
    const InPlane b = to - side.centre;
    const double angle = side.turn * std::atan2(cross(a, b), dot(a, b));
    return angle <= 1e-12 ? angle + 2.0 * std::numbers::pi : angle;
  };
  return angleTo(place) / angleTo(side.to);
}

/// What takes the place of a corner.
struct Transition {
  InPlane leave;  ///< the side before it
  InPlane arrive;
  InPlane middle;  ///< of a rounding
};

/// Between straight sides, smaller where one is too short. @param turned  radians, + to the left
Transition betweenLines(const Side& before, const Side& after, const ContourCorner& corner,
                        double turned) {
  const InPlane in = before.directionAt(before.to);
  const InPlane out = after.directionAt(before.to);
  const double half = std::abs(turned) / 2.0;
  const double wanted = corner.kind == ContourCorner::Kind::Radius ? corner.mm * std::tan(half)
                        : corner.kind == ContourCorner::Kind::Chamfer
                            ? corner.mm / (2.0 * std::cos(half))
                            : corner.mm;
  const double cut = std::min({wanted, norm(before.to - before.from), norm(after.to - after.from)});
  const InPlane leave = before.to - cut * in;
  const double hand = turned > 0.0 ? 1.0 : -1.0;
  return {leave, before.to + cut * out, leave + (hand * cut / std::tan(half)) * left(in)};
}

/// A rounding that fits between both sides; nothing: there is none.
std::optional<Transition> atArc(const Side& before, const Side& after, const ContourCorner& corner,
                                double turned) {
  if (corner.kind != ContourCorner::Kind::Radius) {
    return std::nullopt;
  }
  const double offset = turned > 0.0 ? corner.mm : -corner.mm;
  const std::optional<InPlane> middle =
      meet(locusOf(before, offset, before.to), locusOf(after, offset, before.to), before.to);
  if (!middle) {
    return std::nullopt;
  }
  const Transition made{touch(before, *middle), touch(after, *middle), *middle};
  const double from = shareAt(before, made.leave);
  const double to = shareAt(after, made.arrive);
  const bool isOutside = from <= 0.0 || from > 1.0 || to < 0.0 || to >= 1.0;
  return isOutside ? std::nullopt : std::optional(made);
}

}  // namespace

std::optional<Alarm> ContourCorners::add(Prepared next, std::optional<ContourCorner> corner,
                                         std::size_t firstAxis, std::deque<Prepared>& ready) {
  auto* const motion = std::get_if<PreparedMotion>(&next);
  if (motion == nullptr) {
    (m_held ? m_behind : ready).push_back(std::move(next));
    return std::nullopt;
  }
  const base::Vec3 endMm = motion->targetMm;
  const bool isCorner = corner && corner->mm > 0.0;
  std::optional<Alarm> alarm = m_held ? join(*motion, ready) : std::nullopt;
  if (isCorner) {
    // The rest of this motion begins where the corner before it ends.
    m_held = Held{std::move(*motion), m_atMm, *corner, firstAxis};
  } else {
    ready.push_back(std::move(next));
  }
  m_atMm = endMm;
  return alarm;
}

void ContourCorners::finish(std::deque<Prepared>& ready) {
  if (m_held) {
    ready.push_back(std::move(m_held->motion));
    m_held.reset();
  }
  std::move(m_behind.begin(), m_behind.end(), std::back_inserter(ready));
  m_behind.clear();
}

/// The motion held back, its corner, and `next` from there on.
std::optional<Alarm> ContourCorners::join(PreparedMotion& next, std::deque<Prepared>& ready) {
  Held held = *std::move(m_held);
  m_held.reset();
  const auto pass = [&] {
    ready.push_back(std::move(held.motion));
    std::move(m_behind.begin(), m_behind.end(), std::back_inserter(ready));
    m_behind.clear();
  };
  const std::size_t first = held.firstAxis;
  const base::Vec3 cornerMm = held.motion.targetMm;
  const std::optional<Side> before = sideOf(held.motion, held.fromMm, first);
  const std::optional<Side> after = sideOf(next, cornerMm, first);
  if (!before || !after) {
    pass();
    return std::nullopt;
  }
  const InPlane in = before->directionAt(before->to);
  const InPlane out = after->directionAt(before->to);
  const double turned = std::atan2(cross(in, out), dot(in, out));
  if (std::abs(turned) < kNoCornerRad) {
    pass();
    return std::nullopt;
  }
  const std::optional<Transition> made = before->isArc() || after->isArc()
                                             ? atArc(*before, *after, held.corner, turned)
                                             : betweenLines(*before, *after, held.corner, turned);
  if (!made) {
    pass();
    return Alarm{kCornerNotMade,
                 fmt::format("Line {}: this machine makes no such corner at an arc.",
                             held.motion.line.value)};
  }
  const std::size_t second = (first + 1) % base::kAxisCount;
  const std::size_t third = (first + 2) % base::kAxisCount;
  const auto placed = [&](InPlane at, double height) {
    base::Vec3 place;
    place.set(first, at.u);
    place.set(second, at.v);
    place.set(third, height);
    return place;
  };
  const double left1 = shareAt(*before, made->leave);
  const double fromHeight = held.fromMm[third];
  const double leaveHeight = fromHeight + left1 * (cornerMm[third] - fromHeight);
  PreparedMotion across = held.motion;
  const bool remains = left1 > 1e-9;
  if (remains) {
    held.motion.targetMm = placed(made->leave, leaveHeight);
    if (held.motion.arc) {
      held.motion.arc->sweepRad *= left1;
    }
    ready.push_back(held.motion);
  }
  across.targetMm = placed(made->arrive, cornerMm[third]);
  across.arc.reset();
  if (held.corner.kind == ContourCorner::Kind::Radius) {
    base::Vec3 axis;
    axis.set(third, turned > 0.0 ? 1.0 : -1.0);
    across.arc = ArcPath{placed(made->middle, leaveHeight), axis, std::abs(turned)};
    const InPlane a = made->leave - made->middle;
    const InPlane b = made->arrive - made->middle;
    across.arc->sweepRad = std::abs(std::atan2(cross(a, b), dot(a, b)));
  }
  ready.push_back(across);
  std::move(m_behind.begin(), m_behind.end(), std::back_inserter(ready));
  m_behind.clear();
  if (next.arc) {
    next.arc->sweepRad *= 1.0 - shareAt(*after, made->arrive);
  }
  m_atMm = across.targetMm;
  return std::nullopt;
}

}  // namespace rivulet::machine
