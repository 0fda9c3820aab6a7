// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// From recordings to an emulator that has been tested, and to its file: the same for the command
/// line and the window. @threadsafety any thread; nothing is shared.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "emulator/emulator.h"
#include "emulator/identification.h"
#include "emulator/limits.h"
#include "learning/recording.h"

namespace rivulet::learning {

/// How far the emulator is off on a run.
struct RunTest {
  emulator::RunFit fit;
  bool isUnseen = false;  ///< the run was not learned from
  /// Of the samples' times, standard deviation, s; 0 where set points are of the trace's own clock.
  double jitterS = 0.0;
};

/// An emulator with what it was tested on.
struct Learned {
  emulator::Emulator emulator;
  std::vector<RunTest> tests;         ///< in the order of the recordings
  std::vector<Recording> recordings;  ///< their clocks put right
  double feedMmPerSMax = 0.0;         ///< of those that were learned from
  /// Of the machine's planner; empty if set points come from programs.
  std::vector<emulator::AxisLimits> limits;
};

struct LearnRequest {
  std::vector<Recording> learnFrom;
  std::vector<Recording> testOn;  ///< beside stretches of those learned from
  /// Has what the emulator's file does not say, as in `emulator::Emulator::preset`.
  std::string preset;
};

/// @param progress  see emulator::LearnOptions
/// @return errors of the emulator; EmulatorError::WrongProgram if some recordings have a program
///         and others have set points, or a program does not fit its trace
[[nodiscard]] base::Result<Learned> learn(
    LearnRequest request, const std::function<bool(const emulator::LearnProgress&)>& progress,
    const std::function<bool()>& isCancelled = {});

/// As an emulator's file names a preset: a path begins in the file's own folder.
/// @param output  of the emulator; empty: not known yet
[[nodiscard]] std::string presetBeside(const std::string& preset, const std::string& output);

/// The text of its file: an emulator, and a preset of the virtual machine, with remarks on what it
/// was tested on.
[[nodiscard]] std::string presetText(const Learned& learned);

}  // namespace rivulet::learning
