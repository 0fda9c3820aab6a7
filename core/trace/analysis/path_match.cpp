// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/path_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/contract.h"
#include "trace/series.h"

namespace rivulet::trace {

namespace {

using FaultKind = PathFault::Kind;

constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);
constexpr std::size_t kPathFaultsMax = 100;
/// Hypotheses that are followed at the same time: places on the path, and courses off it.
constexpr std::size_t kPlacesMax = 24;
constexpr std::size_t kOffMax = 4;
/// Where the path passes often, a course returns to it within this many tolerances of the place
/// where it left.
constexpr double kReturnTolerances = 50.0;
/// Segments near a sample that are looked at, besides those of as many passes as are followed.
constexpr std::size_t kSegmentsMax = 128;
/// A jump along the path is less plausible than that many uneven steps, and so is leaving it.
constexpr double kJumpCost = 30.0;
constexpr double kLeaveCost = 15.0;
/// Being off the path costs as much as the farthest place that is still on it.
constexpr double kOffCost = 1.0;
/// The trace begins in the middle of the program.
constexpr double kLateStartCost = 5.0;
/// A corner may be rounded by this many tolerances if more than one point is passed by.
constexpr double kRoundingTolerances = 10.0;
/// Lengths of the path that differ by less are the same.
constexpr double kSamePlaceMm = 1e-9;
/// Speeds between samples may be higher than the highest recorded.
constexpr double kReachFactor = 1.2;

/// A sample that is used, and how far the tool moved since the one before.
struct Step {
  std::size_t sample = 0;
  base::Vec3 placeMm;
  double chordMm = 0.0;
  double reachMm = 0.0;  ///< the most that the path can have advanced meanwhile
};

/// One hypothesis at one step.
struct Node {
  PathPlace place;  ///< off the path: where it was left
  double cost = 0.0;
  double offMm = 0.0;  ///< travelled since the path was left
  std::size_t parent = kNoNode;
  std::size_t step = 0;
  bool isOff = false;
};

double fastestMmPerS(const Motion& motion, const ProgramPath& path) {
  double fastest = 0.0;
  const PackedValues speeds = motion.samples.valuesOf(MotionColumn::Speed);
  PackedReader<PackedValues> speed(speeds);
  for (std::size_t i = 0; i < speed.size(); ++i) {
    fastest = std::max(fastest, speed[i]);
  }
  for (const gcode::StreamPoint& point : path.points()) {
    fastest = std::max(fastest, point.feedMmPerS);
  }
  return fastest;
}

/// Samples that moved at least a little: a tool that stands says nothing new.
std::vector<Step> stepsOf(const Motion& motion, const ProgramPath& path, double toleranceMm) {
  const double speed = fastestMmPerS(motion, path);
  const double moveMm = 0.02 * toleranceMm;
  std::vector<Step> steps;
  base::Instant before{};
  MotionReader samples(motion.samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const base::Vec3 place = motion.placeMm(samples[i]);
    const base::Instant at = samples[i].at;
    if (steps.empty()) {
      steps.push_back({i, place, 0.0, 0.0});
    } else {
      const double chord = base::distance(place, steps.back().placeMm);
      if (chord < moveMm) {
        continue;
      }
      steps.push_back({i, place, chord,
                       kReachFactor * speed * base::toSeconds(at - before) + 2.0 * toleranceMm});
    }
    before = at;
  }
  return steps;
}

/// The most plausible course, step by step.
class CourseFinder {
 public:
  CourseFinder(const std::vector<Step>& steps, const ProgramPath& path, double toleranceMm)
      : m_steps(steps), m_path(path), m_toleranceMm(toleranceMm) {
    const double meanMm = path.lengthMm() / static_cast<double>(path.points().size());
    const double perPass = meanMm > 0.0 ? std::ceil(2.0 * toleranceMm / meanMm) : 1.0;
    m_segmentsMax = kSegmentsMax +
                    static_cast<std::size_t>(std::min(perPass * static_cast<double>(kPlacesMax),
                                                      static_cast<double>(path.points().size())));
  }

