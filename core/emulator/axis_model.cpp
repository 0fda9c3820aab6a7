// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/axis_model.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace rivulet::emulator {

namespace {

using P = AxisParameter;

constexpr std::array<AxisParameterFacts, kAxisParameterCount> kFacts{{
    {P::PositionGain, "position_gain", "1/s",
     "position loop gain Kv: speed command per mm of following error", 1.0, 500.0, 40.0},
    {P::FeedForward, "feed_forward", "",
     "velocity feed-forward: share of the speed that needs no following error", 0.001, 1.5, 0.5},
    {P::FeedForwardLag, "feed_forward_lag", "s", "filter of the velocity feed-forward", 1e-5, 0.05,
     0.001},
    {P::SpeedGain, "speed_gain", "1/s", "speed loop gain: bandwidth of the speed loop", 5.0, 2000.0,
     100.0},
    {P::ResetTime, "reset_time", "s", "reset time of the speed loop", 0.001, 5.0, 0.02},
    {P::EffortLag, "effort_lag", "s", "lag of current loop and drive", 1e-5, 0.05, 0.002},
    {P::Coulomb, "coulomb_friction", "mm/s2", "Coulomb friction, as the acceleration it costs",
     0.01, 5000.0, 50.0},
    {P::CoulombSpeed, "friction_speed", "mm/s", "speed at which the Coulomb friction is built up",
     0.1, 20.0, 0.5},
    {P::Viscous, "viscous_friction", "1/s", "viscous friction, as the acceleration per speed",
     0.001, 100.0, 1.0},
    {P::Delay, "delay", "s", "delay between set point and position loop", 1e-6, 0.03, 0.001},
    {P::ResonanceHz, "resonance", "Hz", "resonance between motor and load", 5.0, 400.0, 60.0},
    {P::ResonanceDamping, "resonance_damping", "",
     "damping of the resonance, share of the critical", 0.001, 3.0, 0.1},
}};

/// tanh differs from 1 by less than 1e-8 beyond this.
constexpr double kTanhIsOne = 9.5;

/// Several times faster than std::tanh, and off by the last digit of 1 at most.
/// @param x  >= 0
double quickTanh(double x) {
  return x < kTanhIsOne ? 1.0 - 2.0 / (std::exp(2.0 * x) + 1.0) : 1.0;
}

}  // namespace

std::span<const AxisParameterFacts, kAxisParameterCount> axisParameterFacts() {
  return kFacts;
}

const AxisParameterFacts& factsOf(AxisParameter parameter) {
  return kFacts[static_cast<std::size_t>(parameter)];
}

AxisParameters firstOrderLag(double timeConstantS) {
  AxisParameters parameters;
  parameters[P::PositionGain] = 1.0 / timeConstantS;
  return parameters;
}

double followingLagS(const AxisParameters& parameters) {
  return parameters[P::Delay] + (1.0 - parameters[P::FeedForward]) / parameters[P::PositionGain];
}

double delayMax(double stepS) {
  return 60.0 * stepS;  // two steps are needed before and after the place that is interpolated
}

double cubicAt(std::span<const double> values, double place) {
  const auto last = static_cast<double>(values.size() - 1);
  if (!(place > 0.0)) {
    return values.front();
  }
  if (place >= last) {
    return values.back();
  }
  const auto index = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(index);
  const double a = values[index > 0 ? index - 1 : 0];
  const double b = values[index];
  const double c = values[index + 1];
  const double d = values[std::min(index + 2, values.size() - 1)];
  return b +
         0.5 * share *
             (c - a + share * (2.0 * a - 5.0 * b + 4.0 * c - d + share * (3.0 * (b - c) + d - a)));
}

struct AxisSimulator::Matrices {
  Eigen::Matrix<double, kStates, kStates> state = Eigen::Matrix<double, kStates, kStates>::Zero();
  Eigen::Matrix<double, kStates, kInputs> input = Eigen::Matrix<double, kStates, kInputs>::Zero();
};

AxisSimulator::AxisSimulator(const AxisParameters& parameters, double stepS, AxisState setPoint)
    : m_parameters(parameters), m_stepS(stepS) {
  m_parameters[P::Delay] = std::clamp(m_parameters[P::Delay], 0.0, delayMax(stepS));
  const double delay = m_parameters[P::Delay] / stepS;
  m_delaySteps = static_cast<std::size_t>(delay);
  m_delayShare = delay - static_cast<double>(m_delaySteps);
  // Held over a step, a steeper friction would reverse an axis that it can only stop.
  m_parameters[P::CoulombSpeed] =
      std::max({m_parameters[P::CoulombSpeed], 0.3 * m_parameters[P::Coulomb] * stepS, 1e-9});
  discretise();
  rest(setPoint);
}

