// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Straight lines and arcs. Chapter "Programming contours", "Path contours".

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "nc/dialects/heidenhain/control.h"
#include "nc/geometry/arc.h"

namespace rivulet::nc::heidenhain {

namespace {

bool isKnown(Flat place) {
  return std::isfinite(place.x) && std::isfinite(place.y);
}

}  // namespace

/// L and LN, and blocks of words alone.
Expected<void> Control::line(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = refuseUnused(*words, ""); !done) {
    return done;
  }
  Expected<Item> item = itemOf(*words);
  if (!item) {
    return fail(item.error());
  }
  if (words->moves() && !words->isInMachine()) {
    const Expected<base::Vec3> target = targetOf(*words);
    if (!target) {
      return fail(target.error());
    }
    if (Expected<void> done = setTarget(*item, *target, *words); !done) {
      return done;
    }
  }
  return moveOn(*words, std::move(*item));
}

Expected<void> Control::polarLine(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = refuseUnused(*words, "polar"); !done) {
    return done;
  }
  const Expected<Flat> end = polarTarget(*words);
  if (!end) {
    return fail(end.error());
  }
  words->axes[m_pole.axis] = end->x;
  words->axes[poleSecondAxis()] = end->y;
  words->isIncrement[m_pole.axis] = false;
  words->isIncrement[poleSecondAxis()] = false;
  Expected<Item> item = itemTo(*words);
  return item ? moveOn(*words, std::move(*item)) : fail(item.error());
}

/// CC without coordinates: the pole is where the tool is. Its axes say in which plane arcs lie.
Expected<void> Control::circleCentre(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  for (std::size_t axis = kFirstRotary; axis < kProgrammedAxisCount; ++axis) {
    if (words->axes[axis]) {
      return in.fault<void>(FaultCode::CentreOutsidePlane, std::string(1, kProgrammedAxes[axis]));
    }
  }
  const bool isNamed = words->movesLinear();
  std::optional<std::size_t> plane = isNamed ? std::nullopt : std::optional(firstAxis());
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const std::size_t next = (axis + 1) % base::kAxisCount;
    const std::size_t other = (axis + 2) % base::kAxisCount;
    if (words->axes[axis] && words->axes[next] && !words->axes[other]) {
      plane = axis;
    }
  }
  if (!plane) {
    return in.fault<void>(FaultCode::ValueMissing, "CC");
  }
  const base::Vec3 at = programmed();
  base::Vec3 place = at;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words->axes[axis]) {
      place.set(axis, *words->axes[axis] + (words->isIncrement[axis] ? at[axis] : 0.0));
    }
  }
  if (!isKnown(flatIn(*plane, place))) {
    return in.fault<void>(FaultCode::RelativeFromUnknownPosition, "CC");
  }
  m_pole.place = flatIn(*plane, place);
  m_pole.axis = *plane;
  return {};
}

Expected<void> Control::arcAboutCentre(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = refuseUnused(*words, "direction"); !done) {
    return done;
  }
  if (!m_pole.place || !words->clockwise) {
    return in.fault<void>(FaultCode::ArcWithoutCentre, m_pole.place ? "DR" : "CC");
  }
  Expected<Item> item = itemOf(*words);
  const Expected<base::Vec3> target = item ? targetOf(*words) : fail(item.error());
  if (!target) {
    return fail(target.error());
  }
  const Flat pole = *m_pole.place;
  item->given[m_pole.axis] = true;
  item->given[poleSecondAxis()] = true;
  if (Expected<void> done = setTarget(*item, *target, *words); !done) {
    return done;
  }
  if (Expected<void> done = setArc(*item, pole, *words->clockwise, m_pole.axis); !done) {
    return done;
  }
  return moveOn(*words, std::move(*item));
}