  [[nodiscard]] std::vector<Node> find() {
    begin();
    for (std::size_t step = 1; step < m_steps.size(); ++step) {
      advance(step);
    }
    std::size_t best = kNoNode;
    for (const std::size_t node : m_live) {
      best = best == kNoNode || m_nodes[node].cost < m_nodes[best].cost ? node : best;
    }
    std::vector<Node> course(m_steps.size());
    for (std::size_t node = best; node != kNoNode; node = m_nodes[node].parent) {
      course[m_nodes[node].step] = m_nodes[node];
    }
    return course;
  }

 private:
  [[nodiscard]] double distanceCost(const PathPlace& place) const {
    const double share = place.distanceMm / m_toleranceMm;
    return share * share;
  }

  /// Where the tool can be. Where the path passes more often than can be followed, that is where
  /// the courses so far lead to, in the order of their costs, and then what is nearest.
  [[nodiscard]] std::vector<PathPlace> places(std::size_t step) const {
    const base::Vec3 at = m_steps[step].placeMm;
    std::optional<std::vector<PathPlace>> all = m_path.nearIfFew(at, m_toleranceMm, m_segmentsMax);
    if (all && all->size() <= kPlacesMax) {
      return *std::move(all);
    }
    std::vector<PathPlace> chosen = continued(step);
    if (chosen.empty() || all) {
      if (!all) {
        all = m_path.near(at, m_toleranceMm);
      }
      std::ranges::stable_sort(*all, {}, &PathPlace::distanceMm);
      take(*all, chosen);
    }
    std::ranges::sort(chosen, {}, &PathPlace::segment);
    return chosen;
  }

  [[nodiscard]] std::vector<PathPlace> continued(std::size_t step) const {
    const double chordMm = m_steps[step].chordMm;
    std::vector<std::size_t> live = m_live;
    std::ranges::stable_sort(live, {}, [this](std::size_t node) { return m_nodes[node].cost; });
    std::vector<PathPlace> chosen;
    for (const std::size_t node : live) {
      const Node& from = m_nodes[node];
      const double begin = from.place.lengthMm - 2.0 * m_toleranceMm;
      const double reachMm =
          from.isOff
              ? std::min(3.0 * from.offMm, kReturnTolerances * m_toleranceMm) + 4.0 * m_toleranceMm
              : std::max(m_steps[step].reachMm, 1.05 * chordMm + 4.0 * m_toleranceMm);
      take(m_path.nearWithin(m_steps[step].placeMm, m_toleranceMm, begin,
                             from.place.lengthMm + reachMm),
           chosen);
    }
    return chosen;
  }

  /// The first of them that are not there yet, until there are enough.
  static void take(const std::vector<PathPlace>& places, std::vector<PathPlace>& chosen) {
    for (const PathPlace& place : places) {
      const bool isNew = std::ranges::none_of(
          chosen, [&place](const PathPlace& other) { return other.segment == place.segment; });
      if (isNew && chosen.size() < kPlacesMax) {
        chosen.push_back(place);
      }
    }
  }

  void begin() {
    std::vector<Node> nodes;
    for (const PathPlace& place : m_path.near(m_steps[0].placeMm, m_toleranceMm)) {
      const bool isLate = place.lengthMm > 2.0 * m_toleranceMm;
      nodes.push_back(
          {place, distanceCost(place) + (isLate ? kLateStartCost : 0.0) + 1e-9 * place.lengthMm,
           0.0, kNoNode, 0, false});
    }
    if (nodes.size() > kPlacesMax) {
      std::ranges::sort(nodes, {}, &Node::cost);
      nodes.resize(kPlacesMax);
    }
    for (const Node& node : nodes) {
      add(node);
    }
    add({{}, kLeaveCost, 0.0, kNoNode, 0, true});
    m_live = std::move(m_next);
    m_next.clear();
  }

  void add(Node node) {
    m_next.push_back(m_nodes.size());
    m_nodes.append(node);
  }