/// The equations of the file's head as derivatives of (x, v, integral, effort, filtered set point)
/// by (set point, slope, friction).
AxisSimulator::Matrices AxisSimulator::matrices() const {
  using Row = Eigen::Matrix<double, 1, kStates>;
  using InputRow = Eigen::Matrix<double, 1, kInputs>;
  const AxisParameters& p = m_parameters;
  Row error = Row::Zero();  // c - v
  InputRow errorIn = InputRow::Zero();
  error[0] = -p[P::PositionGain];
  error[1] = -1.0;
  errorIn[0] = p[P::PositionGain];
  Matrices m;
  if (const double lag = p[P::FeedForwardLag]; lag > 0.0) {
    error[4] -= p[P::FeedForward] / lag;
    errorIn[0] += p[P::FeedForward] / lag;
    m.state(4, 4) = -1.0 / lag;
    m.input(4, 0) = 1.0 / lag;
  } else {
    errorIn[1] += p[P::FeedForward];
  }
  if (p[P::SpeedGain] <= 0.0) {
    m.state.row(0) = error;
    m.state(0, 1) = 0.0;
    m.input.row(0) = errorIn;
    return m;
  }
  m.state.row(2) = p[P::SpeedGain] / p[P::ResetTime] * error;
  m.input.row(2) = p[P::SpeedGain] / p[P::ResetTime] * errorIn;
  Row effort = p[P::SpeedGain] * error;
  effort[2] += 1.0;
  const InputRow effortIn = p[P::SpeedGain] * errorIn;
  if (const double lag = p[P::EffortLag]; lag > 0.0) {
    m.state.row(3) = effort / lag;
    m.state(3, 3) -= 1.0 / lag;
    m.input.row(3) = effortIn / lag;
    m.state(1, 3) = 1.0;
  } else {
    m.state.row(1) = effort;
    m.input.row(1) = effortIn;
  }
  m.state(1, 1) -= p[P::Viscous];
  m.input(1, 2) = -1.0;
  m.state(0, 1) = 1.0;
  return m;
}

