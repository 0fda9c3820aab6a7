// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "experiments/path_time.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "machine/path_planner.h"

namespace rivulet::experiments {

namespace {

/// Blocks in the look-ahead at most: as many as a control of this class looks at. More would
/// change the time by less than one braking distance, once.
constexpr int kBlocksAhead = 200;
/// Cycles between two reports.
constexpr std::uint64_t kCyclesPerReport = 1U << 15U;

}  // namespace

std::optional<PathTime> pathTime(const gcode::Trajectory& trajectory, base::Vec3 startMm,
                                 const machine::MachineConfig& config,
                                 const PathTimeOptions& options) {
  RIVULET_ASSERT(base::isFinite(startMm));
  RIVULET_ASSERT(options.feedMmPerS >= 0.0 && options.pauseS >= 0.0);
  RIVULET_ASSERT(std::is_sorted(options.pausesBehind.begin(), options.pausesBehind.end()));
  const std::vector<gcode::TrajectoryPoint>& points = trajectory.points;
  PathTime result;
  result.atS.reserve(points.size());
  machine::PathPlanner planner(config, startMm);
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  std::size_t appended = 0;
  std::size_t streamedBefore = 0;  // streamed points in front of the next block
  auto nextPause = options.pausesBehind.begin();
  std::uint64_t cycles = 0;

  const auto targetMm = [&](std::size_t index) {
    base::Vec3 positionMm = points[index].positionMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (std::isnan(positionMm[axis])) {
        positionMm.set(axis, startMm[axis]);
      }
    }
    return positionMm;
  };
  // As `gcode::streamPoints` sees it: a move that only turns is streamed, too.
  const auto turnsAt = [&trajectory](std::size_t index) {
    const auto degrees = [&trajectory, index](std::size_t back, std::size_t axis) {
      const double value = trajectory.rotary[index - back].degrees[axis];
      return std::isnan(value) ? 0.0 : value;
    };
    for (std::size_t axis = 0; !trajectory.rotary.empty() && axis < base::kRotaryAxisCount;
         ++axis) {
      if (degrees(0, axis) != degrees(1, axis)) {
        return true;
      }
    }
    return false;
  };
  // A point that repeats its predecessor is not streamed: it fills no slot of a loop.
  const auto isStreamed = [&](std::size_t index) {
    return index == 0 || !(targetMm(index) == targetMm(index - 1)) || turnsAt(index);
  };
  std::size_t lastStreamed = points.empty() ? 0 : points.size() - 1;
  while (lastStreamed > 0 && !isStreamed(lastStreamed)) {
    --lastStreamed;
  }

  const auto append = [&](const gcode::TrajectoryPoint& point) {
    machine::PreparedMotion block;
    block.line = point.line;
    block.targetMm = targetMm(appended);
    const bool isRapid = point.kind == gcode::MoveKind::Rapid;
    if (options.feedMmPerS > 0.0) {
      block.feedMmPerS = options.feedMmPerS;
    } else {
      // A feed the program does not give is not known here: the machine's fastest is the bound.
      block.feedMmPerS = isRapid || point.feedMmPerS <= 0.0 ? config.rapidMmPerS : point.feedMmPerS;
    }
    block.roundingMm = config.roundingMm;
    block.dynamics = config.resetDynamics;
    const bool streamed = isStreamed(appended);
    const bool isPlace =
        streamed && nextPause != options.pausesBehind.end() && *nextPause == streamedBefore;
    if (isPlace) {
      ++nextPause;
    }
    streamedBefore += streamed ? 1 : 0;
    const bool pauses = isPlace && appended < lastStreamed;
    block.end = pauses ? machine::BlockEnd::ExactStop : machine::BlockEnd::Rounded;
    planner.append(block);
    ++appended;
    if (pauses) {
      ++result.pauses;
      result.standingS += options.pauseS;
      planner.append(machine::PreparedDwell{point.line, base::fromSeconds(options.pauseS)});
    }
  };

  while (appended < points.size() || planner.blockCount() > 0) {
    while (appended < points.size() && planner.blockCount() < kBlocksAhead) {
      append(points[appended]);
    }
    executed.clear();
    planner.step(now += config.interpolationCycle, executed);
    for (const trace::ExecutedBlock& block : executed) {
      result.atS.push_back(static_cast<float>(base::toSeconds(block.to)));
      result.totalS = base::toSeconds(block.to);
    }
    if (++cycles % kCyclesPerReport == 0 && options.progress &&
        !options.progress(static_cast<double>(result.atS.size()) /
                          static_cast<double>(points.size()))) {
      return std::nullopt;
    }
  }
  RIVULET_ASSERT(result.atS.size() == points.size());
  if (options.progress && !options.progress(1.0)) {
    return std::nullopt;
  }
  return result;
}

}  // namespace rivulet::experiments
