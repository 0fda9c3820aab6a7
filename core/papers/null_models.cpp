// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/null_models.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/contract.h"

namespace rivulet::papers {

namespace {

using emulator::paper::Course;
using emulator::paper::Emulation;
using emulator::paper::Learning;
using emulator::paper::Misfit;
using emulator::paper::Trial;

struct TableCourse {
  std::vector<double> mm;
  std::vector<double> mmPerS;
};

/// Integrates one axis over its set points and looks at the table at the given times.
TableCourse lookAt(const LaggingAxis& axis, const std::vector<double>& reference, double periodS,
                   const std::vector<double>& timesS) {
  constexpr double kStepS = 1e-4;
  constexpr double kHeldMmPerS = 1e-3;  // below this, friction can hold the motor
  const double omega = 2.0 * std::numbers::pi * axis.resonanceHz;
  const double start = reference.front();
  const auto delay = static_cast<std::size_t>(std::lround(axis.positionDelayS / kStepS));
  std::vector<double> late(delay + 1, start);
  double motor = start;
  double motorSpeed = 0.0;
  double table = start;
  double tableSpeed = 0.0;
  TableCourse seen;
  for (std::size_t step = 0; seen.mm.size() < timesS.size(); ++step) {
    const double now = static_cast<double>(step) * kStepS;
    while (seen.mm.size() < timesS.size() && timesS[seen.mm.size()] <= now) {
      seen.mm.push_back(table);
      seen.mmPerS.push_back(tableSpeed);
    }
    const auto sample = std::min(static_cast<std::size_t>(now / periodS), reference.size() - 1);
    late[step % late.size()] = motor;
    const double lateMm = late[(step + 1) % late.size()];
    const double wanted = axis.positionGainPerS * (reference[sample] - lateMm);
    const double drive = (wanted - motorSpeed) / axis.speedLagS;
    const bool isHeld =
        std::abs(motorSpeed) < kHeldMmPerS && std::abs(drive) < axis.frictionMmPerS2;
    const double direction = std::abs(motorSpeed) < kHeldMmPerS ? drive : motorSpeed;
    motorSpeed =
        isHeld ? 0.0
               : motorSpeed + kStepS * (drive - std::copysign(axis.frictionMmPerS2, direction));
    motor += kStepS * motorSpeed;
    tableSpeed += kStepS * (omega * omega * (motor - table) +
                            2.0 * axis.resonanceDamping * omega * (motorSpeed - tableSpeed));
    table += kStepS * tableSpeed;
  }
  return seen;
}

}  // namespace

Misfit setPointMisfit(const Course& course) {
  Emulation still;
  for (std::size_t axis = 0; axis < still.mm.size(); ++axis) {
    const std::vector<double>& reference = course.referenceMm[axis];
    const auto at = [&](std::size_t step) {
      return reference[std::min(step, reference.size() - 1)];
    };
    for (const auto& point : course.points) {
      const double apart = at(point.step + 1) - at(point.step);
      still.mm[axis].push_back(at(point.step) + point.share * apart);
      still.mmPerS[axis].push_back(apart / course.stepS);
    }
  }
  return emulator::paper::misfitOf(course, still);
}

Misfit nominalMisfit(const Course& course, const emulator::paper::PlantSettings& plant) {
  return emulator::paper::misfitOf(
      course, emulator::paper::emulate(course, emulator::paper::nominalParameters(), plant));
}

emulator::paper::Parameters afterOneGeneration(const Learning& learning) {
  const Trial* best = nullptr;
  for (const Trial& trial : learning.trials) {
    if (trial.generation <= 1 && (best == nullptr || trial.objective < best->objective)) {
      best = &trial;
    }
  }
  RIVULET_ASSERT(best != nullptr);
  return best->values;
}

emulator::TrainingRun observedOfMachine(emulator::TrainingRun run,
                                        const std::array<LaggingAxis, 2>& axes) {
  RIVULET_ASSERT(run.axes.size() == axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    TableCourse seen = lookAt(axes[i], run.axes[i].reference, run.period, run.observedAt);
    run.axes[i].observed = std::move(seen.mm);
    run.axes[i].observedMmPerS = std::move(seen.mmPerS);
  }
  return run;
}

}  // namespace rivulet::papers