  /// From a place on the path to another one.
  [[nodiscard]] double stepCost(const Node& from, const PathPlace& to, const Step& step) const {
    const double advance = to.lengthMm - from.place.lengthMm;
    if (advance < -2.0 * m_toleranceMm) {
      return kJumpCost;
    }
    if (advance < 0.0) {
      return 0.3 - advance / m_toleranceMm;
    }
    const double excess = std::abs(advance - step.chordMm);
    if (advance <= 1.05 * step.chordMm + 4.0 * m_toleranceMm) {
      return std::min(1.0, 0.2 * excess / m_toleranceMm);
    }
    if (advance <= step.reachMm) {
      return 1.0 + excess / (step.chordMm + m_toleranceMm);
    }
    return kJumpCost;
  }

  [[nodiscard]] double returnCost(const Node& from, const PathPlace& to) const {
    const double advance = to.lengthMm - from.place.lengthMm;
    const bool goesOn =
        advance >= -2.0 * m_toleranceMm && advance <= 3.0 * from.offMm + 4.0 * m_toleranceMm;
    return goesOn ? 0.0 : kLeaveCost;
  }

  void advance(std::size_t index) {
    const Step& step = m_steps[index];
    for (const PathPlace& place : places(index)) {
      Node best;
      best.cost = std::numeric_limits<double>::infinity();
      for (const std::size_t live : m_live) {
        const Node& from = m_nodes[live];
        const double cost =
            from.cost + (from.isOff ? returnCost(from, place) : stepCost(from, place, step));
        if (cost < best.cost) {
          best = {place, cost, 0.0, live, index, false};
        }
      }
      best.cost += distanceCost(place);
      add(best);
    }
    addOff(index);
    m_live = std::move(m_next);
    m_next.clear();
  }

  /// The cheapest courses that are off the path now, with different places at which they left it.
  void addOff(std::size_t index) {
    std::vector<Node> off;
    for (const std::size_t live : m_live) {
      const Node& from = m_nodes[live];
      off.push_back({from.place, from.cost + kOffCost + (from.isOff ? 0.0 : kLeaveCost),
                     from.offMm + m_steps[index].chordMm, live, index, true});
    }
    std::sort(off.begin(), off.end(), [](const Node& a, const Node& b) { return a.cost < b.cost; });
    std::vector<double> lefts;
    for (const Node& node : off) {
      const bool isNew = std::none_of(lefts.begin(), lefts.end(), [&](double left) {
        return std::abs(left - node.place.lengthMm) < m_toleranceMm;
      });
      if (isNew && lefts.size() < kOffMax) {
        lefts.push_back(node.place.lengthMm);
        add(node);
      }
    }
  }

  const std::vector<Step>& m_steps;
  const ProgramPath& m_path;
  double m_toleranceMm;
  std::size_t m_segmentsMax = 0;
  Series<Node> m_nodes;
  std::vector<std::size_t> m_live;
  std::vector<std::size_t> m_next;
};

/// Reads the course: what was passed, and what not.
class CourseJudge {
 public:
  CourseJudge(const Motion& motion, const std::vector<Step>& steps, const std::vector<Node>& course,
              const ProgramPath& path, double toleranceMm)
      : m_motion(motion),
        m_steps(steps),
        m_course(course),
        m_path(path),
        m_toleranceMm(toleranceMm),
        m_passes(path.points().size(), 0),
        m_skippedAt(path.points().size(), kNoNode) {}

  [[nodiscard]] PathMatch judge();

 private:
  struct Interval {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  /// Points whose place on the path is in (from, to].
  [[nodiscard]] Interval pointsIn(double fromMm, double toMm) const;
  void arrive(std::size_t step);
  void follow(std::size_t from, std::size_t to);
  void goOn(std::size_t from, std::size_t to);
  void jumpBack(std::size_t from, std::size_t to);
  void pass(std::size_t point, std::size_t step);
  [[nodiscard]] double distanceToMotion(base::Vec3 place, std::size_t from, std::size_t to) const;
  [[nodiscard]] bool isStraight(std::size_t from, std::size_t to) const;
  [[nodiscard]] bool isAtPoint(double lengthMm) const;
  [[nodiscard]] double farthestOff(std::size_t from, std::size_t to) const;
  void addForeign(std::size_t step, double atMm);
  [[nodiscard]] PathFault fault(FaultKind kind, std::size_t point, std::size_t step) const;
  void findSkipped();
  void findDeparture(std::size_t lastOn);
  void collectSamples();

