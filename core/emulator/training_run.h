// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The data an emulator is learned from, or tested on: what was asked of the axes and what was seen
/// of them. Frame: machine, as recorded. @threadsafety plain values; pure functions.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace rivulet::emulator {

/// One axis of a run: what was asked of it and what was seen of it.
struct AxisTrack {
  char axis = 'X';                ///< letter: 'X', 'Y', 'Z'
  std::vector<double> reference;  ///< set points, mm, one each TrainingRun::period, from time 0
  std::vector<double> observed;   ///< actual positions, mm, one each entry of observedAt
  std::vector<double> observedMmPerS = {};  ///< actual speeds, likewise; empty: none were seen
};

/// A program that ran on the machine.
struct TrainingRun {
  std::string name;     ///< design, as the figures name it: "G1"
  double period = 0.0;  ///< s, between two set points
  std::vector<AxisTrack> axes;
  std::vector<double> observedAt;  ///< s, ascending, on the time of the reference, spacing as it
                                   ///< comes
};

/// True of data that a model can be computed from: lengths that agree, times that ascend, finite
/// numbers. @return error EmulatorError::BadTimes, BadNumbers
[[nodiscard]] base::Result<void> checkRun(const TrainingRun& run);

}  // namespace rivulet::emulator
