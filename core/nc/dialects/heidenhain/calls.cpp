// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls of fixed cycles: CYCL CALL, CYCL CALL POS, M99, M89, and the patterns that call them. TNC
// 640 User's Manual Cycle Programming, chapters "Working with fixed cycles" and "Pattern
// Definitions".

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "nc/dialects/heidenhain/control.h"

namespace rivulet::nc::heidenhain {

namespace {

/// What starts the machine comes before a cycle, what stops it afterwards.
bool startsMachine(int function) {
  static constexpr std::array kStarts{3, 4, 7, 8, 13, 14};
  return std::find(kStarts.begin(), kStarts.end(), function) != kStarts.end();
}

}  // namespace

CycleSituation Control::situation() const {
  constexpr double kInch = 25.4;
  return {.parameters = m_parameters,
          .at = programmed(),
          .toolAxis = m_tool.axis,
          .spindlePerMin = m_spindlePerMin,
          .millimetre = m_isInch ? 1.0 / kInch : 1.0,
          .setUp = {},
          .surface = {},
          .secondSetUp = {}};
}

/// PATTERN DEF POS1 (X+10 Y+5 Z+0) ROW1 (X+25 Y+33 D+8 NUM5 ROT+0 Z+0) ...
Expected<void> Control::pattern(Scanner& in) {
  if (!in.takeWord("DEF")) {
    return in.fault<void>(FaultCode::UnknownWord, "PATTERN");
  }
  m_cycles.pattern.clear();
  while (!in.isAtEnd()) {
    const std::string kind = in.takeName();
    (void)in.takeInteger();
    if (!in.take('(')) {
      return in.fault<void>(FaultCode::BracketNotClosed);
    }
    if (Expected<void> done = patternPart(in, kind); !done) {
      m_cycles.pattern.clear();
      return done;
    }
  }
  return {};
}

Expected<void> Control::patternPart(Scanner& in, const std::string& kind) {
  std::map<std::string, double, std::less<>> words;
  while (!in.take(')')) {
    const std::string name = in.takeName();
    if (name.empty() || name.front() == 'I' || !in.isAtValue()) {
      return in.fault<void>(FaultCode::UnsupportedGCode, "PATTERN DEF " + in.nextText());
    }
    const Expected<double> value = in.value();
    if (!value) {
      return fail(value.error());
    }
    words[name] = *value;
  }
  std::optional<std::string> missing;
  const auto take = [&words, &missing](const char* name) {
    const auto found = words.find(name);
    if (found == words.end()) {
      missing = missing.value_or(name);
      return 0.0;
    }
    const double value = found->second;
    words.erase(found);
    return value;
  };
  static constexpr std::string_view kAxes = "XYZ";
  const auto nameOf = [](std::size_t axis) { return std::string(1, kAxes[axis]); };
  const Flat first{take(nameOf(firstAxis()).c_str()), take(nameOf(secondAxis()).c_str())};
  const double surface = take(nameOf(thirdAxis()).c_str());
  double count = 1.0;
  Flat centre = first;
  Flat arm;
  Flat step;
  double turn = 0.0;
  if (kind == "ROW") {
    const double spacing = take("D");
    count = take("NUM");
    step = turned({spacing, 0.0}, take("ROT"));
  } else if (kind == "CIRC" || kind == "PITCHCIRC") {
    const double radius = take("D") / 2.0;
    arm = turned({radius, 0.0}, take("START"));
    turn = kind == "CIRC" ? 0.0 : take("STEP");
    count = take("NUM");
    turn = kind == "CIRC" && count > 0.0 ? 360.0 / count : turn;
  } else if (kind != "POS") {
    // In which order PAT and FRAME are machined is not known here.
    return in.fault<void>(FaultCode::UnsupportedGCode, "PATTERN DEF " + kind);
  }
  constexpr double kPointsMax = 99999.0;
  if (missing || !words.empty() || !(count >= 1.0 && count <= kPointsMax)) {
    return in.fault<void>(FaultCode::UnsupportedGCode,
                          "PATTERN DEF " + (missing         ? *missing
                                            : words.empty() ? std::string("NUM")
                                                            : words.begin()->first));
  }
  for (int i = 0; i < static_cast<int>(count); ++i) {
    m_cycles.pattern.push_back(
        {centre + turned(arm, turn * i) + static_cast<double>(i) * step, surface});
  }
  return {};
}

/// Between the points the tool is at the height of the call or at the second set-up clearance,
/// whichever is higher.
Expected<void> Control::callPattern(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (words->moves() || m_cycles.pattern.empty()) {
    return in.fault<void>(FaultCode::CycleNotRun, "CYCL CALL PAT");
  }
  MotionWords after;
  after.column = words->column;
  for (const MFunction& function : std::exchange(words->functions, {})) {
    (startsMachine(function.number) ? words->functions : after.functions).push_back(function);
  }
  Expected<Item> item = itemOf(*words);
  if (!item) {
    return fail(item.error());
  }
  const Feed feed = item->feed;
  if (!item->tokens.empty()) {
    push(std::move(*item));
  }
  const double start = programmed()[thirdAxis()];
  const Expected<double> surface = m_parameters.number("Q203");
  const Expected<double> second = m_parameters.number("Q204");
  if (!surface || !second || std::isnan(start)) {
    return in.fault<void>(FaultCode::RelativeFromUnknownPosition,
                          std::string(1, base::kAxisNames[thirdAxis()]));
  }
  for (const PatternPoint& point : m_cycles.pattern) {
    base::Vec3 place = programmed();
    place.set(thirdAxis(), std::max(start, *surface + point.surface + *second));
    if (Expected<void> done = step(place, {FeedKind::Rapid, 0.0}); !done) {
      return done;
    }
    place.set(firstAxis(), point.place.x);
    place.set(secondAxis(), point.place.y);
    if (Expected<void> done = step(place, feed); !done) {
      return done;
    }
    if (Expected<void> done = callCycle(point.surface); !done) {
      return done;
    }
  }
  Expected<Item> last = itemOf(after);
  if (last && !last->tokens.empty()) {
    push(std::move(*last));
  }
  return {};
}

/// CYCL CALL, with M functions; CYCL CALL POS with a place.
Expected<void> Control::cycleCall(Scanner& in) {
  const bool toPlace = in.takeWord("POS");
  if (!toPlace && in.takeWord("PAT")) {
    return callPattern(in);
  }
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  if (Expected<void> done = refuseUnused(*words, ""); !done) {
    return done;
  }
  if (!toPlace && words->moves()) {
    return in.fault<void>(FaultCode::UnknownWord, "CYCL CALL");
  }
  MotionWords before = *words;
  MotionWords after;
  after.column = words->column;
  before.functions.clear();
  constexpr int kCallsAlways = 89;
  constexpr int kCalls = 99;
  for (const MFunction& function : words->functions) {
    if (function.number == kCalls || function.number == kCallsAlways) {
      m_cycles.callsAlways = function.number == kCallsAlways;
      continue;
    }
    (startsMachine(function.number) ? before : after).functions.push_back(function);
  }
  double surfaceShift = 0.0;
  if (toPlace) {
    // The third coordinate shifts the surface; the tool goes there in the plane, from above.
    surfaceShift = before.axes[thirdAxis()].value_or(0.0);
    const double surface = m_parameters.number("Q203").value_or(std::nan("")) + surfaceShift;
    const bool isAbove = programmed()[thirdAxis()] > surface;
    if (!before.axes[firstAxis()] || !before.axes[secondAxis()] || !before.axes[thirdAxis()] ||
        before.isIncrement[thirdAxis()] || !isAbove) {
      return in.fault<void>(FaultCode::RelativeFromUnknownPosition,
                            std::string(1, base::kAxisNames[thirdAxis()]));
    }
    before.axes[thirdAxis()].reset();
  }
  Expected<Item> item = itemOf(before);
  if (!item) {
    return fail(item.error());
  }
  if (before.moves()) {
    const Expected<base::Vec3> target = targetOf(before);
    if (!target) {
      return fail(target.error());
    }
    if (Expected<void> done = setTarget(*item, *target, before); !done) {
      return done;
    }
  }
  if (item->moves || !item->tokens.empty()) {
    push(std::move(*item));
  }
  if (Expected<void> done = callCycle(surfaceShift); !done) {
    return done;
  }
  Expected<Item> last = itemOf(after);
  if (last && !last->tokens.empty()) {
    push(std::move(*last));
  }
  return {};
}

Expected<void> Control::callCycle(double surfaceShift) {
  CycleSituation where = situation();
  where.surfaceShift = surfaceShift;
  return runCycle(where);
}

Expected<void> Control::step(base::Vec3 programmed, Feed feed) {
  Item item;
  item.place = m_block.place;
  item.isSkipped = m_block.isSkipped;
  item.moves = true;
  item.isMade = true;
  item.feed = feed;
  const base::Vec3 from = m_at;
  MotionWords words;
  words.column = m_block.place.column;
  words.feed = feed;
  // Axes that stay are not named.
  constexpr double kSame = 1e-9;
  const base::Vec3 target = m_coordinates.frame.toWorkpiece(programmed);
  bool moves = false;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    item.given[axis] = !std::isnan(target[axis]) && !(std::abs(target[axis] - from[axis]) < kSame);
    moves = moves || item.given[axis];
  }
  if (!moves) {
    return {};
  }
  if (Expected<void> done = setTarget(item, programmed, words); !done) {
    return done;
  }
  push(std::move(item));
  return {};
}

