// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The 34 parameters of [P2] Table 1, and the nine numbers κ1 to κ9 that it takes as given.
/// @threadsafety plain values; pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace rivulet::emulator::paper {

inline constexpr std::size_t kParameterCount = 34;

/// p_i of the paper is at index i - 1; `parameter(p, i)` takes the paper's index.
using Parameters = std::array<double, kParameterCount>;

[[nodiscard]] constexpr double parameter(const Parameters& values, int index) {
  return values[static_cast<std::size_t>(index - 1)];
}

struct ParameterInfo {
  int index = 0;           ///< of p_i, 1 to 34
  std::string_view group;  ///< row of Table 1
  std::string_view meaning;
  std::string_view unit;  ///< empty: a ratio
  double nominal = 1.0;   ///< our value before anything is learned
  double startLow = 0.0;  ///< the first population is drawn from this range
  double startHigh = 1.0;
};

/// In the order of their indices. @source [P2] Table 1
/// @deviation The paper gives neither values nor units nor the range of the first population. Here
/// p13 to p16 are factors on the values that the tuning rules give (the paper: "determined using"
/// these rules "and adjusted" by the genetic algorithm), and p28 to p34 are the ratios of the
/// identified to the true κ1, κ2, κ4, κ6, κ7, κ8, κ9: the seven numbers that the rules need.
[[nodiscard]] const std::array<ParameterInfo, kParameterCount>& parameterTable();

[[nodiscard]] Parameters nominalParameters();

/// κ1 to κ9, and the delay δt. @source [P2] eq. (1) to (5), which give no values.
/// @deviation The default values are ours: a drive of 1 ms cycle with an electrical time constant
/// of 10 ms and a mechanical one of 1 s. The feedbacks are sampled once in `stepS` and held, as a
/// digital control does it. κ4 is twice δt: the power controller's own feedback alone makes eq. (3)
/// unstable for a κ4 of δt or less, whatever the gains are (held, w obeys z² - z + δt/κ4 = 0).
struct PlantSettings {
  double speedFeedback = 1.0;       ///< κ1, gain of the speed fed back to the speed controller
  double currentFeedback = 1.0;     ///< κ2, gain of the current fed back to the power controller
  double currentDisturbance = 1.0;  ///< κ3, added to this current, times p27
  double powerDelayS = 0.002;       ///< κ4, s, lag of the power controller
  double backEmf = 0.02;            ///< κ5, gain of the speed fed back to the electronics
  double electronicsGain = 100.0;   ///< κ6, 1/s
  double electronicsDecay = 100.0;  ///< κ7, 1/s, gain of the current's own feedback
  double motorGain = 100.0;         ///< κ8, mm/s² for each unit of current
  double motorDecay = 1.0;          ///< κ9, 1/s, gain of the speed's own feedback
  double stepS = 0.001;             ///< s, cycle of the control, > 0
  int feedbackDelaySteps = 1;       ///< δt in steps, 1 to kFeedbackDelayStepsMax
};

inline constexpr int kFeedbackDelayStepsMax = 64;

}  // namespace rivulet::emulator::paper
