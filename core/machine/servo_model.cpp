// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/servo_model.h"

#include <algorithm>
#include <cmath>

namespace rivulet::machine {

LinearServo::LinearServo(const MachineConfig& config, base::Vec3 startMm)
    : m_steps(static_cast<int>(
          std::max<base::Duration::rep>(1, config.interpolationCycle / config.positionCycle))),
      m_actualMm(startMm) {
  const double stepS = base::toSeconds(config.interpolationCycle) / m_steps;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double constantS = config.axes[axis].servoTimeConstantS;
    if (constantS > 0.0) {
      m_lags[axis].decay = std::exp(-stepS / constantS);
      m_lags[axis].drag = constantS / stepS * (1.0 - m_lags[axis].decay);
    }
  }
}

base::Vec3 LinearServo::follow(base::Vec3 fromMm, base::Vec3 toMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const auto& [decay, drag] = m_lags[axis];
    const double step = (toMm[axis] - fromMm[axis]) / m_steps;
    double command = fromMm[axis];
    double actual = m_actualMm[axis];
    for (int i = 0; i < m_steps; ++i) {
      // Solution of the lag for a set point rising from `command` by `step`.
      actual = command + step + (actual - command) * decay - step * drag;
      command += step;
    }
    m_actualMm.set(axis, actual);
  }
  return m_actualMm;
}

}  // namespace rivulet::machine
