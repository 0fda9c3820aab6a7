// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What emulators score that have learned nothing or next to nothing, and a machine on which that
/// is far from enough: without both, a table of small errors says nothing of learning.
/// @threadsafety pure functions.
#pragma once

#include <array>
#include <cstdint>

#include "emulator/paper/emulation.h"
#include "emulator/paper/learning.h"

namespace rivulet::papers {

/// The machine is where its set point is, at its speed.
[[nodiscard]] emulator::paper::Misfit setPointMisfit(const emulator::paper::Course& course);

/// The parameters before anything is learned (nominalParameters).
[[nodiscard]] emulator::paper::Misfit nominalMisfit(const emulator::paper::Course& course,
                                                    const emulator::paper::PlantSettings& plant);

/// The best candidate that a learning had met after one generation.
[[nodiscard]] emulator::paper::Parameters afterOneGeneration(
    const emulator::paper::Learning& learning);

/// One axis of a machine of the class that [P2] emulates, in equations of its own: a position
/// controller that sees a late position, a speed loop with a lag, dry friction at the motor, and
/// the table on a spring. What a client sees is the table. Default: far from what follows its set
/// points and from the nominal parameters.
struct LaggingAxis {
  double positionGainPerS = 3.0;  ///< Kv; the nominal emulator has 15
  double positionDelayS = 0.002;
  double speedLagS = 0.03;
  double frictionMmPerS2 = 20.0;  ///< what dry friction takes from the acceleration of the motor
  double resonanceHz = 3.0;       ///< of the table on its spring
  double resonanceDamping = 0.15;
};

/// The same run, seen on a machine with these axes. @param axes  of X, of Y
[[nodiscard]] emulator::TrainingRun observedOfMachine(emulator::TrainingRun run,
                                                      const std::array<LaggingAxis, 2>& axes);

}  // namespace rivulet::papers
