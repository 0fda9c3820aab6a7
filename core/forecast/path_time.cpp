// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/path_time.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/contract.h"
#include "gcode/named_start.h"
#include "machine/path_planner.h"

namespace rivulet::forecast {

namespace {

/// Blocks in the look-ahead, as on a control of this class, and at most where hundreds are planned
/// at once. More would change the time by at most one braking distance, once.
constexpr int kBlocksAhead = 200;
constexpr int kBlocksAheadMax = 400;
/// Where only stretches are followed: points of each, and points before and behind it that are
/// followed, too, so that it is passed in motion. A block takes about a cycle at least, and no
/// braking so many cycles.
constexpr std::size_t kStretchPoints = 200;
constexpr std::size_t kRunUpPoints = 50;
/// Cycles between two calls of the progress function.
constexpr std::uint64_t kCyclesPerReport = 1U << 15U;

/// The points of a trajectory, as the flexible program executes them.
class Stream {
 public:
  Stream(const gcode::Trajectory& trajectory, base::Vec3 startMm,
         const machine::MachineConfig& config, const PathTimeOptions& options)
      : m_trajectory(trajectory), m_config(config), m_options(options), m_startMm(startMm) {
    const bool isOpen = std::any_of(
        trajectory.points.begin(), trajectory.points.end(),
        [](const gcode::TrajectoryPoint& point) { return !base::isFinite(point.positionMm); });
    for (std::size_t i = 0; isOpen && i < trajectory.points.size(); ++i) {
      startMm = gcode::placeOf(trajectory.points[i], startMm);
      m_places.push_back(startMm);
    }
    placePauses();
  }

  [[nodiscard]] std::size_t count() const { return m_trajectory.points.size(); }
  [[nodiscard]] bool pausesAfter(std::size_t index) const {
    return !m_pauses.empty() && m_pauses[index];
  }
  [[nodiscard]] std::size_t pauses() const { return m_pauseCount; }
  /// Where the move to a point begins.
  [[nodiscard]] base::Vec3 fromMm(std::size_t index) const {
    return index == 0 ? m_startMm : targetMm(index - 1);
  }

  [[nodiscard]] machine::PreparedMotion motion(std::size_t index) const {
    const gcode::TrajectoryPoint& point = m_trajectory.points[index];
    machine::PreparedMotion block;
    block.line = point.line;
    block.targetMm = targetMm(index);
    block.feedMmPerS = feedMmPerS(point);
    block.roundingMm = m_config.roundingMm;
    block.dynamics = m_config.resetDynamics;
    block.end = pausesAfter(index) ? machine::BlockEnd::ExactStop : machine::BlockEnd::Rounded;
    return block;
  }

  /// The move to a point at its feed, or at the shortest time of a block.
  [[nodiscard]] double simpleS(std::size_t index) const {
    const double mm = base::distance(fromMm(index), targetMm(index));
    const double blockS =
        m_config.blocksPerCycleMax > 0.0
            ? base::toSeconds(m_config.interpolationCycle) / m_config.blocksPerCycleMax
            : 0.0;
    return mm > 0.0 ? std::max(mm / feedMmPerS(m_trajectory.points[index]), blockS) : 0.0;
  }

 private:
  [[nodiscard]] base::Vec3 targetMm(std::size_t index) const {
    return m_places.empty() ? m_trajectory.points[index].positionMm : m_places[index];
  }

  [[nodiscard]] double feedMmPerS(const gcode::TrajectoryPoint& point) const {
    if (m_options.programFeeds) {
      const double commanded = gcode::commandedMmPerS(point, *m_options.programFeeds);
      return commanded > 0.0 ? commanded : m_options.programFeeds->rapidMmPerS;
    }
    if (m_options.feedMmPerS > 0.0) {
      return m_options.feedMmPerS;
    }
    // If the program gives no feed, the machine's rapid is the upper bound.
    const bool isRapid = point.kind == gcode::MoveKind::Rapid;
    return isRapid || point.feedMmPerS <= 0.0 ? m_config.rapidMmPerS : point.feedMmPerS;
  }

  [[nodiscard]] double degrees(std::size_t index, std::size_t axis) const {
    const double value = m_trajectory.rotary[index].degrees[axis];
    return std::isnan(value) ? 0.0 : value;
  }

  /// @pre index > 0
  [[nodiscard]] bool turnsAt(std::size_t index) const {
    if (m_trajectory.rotary.empty()) {
      return false;
    }
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (degrees(index, axis) != degrees(index - 1, axis)) {
        return true;
      }
    }
    return false;
  }

  /// A point that repeats its predecessor is not streamed (`gcode::streamPoints`): it fills no
  /// slot of a loop. A move that only turns is streamed.
  [[nodiscard]] bool isStreamed(std::size_t index) const {
    return index == 0 || !(targetMm(index) == targetMm(index - 1)) || turnsAt(index);
  }

  /// There is no pause after the last point.
  void placePauses() {
    auto pause = m_options.pausesBehind.begin();
    if (pause == m_options.pausesBehind.end()) {
      return;
    }
    m_pauses.resize(count());
    std::size_t last = count();
    for (std::size_t i = 0, streamed = 0; i < count(); ++i) {
      if (!isStreamed(i)) {
        continue;
      }
      last = i;
      if (pause != m_options.pausesBehind.end() && *pause == streamed++) {
        m_pauses[i] = true;
        ++m_pauseCount;
        ++pause;
      }
    }
    if (last < count() && m_pauses[last]) {
      m_pauses[last] = false;
      --m_pauseCount;
    }
  }

