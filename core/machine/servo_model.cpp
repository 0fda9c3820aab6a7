// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/servo_model.h"

#include <algorithm>

namespace rivulet::machine {

namespace {

/// Longest step in which the friction of an axis is exact enough.
constexpr base::Duration kStepMax = std::chrono::milliseconds{1};

}  // namespace

ServoModel::ServoModel(const MachineConfig& config, const base::AxisPosition& start)
    : m_steps(static_cast<int>(std::max<base::Duration::rep>(
          1, config.interpolationCycle / std::min(config.positionCycle, kStepMax)))),
      m_actualMm(start.mm),
      m_actualDeg(start.deg) {
  const double stepS = base::toSeconds(config.interpolationCycle) / m_steps;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (const auto law = config.axisLaw(axis)) {
      m_axes[axis].emplace(*law, stepS, emulator::AxisState{start.mm[axis], 0.0});
    }
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (config.rotaryAxes[axis] && config.rotaryAxes[axis]->servoTimeConstantS > 0.0) {
      m_rotaryAxes[axis].emplace(
          emulator::firstOrderLag(config.rotaryAxes[axis]->servoTimeConstantS), stepS,
          emulator::AxisState{start.deg[axis], 0.0});
    }
  }
}

double ServoModel::followOne(Axis& axis, double from, double to) const {
  if (!axis) {
    return to;
  }
  for (int i = 1; i < m_steps; ++i) {
    axis->step(from + (to - from) * i / m_steps);
  }
  return axis->step(to).mm;
}

base::Vec3 ServoModel::follow(base::Vec3 fromMm, base::Vec3 toMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_actualMm.set(axis, followOne(m_axes[axis], fromMm[axis], toMm[axis]));
  }
  return m_actualMm;
}

base::RotaryDeg ServoModel::followDeg(const base::RotaryDeg& fromDeg,
                                      const base::RotaryDeg& toDeg) {
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    m_actualDeg[axis] = followOne(m_rotaryAxes[axis], fromDeg[axis], toDeg[axis]);
  }
  return m_actualDeg;
}

}  // namespace rivulet::machine