Expected<void> Control::runCycle(const CycleSituation& situation) {
  if (m_compensation != 0) {
    return fail(FaultCode::UnsupportedGCode, "CYCL CALL", m_block.place);  // the cycles need R0
  }
  const Expected<std::vector<CycleStep>> steps = stepsOf(m_cycles.defined, situation);
  if (!steps) {
    Fault fault = steps.error();
    fault.place = m_block.place;
    return fail(std::move(fault));
  }
  for (const CycleStep& each : *steps) {
    switch (each.kind) {
      case CycleStep::Kind::Rapid:
      case CycleStep::Kind::Feed: {
        const bool isRapid = each.kind == CycleStep::Kind::Rapid;
        const Expected<void> done = step(
            each.to, isRapid ? Feed{FeedKind::Rapid, 0.0} : Feed{FeedKind::PerMinute, each.feed});
        if (!done) {
          return done;
        }
        break;
      }
      case CycleStep::Kind::Dwell:
        tell({word('G', 4.0), word('F', each.seconds)});
        break;
      case CycleStep::Kind::Function:
        if (each.spindlePerMin > 0.0) {
          m_spindlePerMin = each.spindlePerMin;
          tell({word('S', each.spindlePerMin), word('M', each.function)});
        } else {
          tell({word('M', each.function)});
        }
        break;
      case CycleStep::Kind::Tap:
        tap(each);
        break;
      case CycleStep::Kind::Bore:
        bore(each);
        break;
    }
  }
  m_direction.reset();
  return {};
}

