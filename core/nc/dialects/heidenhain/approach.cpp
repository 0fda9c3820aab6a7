// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// APPR and DEP. TNC 640 User's Manual Conversational Programming, chapter "Programming contours",
// "Approaching and departing a contour" (where the third axis goes: "Important positions for
// approach and departure"); iTNC 530 User's Manual, 6.3. The points are those of the contour: the
// radius compensation is in force from the auxiliary point on and offsets them.

#include <cmath>
#include <utility>

#include "nc/dialects/heidenhain/control.h"

namespace rivulet::nc::heidenhain {

namespace {

constexpr double kSamePlace = 1e-9;

/// Where a tangent from a point outside touches a circle. @param counter  the way goes on
/// counterclockwise about the centre, or has come so where `leaves`
std::optional<Flat> tangentPoint(Flat outside, Flat centre, double radius, bool counter,
                                 bool leaves) {
  const Flat away = outside - centre;
  const double distance = norm(away);
  if (!(distance > radius + kSamePlace)) {
    return std::nullopt;
  }
  const double angle = std::acos(radius / distance) * kDegreesPerRadian;
  const double side = counter != leaves ? 1.0 : -1.0;
  return centre + radius * unit(turned(away, side * angle));
}

bool areSame(Flat a, Flat b) {
  return norm(a - b) < kSamePlace;
}

}  // namespace

/// PLT, PCT and PLCT name their place by a pole.
Expected<void> Control::placeByPole(std::string& kind, MotionWords& words) {
  if ((kind != "PLT" && kind != "PCT" && kind != "PLCT") || m_pole.axis != firstAxis()) {
    return {};  // what is not known is refused by its name
  }
  const Expected<Flat> place = polarTarget(words);
  if (!place) {
    return fail(place.error());
  }
  kind.erase(0, 1);
  words.axes[firstAxis()] = place->x;
  words.axes[secondAxis()] = place->y;
  words.isIncrement[firstAxis()] = false;
  words.isIncrement[secondAxis()] = false;
  words.polarRadius.reset();
  words.polarAngle.reset();
  return {};
}

Expected<void> Control::approach(Scanner& in) {
  Approach made;
  made.place = m_block.place;
  made.line = m_block.line;
  made.kind = in.takeName();
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = placeByPole(made.kind, *words); !done) {
    return done;
  }
  const bool isLine = made.kind == "LT";
  const bool isArc = made.kind == "CT";
  const bool isBoth = made.kind == "LCT";
  const int side = words->compensation.value_or(m_compensation);
  // Others need the radius of the tool; without a compensation the side of an arc is not said.
  const bool isKnown = isLine || ((isArc || isBoth) && side != 0);
  if (!isKnown || words->isInMachine() || !words->axes[firstAxis()] || !words->axes[secondAxis()]) {
    return in.fault<void>(FaultCode::UnsupportedGCode, "APPR " + made.kind);
  }
  if (Expected<void> done = refuseUnused(*words, isLine  ? "length"
                                                 : isArc ? "radius angle"
                                                         : "radius");
      !done) {
    return done;
  }
  const bool lacks = isLine ? !words->length : !words->radius || (isArc && !words->centreAngle);
  const bool isWrong = (isLine && !(words->length.value_or(0.0) > 0.0)) ||
                       (!isLine && words->radius.value_or(0.0) == 0.0) ||
                       (isBoth && words->radius.value_or(0.0) < 0.0);
  if (lacks || isWrong) {
    return in.fault<void>(FaultCode::UnsupportedGCode, "APPR " + made.kind);
  }
  made.before = isBoth ? Feed{} : m_wasRapid ? Feed{FeedKind::Rapid, 0.0} : m_feed;
  made.start = flat(m_at);
  Expected<Item> item = itemTo(*words);
  if (!item) {
    return fail(item.error());
  }
  if (isBoth) {
    made.before = item->feed;
  }
  m_direction.reset();
  made.first = flat(item->target);
  made.length = words->length.value_or(0.0) * m_coordinates.scale;
  made.radius = words->radius.value_or(0.0) * m_coordinates.scale;
  made.centreAngle = words->centreAngle.value_or(0.0);
  const Expected<bool> mirrors = mirrorsPlane(firstAxis());
  if (!mirrors) {
    return fail(mirrors.error());
  }
  made.turnsLeft = (side > 0) != *mirrors;
  made.item = std::move(*item);
  if (m_corner) {
    return in.fault<void>(FaultCode::CornerMalformed);
  }
  flush();
  m_approach = std::move(made);
  return {};
}