  const Motion& m_motion;
  const std::vector<Step>& m_steps;
  const std::vector<Node>& m_course;
  const ProgramPath& m_path;
  double m_toleranceMm;
  std::vector<std::size_t> m_passes;     ///< per point
  std::vector<std::size_t> m_skippedAt;  ///< per point: the step that skipped it first
  std::vector<bool> m_undecided;
  double m_frontMm = 0.0;  ///< how far along the path the motion has come since its last jump
  PathMatch m_match;
};

CourseJudge::Interval CourseJudge::pointsIn(double fromMm, double toMm) const {
  Interval interval;
  const std::size_t count = m_path.points().size();
  interval.begin = m_path.segmentAt(std::max(0.0, fromMm));
  while (interval.begin > 0 && m_path.lengthTo(interval.begin - 1) > fromMm) {
    --interval.begin;
  }
  while (interval.begin < count && m_path.lengthTo(interval.begin) <= fromMm) {
    ++interval.begin;
  }
  interval.end = interval.begin;
  while (interval.end < count && m_path.lengthTo(interval.end) <= toMm) {
    ++interval.end;
  }
  return interval;
}

PathFault CourseJudge::fault(FaultKind kind, std::size_t point, std::size_t step) const {
  const Step& at = m_steps[step];
  return {kind, base::PointIndex{static_cast<std::uint32_t>(point)}, m_path.points()[point].line,
          m_motion.samples[at.sample].at, at.placeMm};
}

void CourseJudge::addForeign(std::size_t step, double atMm) {
  ++m_match.foreign;
  m_match.faults.push_back(fault(FaultKind::Foreign, m_path.segmentAt(atMm), step));
}

void CourseJudge::pass(std::size_t point, std::size_t step) {
  if (!m_path.isBlockEnd(point)) {
    return;
  }
  if (m_passes[point]++ > 0) {
    ++m_match.repeated;
    m_match.faults.push_back(fault(FaultKind::Repeated, point, step));
  }
}

double CourseJudge::distanceToMotion(base::Vec3 place, std::size_t from, std::size_t to) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t step = from; step < to; ++step) {
    nearest = std::min(
        nearest, base::distanceToSegment(place, m_steps[step].placeMm, m_steps[step + 1].placeMm));
  }
  return nearest;
}

bool CourseJudge::isStraight(std::size_t from, std::size_t to) const {
  for (std::size_t step = from + 1; step < to; ++step) {
    if (base::distanceToSegment(m_steps[step].placeMm, m_steps[from].placeMm, m_steps[to].placeMm) >
        m_toleranceMm) {
      return false;
    }
  }
  return true;
}

/// True if a programmed point is near this place of the path.
bool CourseJudge::isAtPoint(double lengthMm) const {
  const Interval points = pointsIn(lengthMm - 3.0 * m_toleranceMm, lengthMm + 3.0 * m_toleranceMm);
  for (std::size_t point = points.begin; point < points.end; ++point) {
    if (m_path.isBlockEnd(point)) {
      return true;
    }
  }
  return lengthMm < 3.0 * m_toleranceMm;
}

/// Greatest distance of the motion from this part of the path.
double CourseJudge::farthestOff(std::size_t from, std::size_t to) const {
  const double begin = std::min(m_course[from].place.lengthMm, m_course[to].place.lengthMm);
  const double end = std::max(m_course[from].place.lengthMm, m_course[to].place.lengthMm);
  double farthest = 0.0;
  for (std::size_t step = from + 1; step < to; ++step) {
    farthest = std::max(farthest, m_path.nearest(m_steps[step].placeMm, begin, end).distanceMm);
  }
  return farthest;
}