/// The spindle and the axis move together: the control's own tapping, from where the tool stands
/// and back there.
void Control::tap(const CycleStep& tapping) {
  flush();
  constexpr double kLeftHanded = 74.0;
  constexpr double kRightHanded = 84.0;
  const std::size_t axis = thirdAxis();
  const double depth = m_coordinates.frame.toWorkpiece(tapping.to)[axis] + m_tool.lengthDelta;
  const double start = m_at[axis] + m_tool.lengthDelta;
  const double feed =
      tapping.feed * (m_isInch && m_cycles.defined.number != 207 &&
                              m_cycles.defined.number != 209 && m_cycles.defined.number != 17
                          ? 0.1
                          : 1.0);
  std::vector<Token> tokens{word('G', 99.0),
                            word('G', tapping.isLeftHanded ? kLeftHanded : kRightHanded),
                            word(base::kAxisNames[axis], depth), word('R', start), word('F', feed)};
  if (tapping.seconds > 0.0) {
    tokens.push_back(word('P', tapping.seconds));
  }
  if (tapping.stroke > 0.0) {
    tokens.push_back(word('Q', tapping.stroke));
    tokens.push_back(named("VRT", tapping.back));
  }
  tellHole(std::move(tokens));
}

/// The control's own boring: the spindle is stopped at an angle at the bottom.
void Control::bore(const CycleStep& boring) {
  flush();
  constexpr double kFineBoring = 76.0;
  const std::size_t axis = thirdAxis();
  const base::Vec3 aside = m_coordinates.frame.turned(boring.aside);
  const double unit = m_isInch ? 0.1 : 1.0;  // see `write`
  std::vector<Token> tokens{
      word('G', 99.0),
      word('G', kFineBoring),
      word(base::kAxisNames[axis],
           m_coordinates.frame.toWorkpiece(boring.to)[axis] + m_tool.lengthDelta),
      word('R', m_at[axis] + m_tool.lengthDelta),
      word('F', boring.feed * unit),
      named("RPA", aside[firstAxis()]),
      named("RPO", aside[secondAxis()]),
      named("POSS", boring.degrees),
      named("RFF", boring.backFeed * unit)};
  if (boring.seconds > 0.0) {
    tokens.push_back(word('P', boring.seconds));
  }
  tellHole(std::move(tokens));
}

void Control::tellHole(std::vector<Token> tokens) {
  if (m_told.kind == FeedKind::PerRevolution) {
    tokens.push_back(word('G', 94.0));
  }
  m_told = {};
  tell(std::move(tokens));
  tell({word('G', 80.0)});
}

Expected<void> Control::runPattern(int number) {
  if (m_cycles.defined.number == 0) {
    return fail(FaultCode::CycleNotRun, fmt::format("CYCL DEF {}", number), m_block.place);
  }
  CycleSituation where = situation();
  const Expected<Pattern> pattern = patternOf(number, where);
  if (!pattern) {
    Fault fault = pattern.error();
    fault.place = m_block.place;
    return fail(std::move(fault));
  }
  const Feed rapid{FeedKind::Rapid, 0.0};
  const double clearance = pattern->surface + pattern->setUp;
  const double above = pattern->surface + std::max(pattern->secondSetUp, pattern->setUp);
  for (std::size_t i = 0; i < pattern->points.size(); ++i) {
    base::Vec3 point = pattern->points[i];
    const bool isFirst = i == 0;
    const bool isLast = i + 1 == pattern->points.size();
    const double between = isFirst || pattern->risesBetween ? above : clearance;
    base::Vec3 risen = programmed();
    risen.set(thirdAxis(), between);
    if (Expected<void> done = step(risen, rapid); !done) {
      return done;
    }
    point.set(thirdAxis(), between);
    if (Expected<void> done = step(point, rapid); !done) {
      return done;
    }
    where.at = programmed();
    where.setUp = pattern->setUp;
    where.surface = pattern->surface;
    // Between the points the tool stays at the set-up clearance.
    where.secondSetUp = pattern->risesBetween || isLast ? pattern->secondSetUp : pattern->setUp;
    if (Expected<void> done = runCycle(where); !done) {
      return done;
    }
  }
  return {};
}

}  // namespace rivulet::nc::heidenhain
