// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What each recording teaches: an emulator learned from it alone, tested on all recordings (the
/// train/test matrix of [P2], with the axes of this folder); and what each parameter is worth on
/// them. @threadsafety pure functions.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "emulator/emulator.h"
#include "emulator/training_run.h"

namespace rivulet::emulator {

/// How much the positions of a run would change if a parameter were a tenth larger.
struct ParameterWorth {
  char axis = 'X';
  AxisParameter parameter = AxisParameter::PositionGain;
  std::vector<double> rmsMm;  ///< of each run
};

struct CrossTest {
  std::vector<std::string> runs;
  /// RMS of the error of position, mm: [run tested on][run learned from]. NaN: from this run
  /// nothing can be learned, or an axis moves in the one that does not move in the other.
  std::vector<std::vector<double>> rmsMm;
  std::vector<ParameterWorth> worth;  ///< of all parameters, in the order of the emulator
};

struct CrossTestOptions {
  std::function<bool(double share)> progress{};  ///< 0 to 1; @return false to stop
  std::function<bool()> isCancelled{};           ///< asked every few milliseconds
};

/// @param emulator  its structure is fitted to each run alone
/// @return EmulatorError::Cancelled, and those of checkRun
[[nodiscard]] base::Result<CrossTest> crossTest(const Emulator& emulator,
                                                std::span<const TrainingRun> runs,
                                                const CrossTestOptions& options = {});

}  // namespace rivulet::emulator