/// Forwards along the path, on it or beside it.
void CourseJudge::goOn(std::size_t from, std::size_t to) {
  const double begin = m_course[from].place.lengthMm;
  const double end = m_course[to].place.lengthMm;
  // Going back a little and on again repeats nothing.
  const double front = std::max(begin, m_frontMm);
  m_frontMm = std::max(m_frontMm, end + kSamePlaceMm);
  const Interval points = pointsIn(front, end + kSamePlaceMm);
  const bool leaves = to > from + 1;
  double travelled = 0.0;
  for (std::size_t step = from + 1; step <= to; ++step) {
    travelled += m_steps[step].chordMm;
  }
  const double offMm = leaves ? farthestOff(from, to) : 0.0;
  const bool isShortcut = leaves && isStraight(from, to) && isAtPoint(begin) && isAtPoint(end);
  std::size_t ends = 0;
  for (std::size_t point = points.begin; point < points.end; ++point) {
    ends += static_cast<std::size_t>(m_path.isBlockEnd(point));
  }
  // Rounding cuts a corner: it is not longer than the path. An overshoot is a little longer.
  const bool isRounding = leaves && !isShortcut &&
                          ((ends <= 1 && travelled <= 1.02 * (end - begin) + 2.0 * m_toleranceMm) ||
                           offMm <= kRoundingTolerances * m_toleranceMm);
  const bool isForeign = leaves && !isShortcut && !isRounding;
  const bool isTooFar = !leaves && end - begin > m_steps[to].reachMm &&
                        end - begin > 1.05 * travelled + 4.0 * m_toleranceMm;
  if (isForeign) {
    addForeign(from + 1, begin);
  }
  for (std::size_t point = points.begin; point < points.end; ++point) {
    const double missed = distanceToMotion(m_path.points()[point].positionMm, from, to);
    if (missed <= m_toleranceMm || isRounding) {
      pass(point, to);
    } else if (isShortcut || isForeign || isTooFar) {
      m_skippedAt[point] = std::min(m_skippedAt[point], to);
    } else {
      m_undecided[point] = true;
    }
  }
}

/// To an earlier place, by whatever way.
void CourseJudge::jumpBack(std::size_t from, std::size_t to) {
  if (to > from + 1 && !isStraight(from, to)) {
    addForeign(from + 1, m_course[from].place.lengthMm);
  }
  arrive(to);
}

/// The points at which a motion from elsewhere ends.
void CourseJudge::arrive(std::size_t step) {
  const double at = m_course[step].place.lengthMm;
  m_frontMm = at + kSamePlaceMm;
  const Interval points = pointsIn(at - m_toleranceMm, at + kSamePlaceMm);
  for (std::size_t point = points.begin; point < points.end; ++point) {
    if (base::distance(m_path.points()[point].positionMm, m_steps[step].placeMm) <=
        2.0 * m_toleranceMm) {
      pass(point, step);
    }
  }
}

void CourseJudge::follow(std::size_t from, std::size_t to) {
  const double advance = m_course[to].place.lengthMm - m_course[from].place.lengthMm;
  if (advance < -2.0 * m_toleranceMm) {
    jumpBack(from, to);
  } else if (advance >= 0.0 || to > from + 1) {
    goOn(from, to);
  }
}

void CourseJudge::findSkipped() {
  std::size_t last = kNoNode;
  for (std::size_t point = m_passes.size(); point-- > 0 && last == kNoNode;) {
    last = m_passes[point] > 0 ? point : kNoNode;
  }
  for (std::size_t point = 0; point < m_passes.size(); ++point) {
    if (!m_path.isBlockEnd(point)) {
      continue;
    }
    ++m_match.points;
    if (m_passes[point] > 0) {
      ++m_match.executed;
    } else if (m_undecided[point]) {
      ++m_match.undecided;
    } else if (m_skippedAt[point] != kNoNode && last != kNoNode && point < last) {
      ++m_match.skipped;
      m_match.faults.push_back(fault(FaultKind::Skipped, point, m_skippedAt[point]));
    }
  }
}