/// CR: R > 0 is the arc of less than 180 degrees, R < 0 the other one.
Expected<void> Control::arcWithRadius(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = refuseUnused(*words, "radius direction"); !done) {
    return done;
  }
  if (!words->radius || *words->radius == 0.0 || !words->clockwise) {
    return in.fault<void>(FaultCode::ArcWithoutCentre, words->clockwise ? "R" : "DR");
  }
  Expected<Item> item = itemOf(*words);
  const Expected<base::Vec3> target = item ? targetOf(*words) : fail(item.error());
  if (!target) {
    return fail(target.error());
  }
  const base::Vec3 from = programmed();
  const Flat start = flat(from);
  const Flat end = flat(*target);
  const double half = norm(end - start) / 2.0;
  const double radius = *words->radius;
  if (!isKnown(start)) {
    return in.fault<void>(FaultCode::ArcFromUnknownPosition,
                          std::string(1, base::kAxisNames[firstAxis()]));
  }
  if (!(half > 0.0)) {
    return in.fault<void>(FaultCode::ArcWithoutCentre, "R");
  }
  const double tolerance = kArcRadiusToleranceMm * (m_isInch ? 1.0 / 25.4 : 1.0);
  if (std::abs(radius) < half - tolerance) {
    return in.fault<void>(FaultCode::ArcRadiusTooSmall, fmt::format("{} < {}", radius, half));
  }
  const double away = std::sqrt(std::max(0.0, radius * radius - half * half));
  // The centre of a counterclockwise arc of less than 180 degrees lies to the left of the chord.
  const double side = (*words->clockwise ? -1.0 : 1.0) * (radius > 0.0 ? 1.0 : -1.0);
  const Flat centre = start + 0.5 * (end - start) + side * away * leftOf(unit(end - start));
  if (Expected<void> done = setTarget(*item, *target, *words); !done) {
    return done;
  }
  if (Expected<void> done = setArc(*item, centre, *words->clockwise, firstAxis()); !done) {
    return done;
  }
  item->radius = radius * m_coordinates.scale;
  return moveOn(*words, std::move(*item));
}

/// CP: about the pole, to an angle. IPA with a third axis is a helix of as many turns as that.
Expected<void> Control::polarArc(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = refuseUnused(*words, "polar direction"); !done) {
    return done;
  }
  if (!m_pole.place || !words->clockwise) {
    return in.fault<void>(FaultCode::ArcWithoutCentre, m_pole.place ? "DR" : "CC");
  }
  const base::Vec3 from = programmed();
  const std::size_t across = (m_pole.axis + 2) % base::kAxisCount;
  if (words->polarRadius || !words->polarAngle || words->axes[m_pole.axis] ||
      words->axes[poleSecondAxis()]) {
    return in.fault<void>(FaultCode::ValueMissing, "PA");
  }
  const Flat pole = *m_pole.place;
  const Flat start = flatIn(m_pole.axis, from) - pole;
  if (!isKnown(start)) {
    return in.fault<void>(FaultCode::ArcFromUnknownPosition,
                          std::string(1, base::kAxisNames[m_pole.axis]));
  }
  const double sense = *words->clockwise ? -1.0 : 1.0;
  double sweep = 0.0;
  if (words->angleIsIncrement) {
    sweep = *words->polarAngle;
    if (sweep * sense <= 0.0) {
      return in.fault<void>(FaultCode::OutOfDomain, "IPA DR");  // they contradict each other
    }
  } else {
    sweep = std::fmod(*words->polarAngle - std::atan2(start.y, start.x) * kDegreesPerRadian, 360.0);
    sweep += sweep * sense <= 0.0 ? sense * 360.0 : 0.0;
    if (std::abs(std::abs(sweep) - 360.0) < 1e-9) {
      sweep = sense * 360.0;
    }
  }
  const Expected<base::Vec3> end = targetOf(*words);
  if (!end) {
    return fail(end.error());
  }
  const double rise = words->axes[across] ? (*end)[across] - from[across] : 0.0;
  if (std::isnan(rise)) {
    return in.fault<void>(FaultCode::RelativeFromUnknownPosition,
                          std::string(1, base::kAxisNames[across]));
  }
  Expected<Item> item = itemOf(*words);
  if (!item) {
    return fail(item.error());
  }
  // Full circles on top of what is left of the angle.
  const double whole = std::ceil(std::abs(sweep) / 360.0 - 1e-9) - 1.0;
  constexpr double kTurnsMax = 10000.0;
  if (whole > kTurnsMax) {
    return in.fault<void>(FaultCode::ValueOutOfRange, "IPA");
  }
  item->turns = static_cast<int>(whole);
  const bool isWhole = std::fmod(std::abs(sweep), 360.0) == 0.0;
  const Flat flatEnd = pole + (isWhole ? start : turned(start, sweep));
  base::Vec3 target = *end;
  target.set(m_pole.axis, flatEnd.x);
  target.set(poleSecondAxis(), flatEnd.y);
  item->moves = true;
  item->given[m_pole.axis] = true;
  item->given[poleSecondAxis()] = true;
  if (Expected<void> done = setTarget(*item, target, *words); !done) {
    return done;
  }
  if (Expected<void> done = setArc(*item, pole, *words->clockwise, m_pole.axis); !done) {
    return done;
  }
  return moveOn(*words, std::move(*item));
}

