// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/path_planner.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::machine {

namespace {

/// A path shorter than this is no motion; far below the resolution of any control.
constexpr double kLengthMmMin = 1e-9;
/// Time below this is rounding, not motion.
constexpr double kTimeSMin = 1e-12;

}  // namespace

PathPlanner::PathPlanner(const MachineConfig& config, base::Vec3 startMm)
    : m_config(config),
      m_cycleS(base::toSeconds(config.interpolationCycle)),
      m_commandMm(startMm),
      m_endMm(startMm) {
}

void PathPlanner::append(const PreparedMotion& motion) {
  Block block;
  block.line = motion.line;
  block.fromMm = m_endMm;
  block.toMm = motion.targetMm;
  block.lengthMm = base::distance(block.fromMm, block.toMm);
  block.exactStop = motion.end == BlockEnd::ExactStop;
  m_endMm = motion.targetMm;
  if (block.lengthMm > kLengthMmMin) {
    block.direction = (1.0 / block.lengthMm) * (block.toMm - block.fromMm);
    block.speedMmPerSMax = motion.feedMmPerS;
    block.accelerationMmPerS2 = 1e12;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double share = std::abs(block.direction[axis]);
      if (share > 1e-12) {
        const AxisLimits& limits = m_config.axes[axis];
        block.speedMmPerSMax = std::min(block.speedMmPerSMax, limits.speedMmPerSMax / share);
        block.accelerationMmPerS2 =
            std::min(block.accelerationMmPerS2, limits.accelerationMmPerS2Max / share);
      }
    }
  } else {
    block.lengthMm = 0.0;
  }
  if (!m_blocks.empty()) {
    block.cornerMmPerSMax = cornerSpeed(m_blocks.back(), block);
  }
  m_blocks.push_back(block);
  planBackwards();
}

void PathPlanner::append(const PreparedDwell& dwell) {
  Block block;
  block.line = dwell.line;
  block.fromMm = m_endMm;
  block.toMm = m_endMm;
  block.dwellS = base::toSeconds(dwell.duration);
  block.exactStop = true;
  m_blocks.push_back(block);
}

double PathPlanner::cornerSpeed(const Block& before, const Block& after) const {
  // A block without length has no direction: the path stands there.
  if (before.exactStop || before.lengthMm == 0.0 || after.lengthMm == 0.0) {
    return 0.0;
  }
  double speed = std::min(before.speedMmPerSMax, after.speedMmPerSMax);
  const double curveMm = 0.5 * (before.lengthMm + after.lengthMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double turn = std::abs(after.direction[axis] - before.direction[axis]);
    if (turn > 1e-12) {
      const double acceleration = m_config.axes[axis].accelerationMmPerS2Max;
      speed = std::min({speed, m_config.accelerationOverload * acceleration * m_cycleS / turn,
                        std::sqrt(acceleration * curveMm / turn)});
    }
  }
  return speed;
}

void PathPlanner::planBackwards() {
  // The block in motion keeps its entry: it has been entered. Going back stops where nothing
  // changes any more.
  for (std::size_t index = m_blocks.size(); index-- > 1;) {
    Block& block = m_blocks[index];
    const double exit = index + 1 < m_blocks.size() ? m_blocks[index + 1].entryMmPerSMax : 0.0;
    const double braking =
        std::sqrt(exit * exit + 2.0 * block.accelerationMmPerS2 * block.lengthMm);
    const double entry = std::min(block.cornerMmPerSMax, braking);
    const bool unchanged = entry == block.entryMmPerSMax && index + 1 < m_blocks.size();
    block.entryMmPerSMax = entry;
    if (unchanged) {
      return;
    }
  }
}

double PathPlanner::exitSpeed(std::size_t index) const {
  return !m_aborting && index + 1 < m_blocks.size() ? m_blocks[index + 1].entryMmPerSMax : 0.0;
}

