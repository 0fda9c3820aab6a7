// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nc/dialects/heidenhain/contour.h"

namespace rivulet::nc::heidenhain {

namespace {

using base::Vec3;
using Steps = std::vector<CycleStep>;

constexpr int kStrokesMax = 10000;
constexpr double kRounding = 1e-9;

/// Reads parameters until one is missing.
class Values {
 public:
  Values(const CycleDefinition& cycle, const CycleSituation& situation)
      : m_cycle(cycle), m_situation(situation) {}

  double q(int number) {
    const Expected<double> value = m_situation.parameters.number(fmt::format("Q{}", number));
    if (!value) {
      note(value.error());
      return 0.0;
    }
    return *value;
  }
  /// A parameter that older controls do not have.
  double q(int number, double otherwise) {
    // Another cycle may have set it before.
    const std::string name = fmt::format("Q{}", number);
    const bool isSet =
        m_cycle.named.empty() ? m_situation.parameters.has(name) : m_cycle.named.contains(name);
    return isSet ? q(number) : otherwise;
  }
  /// Line `number` of an old cycle.
  double old(int number) {
    const auto found = m_cycle.values.find(number);
    if (found == m_cycle.values.end()) {
      note({FaultCode::ValueMissing, fmt::format("CYCL DEF {}.{}", m_cycle.number, number), {}});
      return 0.0;
    }
    return found->second;
  }
  void note(Fault fault) {
    if (!m_fault) {
      m_fault = std::move(fault);
    }
  }
  void outOfRange(int number) { note({FaultCode::OutOfDomain, fmt::format("Q{}", number), {}}); }
  [[nodiscard]] const std::optional<Fault>& fault() const { return m_fault; }
  [[nodiscard]] bool isFaulty() const { return m_fault.has_value(); }
  [[nodiscard]] const CycleSituation& situation() const { return m_situation; }

 private:
  const CycleDefinition& m_cycle;
  const CycleSituation& m_situation;
  std::optional<Fault> m_fault;
};

/// What the cycles from 200 on have in common: the planes and the moves between them.
class Drilling {
 public:
  explicit Drilling(Values& values) : m_values(values) {
    const CycleSituation& situation = values.situation();
    m_setUp = situation.setUp ? *situation.setUp : values.q(200);
    m_surface = (situation.surface ? *situation.surface : values.q(203)) + situation.surfaceShift;
    const double second = situation.secondSetUp ? *situation.secondSetUp : values.q(204);
    m_retract = m_surface + std::max(second, m_setUp);
    const double depth = values.q(201);
    // A positive depth: the manual leaves it to a machine parameter (displayDepthErr).
    if (depth > 0.0) {
      values.outOfRange(201);
    }
    if (m_setUp < 0.0) {
      values.outOfRange(200);
    }
    m_depth = -depth;
    m_place = situation.at;
  }

  [[nodiscard]] double whole() const { return m_depth; }
  [[nodiscard]] double clearance() const { return m_surface + m_setUp; }
  /// So far below the surface.
  [[nodiscard]] double below(double depth) const { return m_surface - depth; }
  [[nodiscard]] double setUp() const { return m_setUp; }

  void rapid(double height) { add({.kind = CycleStep::Kind::Rapid, .to = at(height)}); }
  void feed(double height, double feed) {
    if (feed >= kFeedMax) {
      rapid(height);
    } else {
      add({.kind = CycleStep::Kind::Feed, .to = at(height), .feed = feed});
    }
  }
  void dwell(double seconds) {
    if (seconds > 0.0) {
      add({.kind = CycleStep::Kind::Dwell, .seconds = seconds});
    }
  }
  void add(CycleStep step) { m_steps.push_back(step); }
  [[nodiscard]] Vec3 at(double height) const {
    Vec3 place = m_place;
    place.set(m_values.situation().toolAxis, height);
    return place;
  }
  /// To the second set-up clearance, if it is farther away than the first.
  void leave() {
    if (m_retract > clearance() + kRounding) {
      rapid(m_retract);
    }
  }
  [[nodiscard]] Steps take() { return std::move(m_steps); }

 private:
  Values& m_values;
  double m_setUp = 0.0;
  double m_surface = 0.0;
  double m_retract = 0.0;
  double m_depth = 0.0;
  Vec3 m_place;
  Steps m_steps;
};

/// A feed that the manual lets be 0: then another one counts.
double feedOr(double feed, double otherwise) {
  return feed == 0.0 ? otherwise : feed;
}

void checkFeed(Values& values, int number, double feed) {
  if (!(feed > 0.0)) {
    values.outOfRange(number);
  }
}

/// 200 DRILLING, and 240 CENTERING without pecks.
Steps drill(Values& values) {
  Drilling hole(values);
  const double feed = values.q(206);
  const double peck = values.q(202);
  const double dwellAbove = values.q(210);
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
    depth = depth + peck < hole.whole() - kRounding ? depth + peck : hole.whole();
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
  const double dwellAbove = values.q(210);
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
    depth = depth + peck < hole.whole() - kRounding ? depth + peck : hole.whole();
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
    const double to = depth + peck < hole.whole() - kRounding ? depth + peck : hole.whole();
    while (breakAfter > 0.0 && depth + breakAfter < to - kRounding) {
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

/// Old cycles begin and end where the tool stands, the set-up clearance above the surface.
struct OldHole {
  OldHole(Values& values, const CycleSituation& situation)
      : place(situation.at),
        axis(situation.toolAxis),
        start(situation.at[situation.toolAxis]),
        setUp(std::abs(values.old(1))),
        depth(values.old(2)) {
    if (std::isnan(start)) {
      values.note(
          {FaultCode::RelativeFromUnknownPosition, std::string(1, base::kAxisNames[axis]), {}});
    }
    if (depth > 0.0) {
      values.note({FaultCode::OutOfDomain, "DEPTH", {}});
    }
  }
  [[nodiscard]] Vec3 at(double height) const {
    Vec3 to = place;
    to.set(axis, height);
    return to;
  }
  [[nodiscard]] double surface() const { return start - setUp; }

  Vec3 place;
  std::size_t axis;
  double start;
  double setUp;
  double depth;
};

/// 1 PECKING (iTNC 530 User's Manual Cycles, chapter "Drilling"): the feed begins again above the
/// last depth by 0.6 mm, in holes deeper than 30 mm by a 50th of the depth, at most 7 mm.
Steps peck(Values& values) {
  const OldHole hole(values, values.situation());
  const double infeed = std::abs(values.old(3));
  const double dwell = values.old(4);
  const double feed = values.old(5);
  const double whole = -hole.depth;
  if (!(infeed > 0.0) || whole / infeed > kStrokesMax) {
    values.note({FaultCode::OutOfDomain, "PECKG", {}});
  }
  if (!(feed > 0.0)) {
    values.note({FaultCode::OutOfDomain, "F", {}});
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
    depth = depth + infeed < whole - kRounding ? depth + infeed : whole;
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
    values.note({FaultCode::OutOfDomain, isRigid ? "PITCH" : "F", {}});
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
    Row{17, [](Values& values) { return tapOld(values, true); }},
    Row{200, drill},
    Row{201, ream},
    Row{203, drillUniversally},
    Row{205, peckUniversally},
    Row{206, [](Values& values) { return tap(values, false); }},
    Row{207, [](Values& values) { return tap(values, true); }},
    Row{240, centre},
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
  const bool isFull = std::abs(std::abs(to - from) - 360.0) < kRounding;
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