/// CT and CTP: leaves in the direction in which the element before it has arrived.
Expected<void> Control::tangentialArc(Scanner& in, bool isPolar) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = refuseUnused(*words, isPolar ? "polar" : ""); !done) {
    return done;
  }
  if (isPolar && m_pole.place && m_pole.axis != firstAxis()) {
    return in.fault<void>(FaultCode::UnsupportedGCode, "CTP");
  }
  if (isPolar) {
    const Expected<Flat> end = polarTarget(*words);
    if (!end) {
      return fail(end.error());
    }
    words->axes[firstAxis()] = end->x;
    words->axes[secondAxis()] = end->y;
    words->isIncrement[firstAxis()] = false;
    words->isIncrement[secondAxis()] = false;
  }
  Expected<Item> item = itemOf(*words);
  if (!item) {
    return fail(item.error());
  }
  const Expected<base::Vec3> target = targetOf(*words);
  if (!target) {
    return fail(target.error());
  }
  const std::optional<Flat> direction = m_direction;
  const bool isCorner = m_corner.has_value();
  item->given[firstAxis()] = true;
  item->given[secondAxis()] = true;
  if (Expected<void> done = setTarget(*item, *target, *words); !done) {
    return done;
  }
  const std::optional<Element> made =
      direction && item->element && !isCorner
          ? tangentArc(item->element->start, *direction, item->element->end)
          : std::nullopt;
  if (!made) {
    return in.fault<void>(FaultCode::ArcWithoutCentre, "CT");
  }
  item->element = made;
  m_direction = made->endDirection();
  return moveOn(*words, std::move(*item));
}

Expected<void> Control::corner(Scanner& in, bool isChamfer) {
  CornerWords made;
  made.place = m_block.place;
  made.line = m_block.line;
  made.isChamfer = isChamfer;
  if (isChamfer == in.takePrefix("R")) {
    return in.fault<void>(FaultCode::ValueMissing, "R");
  }
  const Expected<double> size = in.value();
  if (!size) {
    return fail(size.error());
  }
  made.size = *size * m_coordinates.scale;
  if (!in.isAtEnd() && in.peek() == 'F') {
    const Expected<Feed> feed = feedWord(in);
    if (!feed) {
      return fail(feed.error());
    }
    made.feed = *feed;
  }
  if (!(*size > 0.0) || !m_pending || m_corner) {
    return in.fault<void>(FaultCode::CornerMalformed);
  }
  m_corner = made;
  return {};
}

// --- where to -----------------------------------------------------------------------------------

/// Programmed coordinates. Axes that are not named stay.
Expected<base::Vec3> Control::targetOf(const MotionWords& words) {
  const base::Vec3 from = programmed();
  base::Vec3 target = from;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!words.axes[axis]) {
      continue;
    }
    if (words.isIncrement[axis] && std::isnan(from[axis])) {
      return fail(FaultCode::RelativeFromUnknownPosition, std::string(1, base::kAxisNames[axis]),
                  {m_block.place.line, m_block.place.file, words.column});
    }
    target.set(axis, *words.axes[axis] + (words.isIncrement[axis] ? from[axis] : 0.0));
  }
  return target;
}