double PathPlanner::advanceFirst(double seconds) {
  Block& block = m_blocks.front();
  const double a = block.accelerationMmPerS2;
  const double left = block.lengthMm - m_pathMm;
  const double v0 = m_speedMmPerS;
  if (m_aborting) {
    const double stopS = v0 / a;
    const double endS = std::min(seconds, stopS);
    m_pathMm = std::min(block.lengthMm, m_pathMm + v0 * endS - 0.5 * a * endS * endS);
    m_speedMmPerS = endS >= stopS ? 0.0 : v0 - a * endS;
    return seconds - endS;
  }
  const double exit = std::min(exitSpeed(0), std::sqrt(v0 * v0 + 2.0 * a * left));
  const double peak = std::sqrt(std::max(0.0, a * left + 0.5 * (v0 * v0 + exit * exit)));
  const double cruise = std::max(std::min(block.speedMmPerSMax, peak), exit);
  // Rounding may leave v0 a hair above the cruise speed; then it counts as cruising.
  const double top = std::max(cruise, std::min(v0, peak));
  const double accelerateS = std::max(0.0, (top - v0) / a);
  const double brakeS = (top - exit) / a;
  const double accelerateMm = 0.5 * (v0 + top) * accelerateS;
  const double brakeMm = 0.5 * (top + exit) * brakeS;
  const double cruiseMm = std::max(0.0, left - accelerateMm - brakeMm);
  const double cruiseS = top > 0.0 ? cruiseMm / top : 0.0;
  const double totalS = accelerateS + cruiseS + brakeS;
  if (totalS <= seconds) {
    m_pathMm = block.lengthMm;
    m_speedMmPerS = exit;
    return seconds - totalS;
  }
  double t = seconds;
  if (t < accelerateS) {
    m_pathMm += v0 * t + 0.5 * a * t * t;
    m_speedMmPerS = v0 + a * t;
    return 0.0;
  }
  t -= accelerateS;
  if (t < cruiseS) {
    m_pathMm += accelerateMm + top * t;
    m_speedMmPerS = top;
    return 0.0;
  }
  t -= cruiseS;
  m_pathMm += accelerateMm + cruiseMm + top * t - 0.5 * a * t * t;
  m_speedMmPerS = std::max(0.0, top - a * t);
  return 0.0;
}

void PathPlanner::finishFirst(base::Instant at, std::vector<trace::ExecutedBlock>& executed) {
  const Block& block = m_blocks.front();
  m_commandMm = block.toMm;
  if (block.dwellS == 0.0) {
    executed.push_back({block.startedAt.value_or(at), at, block.line, block.toMm, block.lengthMm});
  }
  m_blocks.pop_front();
  m_pathMm = 0.0;
}

void PathPlanner::step(base::Instant end, std::vector<trace::ExecutedBlock>& executed) {
  double left = m_cycleS;
  const base::Instant begin = end - m_config.interpolationCycle;
  const auto instantNow = [&] { return begin + base::fromSeconds(m_cycleS - left); };
  while (!m_blocks.empty()) {
    Block& block = m_blocks.front();
    if (!block.startedAt) {
      block.startedAt = instantNow();
      m_dwellLeftS = block.dwellS;
    }
    m_line = block.line;
    if (block.lengthMm == 0.0) {
      const double waited = std::min(left, m_dwellLeftS);
      m_dwellLeftS -= waited;
      left -= waited;
      if (m_aborting) {
        break;
      }
      if (m_dwellLeftS > kTimeSMin) {
        return;
      }
      finishFirst(instantNow(), executed);
      continue;
    }
    left = advanceFirst(left);
    if (m_pathMm >= block.lengthMm) {
      finishFirst(instantNow(), executed);
      continue;
    }
    m_commandMm = block.fromMm + m_pathMm * block.direction;
    if (m_aborting && m_speedMmPerS == 0.0) {
      break;
    }
    if (left <= kTimeSMin) {
      return;
    }
  }
  // Nothing left to move: the path stands, here or where it was aborted.
  if (m_aborting || m_blocks.empty()) {
    m_blocks.clear();
    m_endMm = m_commandMm;
    m_pathMm = 0.0;
    m_speedMmPerS = 0.0;
    m_aborting = false;
  }
}

double PathPlanner::feedCommandMmPerS() const {
  return m_blocks.empty() ? 0.0 : m_blocks.front().speedMmPerSMax;
}

base::Vec3 PathPlanner::distanceToGoMm() const {
  return m_blocks.empty() ? base::Vec3{} : m_blocks.front().toMm - m_commandMm;
}

}  // namespace rivulet::machine