void AxisSimulator::discretise() {
  const Matrices m = matrices();
  constexpr int kAll = kStates + kInputs;
  // The inputs become states that the derivative of the set point drives, so that one exponential
  // holds the answer to states and inputs.
  Eigen::Matrix<double, kAll, kAll> all = Eigen::Matrix<double, kAll, kAll>::Zero();
  all.topLeftCorner<kStates, kStates>() = m.state;
  all.topRightCorner<kStates, kInputs>() = m.input;
  all(kStates, kStates + 1) = 1.0;
  const Eigen::Matrix<double, kAll, kAll> sub = (all * (m_stepS / kSubSteps)).exp();
  const Eigen::Matrix<double, kAll, kAll> half = sub * sub;
  const Eigen::Matrix<double, kAll, kAll> next = half * half;
  for (int row = 0; row < kStates; ++row) {
    for (int column = 0; column < kAll; ++column) {
      m_next[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = next(row, column);
      m_nextSub[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = sub(row, column);
    }
  }
  if (m_parameters[P::ResonanceHz] <= 0.0) {
    return;
  }
  const double omega = 2.0 * 3.14159265358979323846 * m_parameters[P::ResonanceHz];
  const double damping = 2.0 * m_parameters[P::ResonanceDamping] * omega;
  Eigen::Matrix4d load = Eigen::Matrix4d::Zero();
  load(0, 1) = 1.0;
  load.row(1) << -omega * omega, -damping, omega * omega, damping;
  load(2, 3) = 1.0;
  const Eigen::Matrix4d nextLoad = (load * m_stepS).exp();
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 4; ++column) {
      m_nextLoad[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          nextLoad(row, column);
    }
  }
}

double AxisSimulator::friction(double mmPerS) const {
  const double share = mmPerS / m_parameters[P::CoulombSpeed];
  return m_parameters[P::Coulomb] * std::copysign(quickTanh(std::abs(share)), share);
}

void AxisSimulator::rest(AxisState setPoint) {
  const AxisParameters& p = m_parameters;
  const double speed = setPoint.mmPerS;
  for (std::size_t back = 0; back < kDelaySteps; ++back) {
    m_past[(kDelaySteps - back) % kDelaySteps] =
        setPoint.mm - speed * m_stepS * static_cast<double>(back);
  }
  m_pastIndex = 0;
  m_setPointMm = setPoint.mm - speed * p[P::Delay];
  const double lag = (1.0 - p[P::FeedForward]) * speed / p[P::PositionGain];
  m_mmPerSChange = 0.0;
  const double effort = friction(speed) + p[P::Viscous] * speed;
  m_state = {m_setPointMm - lag, speed, effort, p[P::EffortLag] > 0.0 ? effort : 0.0,
             p[P::FeedForwardLag] > 0.0 ? m_setPointMm - speed * p[P::FeedForwardLag] : 0.0};
  m_load = {m_state[0], m_state[1]};
}

double AxisSimulator::delayed(double setPointMm) {
  m_pastIndex = (m_pastIndex + 1) % kDelaySteps;
  m_past[m_pastIndex] = setPointMm;
  const auto at = [&](std::size_t stepsBack) {
    return m_past[(m_pastIndex + kDelaySteps - stepsBack) % kDelaySteps];
  };
  return at(m_delaySteps) + m_delayShare * (at(m_delaySteps + 1) - at(m_delaySteps));
}

void AxisSimulator::advance(const Next& next, double setPointMm, double slope,
                            double frictionHeld) {
  const std::array<double, kStates> from = m_state;
  // What an axis without this lag or filter has no use for stays 0.
  const std::array<bool, kStates> isUsed{true, true, true, m_parameters[P::EffortLag] > 0.0,
                                         m_parameters[P::FeedForwardLag] > 0.0};
  for (std::size_t row = 0; row < kStates; ++row) {
    if (!isUsed[row]) {
      continue;
    }
    const auto& by = next[row];
    m_state[row] = (by[0] * from[0] + by[1] * from[1]) + (by[2] * from[2] + by[3] * from[3]) +
                   (by[4] * from[4] + by[5] * setPointMm) + (by[6] * slope + by[7] * frictionHeld);
  }
}

void AxisSimulator::advanceWithSpeedLoop(double slope) {
  const double before = m_state[1];
  const double built = m_parameters[P::CoulombSpeed];
  const double change = std::abs(m_mmPerSChange);
  if (change > 0.05 * built && std::abs(before) < 5.0 * built + 2.0 * change) {
    double changeSub = m_mmPerSChange / kSubSteps;
    for (int i = 0; i < kSubSteps; ++i) {
      const double was = m_state[1];
      advance(m_nextSub, m_setPointMm + slope * m_stepS * i / kSubSteps, slope,
              friction(was + 0.5 * changeSub));
      changeSub = m_state[1] - was;
    }
  } else {
    advance(m_next, m_setPointMm, slope, friction(before + 0.5 * m_mmPerSChange));
  }
  m_mmPerSChange = m_state[1] - before;
}

/// Position and filtered set point are all there is, and no friction.
void AxisSimulator::advanceWithoutSpeedLoop(double slope) {
  const double before = m_state[0];
  const double filtered = m_state[4];
  const auto next = [&](const std::array<double, kStates + kInputs>& by) {
    return (by[0] * before + by[4] * filtered) + (by[5] * m_setPointMm + by[6] * slope);
  };
  m_state[0] = next(m_next[0]);
  m_state[4] = next(m_next[4]);
  m_state[1] = (m_state[0] - before) / m_stepS;
}

void AxisSimulator::advanceLoad(double fromMm) {
  const std::array<double, 4> motor{m_load[0], m_load[1], fromMm, (m_state[0] - fromMm) / m_stepS};
  for (std::size_t row = 0; row < 2; ++row) {
    const auto& next = m_nextLoad[row];
    m_load[row] = next[0] * motor[0] + next[1] * motor[1] + next[2] * motor[2] + next[3] * motor[3];
  }
}

AxisState AxisSimulator::stepDelayed(double setPointMm) {
  const double slope = (setPointMm - m_setPointMm) / m_stepS;
  const double before = m_state[0];
  if (m_parameters[P::SpeedGain] > 0.0) {
    advanceWithSpeedLoop(slope);
  } else {
    advanceWithoutSpeedLoop(slope);
  }
  m_setPointMm = setPointMm;
  if (m_parameters[P::ResonanceHz] > 0.0) {
    advanceLoad(before);
  }
  return actual();
}

AxisState AxisSimulator::actual() const {
  return m_parameters[P::ResonanceHz] > 0.0 ? AxisState{m_load[0], m_load[1]}
                                            : AxisState{m_state[0], m_state[1]};
}

std::vector<AxisState> simulateAxis(const AxisParameters& parameters, double stepS,
                                    std::span<const double> setPointsMm) {
  std::vector<AxisState> states;
  if (setPointsMm.empty()) {
    return states;
  }
  const double slope = setPointsMm.size() > 1 ? (setPointsMm[1] - setPointsMm[0]) / stepS : 0.0;
  AxisSimulator axis(parameters, stepS, {setPointsMm[0], slope});
  states.reserve(setPointsMm.size());
  states.push_back(axis.actual());
  for (std::size_t i = 1; i < setPointsMm.size(); ++i) {
    states.push_back(axis.step(setPointsMm[i]));
  }
  return states;
}

}  // namespace rivulet::emulator
