// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nc/dialects/heidenhain/contour.h"
#include "nc/dialects/heidenhain/cycle_values.h"
#include "nc/dialects/heidenhain/milling_cycles.h"

namespace rivulet::nc::heidenhain {

namespace {

using base::Vec3;

constexpr int kStrokesMax = 10000;

/// 200 DRILLING, and 240 CENTERING without pecks.
Steps drill(Values& values) {
  Drilling hole(values);
  const double feed = values.q(206);
  const double peck = values.q(202);
  const double dwellAbove = values.q(210, 0.0);
  const double dwellBelow = values.q(211, 0.0);
  checkFeed(values, 206, feed);
  if (!(peck > 0.0) || hole.whole() / peck > kStrokesMax) {
    values.outOfRange(202);
  }
  if (values.q(395, 0.0) != 0.0) {
    values.outOfRange(395);  // the depth of the shoulder needs the angle of the tip
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  hole.rapid(hole.clearance());
  for (double depth = 0.0; depth < hole.whole();) {
    if (depth > 0.0) {
      hole.rapid(hole.clearance());
      hole.dwell(dwellAbove);
      hole.rapid(hole.below(depth) + hole.setUp());
    }
    depth = depth + peck < hole.whole() - kCycleRounding ? depth + peck : hole.whole();
    hole.feed(hole.below(depth), feed);
  }
  hole.dwell(dwellBelow);
  hole.rapid(hole.clearance());
  hole.leave();
  return hole.take();
}

/// 240 CENTERING, with the depth.
Steps centre(Values& values) {
  Drilling hole(values);
  const double feed = values.q(206);
  const double dwell = values.q(211);
  checkFeed(values, 206, feed);
  if (values.q(343) != 0.0) {
    values.outOfRange(343);  // a diameter needs the angle of the tip
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  hole.rapid(hole.clearance());
  hole.feed(hole.below(hole.whole()), feed);
  hole.dwell(dwell);
  hole.rapid(hole.clearance());
  hole.leave();
  return hole.take();
}

/// 201 REAMING.
Steps ream(Values& values) {
  Drilling hole(values);
  const double feed = values.q(206);
  const double dwell = values.q(211);
  const double back = feedOr(values.q(208), feed);
  checkFeed(values, 206, feed);
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  hole.rapid(hole.clearance());
  hole.feed(hole.below(hole.whole()), feed);
  hole.dwell(dwell);
  hole.feed(hole.clearance(), back);
  hole.leave();
  return hole.take();
}

/// The next infeed of 203 and 205: smaller by Q212 each time, but not below Q205.
double nextPeck(double peck, double decrement, double smallest) {
  return std::max(peck - decrement, std::min(smallest, peck));
}

/// 203 UNIVERSAL DRILLING.
Steps drillUniversally(Values& values) {
  Drilling hole(values);
  const double feed = values.q(206);
  double peck = values.q(202);
  const double dwellAbove = values.q(210, 0.0);
  const double decrement = values.q(212);
  const double breaks = values.q(213);
  const double smallest = values.q(205);
  const double dwellBelow = values.q(211);
  const double back = feedOr(values.q(208), feed);
  const double breakBy = values.q(256, 0.0);
  checkFeed(values, 206, feed);
  if (!(peck > 0.0) || hole.whole() / peck > kStrokesMax) {
    values.outOfRange(202);
  }
  if (decrement < 0.0 || (decrement > 0.0 && !(smallest > 0.0))) {
    values.outOfRange(212);
  }
  if (breaks > 0.0 && !(breakBy > 0.0)) {
    values.outOfRange(256);
  }
  if (values.q(395, 0.0) != 0.0) {
    values.outOfRange(395);
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  hole.rapid(hole.clearance());
  double depth = 0.0;
  for (int strokes = 0, broken = 0; depth < hole.whole() && strokes < kStrokesMax; ++strokes) {
    if (depth > 0.0) {
      if (broken < breaks) {
        ++broken;
        hole.feed(hole.below(depth - breakBy), back);
      } else {
        broken = 0;
        hole.feed(hole.clearance(), back);
        hole.dwell(dwellAbove);
        hole.rapid(hole.below(depth) + hole.setUp());
      }
      peck = nextPeck(peck, decrement, smallest);
    }
    depth = depth + peck < hole.whole() - kCycleRounding ? depth + peck : hole.whole();
    hole.feed(hole.below(depth), feed);
  }
  hole.dwell(dwellBelow);
  hole.feed(hole.clearance(), back);
  hole.leave();
  return hole.take();
}

/// 205 UNIVERSAL PECKING.
Steps peckUniversally(Values& values) {
  Drilling hole(values);
  const double feed = values.q(206);
  double peck = values.q(202);
  const double decrement = values.q(212);
  const double smallest = values.q(205);
  const double stopAbove = values.q(258);
  const double stopBelow = values.q(259);
  const double breakAfter = values.q(257);
  const double breakBy = values.q(256);
  const double dwellBelow = values.q(211);
  const double start = values.q(379, 0.0);
  const double startFeed = values.q(253, 0.0);
  checkFeed(values, 206, feed);
  if (!(peck > 0.0) || hole.whole() / peck > kStrokesMax) {
    values.outOfRange(202);
  }
  if (decrement < 0.0 || (decrement > 0.0 && !(smallest > 0.0))) {
    values.outOfRange(212);
  }
  if (breakAfter < 0.0 ||
      (breakAfter > 0.0 && (!(breakBy > 0.0) || hole.whole() / breakAfter > kStrokesMax))) {
    values.outOfRange(257);
  }
  // How far the stop lies above the last depth changes from the first to the last peck; a start
  // below the surface counts the pecks from there: what these do together is not described.
  if (stopAbove != stopBelow) {
    values.outOfRange(259);
  }
  if (start != 0.0) {
    values.outOfRange(379);
  }
  if (values.q(395, 0.0) != 0.0) {
    values.outOfRange(395);
  }
  if (values.q(208, kFeedMax) < kFeedMax && values.q(208) != 0.0) {
    values.outOfRange(208);  // a retraction feed that older controls do not have
  }
  (void)startFeed;
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  hole.rapid(hole.clearance());
  double depth = 0.0;
  for (int strokes = 0; depth < hole.whole() && strokes < kStrokesMax; ++strokes) {
    if (depth > 0.0) {
      hole.rapid(hole.clearance());
      hole.rapid(hole.below(depth) + stopAbove);
      peck = nextPeck(peck, decrement, smallest);
    }
    const double to = depth + peck < hole.whole() - kCycleRounding ? depth + peck : hole.whole();
    while (breakAfter > 0.0 && depth + breakAfter < to - kCycleRounding) {
      depth += breakAfter;
      hole.feed(hole.below(depth), feed);
      hole.rapid(hole.below(depth - breakBy));
    }
    depth = to;
    hole.feed(hole.below(depth), feed);
  }
  hole.dwell(dwellBelow);
  hole.rapid(hole.clearance());
  hole.leave();
  return hole.take();
}

void checkSpindle(Values& values) {
  if (!(values.situation().spindlePerMin > 0.0)) {
    values.note({FaultCode::ValueMissing, "S", {}});
  }
}

/// 206 TAPPING with a floating tap holder, and 207 RIGID TAPPING.
Steps tap(Values& values, bool isRigid) {
  Drilling hole(values);
  const double spindle = values.situation().spindlePerMin;
  const double pitch = isRigid ? values.q(239) : 0.0;
  const double feed = isRigid ? std::abs(pitch) * spindle : values.q(206);
  const double dwell = isRigid ? 0.0 : values.q(211);
  checkSpindle(values);
  checkFeed(values, isRigid ? 239 : 206, feed);
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  hole.rapid(hole.clearance());
  hole.add({.kind = CycleStep::Kind::Tap,
            .to = hole.at(hole.below(hole.whole())),
            .feed = feed,
            .seconds = dwell,
            .isLeftHanded = pitch < 0.0});
  hole.leave();
  return hole.take();
}

/// 202 BORING: the spindle stops at an angle, and the edge leaves the wall by 0.2 mm (chapter
/// "Drilling").
Steps bore(Values& values) {
  constexpr double kAsideMm = 0.2;
  Drilling hole(values);
  const double feed = values.q(206);
  const double dwell = values.q(211);
  const double back = feedOr(values.q(208), feed);
  const double direction = values.q(214);
  const double angle = values.q(336, 0.0);
  checkFeed(values, 206, feed);
  checkSpindle(values);
  if (direction < 0.0 || direction > 4.0 || direction != std::floor(direction)) {
    values.outOfRange(214);
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  // 1 and 3: against and along the first axis; 2 and 4 the second.
  Vec3 aside;
  const double way = direction >= 3.0 ? 1.0 : -1.0;
  const std::size_t first = (values.situation().toolAxis + 1) % base::kAxisCount;
  const bool isSecond = direction == 2.0 || direction == 4.0;
  if (direction > 0.0) {
    aside.set(isSecond ? (first + 1) % base::kAxisCount : first,
              way * kAsideMm * values.situation().millimetre);
  }
  hole.rapid(hole.clearance());
  hole.add({.kind = CycleStep::Kind::Bore,
            .to = hole.at(hole.below(hole.whole())),
            .feed = feed,
            .seconds = dwell,
            .aside = aside,
            .degrees = angle,
            .backFeed = back >= kFeedMax ? 0.0 : back});
  hole.leave();
  return hole.take();
}

/// 209 TAPPING WITH CHIP BREAKING, with a rigid chuck.
Steps tapInStrokes(Values& values) {
  Drilling hole(values);
  const double spindle = values.situation().spindlePerMin;
  const double pitch = values.q(239);
  const double stroke = values.q(257);
  const double back = values.q(256);
  checkSpindle(values);
  checkFeed(values, 239, std::abs(pitch) * spindle);
  if (stroke < 0.0) {
    values.outOfRange(257);
  }
  if (back < 0.0) {
    values.outOfRange(256);
  }
  if (values.q(403, 1.0) != 1.0) {
    values.outOfRange(403);  // faster out of the hole
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  hole.rapid(hole.clearance());
  hole.add({.kind = CycleStep::Kind::Tap,
            .to = hole.at(hole.below(hole.whole())),
            .feed = std::abs(pitch) * spindle,
            .isLeftHanded = pitch < 0.0,
            .stroke = stroke,
            .back = back * std::abs(pitch)});
  hole.leave();
  return hole.take();
}

/// 241 SINGLE-LIP D.H.D.: slowly into the pilot hole, and out of the hole again.
Steps drillDeep(Values& values) {
  Drilling hole(values);
  const double feed = values.q(206);
  const double dwell = values.q(211);
  const double start = values.q(379);
  const double startFeed = values.q(253);
  const double back = values.q(208);
  const double slow = values.q(427);
  const double speed = values.q(428);
  const auto function = [&values](int number, double otherwise) {
    const double value = values.q(number, otherwise);
    if (value < 0.0 || value > 999.0 || value != std::floor(value)) {
      values.outOfRange(number);
      return 0;
    }
    return static_cast<int>(value);
  };
  const int turns = function(426, 3.0);
  const int coolant = function(429, 8.0);
  const int coolantOff = function(430, 9.0);
  checkFeed(values, 206, feed);
  checkFeed(values, 253, startFeed);
  if (turns < 3 || turns > 5) {
    values.outOfRange(426);
  }
  if (!(speed > 0.0) || slow < 0.0) {
    values.outOfRange(428);
  }
  if (start < 0.0 || start > hole.whole()) {
    values.outOfRange(379);
  }
  if (values.q(435, 0.0) != 0.0) {
    values.outOfRange(435);  // a dwell on the way
  }
  if (values.q(202, kFeedMax) < hole.whole()) {
    values.outOfRange(202);
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  const auto spindle = [&hole](int way, double perMin) {
    hole.add({.kind = CycleStep::Kind::Function, .function = way, .spindlePerMin = perMin});
  };
  hole.rapid(hole.clearance());
  spindle(turns, slow);
  if (start > 0.0) {
    hole.feed(hole.below(start) + hole.setUp(), startFeed);
  }
  spindle(3, speed);
  spindle(coolant, 0.0);
  hole.feed(hole.below(hole.whole()), feed);
  hole.dwell(dwell);
  spindle(coolantOff, 0.0);
  spindle(turns, slow);
  hole.feed(hole.clearance(), feedOr(back, feed));
  hole.leave();
  return hole.take();
}

/// 1 PECKING (iTNC 530 User's Manual Cycles, chapter "Drilling"): the feed begins again above the
/// last depth by 0.6 mm, in holes deeper than 30 mm by a 50th of the depth, at most 7 mm.
Steps peck(Values& values) {
  const OldHole hole(values, values.situation());
  const double infeed = std::abs(values.old(3));
  const double dwell = values.old(4);
  const double feed = values.old(5);
  const double whole = -hole.depth;
  if (!(infeed > 0.0) || whole / infeed > kStrokesMax) {
    values.refuse("PECKG");
  }
  if (!(feed > 0.0)) {
    values.refuse("F");
  }
  if (values.isFaulty() || whole == 0.0) {
    return {};
  }
  const double millimetre = values.situation().millimetre;
  const double stop =
      whole <= 30.0 * millimetre ? 0.6 * millimetre : std::min(whole / 50.0, 7.0 * millimetre);
  Steps steps;
  for (double depth = 0.0; depth < whole;) {
    if (depth > 0.0) {
      steps.push_back({.kind = CycleStep::Kind::Rapid, .to = hole.at(hole.start)});
      steps.push_back(
          {.kind = CycleStep::Kind::Rapid, .to = hole.at(hole.surface() - depth + stop)});
    }
    depth = depth + infeed < whole - kCycleRounding ? depth + infeed : whole;
    steps.push_back(
        {.kind = CycleStep::Kind::Feed, .to = hole.at(hole.surface() - depth), .feed = feed});
  }
  if (dwell > 0.0) {
    steps.push_back({.kind = CycleStep::Kind::Dwell, .seconds = dwell});
  }
  steps.push_back({.kind = CycleStep::Kind::Rapid, .to = hole.at(hole.start)});
  return steps;
}

/// 2 TAPPING and 17 RIGID TAPPING of old controls.
Steps tapOld(Values& values, bool isRigid) {
  const OldHole hole(values, values.situation());
  const double third = values.old(3);
  const double spindle = values.situation().spindlePerMin;
  const double feed = isRigid ? std::abs(third) * spindle : values.old(4);
  checkSpindle(values);
  if (!(feed > 0.0)) {
    values.refuse(isRigid ? "PITCH" : "F");
  }
  if (values.isFaulty() || hole.depth == 0.0) {
    return {};
  }
  CycleStep step{.kind = CycleStep::Kind::Tap,
                 .to = hole.at(hole.surface() + hole.depth),
                 .feed = feed,
                 .seconds = isRigid ? 0.0 : third,
                 .isLeftHanded = isRigid && third < 0.0};
  return {step};
}

struct Row {
  int number;
  Steps (*steps)(Values& values);
};
constexpr std::array kCycles{
    Row{1, peck},
    Row{2, [](Values& values) { return tapOld(values, false); }},
    Row{4, pocketOld},
    Row{5, circularPocketOld},
    Row{17, [](Values& values) { return tapOld(values, true); }},
    Row{200, drill},
    Row{201, ream},
    Row{202, bore},
    Row{203, drillUniversally},
    Row{205, peckUniversally},
    Row{206, [](Values& values) { return tap(values, false); }},
    Row{207, [](Values& values) { return tap(values, true); }},
    Row{208, boreByMilling},
    Row{209, tapInStrokes},
    Row{232, faceByMilling},
    Row{240, centre},
    Row{241, drillDeep},
    Row{251, rectangularPocket},
    Row{252, circularPocket},
    Row{253, slot},
    Row{254, circularSlot},
    Row{256, rectangularStud},
    Row{257, circularStud},
    Row{262, threadByMilling},
};

const Row* rowOf(int cycle) {
  const auto* const found = std::find_if(kCycles.begin(), kCycles.end(),
                                         [cycle](const Row& row) { return row.number == cycle; });
  return found == kCycles.end() ? nullptr : found;
}

Vec3 inPlane(const CycleSituation& situation, Flat point) {
  Vec3 place = situation.at;
  place.set((situation.toolAxis + 1) % base::kAxisCount, point.x);
  place.set((situation.toolAxis + 2) % base::kAxisCount, point.y);
  return place;
}

constexpr double kPointsMax = 99999.0;

/// 220 POLAR PATTERN: on a circle. If the angles span a full circle, the last point is not the
/// first one again.
std::vector<Vec3> circle(Values& values) {
  const Flat centre{values.q(216), values.q(217)};
  const double radius = values.q(244) / 2.0;
  const double from = values.q(245);
  const double to = values.q(246);
  const double step = values.q(247);
  const double count = values.q(241);
  if (!(count >= 1.0 && count <= kPointsMax)) {
    values.outOfRange(241);
    return {};
  }
  const bool isFull = std::abs(std::abs(to - from) - 360.0) < kCycleRounding;
  const double own = step != 0.0    ? step
                     : count == 1.0 ? 0.0
                                    : (to - from) / (isFull ? count : count - 1.0);
  std::vector<Vec3> points;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    points.push_back(inPlane(values.situation(), centre + turned({radius, 0.0}, from + own * i)));
  }
  return points;
}

/// 221 CARTESIAN PATTERN: line after line, every second one backwards.
std::vector<Vec3> grid(Values& values) {
  const Flat start{values.q(225), values.q(226)};
  const Flat spacing{values.q(237), values.q(238)};
  const double columns = values.q(242);
  const double rows = values.q(243);
  const double angle = values.q(224);
  if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= kPointsMax)) {
    values.outOfRange(242);
    return {};
  }
  std::vector<Vec3> points;
  for (int row = 0; row < static_cast<int>(rows); ++row) {
    for (int i = 0; i < static_cast<int>(columns); ++i) {
      const int column = row % 2 == 0 ? i : static_cast<int>(columns) - 1 - i;
      points.push_back(inPlane(values.situation(),
                               start + turned({column * spacing.x, row * spacing.y}, angle)));
    }
  }
  return points;
}

}  // namespace

bool isPattern(int cycle) {
  return cycle == 220 || cycle == 221;
}

bool isKnownCycle(int cycle) {
  return rowOf(cycle) != nullptr;
}

/// TNC 640, iTNC 530, User's Manual Cycle Programming: overviews of the cycles, and "Calling a
/// cycle".
bool waitsForCall(int cycle) {
  static constexpr std::array kRefusedAtCall{3,   6,   12,  15,  16,  18,  21,  22,  23,  24,
                                             25,  27,  28,  29,  39,  204, 210, 211, 212, 213,
                                             214, 215, 225, 230, 231, 233, 258, 263, 264, 265,
                                             267, 272, 273, 274, 275, 276, 277, 278};
  static constexpr std::array kData{14, 20, 270, 271};
  const auto isIn = [cycle](const auto& all) {
    return std::find(all.begin(), all.end(), cycle) != all.end();
  };
  return isKnownCycle(cycle) || isIn(kRefusedAtCall) || isIn(kData);
}

Expected<std::vector<CycleStep>> stepsOf(const CycleDefinition& cycle,
                                         const CycleSituation& situation) {
  const Row* const row = rowOf(cycle.number);
  if (row == nullptr) {
    return fail(FaultCode::CycleNotRun, cycle.number == 0
                                            ? std::string("CYCL CALL")
                                            : fmt::format("CYCL DEF {}", cycle.number));
  }
  Values values(cycle, situation);
  Steps steps = row->steps(values);
  if (values.fault()) {
    return fail(*values.fault());
  }
  return steps;
}

Expected<Pattern> patternOf(int cycle, const CycleSituation& situation) {
  const CycleDefinition own;
  Values values(own, situation);
  Pattern made;
  made.points = cycle == 220 ? circle(values) : grid(values);
  made.setUp = values.q(200);
  made.surface = values.q(203);
  made.secondSetUp = values.q(204);
  made.risesBetween = values.q(301) != 0.0;
  if (cycle == 220 && values.q(365, 0.0) != 0.0) {
    values.outOfRange(365);  // on an arc between the points
  }
  if (values.fault()) {
    return fail(*values.fault());
  }
  return made;
}

}  // namespace rivulet::nc::heidenhain
