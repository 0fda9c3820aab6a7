// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/planned_run.h"

#include <array>

#include "machine/path_planner.h"

namespace rivulet::papers {

machine::MachineConfig recordedMachine(double accelerationShare) {
  machine::MachineConfig config;
  constexpr std::array<double, base::kAxisCount> kSpeeds{250.0, 200.0, 150.0};
  constexpr std::array<double, base::kAxisCount> kAccelerations{600.0, 500.0, 350.0};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    config.axes[axis].positionMmMin = -1e6;
    config.axes[axis].positionMmMax = 1e6;
    config.axes[axis].speedMmPerSMax = kSpeeds[axis];
    config.axes[axis].accelerationMmPerS2Max = accelerationShare * kAccelerations[axis];
    config.axes[axis].jerkMmPerS3Max = 1e9;
  }
  config.interpolationCycle = std::chrono::milliseconds{1};
  config.positionCycle = config.interpolationCycle;
  return config;
}

PlannedRun planRun(const std::vector<machine::PreparedMotion>& blocks, base::Vec3 startMm,
                   const machine::MachineConfig& config) {
  machine::PathPlanner planner(config, startMm);
  for (const machine::PreparedMotion& block : blocks) {
    planner.append(block);
  }
  PlannedRun run;
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  while (planner.blockCount() > 0) {
    planner.step(now += config.interpolationCycle, executed);
    run.commandsMm.push_back(planner.commandMm());
    run.speeds.push_back(planner.speedMmPerS());
  }
  run.seconds = executed.empty() ? 0.0 : base::toSeconds(executed.back().to);
  return run;
}

}  // namespace rivulet::papers
