// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/servo_model.h"

#include <algorithm>
#include <cmath>

namespace rivulet::machine {

LinearServo::LinearServo(const MachineConfig& config, const base::AxisPosition& start)
    : m_steps(static_cast<int>(
          std::max<base::Duration::rep>(1, config.interpolationCycle / config.positionCycle))),
      m_actualMm(start.mm),
      m_actualDeg(start.deg) {
  const double stepS = base::toSeconds(config.interpolationCycle) / m_steps;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_lags[axis] = lagOf(config.axes[axis].servoTimeConstantS, stepS);
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (config.rotaryAxes[axis]) {
      m_rotaryLags[axis] = lagOf(config.rotaryAxes[axis]->servoTimeConstantS, stepS);
    }
  }
}

LinearServo::Lag LinearServo::lagOf(double timeConstantS, double stepS) {
  Lag lag;
  if (timeConstantS > 0.0) {
    lag.decay = std::exp(-stepS / timeConstantS);
    lag.drag = timeConstantS / stepS * (1.0 - lag.decay);
  }
  return lag;
}

double LinearServo::followOne(const Lag& lag, double actual, double from, double to) const {
  const double step = (to - from) / m_steps;
  double command = from;
  for (int i = 0; i < m_steps; ++i) {
    // Solution of the lag for a set point rising from `command` by `step`.
    actual = command + step + (actual - command) * lag.decay - step * lag.drag;
    command += step;
  }
  return actual;
}

base::Vec3 LinearServo::follow(base::Vec3 fromMm, base::Vec3 toMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_actualMm.set(axis, followOne(m_lags[axis], m_actualMm[axis], fromMm[axis], toMm[axis]));
  }
  return m_actualMm;
}

base::RotaryDeg LinearServo::followDeg(const base::RotaryDeg& fromDeg,
                                       const base::RotaryDeg& toDeg) {
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    m_actualDeg[axis] =
        followOne(m_rotaryLags[axis], m_actualDeg[axis], fromDeg[axis], toDeg[axis]);
  }
  return m_actualDeg;
}

}  // namespace rivulet::machine
