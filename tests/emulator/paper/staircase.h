// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cmath>

#include "emulator/paper/emulation.h"
#include "emulator/training_run.h"

namespace rivulet::tests {

/// A staircase in X and Y, as [P2] G1 but shorter, at a constant speed with exact corners.
inline emulator::TrainingRun staircase(int segments, double lengthMm, double mmPerS,
                                       double sampleS = 0.1) {
  emulator::TrainingRun run{"stairs", 0.001, {{'X', {}, {}, {}}, {'Y', {}, {}, {}}}, {}};
  const double seconds = segments * lengthMm / mmPerS;
  for (double t = 0.0; t <= seconds + 0.5; t += run.period) {
    const double along = std::min(t * mmPerS, segments * lengthMm);
    const int whole = std::min(static_cast<int>(along / lengthMm), segments - 1);
    const double part = along - whole * lengthMm;
    run.axes[0].reference.push_back((whole + 1) / 2 * lengthMm + (whole % 2 == 0 ? part : 0.0));
    run.axes[1].reference.push_back(whole / 2 * lengthMm + (whole % 2 == 1 ? part : 0.0));
  }
  for (double t = 0.0; t <= seconds + 0.5; t += sampleS) {
    run.observedAt.push_back(t);
    for (emulator::AxisTrack& track : run.axes) {
      track.observed.push_back(0.0);
      track.observedMmPerS.push_back(0.0);
    }
  }
  return run;
}

/// The same run, observed of an emulator with these parameters.
inline emulator::TrainingRun observedOf(emulator::TrainingRun run,
                                        const emulator::paper::Parameters& values,
                                        const emulator::paper::PlantSettings& plant) {
  const auto course = emulator::paper::makeCourse(run, plant.stepS);
  const emulator::paper::Emulation emulation = emulator::paper::emulate(*course, values, plant);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    run.axes[axis].observed = emulation.mm[axis];
    run.axes[axis].observedMmPerS = emulation.mmPerS[axis];
  }
  return run;
}

}  // namespace rivulet::tests