  const gcode::Trajectory& m_trajectory;
  const machine::MachineConfig& m_config;
  const PathTimeOptions& m_options;
  base::Vec3 m_startMm;
  std::vector<base::Vec3> m_places;  ///< of all points, if one leaves an axis open
  std::vector<bool> m_pauses;        ///< after each point; empty: there are none
  std::size_t m_pauseCount = 0;
};

/// Follows the planner through a part of a stream, which begins and ends at a standstill.
/// @param passed  told when each point is passed, s
/// @param goesOn  asked now and then; false: give up
/// @return false: given up
bool follow(const Stream& stream, std::size_t from, std::size_t to,
            const machine::MachineConfig& config, const PathTimeOptions& options,
            const std::function<void(double)>& passed, const std::function<bool()>& goesOn) {
  machine::PathPlanner planner(config, stream.fromMm(from));
  int most = kBlocksAhead;
  if (options.followedMax) {
    planner.planTogether();
    most = kBlocksAheadMax;
  }
  const auto fill = [&] {
    for (; from < to && planner.blockCount() < most; ++from) {
      const machine::PreparedMotion motion = stream.motion(from);
      planner.append(motion);
      if (stream.pausesAfter(from)) {
        planner.append(machine::PreparedDwell{motion.line, base::fromSeconds(options.pauseS)});
      }
    }
  };
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  std::uint64_t cycles = 0;
  while (from < to || planner.blockCount() > 0) {
    if (planner.blockCount() < kBlocksAhead) {
      fill();
    }
    executed.clear();
    planner.step(now += config.interpolationCycle, executed);
    for (const trace::ExecutedBlock& block : executed) {
      passed(base::toSeconds(block.to));
    }
    if (++cycles % kCyclesPerReport == 0 && !goesOn()) {
      return false;
    }
  }
  return true;
}

/// Follows stretches alone, in the middle of equal parts of the stream. @return false: given up
bool followStretches(const Stream& stream, const machine::MachineConfig& config,
                     const PathTimeOptions& options, const std::function<bool()>& goesOn,
                     PathTime& result) {
  const std::size_t count = stream.count();
  const std::size_t parts = std::max<std::size_t>(1, *options.followedMax / kStretchPoints);
  std::vector<double> passedS;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = part * count / parts;
    const std::size_t end = (part + 1) * count / parts;
    const std::size_t first = begin + (end - begin - std::min(end - begin, kStretchPoints)) / 2;
    const std::size_t last = std::min(end, first + kStretchPoints);
    const std::size_t from = first - std::min(first, kRunUpPoints);
    passedS.clear();
    const auto passed = [&](double seconds) { passedS.push_back(seconds); };
    if (!goesOn() || !follow(stream, from, std::min(count, last + kRunUpPoints), config, options,
                             passed, goesOn)) {
      return false;
    }
    const auto pauseS = [&](std::size_t i) {
      return i > 0 && stream.pausesAfter(i - 1) ? options.pauseS : 0.0;
    };
    const auto followedS = [&](std::size_t i) {
      return passedS[i - from] - (i > from ? passedS[i - from - 1] : 0.0);
    };
    double moving = 0.0;
    double simple = 0.0;
    for (std::size_t i = first; i < last; ++i) {
      moving += followedS(i) - (i > from ? pauseS(i) : 0.0);
      simple += stream.simpleS(i);
    }
    const double longer = simple > 0.0 ? moving / simple : 1.0;
    for (std::size_t i = begin; i < end; ++i) {
      result.totalS +=
          i >= first && i < last ? followedS(i) : longer * stream.simpleS(i) + pauseS(i);
      result.atS.push_back(static_cast<float>(result.totalS));
    }
  }
  return true;
}

}  // namespace

std::optional<PathTime> pathTime(const gcode::Trajectory& trajectory, base::Vec3 startMm,
                                 const machine::MachineConfig& config,
                                 const PathTimeOptions& options) {
  RIVULET_ASSERT(base::isFinite(startMm));
  RIVULET_ASSERT(options.feedMmPerS >= 0.0 && options.pauseS >= 0.0);
  RIVULET_ASSERT(std::is_sorted(options.pausesBehind.begin(), options.pausesBehind.end()));
  const Stream stream(trajectory, startMm, config, options);
  const std::size_t count = stream.count();
  PathTime result;
  result.atS.reserve(count);
  result.pauses = stream.pauses();
  for (std::size_t i = 0; i < result.pauses; ++i) {
    result.standingS += options.pauseS;
  }
  const auto goesOn = [&] {
    return !options.progress ||
           options.progress(static_cast<double>(result.atS.size()) / static_cast<double>(count));
  };
  const auto passed = [&result](double seconds) {
    result.totalS = seconds;
    result.atS.push_back(static_cast<float>(seconds));
  };
  const bool isDone = options.followedMax && count > *options.followedMax
                          ? followStretches(stream, config, options, goesOn, result)
                          : follow(stream, 0, count, config, options, passed, goesOn);
  if (!isDone) {
    return std::nullopt;
  }
  RIVULET_ASSERT(result.atS.size() == count);
  if (options.progress && !options.progress(1.0)) {
    return std::nullopt;
  }
  return result;
}

}  // namespace rivulet::forecast