Expected<Flat> Control::polarTarget(const MotionWords& words) {
  const Place place{m_block.place.line, m_block.place.file, words.column};
  if (!m_pole.place) {
    return fail(FaultCode::ArcWithoutCentre, "CC", place);
  }
  const Flat from = flatIn(m_pole.axis, programmed()) - *m_pole.place;
  const bool needsFrom =
      !words.polarRadius || !words.polarAngle || words.radiusIsIncrement || words.angleIsIncrement;
  if (needsFrom && !isKnown(from)) {
    return fail(FaultCode::RelativeFromUnknownPosition, "PR", place);
  }
  const double startAngle = needsFrom ? std::atan2(from.y, from.x) * kDegreesPerRadian : 0.0;
  const double radius = words.polarRadius
                            ? *words.polarRadius + (words.radiusIsIncrement ? norm(from) : 0.0)
                            : norm(from);
  const double angle = words.polarAngle
                           ? *words.polarAngle + (words.angleIsIncrement ? startAngle : 0.0)
                           : startAngle;
  return *m_pole.place + turned({radius, 0.0}, angle);
}

Expected<bool> Control::mirrorsPlane(std::size_t plane) const {
  base::Vec3 first;
  base::Vec3 second;
  first.set(plane, 1.0);
  second.set((plane + 1) % base::kAxisCount, 1.0);
  first = m_coordinates.frame.turned(first);
  second = m_coordinates.frame.turned(second);
  const std::size_t across = (plane + 2) % base::kAxisCount;
  if (first[across] != 0.0 || second[across] != 0.0) {
    return fail(FaultCode::UnsupportedGCode, "CYCL DEF 10", m_block.place);  // into another plane
  }
  return cross(flatIn(plane, first), flatIn(plane, second)) < 0.0;
}

Expected<Control::Item> Control::itemOf(const MotionWords& words) {
  Item item;
  item.place = {m_block.place.line, m_block.place.file, words.column};
  item.isSkipped = m_block.isSkipped;
  if (m_depth > 0 && (words.has(2) || words.has(30))) {
    // A program that is called must not end all programs.
    return fail(FaultCode::UnsupportedGCode, words.has(2) ? "M2" : "M30", item.place);
  }
  // M92: from a datum that the machine's builder has set. Its zero of the tool axis is the top.
  const bool isTop = words.axes[thirdAxis()] && *words.axes[thirdAxis()] == 0.0 &&
                     !words.isIncrement[thirdAxis()] && !words.axes[firstAxis()] &&
                     !words.axes[secondAxis()];
  if (words.has(92) && !isTop) {
    return fail(FaultCode::UnsupportedGCode, "M92", item.place);
  }
  item.moves = words.moves();
  m_hasMoved = m_hasMoved || item.moves;
  item.isInMachine = words.isInMachine();
  if (words.feed && words.feed->kind != FeedKind::Rapid) {
    m_feed = *words.feed;
  }
  // FMAX holds for its block alone.
  item.feed = words.feed && words.feed->kind == FeedKind::Rapid ? *words.feed : m_feed;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    item.given[axis] = words.axes[axis].has_value();
  }
  if (Expected<void> done = turnRotary(words, item); !done) {
    return fail(done.error());
  }
  if (Expected<void> done = compensate(words, item); !done) {
    return fail(done.error());
  }
  const bool hasNormal = words.normal[0] || words.normal[1] || words.normal[2];
  if (hasNormal && (m_tool.radiusDelta != 0.0 || m_tool.lengthDelta != 0.0)) {
    return fail(FaultCode::UnsupportedGCode, "DR", item.place);
  }
  if (words.tool[0] || words.tool[1] || words.tool[2]) {
    const base::Vec3 direction = m_coordinates.frame.turned(
        {words.tool[0].value_or(0.0), words.tool[1].value_or(0.0), words.tool[2].value_or(0.0)});
    item.tokens.push_back(named("A3", direction.x));
    item.tokens.push_back(named("B3", direction.y));
    item.tokens.push_back(named("C3", direction.z));
  }
  if (words.spindlePerMin) {  // as some post-processors write it; a TNC has it in TOOL CALL
    m_spindlePerMin = *words.spindlePerMin;
    item.tokens.push_back(word('S', m_spindlePerMin));
  }
  addFunctions(words, item);
  if (Expected<void> done = goInMachine(words, item); !done) {
    return fail(done.error());
  }
  return item;
}