/// The direction of the first element is known now.
Expected<void> Control::joinApproach(const Item& next) {
  Approach own = *std::exchange(m_approach, std::nullopt);
  const std::optional<Flat> direction =
      next.moves && next.element && next.plane == firstAxis() && !next.given[thirdAxis()]
          ? next.element->startDirection()
          : std::nullopt;
  const auto failed = [&own] {
    return fail(FaultCode::UnsupportedGCode, "APPR " + own.kind, own.place);
  };
  if (!direction) {
    return failed();
  }
  Flat auxiliary;
  Element last = Element::line({}, own.first);
  if (own.kind == "LT") {
    auxiliary = own.first - own.length * *direction;
  } else {
    const double radius = std::abs(own.radius);
    const bool turnsLeft = own.turnsLeft == (own.radius > 0.0);
    const Flat centre = own.first + (turnsLeft ? radius : -radius) * leftOf(*direction);
    last.isArc = true;
    last.clockwise = !turnsLeft;
    last.centre = centre;
    if (own.kind == "CT") {
      auxiliary =
          centre + turned(own.first - centre, turnsLeft ? -own.centreAngle : own.centreAngle);
    } else {
      const std::optional<Flat> point = tangentPoint(own.start, centre, radius, turnsLeft, false);
      if (!point) {
        return failed();
      }
      auxiliary = *point;
    }
  }
  last.start = auxiliary;
  // To the auxiliary point, from where the compensation holds.
  Item way = own.item;
  way.given[firstAxis()] = true;
  way.given[secondAxis()] = true;
  way.element = Element::line(own.start, auxiliary);
  way.feed = own.before;
  way.line = own.line;
  // The third axis goes along with LCT, else afterwards: with the feed of the block, which the
  // manual leaves open.
  const bool goesDown = own.kind != "LCT" && own.item.given[thirdAxis()];
  way.given[thirdAxis()] = way.given[thirdAxis()] && !goesDown;
  write(std::move(way));
  if (goesDown) {
    Item down;
    down.place = own.item.place;
    down.line = own.line;
    down.isSkipped = own.item.isSkipped;
    down.moves = true;
    down.given[thirdAxis()] = true;
    down.target = own.item.target;
    down.plane = firstAxis();
    down.feed = own.item.feed;
    write(std::move(down));
  }
  if (areSame(auxiliary, own.first)) {
    return {};
  }
  Item arrival;
  arrival.place = own.item.place;
  arrival.isSkipped = own.item.isSkipped;
  arrival.moves = true;
  arrival.given[firstAxis()] = true;
  arrival.given[secondAxis()] = true;
  arrival.target = own.item.target;
  arrival.plane = firstAxis();
  arrival.element = last;
  arrival.feed = own.item.feed;
  if (last.isArc && arrival.feed.kind == FeedKind::Rapid) {
    return failed();
  }
  arrival.line = own.line;
  write(std::move(arrival));
  return {};
}

Expected<void> Control::checkDeparture(Scanner& in, const std::string& kind,
                                       const MotionWords& words) {
  const bool isLine = kind == "LT";
  const bool isArc = kind == "CT";
  const bool isBoth = kind == "LCT";
  const auto failed = [&]() -> Expected<void> {
    return in.fault<void>(FaultCode::UnsupportedGCode, "DEP " + kind);
  };
  const bool isKnown = isLine || ((isArc || isBoth) && m_compensation != 0);
  const bool namesPlace = words.axes[firstAxis()] && words.axes[secondAxis()];
  if (!isKnown || words.compensation || words.isInMachine() || isBoth != namesPlace ||
      (!isBoth && (words.axes[firstAxis()] || words.axes[secondAxis()])) || m_corner ||
      !m_direction) {
    return failed();
  }
  if (Expected<void> done = refuseUnused(words, isLine  ? "length"
                                                : isArc ? "radius angle"
                                                        : "radius");
      !done) {
    return done;
  }
  const bool lacks = isLine ? !(words.length.value_or(0.0) > 0.0)
                            : words.radius.value_or(0.0) == 0.0 || (isArc && !words.centreAngle) ||
                                  (isBoth && *words.radius < 0.0);
  return lacks ? failed() : Expected<void>();
}

