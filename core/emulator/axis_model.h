// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One servo axis, from set point to actual position, in the few parameters of the usual cascade:
///
///   speed command  c = Kv·(r - x) + Kff·dr/dt       r: set point, delayed; dr/dt perhaps filtered
///   drive effort   u = Kp·((c - v) + ∫(c - v)dt/Tn)  perhaps through a lag
///   motion         dv/dt = u - D·v - F·tanh(v/vF),   dx/dt = v
///   load           perhaps on a spring: a resonance between motor and table
///
/// Without a speed gain the speed loop is taken as perfect: dx/dt = c.
/// The effort is measured as an acceleration, so no mass is needed. Units mm, s.
///
/// Discretised exactly for a set point that moves straight within a step (matrix exponential of the
/// linear part). The friction alone is not linear: its force is held over a step at the value it
/// has, extrapolated, in the middle of the step; the error falls with the square of the step. Where
/// the speed passes zero, steps are divided by four.
/// @threadsafety plain values; one `AxisSimulator`, one thread.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace rivulet::emulator {

enum class AxisParameter {
  PositionGain,      ///< Kv
  FeedForward,       ///< Kff
  FeedForwardLag,    ///< of the derivative of the set point
  SpeedGain,         ///< Kp
  ResetTime,         ///< Tn
  EffortLag,         ///< current loop and drive
  Coulomb,           ///< F
  CoulombSpeed,      ///< vF
  Viscous,           ///< D
  Delay,             ///< of the set point
  ResonanceHz,       ///< 0: stiff
  ResonanceDamping,  ///< share of the critical damping
};
inline constexpr std::size_t kAxisParameterCount = 12;

/// A value for each parameter. A part with 0 (lag, delay, resonance, feed-forward) is not there.
class AxisParameters {
 public:
  [[nodiscard]] double operator[](AxisParameter parameter) const {
    return m_values[static_cast<std::size_t>(parameter)];
  }
  [[nodiscard]] double& operator[](AxisParameter parameter) {
    return m_values[static_cast<std::size_t>(parameter)];
  }
  friend bool operator==(const AxisParameters&, const AxisParameters&) = default;

 private:
  std::array<double, kAxisParameterCount> m_values{};
};

/// What is said of a parameter wherever it is shown, and where it can be.
struct AxisParameterFacts {
  AxisParameter parameter;
  std::string_view key;      ///< in files
  std::string_view unit;     ///< empty: a number
  std::string_view meaning;  ///< one phrase
  double min;                ///< of an axis that has this part; > 0 unless the part can be weak
  double max;
  double typical;  ///< where a search begins
};
[[nodiscard]] std::span<const AxisParameterFacts, kAxisParameterCount> axisParameterFacts();
[[nodiscard]] const AxisParameterFacts& factsOf(AxisParameter parameter);

/// Position and speed of an axis.
struct AxisState {
  double mm = 0.0;
  double mmPerS = 0.0;
};

/// actual' = (set point - actual) / T: the simplest axis there is. @param timeConstantS  T, > 0
[[nodiscard]] AxisParameters firstOrderLag(double timeConstantS);

/// How late an axis at constant speed is where its set point was; below 0: it is early.
[[nodiscard]] double followingLagS(const AxisParameters& parameters);

/// An axis that is fed set points one at a time.
class AxisSimulator {
 public:
  /// Starts as an axis that has followed a set point at constant speed for long.
  /// @param stepS  time between two set points, > 0; up to 1 ms the friction is exact enough
  AxisSimulator(const AxisParameters& parameters, double stepS, AxisState setPoint);

  /// The set point moves straight to `setPointMm` within one step. @return the state at its end.
  /// Never allocates.
  AxisState step(double setPointMm) { return stepDelayed(delayed(setPointMm)); }
  /// The same with a set point that has its delay already.
  AxisState stepDelayed(double setPointMm);
  [[nodiscard]] AxisState actual() const;

 private:
  static constexpr int kStates = 5;  ///< x, v, integral, effort, filtered set point
  static constexpr int kInputs = 3;  ///< set point, its slope, friction
  static constexpr std::size_t kDelaySteps = 64;
  static constexpr int kSubSteps = 4;
  using Next = std::array<std::array<double, kStates + kInputs>, kStates>;
  struct Matrices;

  [[nodiscard]] Matrices matrices() const;
  void discretise();
  void rest(AxisState setPoint);
  [[nodiscard]] double delayed(double setPointMm);
  [[nodiscard]] double friction(double mmPerS) const;
  void advance(const Next& next, double setPointMm, double slope, double frictionHeld);
  void advanceWithSpeedLoop(double slope);
  void advanceWithoutSpeedLoop(double slope);
  void advanceLoad(double fromMm);

  AxisParameters m_parameters;
  double m_stepS;
  Next m_next{};
  Next m_nextSub{};                                   ///< of a quarter of a step
  std::array<std::array<double, 4>, 2> m_nextLoad{};  ///< from load, its speed, x, slope of x
  std::array<double, kStates> m_state{};
  std::array<double, 2> m_load{};
  double m_setPointMm = 0.0;
  double m_mmPerSChange = 0.0;               ///< of the speed in the last step
  std::size_t m_delaySteps = 0;              ///< the whole steps of the delay
  double m_delayShare = 0.0;                 ///< what is left of it, in steps
  std::array<double, kDelaySteps> m_past{};  ///< set points, a ring
  std::size_t m_pastIndex = 0;
};

/// Longest delay that an axis with this step can have.
[[nodiscard]] double delayMax(double stepS);

/// Values on an even grid at a place between: the cubic through four neighbours (Catmull-Rom).
/// Beyond the ends: the value at the end. @param place  in steps of the grid
[[nodiscard]] double cubicAt(std::span<const double> values, double place);

/// The answer of an axis to a whole run of set points, from a state as at the beginning of these.
/// @return as many states as set points; the first is the start
[[nodiscard]] std::vector<AxisState> simulateAxis(const AxisParameters& parameters, double stepS,
                                                  std::span<const double> setPointsMm);

}  // namespace rivulet::emulator