/// @param lastOn  the last step that was on the path
void CourseJudge::findDeparture(std::size_t lastOn) {
  double restMm = 0.0;
  for (std::size_t step = lastOn + 1; step < m_steps.size(); ++step) {
    restMm += m_steps[step].chordMm;
  }
  // A retraction at the end is no other program, unless it is long.
  const double lengthMm = m_course[lastOn].place.lengthMm;
  if (restMm > 2.0 * m_toleranceMm && lengthMm < m_path.lengthMm() - 2.0 * m_toleranceMm) {
    // Where the motion leaves at a point, this one is done, and the next is due.
    m_match.departure =
        fault(FaultKind::Foreign, m_path.segmentAt(lengthMm + m_toleranceMm), lastOn + 1);
  }
}

void CourseJudge::collectSamples() {
  double onMm = 0.0;
  double allMm = 0.0;
  std::size_t lastOn = kNoNode;
  std::vector<std::size_t> nextOn(m_course.size(), kNoNode);
  for (std::size_t step = m_course.size(); step-- > 0;) {
    nextOn[step] = !m_course[step].isOff        ? step
                   : step + 1 < m_course.size() ? nextOn[step + 1]
                                                : kNoNode;
  }
  for (std::size_t step = 0; step < m_course.size(); ++step) {
    const bool isOn = !m_course[step].isOff;
    allMm += m_steps[step].chordMm;
    onMm += isOn ? m_steps[step].chordMm : 0.0;
    PathPlace place = m_course[step].place;
    if (isOn) {
      lastOn = step;
    } else if (lastOn != kNoNode && nextOn[step] != kNoNode &&
               m_course[nextOn[step]].place.lengthMm >= m_course[lastOn].place.lengthMm) {
      place = m_path.nearest(m_steps[step].placeMm, m_course[lastOn].place.lengthMm,
                             m_course[nextOn[step]].place.lengthMm);
    } else {
      place.distanceMm = std::numeric_limits<double>::infinity();
    }
    m_match.samples.push_back({m_steps[step].sample, place, isOn});
  }
  m_match.onPathShare = allMm > 0.0 ? onMm / allMm : 1.0;
}

PathMatch CourseJudge::judge() {
  m_match.judged = true;
  m_undecided.assign(m_path.points().size(), false);
  std::size_t lastOn = kNoNode;
  for (std::size_t step = 0; step < m_course.size(); ++step) {
    if (m_course[step].isOff) {
      continue;
    }
    if (lastOn == kNoNode) {
      arrive(step);
      if (step > 1) {
        addForeign(1, m_course[step].place.lengthMm);
      }
    } else {
      follow(lastOn, step);
    }
    lastOn = step;
  }
  if (lastOn != kNoNode) {
    const Interval rest =
        pointsIn(m_course[lastOn].place.lengthMm, m_course[lastOn].place.lengthMm + m_toleranceMm);
    for (std::size_t point = rest.begin; point < rest.end; ++point) {
      if (m_passes[point] == 0) {
        pass(point, lastOn);
      }
    }
    findDeparture(lastOn);
  } else {
    m_match.departure = fault(FaultKind::Foreign, 0, 0);
  }
  findSkipped();
  collectSamples();
  std::stable_sort(m_match.faults.begin(), m_match.faults.end(),
                   [](const PathFault& a, const PathFault& b) { return a.at < b.at; });
  m_match.faults.resize(std::min(m_match.faults.size(), kPathFaultsMax));
  return std::move(m_match);
}

}  // namespace

PathMatch matchPath(const Motion& motion, const ProgramPath& path,
                    const PathMatchOptions& options) {
  RIVULET_ASSERT(options.toleranceMm > 0.0);
  const std::vector<Step> steps = stepsOf(motion, path, options.toleranceMm);
  if (steps.size() < 2) {
    return {};
  }
  const std::vector<Node> course = CourseFinder(steps, path, options.toleranceMm).find();
  return CourseJudge(motion, steps, course, path, options.toleranceMm).judge();
}

}  // namespace rivulet::trace