/// From the last point of the contour to the auxiliary point.
Expected<Element> Control::departureWay(Scanner& in, const std::string& kind,
                                        const MotionWords& words) {
  const Expected<bool> mirrors = mirrorsPlane(firstAxis());
  if (!mirrors) {
    return fail(mirrors.error());
  }
  const Flat from = flat(m_at);
  const Flat direction = *m_direction;
  Element way = Element::line(from, from);
  if (kind == "LT") {
    way.end = from + (*words.length * m_coordinates.scale) * direction;
    return way;
  }
  const double radius = std::abs(*words.radius) * m_coordinates.scale;
  const bool turnsLeft = ((m_compensation > 0) != *mirrors) == (*words.radius > 0.0);
  way.isArc = true;
  way.clockwise = !turnsLeft;
  way.centre = from + (turnsLeft ? radius : -radius) * leftOf(direction);
  if (kind == "CT") {
    way.end = way.centre +
              turned(from - way.centre, turnsLeft ? *words.centreAngle : -*words.centreAngle);
    return way;
  }
  const Expected<base::Vec3> target = targetOf(words);
  if (!target) {
    return fail(target.error());
  }
  const std::optional<Flat> point = tangentPoint(flat(m_coordinates.frame.toWorkpiece(*target)),
                                                 way.centre, radius, turnsLeft, true);
  if (!point) {
    return in.fault<Element>(FaultCode::UnsupportedGCode, "DEP " + kind);
  }
  way.end = *point;
  return way;
}

Expected<void> Control::departure(Scanner& in) {
  std::string kind = in.takeName();
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = placeByPole(kind, *words); !done) {
    return done;
  }
  if (Expected<void> done = checkDeparture(in, kind, *words); !done) {
    return done;
  }
  const Expected<Element> way = departureWay(in, kind, *words);
  if (!way) {
    return fail(way.error());
  }
  const bool isBoth = kind == "LCT";
  MotionWords first;
  first.column = words->column;
  first.feed = words->feed;
  if (!isBoth) {
    first.functions = words->functions;
  }
  Expected<Item> item = itemOf(first);
  if (!item) {
    return fail(item.error());
  }
  item->moves = true;
  item->given[firstAxis()] = true;
  item->given[secondAxis()] = true;
  item->target = m_at;
  item->plane = firstAxis();
  item->element = *way;
  if (way->isArc && item->feed.kind == FeedKind::Rapid) {
    return in.fault<void>(FaultCode::UnsupportedGCode, "DEP " + kind);
  }
  m_at.set(firstAxis(), way->end.x);
  m_at.set(secondAxis(), way->end.y);
  if (!areSame(way->start, way->end)) {
    push(std::move(*item));
  }
  if (isBoth) {
    words->compensation = 0;
    Expected<Item> last = itemTo(*words);
    return last ? moveOn(*words, std::move(*last)) : fail(last.error());
  }
  m_direction.reset();
  if (m_compensation != 0) {
    m_compensation = 0;
    tell({word('G', 40.0)});
    // The centre of the tool stays beside the last point.
    m_at.set(firstAxis(), std::nan(""));
    m_at.set(secondAxis(), std::nan(""));
  }
  if (words->axes[thirdAxis()]) {  // afterwards
    MotionWords up;
    up.column = words->column;
    up.axes[thirdAxis()] = words->axes[thirdAxis()];
    up.isIncrement[thirdAxis()] = words->isIncrement[thirdAxis()];
    up.feed = words->feed;
    Expected<Item> last = itemTo(up);
    if (!last) {
      return fail(last.error());
    }
    push(std::move(*last));
  }
  return afterMotion(first);
}

}  // namespace rivulet::nc::heidenhain
