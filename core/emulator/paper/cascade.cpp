// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/cascade.h"

#include <Eigen/Core>
#include <unsupported/Eigen/MatrixFunctions>

#include "base/contract.h"

namespace rivulet::emulator::paper {

std::array<OscillatorParameters, 4> oscillatorsOfX(const Parameters& values) {
  std::array<OscillatorParameters, 4> elements;
  for (int i = 0; i < 4; ++i) {
    elements[static_cast<std::size_t>(i)] = {parameter(values, 1 + i), parameter(values, 5 + i),
                                             parameter(values, 19 + i)};
  }
  return elements;
}

std::array<OscillatorParameters, 2> oscillatorsOfY(const Parameters& values) {
  return {{{parameter(values, 9), parameter(values, 11), parameter(values, 17)},
           {parameter(values, 10), parameter(values, 12), parameter(values, 18)}}};
}

ControllerGains controllerGains(const Parameters& values, const PlantSettings& plant) {
  const double kappa1 = plant.speedFeedback * parameter(values, 28);
  const double kappa2 = plant.currentFeedback * parameter(values, 29);
  const double kappa4 = plant.powerDelayS * parameter(values, 30);
  const double kappa6 = plant.electronicsGain * parameter(values, 31);
  const double kappa7 = plant.electronicsDecay * parameter(values, 32);
  const double kappa8 = plant.motorGain * parameter(values, 33);
  const double kappa9 = plant.motorDecay * parameter(values, 34);
  // A value that is sampled δt late and then held is late by half a cycle more on average.
  const double delay = plant.stepS * (plant.feedbackDelaySteps + 0.5);

  // Modulus optimum: the controller's zero cancels the slow pole κ7, the gain makes the rest a
  // well-damped lag of twice the sum of the small times.
  const double fastTime = kappa4 + delay;
  const double powerProportional = 1.0 / (2.0 * kappa2 * kappa6 * fastTime);
  const double powerIntegral = powerProportional * kappa7;

  // Symmetrical optimum: the motor counts as an integrator after the closed power loop. For a motor
  // that decays, the integral part is weaker by the rule's correction for a finite time constant.
  const double speedTime = 2.0 * fastTime + delay;
  const double speedProportional = kappa2 / (2.0 * kappa1 * kappa8 * speedTime);
  const double speedIntegral = speedProportional / (4.0 * speedTime) * (1.0 + kappa9 * speedTime);

  return {parameter(values, 13) * speedProportional, parameter(values, 14) * speedIntegral,
          parameter(values, 15) * powerProportional, parameter(values, 16) * powerIntegral};
}

template <std::size_t kOscillators>
Cascade<kOscillators>::Cascade(const std::array<OscillatorParameters, kOscillators>& oscillators,
                               const Parameters& values, const PlantSettings& plant) {
  RIVULET_ASSERT(plant.stepS > 0.0);
  RIVULET_ASSERT(plant.feedbackDelaySteps >= 1);
  RIVULET_ASSERT(plant.feedbackDelaySteps <= kFeedbackDelayStepsMax);
  m_ringSize = static_cast<std::size_t>(plant.feedbackDelaySteps);

  // d(states)/dt = matrix · (states, inputs)
  using Matrix = Eigen::Matrix<double, kSize, kSize>;
  using Row = Eigen::Matrix<double, 1, kSize>;
  Matrix rates = Matrix::Zero();

  const ControllerGains gains = controllerGains(values, plant);
  Row speedSetPoint = Row::Zero();
  speedSetPoint(kError) = parameter(values, 24) * parameter(values, 23);
  for (std::size_t i = 0; i < kOscillators; ++i) {
    const OscillatorParameters& one = oscillators[i];
    const int a = 2 * static_cast<int>(i);
    rates(a, a) = -2.0 * one.damping * one.frequency;
    rates(a, a + 1) = -one.frequency;
    rates(a, kError) = one.frequency;
    rates(a + 1, a) = one.frequency;
    speedSetPoint(a) = parameter(values, 24) * one.gain;
  }
  Row speedError = speedSetPoint;
  speedError(kSpeed) = -plant.speedFeedback;
  rates.row(kFirst + static_cast<int>(kSpeedIntegral)) = speedError;

  Row powerError = parameter(values, 25) * gains.speedProportional * speedError;
  powerError(kFirst + static_cast<int>(kSpeedIntegral)) =
      parameter(values, 25) * gains.speedIntegral;
  powerError(kCurrent) = -plant.currentFeedback;
  powerError(kDisturbance) = -plant.currentFeedback;
  rates.row(kFirst + static_cast<int>(kPowerIntegral)) = powerError;

  Row power = parameter(values, 26) * gains.powerProportional * powerError;
  power(kFirst + static_cast<int>(kPowerIntegral)) = parameter(values, 26) * gains.powerIntegral;
  power(kPower) = -1.0;
  rates.row(kFirst + static_cast<int>(kW)) = power / plant.powerDelayS;

  constexpr int kIRow = kFirst + static_cast<int>(kI);
  rates(kIRow, kFirst + static_cast<int>(kW)) = plant.electronicsGain;
  rates(kIRow, kSpeed) = -plant.electronicsGain * plant.backEmf;
  rates(kIRow, kCurrent) = -plant.electronicsDecay;
  constexpr int kVRow = kFirst + static_cast<int>(kV);
  rates(kVRow, kIRow) = plant.motorGain;
  rates(kVRow, kSpeed) = -plant.motorDecay;
  rates(kFirst + static_cast<int>(kX), kVRow) = 1.0;

  const Matrix step = (rates * plant.stepS).exp();
  takeOver(step, plant.currentDisturbance * parameter(values, 27));
}

template <std::size_t kOscillators>
template <class Matrix>
void Cascade<kOscillators>::takeOver(const Matrix& step, double disturbance) {
  const auto tailOf = [&step](int column) {
    Tail tail;
    for (std::size_t row = 0; row < kTail; ++row) {
      tail[row] = step(kFirst + static_cast<int>(row), column);
    }
    return tail;
  };
  for (std::size_t i = 0; i < kOscillators; ++i) {
    const int a = 2 * static_cast<int>(i);
    m_oscillators[i] = {{step(a, a), step(a + 1, a)},
                        {step(a, a + 1), step(a + 1, a + 1)},
                        {step(a, kError), step(a + 1, kError)},
                        tailOf(a),
                        tailOf(a + 1)};
  }
  for (std::size_t column = 0; column < kTail; ++column) {
    m_tailMatrix[column] = tailOf(kFirst + static_cast<int>(column));
  }
  m_disturbance = tailOf(kDisturbance);
  for (double& one : m_disturbance) {
    one *= disturbance;
  }
  m_onTail = {tailOf(kError), tailOf(kSpeed), tailOf(kCurrent), tailOf(kPower)};
}

template class Cascade<4>;
template class Cascade<2>;

}  // namespace rivulet::emulator::paper