Expected<Control::Item> Control::itemTo(const MotionWords& words) {
  const Expected<base::Vec3> target = targetOf(words);
  Expected<Item> item = target ? itemOf(words) : fail(target.error());
  if (item) {
    if (Expected<void> done = setTarget(*item, *target, words); !done) {
      return fail(done.error());
    }
  }
  return item;
}

Expected<void> Control::turnRotary(const MotionWords& words, Item& item) {
  for (std::size_t axis = kFirstRotary; axis < kProgrammedAxisCount; ++axis) {
    if (!words.axes[axis]) {
      continue;
    }
    if (words.isIncrement[axis] && std::isnan(m_rotary[axis])) {
      return fail(FaultCode::RelativeFromUnknownPosition, std::string(1, kProgrammedAxes[axis]),
                  item.place);
    }
    const double value = *words.axes[axis] + (words.isIncrement[axis] ? m_rotary[axis] : 0.0);
    item.rotary[axis] = value;
    m_rotary[axis] = item.isInMachine ? std::nan("") : value;
  }
  return {};
}

/// R0, RL and RR.
Expected<void> Control::compensate(const MotionWords& words, Item& item) {
  if (!words.compensation) {
    return {};
  }
  const Expected<bool> mirrors = mirrorsPlane(firstAxis());
  if (!mirrors) {
    return fail(mirrors.error());
  }
  m_compensation = *words.compensation;
  const int side = *mirrors ? -m_compensation : m_compensation;
  Token token = word('G', side == 0 ? 40.0 : side > 0 ? 41.0 : 42.0);
  token.column = words.compensationColumn;
  token.text = m_compensation == 0 ? "R0" : m_compensation > 0 ? "RL" : "RR";
  item.tokens.push_back(token);
  if (side != 0 && m_tool.radiusDelta != 0.0) {
    item.tokens.push_back(named("OFFN", m_tool.radiusDelta));  // the tool is so much larger
  }
  return {};
}

/// M91 and M92: afterwards only the control knows where the axes stand in the workpiece.
Expected<void> Control::goInMachine(const MotionWords& words, Item& item) {
  if (!item.isInMachine || !item.moves) {
    return {};
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!words.axes[axis]) {
      continue;
    }
    if (words.isIncrement[axis]) {
      return fail(FaultCode::UnknownWord, std::string("I") + base::kAxisNames[axis], item.place);
    }
    item.target.set(axis, *words.axes[axis]);
    m_at.set(axis, std::nan(""));
  }
  m_direction.reset();
  return {};
}

/// The way there, in workpiece coordinates.
Expected<void> Control::setTarget(Item& item, base::Vec3 programmed, const MotionWords& words) {
  const base::Vec3 from = m_at;
  const base::Vec3 target = m_coordinates.frame.toWorkpiece(programmed);
  if (!m_coordinates.frame.isAligned()) {
    // Axes that are turned move together.
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (axis != thirdAxis() && (item.given[firstAxis()] || item.given[secondAxis()])) {
        item.given[axis] = true;
        if (std::isnan(target[axis])) {
          return fail(FaultCode::RelativeFromUnknownPosition,
                      std::string(1, base::kAxisNames[axis]), item.place);
        }
      }
    }
  }
  item.start = from;
  item.target = target;
  item.plane = firstAxis();
  m_at = target;
  const bool isFlat = item.given[firstAxis()] || item.given[secondAxis()];
  m_direction.reset();
  if (isKnown(flat(from)) && isKnown(flat(target)) && isFlat) {
    item.element = Element::line(flat(from), flat(target));
    m_direction = item.element->endDirection();
  }
  m_wasRapid = words.feed && words.feed->kind == FeedKind::Rapid;
  return {};
}

