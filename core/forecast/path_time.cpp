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

/// Blocks in the look-ahead, as on a control of this class. More would
/// change the time by at most one braking distance, once.
constexpr int kBlocksAhead = 200;
/// Cycles between two calls of the progress function.
constexpr std::uint64_t kCyclesPerReport = 1U << 15U;

/// Feeds the planner with the points of a trajectory, as the flexible program would.
class Feeder {
 public:
  Feeder(const gcode::Trajectory& trajectory, base::Vec3 startMm,
         const machine::MachineConfig& config, const PathTimeOptions& options)
      : m_trajectory(trajectory),
        m_config(config),
        m_options(options),
        m_nextPause(options.pausesBehind.begin()) {
    const bool isOpen = std::any_of(
        trajectory.points.begin(), trajectory.points.end(),
        [](const gcode::TrajectoryPoint& point) { return !base::isFinite(point.positionMm); });
    for (std::size_t i = 0; isOpen && i < trajectory.points.size(); ++i) {
      startMm = gcode::placeOf(trajectory.points[i], startMm);
      m_places.push_back(startMm);
    }
    const std::size_t count = trajectory.points.size();
    m_lastStreamed = count == 0 ? 0 : count - 1;
    while (m_lastStreamed > 0 && !isStreamed(m_lastStreamed)) {
      --m_lastStreamed;
    }
  }

  [[nodiscard]] bool isAtEnd() const { return m_next == m_trajectory.points.size(); }

  /// Passes on the next point and, if the stream pauses after it, the pause.
  void append(machine::PathPlanner& planner, PathTime& result) {
    const base::LineNumber line = m_trajectory.points[m_next].line;
    const bool pauses = pausesAfterNext();
    machine::PreparedMotion block;
    block.line = line;
    block.targetMm = targetMm(m_next);
    block.feedMmPerS = feedMmPerS(m_trajectory.points[m_next]);
    block.roundingMm = m_config.roundingMm;
    block.dynamics = m_config.resetDynamics;
    block.end = pauses ? machine::BlockEnd::ExactStop : machine::BlockEnd::Rounded;
    planner.append(block);
    ++m_next;
    if (pauses) {
      ++result.pauses;
      result.standingS += m_options.pauseS;
      planner.append(machine::PreparedDwell{line, base::fromSeconds(m_options.pauseS)});
    }
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

  /// Counts the next point. There is no pause after the last one.
  bool pausesAfterNext() {
    if (!isStreamed(m_next)) {
      return false;
    }
    const bool isPlace = m_nextPause != m_options.pausesBehind.end() && *m_nextPause == m_streamed;
    if (isPlace) {
      ++m_nextPause;
    }
    ++m_streamed;
    return isPlace && m_next < m_lastStreamed;
  }

  const gcode::Trajectory& m_trajectory;
  std::vector<base::Vec3> m_places;  ///< of all points, if one leaves an axis open
  const machine::MachineConfig& m_config;
  const PathTimeOptions& m_options;
  std::vector<std::uint32_t>::const_iterator m_nextPause;
  std::size_t m_next = 0;
  std::size_t m_lastStreamed = 0;
  std::size_t m_streamed = 0;  ///< streamed points before the next one
};

}  // namespace

std::optional<PathTime> pathTime(const gcode::Trajectory& trajectory, base::Vec3 startMm,
                                 const machine::MachineConfig& config,
                                 const PathTimeOptions& options) {
  RIVULET_ASSERT(base::isFinite(startMm));
  RIVULET_ASSERT(options.feedMmPerS >= 0.0 && options.pauseS >= 0.0);
  RIVULET_ASSERT(std::is_sorted(options.pausesBehind.begin(), options.pausesBehind.end()));
  const std::size_t count = trajectory.points.size();
  PathTime result;
  result.atS.reserve(count);
  machine::PathPlanner planner(config, startMm);
  Feeder feeder(trajectory, startMm, config, options);
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  std::uint64_t cycles = 0;
  while (!feeder.isAtEnd() || planner.blockCount() > 0) {
    while (!feeder.isAtEnd() && planner.blockCount() < kBlocksAhead) {
      feeder.append(planner, result);
    }
    executed.clear();
    planner.step(now += config.interpolationCycle, executed);
    for (const trace::ExecutedBlock& block : executed) {
      result.atS.push_back(static_cast<float>(base::toSeconds(block.to)));
      result.totalS = base::toSeconds(block.to);
    }
    if (++cycles % kCyclesPerReport == 0 && options.progress &&
        !options.progress(static_cast<double>(result.atS.size()) / static_cast<double>(count))) {
      return std::nullopt;
    }
  }
  RIVULET_ASSERT(result.atS.size() == count);
  if (options.progress && !options.progress(1.0)) {
    return std::nullopt;
  }
  return result;
}

}  // namespace rivulet::forecast
