// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/radius_compensation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/axes.h"

namespace rivulet::machine {

namespace {

constexpr int kCollision = 10751;
constexpr int kSelectedInArc = 10753;
constexpr int kDeselectedInArc = 10754;
constexpr int kPlaneChanged = 10757;
constexpr int kNotMade = 12550;

/// A motion that moves less in the plane is none there.
constexpr double kNoLengthMm = 1e-9;
/// An arc of the tool's radius leaves a point. As much may lie between its radii (MD21000).
constexpr double kPointMm = 0.01;
/// Blocks whose directions differ by less continue each other, rad.
constexpr double kTangentRad = 1e-4;
/// Tangents as a CAM system writes them, with rounded coordinates: such an inner corner is passed
/// straight, even if the paths beside it do not meet. The contour loses half of this, squared,
/// times the radius.
constexpr double kRoundedRad = 0.01;
/// MD20210: corners that turn by more get a circle with G451 too.
constexpr double kCornerRadMax = 100.0 * std::numbers::pi / 180.0;
constexpr double kFullCircle = 2.0 * std::numbers::pi;

Alarm alarmAt(const PreparedMotion& motion, int number, const char* text) {
  return {number, fmt::format("Line {}: {}", motion.line.value, text)};
}

/// In (0, 2 pi].
double positiveAngle(double angle) {
  const double reduced = std::fmod(angle, kFullCircle);
  return reduced <= 1e-9 ? reduced + kFullCircle : reduced;
}

}  // namespace

// --- in the plane -------------------------------------------------------------------------------

RadiusCompensation::Point RadiusCompensation::inPlane(base::Vec3 place) const {
  const std::size_t first = m_active->firstAxis;
  return {place[first], place[(first + 1) % base::kAxisCount]};
}

base::Vec3 RadiusCompensation::placed(base::Vec3 place, Point at) const {
  const std::size_t first = m_active->firstAxis;
  place.set(first, at.u);
  place.set((first + 1) % base::kAxisCount, at.v);
  return place;
}

/// @param direction  unit vector
RadiusCompensation::Point RadiusCompensation::beside(Point place, Point direction) const {
  const double offset = m_active->side * m_active->radiusMm;
  return {place.u - offset * direction.v, place.v + offset * direction.u};
}

RadiusCompensation::Point RadiusCompensation::startDirection(const Element& element) {
  if (element.turn != 0.0) {
    const double scale = element.turn / element.radiusMm;
    return {-scale * (element.from.v - element.centre.v),
            scale * (element.from.u - element.centre.u)};
  }
  const double length = std::hypot(element.to.u - element.from.u, element.to.v - element.from.v);
  return {(element.to.u - element.from.u) / length, (element.to.v - element.from.v) / length};
}

RadiusCompensation::Point RadiusCompensation::endDirection(const Element& element) {
  if (element.turn == 0.0) {
    return startDirection(element);
  }
  const double u = element.to.u - element.centre.u;
  const double v = element.to.v - element.centre.v;
  const double scale = element.turn / std::hypot(u, v);
  return {-scale * v, scale * u};
}

/// True if the place lies beyond the start of the element (way 1) or before its end (way -1): the
/// straight way would cross the contour.
bool RadiusCompensation::isBehind(Point place, const Element& element, double way) {
  const Point at = way > 0.0 ? element.from : element.to;
  const Point direction = way > 0.0 ? startDirection(element) : endDirection(element);
  return way * ((place.u - at.u) * direction.u + (place.v - at.v) * direction.v) > kNoLengthMm;
}

/// Of the path of the tool's centre; not positive: the tool does not fit.
double RadiusCompensation::offsetRadiusMm(const Element& element) const {
  return element.radiusMm - m_active->side * element.turn * m_active->radiusMm;
}

/// @return nothing for an arc across the plane
std::optional<RadiusCompensation::Element> RadiusCompensation::elementOf(
    PreparedMotion motion, std::size_t firstAxis) const {
  const std::size_t second = (firstAxis + 1) % base::kAxisCount;
  const std::size_t third = (firstAxis + 2) % base::kAxisCount;
  const auto point = [&](base::Vec3 place) { return Point{place[firstAxis], place[second]}; };
  Element element;
  element.from = point(m_programmedMm);
  element.to = point(motion.targetMm);
  if (motion.arc) {
    const double across = motion.arc->axis[third];
    if (std::abs(across) < 1.0 - 1e-9) {
      return std::nullopt;
    }
    element.turn = across > 0.0 ? 1.0 : -1.0;
    element.centre = point(motion.arc->centreMm);
    element.radiusMm =
        std::hypot(element.from.u - element.centre.u, element.from.v - element.centre.v);
  }
  element.motion = std::move(motion);
  return element;
}

// --- corners ------------------------------------------------------------------------------------

/// @return nothing if the tool does not fit
std::optional<RadiusCompensation::Corner> RadiusCompensation::cornerTo(const Element& next) const {
  const Point before = m_held->approaches ? startDirection(next) : endDirection(*m_held);
  const Point after = startDirection(next);
  const Point place = next.from;
  const double angle =
      std::atan2(before.u * after.v - before.v * after.u, before.u * after.u + before.v * after.v);
  Corner corner{beside(place, before), beside(place, after), std::nullopt, std::nullopt};
  if (std::abs(angle) <= kTangentRad) {
    corner.start = corner.end;
    return corner;
  }
  // A path that turns back leaves the tool outside.
  const bool isInner =
      m_active->side * angle > 0.0 && std::abs(angle) < std::numbers::pi - kTangentRad;
  if (isInner) {
    const std::optional<Point> meeting = innerCorner(next);
    if (meeting) {
      return Corner{*meeting, *meeting, std::nullopt, std::nullopt};
    }
    corner.waypoint = corner.start;
    return std::abs(angle) <= kRoundedRad ? std::optional(corner) : std::nullopt;
  }
  if (!m_active->intersects || std::abs(angle) > kCornerRadMax) {
    corner.arcAbout = place;
    return corner;
  }
  // Where the straight continuations of both meet.
  const double reach = std::tan(std::abs(angle) / 2.0) * m_active->radiusMm;
  const Point meeting{corner.end.u + reach * before.u, corner.end.v + reach * before.v};
  if (m_held->turn == 0.0 && next.turn == 0.0) {
    return Corner{meeting, meeting, std::nullopt, std::nullopt};
  }
  corner.waypoint = meeting;
  return corner;
}

/// The intersection of the two offset paths that is nearest to the corner, if both reach it.
std::optional<RadiusCompensation::Point> RadiusCompensation::innerCorner(
    const Element& next) const {
  struct Curve {
    Point at;
    Point direction;
    Point centre;
    double radius = 0.0;
    bool isLine = true;
  };
  const auto curveOf = [this](const Element& element, Point place, Point direction) {
    return Curve{beside(place, direction), direction, element.centre,
                 std::max(0.0, offsetRadiusMm(element)), element.turn == 0.0};
  };
  Curve a = curveOf(*m_held, m_held->to, endDirection(*m_held));
  Curve b = curveOf(next, next.from, startDirection(next));
  std::vector<Point> meetings;
  const auto alongLine = [&meetings](const Curve& line, double length) {
    meetings.push_back(
        {line.at.u + length * line.direction.u, line.at.v + length * line.direction.v});
  };
  if (a.isLine && b.isLine) {
    const double sine = a.direction.u * b.direction.v - a.direction.v * b.direction.u;
    alongLine(a, ((b.at.u - a.at.u) * b.direction.v - (b.at.v - a.at.v) * b.direction.u) / sine);
  } else if (a.isLine || b.isLine) {
    const Curve& line = a.isLine ? a : b;
    const Curve& circle = a.isLine ? b : a;
    const Point to{circle.centre.u - line.at.u, circle.centre.v - line.at.v};
    const double along = to.u * line.direction.u + to.v * line.direction.v;
    const double square =
        circle.radius * circle.radius - (to.u * to.u + to.v * to.v - along * along);
    if (square >= 0.0) {
      alongLine(line, along - std::sqrt(square));
      alongLine(line, along + std::sqrt(square));
    }
  } else {
    const Point way{b.centre.u - a.centre.u, b.centre.v - a.centre.v};
    const double distance = std::hypot(way.u, way.v);
    const double along =
        distance > 0.0
            ? (a.radius * a.radius - b.radius * b.radius + distance * distance) / (2.0 * distance)
            : 0.0;
    const double square = a.radius * a.radius - along * along;
    if (distance > 0.0 && square >= 0.0) {
      for (const double side : {-1.0, 1.0}) {
        const double across = side * std::sqrt(square);
        meetings.push_back({a.centre.u + (along * way.u - across * way.v) / distance,
                            a.centre.v + (along * way.v + across * way.u) / distance});
      }
    }
  }
  const Point corner = next.from;
  const auto distanceTo = [&](const Point& p) {
    return std::hypot(p.u - corner.u, p.v - corner.v);
  };
  const auto nearest = std::min_element(
      meetings.begin(), meetings.end(),
      [&](const Point& p, const Point& q) { return distanceTo(p) < distanceTo(q); });
  if (nearest == meetings.end()) {
    return std::nullopt;
  }
  // Neither path may be driven backwards.
  const Point meeting = *nearest;
  const auto reaches = [](const Element& element, Point from, Point to) {
    if (element.turn == 0.0) {
      const Point way = startDirection(element);
      return (to.u - from.u) * way.u + (to.v - from.v) * way.v > -kNoLengthMm;
    }
    const auto angle = [&](Point p) {
      return std::atan2(p.v - element.centre.v, p.u - element.centre.u);
    };
    return positiveAngle(element.turn * (angle(to) - angle(from))) <
           element.motion.arc->sweepRad + 1e-9;
  };
  const bool fits = reaches(*m_held, m_held->start, meeting) &&
                    reaches(next, meeting, beside(next.to, endDirection(next)));
  return fits ? std::optional(meeting) : std::nullopt;
}

// --- what is ready ------------------------------------------------------------------------------

/// The motion that is held back, ending there; then what waits behind it.
void RadiusCompensation::passOn(Point end, std::deque<Prepared>& ready) {
  PreparedMotion motion = std::move(m_held->motion);
  motion.targetMm = placed(motion.targetMm, end);
  if (motion.arc && offsetRadiusMm(*m_held) <= kPointMm) {
    motion.arc.reset();
  } else if (motion.arc) {
    const Point centre = m_held->centre;
    const double turns = std::floor((motion.arc->sweepRad - 1e-9) / kFullCircle);
    const auto angle = [centre](Point p) { return std::atan2(p.v - centre.v, p.u - centre.u); };
    motion.arc->sweepRad =
        positiveAngle(m_held->turn * (angle(end) - angle(m_held->start))) + turns * kFullCircle;
    // CFC: the feed is that of the edge on the contour.
    motion.feedMmPerS *= offsetRadiusMm(*m_held) / m_held->radiusMm;
  }
  m_atMm = motion.targetMm;
  ready.emplace_back(std::move(motion));
  m_held.reset();
  release(ready);
}

void RadiusCompensation::release(std::deque<Prepared>& ready) {
  for (Prepared& each : m_behind) {
    if (auto* const motion = std::get_if<PreparedMotion>(&each)) {
      motion->targetMm = placed(motion->targetMm, inPlane(m_atMm));
      m_atMm = motion->targetMm;
    }
    ready.push_back(std::move(each));
  }
  m_behind.clear();
}

/// From the end of one motion to the start of the next: belongs to the next block.
void RadiusCompensation::passOver(const Corner& corner, const Element& next,
                                  std::deque<Prepared>& ready) {
  const auto to = [&](Point place) {
    PreparedMotion motion = next.motion;
    motion.arc.reset();
    motion.targetMm = placed(m_atMm, place);
    return motion;
  };
  if (corner.arcAbout) {
    PreparedMotion motion = to(corner.start);
    const Point before = inPlane(m_atMm);
    const Point centre = *corner.arcAbout;
    const double angle = std::atan2((before.u - centre.u) * (corner.start.v - centre.v) -
                                        (before.v - centre.v) * (corner.start.u - centre.u),
                                    (before.u - centre.u) * (corner.start.u - centre.u) +
                                        (before.v - centre.v) * (corner.start.v - centre.v));
    base::Vec3 axis;
    // The tool stays outside: it turns the way that the side says.
    axis.set((m_active->firstAxis + 2) % base::kAxisCount, -1.0 * m_active->side);
    motion.arc =
        ArcPath{placed(m_atMm, centre), axis, positiveAngle(-1.0 * m_active->side * angle)};
    m_atMm = motion.targetMm;
    ready.emplace_back(std::move(motion));
  } else if (corner.waypoint) {
    for (const Point place : {*corner.waypoint, corner.start}) {
      const Point at = inPlane(m_atMm);
      if (std::hypot(place.u - at.u, place.v - at.v) > kNoLengthMm) {
        PreparedMotion motion = to(place);
        m_atMm = motion.targetMm;
        ready.emplace_back(std::move(motion));
      }
    }
  }
}

// --- block by block -----------------------------------------------------------------------------

std::optional<Alarm> RadiusCompensation::add(Prepared next, const Compensation& wanted,
                                             std::deque<Prepared>& ready) {
  if (auto* const motion = std::get_if<PreparedMotion>(&next)) {
    return addMotion(std::move(*motion), wanted, ready);
  }
  (m_held ? m_behind : ready).push_back(std::move(next));
  return std::nullopt;
}

std::optional<Alarm> RadiusCompensation::addMotion(PreparedMotion motion,
                                                   const Compensation& wanted,
                                                   std::deque<Prepared>& ready) {
  const bool wants = wanted.side != 0 && wanted.radiusMm > 0.0;
  if (!m_active && !wants) {
    m_programmedMm = motion.targetMm;
    m_atMm = motion.targetMm;
    ready.emplace_back(std::move(motion));
    return std::nullopt;
  }
  const std::size_t firstAxis = m_active ? m_active->firstAxis : wanted.firstAxis;
  if (wanted.firstAxis != firstAxis) {
    return alarmAt(motion, kPlaneChanged,
                   "the plane must not change while the tool radius is "
                   "compensated.");
  }
  std::optional<Element> element = elementOf(motion, firstAxis);
  if (!element) {
    return alarmAt(motion, kNotMade, "this machine compensates the tool radius in the plane only.");
  }
  const base::Vec3 target = motion.targetMm;
  const bool moves =
      element->turn != 0.0 ||
      std::hypot(element->to.u - element->from.u, element->to.v - element->from.v) > kNoLengthMm;
  std::optional<Alarm> alarm;
  if (!moves && !m_active) {
    m_atMm = target;
    ready.emplace_back(std::move(motion));
  } else if (!moves) {
    m_behind.emplace_back(std::move(motion));
    if (!m_held) {
      release(ready);
    }
  } else if (!m_active) {
    alarm = select(*std::move(element), wanted);
  } else if (!wants) {
    if (element->turn != 0.0) {
      return alarmAt(motion, kDeselectedInArc, "G40 needs a straight line.");
    }
    if (m_held && wanted.goesAround && isBehind(element->to, *m_held, -1.0)) {
      return alarmAt(motion, kNotMade, "this machine leaves no contour around its end (KONT).");
    }
    finish(ready);
    m_active.reset();
    m_atMm = target;
    ready.emplace_back(std::move(motion));
  } else if (wanted.side != m_active->side || wanted.radiusMm != m_active->radiusMm) {
    alarm = alarmAt(motion, kNotMade,
                    "this machine changes side or radius of the compensation after G40 only.");
  } else {
    m_active->intersects = wanted.intersects;
    alarm = follow(*std::move(element), ready);
  }
  m_programmedMm = target;
  return alarm;
}

std::optional<Alarm> RadiusCompensation::select(Element element, const Compensation& wanted) {
  if (element.turn != 0.0) {
    return alarmAt(element.motion, kSelectedInArc, "G41 and G42 need a straight line.");
  }
  m_active = wanted;
  element.approaches = true;
  element.start = inPlane(m_atMm);
  m_held = std::move(element);
  return std::nullopt;
}

std::optional<Alarm> RadiusCompensation::follow(Element element, std::deque<Prepared>& ready) {
  if (element.turn != 0.0 && offsetRadiusMm(element) < -kPointMm) {
    return alarmAt(element.motion, kCollision, "the tool is too large for this arc.");
  }
  Corner corner;
  if (m_held && m_held->approaches && m_active->goesAround &&
      isBehind(m_held->from, element, 1.0)) {
    return alarmAt(element.motion, kNotMade,
                   "this machine approaches no contour around its start (KONT).");
  }
  if (m_held) {
    const std::optional<Corner> found = cornerTo(element);
    if (!found) {
      return alarmAt(element.motion, kCollision, "the tool is too large for this corner.");
    }
    corner = *found;
    passOn(corner.end, ready);
  } else {
    corner.start = beside(element.from, startDirection(element));
    corner.waypoint = corner.start;
  }
  passOver(corner, element, ready);
  element.start = corner.start;
  m_held = std::move(element);
  return std::nullopt;
}

void RadiusCompensation::finish(std::deque<Prepared>& ready) {
  if (m_held) {
    passOn(beside(m_held->to, endDirection(*m_held)), ready);
  }
}

}  // namespace rivulet::machine