/// Makes an arc of the way. @param centre  programmed @param plane  its first axis
Expected<void> Control::setArc(Item& item, Flat centre, bool clockwise, std::size_t plane) {
  const Expected<bool> mirrors = mirrorsPlane(plane);
  if (!mirrors) {
    return fail(mirrors.error());
  }
  const bool isAcross = plane != firstAxis();
  const Flat start = flatIn(plane, item.start);
  const Flat end = flatIn(plane, item.target);
  if (!isKnown(start) || !isKnown(end)) {
    return fail(FaultCode::ArcFromUnknownPosition, std::string(1, base::kAxisNames[plane]),
                item.place);
  }
  if (item.feed.kind == FeedKind::Rapid) {
    return fail(FaultCode::UnsupportedGCode, "FMAX", item.place);  // an arc in rapid
  }
  if (isAcross && m_compensation != 0) {
    return fail(FaultCode::UnsupportedGCode, m_compensation > 0 ? "RL" : "RR", item.place);
  }
  base::Vec3 place;
  place.set(plane, centre.x);
  place.set((plane + 1) % base::kAxisCount, centre.y);
  item.plane = plane;
  item.element = Element{start, end, true, clockwise != *mirrors,
                         flatIn(plane, m_coordinates.frame.toWorkpiece(place))};
  m_direction = isAcross ? std::nullopt : item.element->endDirection();
  return {};
}

// --- what else the block says -------------------------------------------------------------------

void Control::addFunctions(const MotionWords& words, Item& item) {
  constexpr int kCallsAlways = 89;
  constexpr int kCalls = 99;
  constexpr int kPerRevolution = 136;
  constexpr int kPerMinute = 137;
  for (const MFunction& function : words.functions) {
    if (function.number == kPerRevolution || function.number == kPerMinute) {
      // The number of F means something else from here on.
      const bool isOn = function.number == kPerRevolution;
      if (isOn != m_perRevolution) {
        m_perRevolution = isOn;
        m_feed = {};
        if (words.feed && words.feed->kind != FeedKind::Rapid) {
          m_feed = {isOn ? FeedKind::PerRevolution : FeedKind::PerMinute, words.feed->value};
          item.feed = m_feed;
        } else if (item.feed.kind != FeedKind::Rapid) {
          item.feed = {};
        }
      }
      continue;
    }
    if (function.number == kCallsAlways || function.number == kCalls) {
      continue;
    }
    Token token = word('M', function.number);
    token.column = function.column;
    item.tokens.push_back(token);
  }
}

Expected<void> Control::moveOn(const MotionWords& words, Item item) {
  const bool says = item.moves || !item.tokens.empty();
  if (says) {
    push(std::move(item));
  }
  return afterMotion(words);
}

/// M140 MB50 F750: along the tool axis by a distance, rapid without a feed (chapter "Miscellaneous
/// functions", M140).
Expected<void> Control::retract(const MotionWords& words) {
  const Place place{m_block.place.line, m_block.place.file, words.column};
  const double from = programmed()[thirdAxis()];
  if (std::isnan(from)) {
    return fail(FaultCode::RelativeFromUnknownPosition,
                std::string(1, base::kAxisNames[thirdAxis()]), place);
  }
  base::Vec3 above = programmed();
  above.set(thirdAxis(), from + *words.retractBy);
  return step(above, words.retractFeed.value_or(Feed{FeedKind::Rapid, 0.0}));
}

Expected<void> Control::afterMotion(const MotionWords& words) {
  constexpr int kRetract = 140;
  if (words.retractBy) {
    if (Expected<void> done = retract(words); !done) {
      return done;
    }
  }
  // X, Y and Z mean something else from here on.
  constexpr int kTipOn = 128;
  constexpr int kTipOff = 129;
  m_tipIsOn = m_tipIsOn || words.has(kTipOn);
  if (m_tipIsOn && (words.has(kTipOn) || words.has(kTipOff))) {
    m_tipIsOn = !words.has(kTipOff);
    forgetPosition();
  }
  if (words.has(kRetract)) {
    m_at.set(thirdAxis(), std::nan(""));
    m_direction.reset();
  }
  // M99 calls the cycle once and ends M89 (chapter "Cycles", "Calling a cycle").
  constexpr int kCallsAlways = 89;
  constexpr int kCalls = 99;
  const bool calls = words.has(kCalls);
  if (words.has(kCallsAlways)) {
    m_cycles.callsAlways = true;
  }
  const bool callsNow =
      calls || (m_cycles.callsAlways && (words.moves() || words.has(kCallsAlways)));
  m_cycles.callsAlways = m_cycles.callsAlways && !calls;
  return callsNow ? callCycle(0.0) : Expected<void>();
}

}  // namespace rivulet::nc::heidenhain
