// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/planner_motion.h"

#include "base/contract.h"
#include "machine/path_planner.h"

namespace rivulet::forecast {

feasibility::TimedMotion PlannerMotion::move(std::span<const gcode::StreamPoint> points,
                                             base::Vec3 fromMm, double feedMmPerS,
                                             double stepS) const {
  RIVULET_ASSERT(base::fromSeconds(stepS) == m_machine.interpolationCycle);
  machine::PathPlanner planner(m_machine, fromMm);
  for (const gcode::StreamPoint& point : points) {
    machine::PreparedMotion block;
    block.line = point.line;
    block.targetMm = point.positionMm;
    block.feedMmPerS = point.feedMmPerS > 0.0 ? point.feedMmPerS : feedMmPerS;
    block.end = machine::BlockEnd::Rounded;
    block.roundingMm = m_machine.roundingMm;
    block.dynamics = m_machine.resetDynamics;
    planner.append(block);
  }
  feasibility::TimedMotion motion;
  motion.setPointsMm.push_back(fromMm);
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  while (planner.blockCount() > 0) {
    planner.step(now += m_machine.interpolationCycle, executed);
    motion.setPointsMm.push_back(planner.commandMm());
  }
  motion.durationS = executed.empty() ? 0.0 : base::toSeconds(executed.back().to);
  return motion;
}

}  // namespace rivulet::forecast
