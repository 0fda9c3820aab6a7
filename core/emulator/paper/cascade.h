// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One axis of the control of [P2] Figure 2 (b): position controller with oscillatory elements,
/// speed and power controllers (PI), electronics, motor, integrator, and delayed feedbacks.
///
///     e  = reference - x'                       v* = p24 (p23 + Σ oscillators) e        (1)
///     u  = p25 (P13 + P14 / s) (v* - κ1 v')                                             (2)
///     κ4 dw/dt = p26 (P15 + P16 / s) (u - κ2 (i' + κ3 p27)) - w'                        (3)
///     di/dt = κ6 (w - κ5 v') - κ7 i'            dv/dt = κ8 i - κ9 v'       dx/dt = v    (4, 5)
///
/// A value with a stroke is that of δt before the beginning of the cycle, where the reference is
/// taken: e(t) = reference(t) - x(t - δt) at each such t. Each is held for one cycle, so between
/// two cycles the axis is a linear system with constant inputs, and the matrix exponential gives
/// its next state without error. The bilinear transform would be an approximation and not less
/// work: the feedbacks leave no loop inside a cycle except those of the oscillators, so most of the
/// matrix is zero, and a step multiplies the rest only.
///
/// @source [P2] eq. (1), (2), (3), (4), (5); Figure 2.
/// @deviation Where the paper is ambiguous:
/// - v stands for the output of the position controller and for the speed of the motor. The first
///   is the set point v* here.
/// - The sum of eq. (1) runs over i and j together: element i has gain p_(i+18).
/// - Eq. (3) needs values of P13 to P16. Kessler's modulus optimum gives the power controller, his
///   symmetrical optimum the speed controller, both for the identified plant (see parameters.h);
///   p13 to p16 are factors on them.
/// - The additive disturbance κ3 has the parameter p27 in Table 1 only: here it is κ3 p27,
/// constant.
/// - Y has two oscillatory elements, and its own numbers for these only.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>

#include "emulator/paper/parameters.h"

namespace rivulet::emulator::paper {

/// An oscillatory element of the position controller: gain ω s / (s² + 2 ζ ω s + ω²).
struct OscillatorParameters {
  double frequency = 0.0;  ///< ω, rad/s
  double damping = 0.0;    ///< ζ
  double gain = 0.0;       ///< 1/s
};

/// Elements of axis X and of axis Y. @source [P2] eq. (1), Table 1
[[nodiscard]] std::array<OscillatorParameters, 4> oscillatorsOfX(const Parameters& values);
[[nodiscard]] std::array<OscillatorParameters, 2> oscillatorsOfY(const Parameters& values);

/// Values that the PI controllers work with. @source [P2] eq. (2), (3)
struct ControllerGains {
  double speedProportional = 0.0;
  double speedIntegral = 0.0;
  double powerProportional = 0.0;
  double powerIntegral = 0.0;
};
[[nodiscard]] ControllerGains controllerGains(const Parameters& values, const PlantSettings& plant);

/// `kOscillators` is 4 for X and 2 for Y.
template <std::size_t kOscillators>
class Cascade {
 public:
  /// At rest at position 0. @param plant  stepS > 0, feedbackDelaySteps within its range
  Cascade(const std::array<OscillatorParameters, kOscillators>& oscillators,
          const Parameters& values, const PlantSettings& plant);

  /// One cycle. Cost: about 80 multiplications for Y and 120 for X.
  void step(double referenceMm) {
    // The oldest makes room for what is sampled now, at the beginning of the cycle.
    const std::array<double, 4> late = m_ring[m_ringAt];
    m_ring[m_ringAt] = {m_tail[kX], m_tail[kV], m_tail[kI], m_tail[kW]};
    if (++m_ringAt == m_ringSize) {
      m_ringAt = 0;
    }
    const double error = referenceMm - late[0];
    const double speed = late[1];
    const double current = late[2];
    const double power = late[3];
    // Three sums that do not wait for each other.
    Tail fromInputs;
    Tail fromTail{};
    Tail fromOscillators{};
    for (std::size_t row = 0; row < kTail; ++row) {
      fromInputs[row] = m_disturbance[row] + m_onTail.error[row] * error +
                        m_onTail.speed[row] * speed + m_onTail.current[row] * current +
                        m_onTail.power[row] * power;
    }
    for (std::size_t column = 0; column < kTail; ++column) {
      for (std::size_t row = 0; row < kTail; ++row) {
        fromTail[row] += m_tailMatrix[column][row] * m_tail[column];
      }
    }
    for (std::size_t i = 0; i < kOscillators; ++i) {
      const Oscillator& one = m_oscillators[i];
      const double a = m_states[i][0];
      const double b = m_states[i][1];
      for (std::size_t row = 0; row < kTail; ++row) {
        fromOscillators[row] += one.tailOfA[row] * a + one.tailOfB[row] * b;
      }
      m_states[i][0] = one.fromA[0] * a + one.fromB[0] * b + one.fromError[0] * error;
      m_states[i][1] = one.fromA[1] * a + one.fromB[1] * b + one.fromError[1] * error;
    }
    for (std::size_t row = 0; row < kTail; ++row) {
      m_tail[row] = fromInputs[row] + (fromTail[row] + fromOscillators[row]);
    }
  }

  [[nodiscard]] double positionMm() const { return m_tail[kX]; }
  [[nodiscard]] double speedMmPerS() const { return m_tail[kV]; }

 private:
  /// States after the oscillators: the integrals of the speed and the power controller, w, i, v, x.
  static constexpr std::size_t kTail = 6;
  static constexpr std::size_t kSpeedIntegral = 0;
  static constexpr std::size_t kPowerIntegral = 1;
  static constexpr std::size_t kW = 2;
  static constexpr std::size_t kI = 3;
  static constexpr std::size_t kV = 4;
  static constexpr std::size_t kX = 5;
  using Tail = std::array<double, kTail>;
  /// Where things are among states and inputs: two states for each oscillator, then the tail, then
  /// the inputs, which do not change within a cycle.
  static constexpr int kFirst = 2 * static_cast<int>(kOscillators);
  static constexpr int kError = kFirst + static_cast<int>(kTail);
  static constexpr int kSpeed = kError + 1;
  static constexpr int kCurrent = kError + 2;
  static constexpr int kPower = kError + 3;
  static constexpr int kDisturbance = kError + 4;
  static constexpr int kSize = kError + 5;

  struct Oscillator {
    std::array<double, 2> fromA{};
    std::array<double, 2> fromB{};
    std::array<double, 2> fromError{};
    Tail tailOfA{};
    Tail tailOfB{};
  };
  struct Inputs {
    Tail error{};
    Tail speed{};
    Tail current{};
    Tail power{};
  };

  /// @param step  what one cycle makes of states and inputs
  template <class Matrix>
  void takeOver(const Matrix& step, double disturbance);

  std::array<Oscillator, kOscillators> m_oscillators{};
  std::array<Tail, kTail> m_tailMatrix{};  ///< by columns
  Inputs m_onTail{};
  Tail m_disturbance{};  ///< what it adds in one cycle

  std::array<std::array<double, 2>, kOscillators> m_states{};
  Tail m_tail{};
  /// x, v, i, w at the beginnings of the last cycles; the entry at m_ringAt is the oldest.
  std::array<std::array<double, 4>, kFeedbackDelayStepsMax> m_ring{};
  std::size_t m_ringAt = 0;
  std::size_t m_ringSize = 1;
};

extern template class Cascade<4>;
extern template class Cascade<2>;

}  // namespace rivulet::emulator::paper
