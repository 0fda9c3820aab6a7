// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A learned emulator as a whole: its axes, what it was learned from, how far off it is on a run,
/// and its file. @threadsafety plain values; pure functions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "emulator/identification.h"
#include "emulator/training_run.h"
#include "trace/motion.h"

namespace rivulet::emulator {

struct Emulator {
  std::vector<LearnedAxis> axes;
  std::vector<std::string> runs;  ///< names of those it was learned from
  std::string dataHash;           ///< SHA-256 of their files, one after another
  std::string date;               ///< ISO 8601, UTC
  /// Preset of the virtual machine that its file completes; empty: it is no preset.
  std::string preset = {};

  /// @return nullptr: it was not learned. @param letter  'X', 'Y', 'Z'
  [[nodiscard]] const LearnedAxis* find(char letter) const;
};

/// What a recorded motion says of X, Y and Z. Set points that came in unequal steps are put on an
/// even grid.
/// @return error EmulatorError::WrongProgram without set points or actual positions, TooShort
[[nodiscard]] base::Result<TrainingRun> trainingRunOf(const trace::Motion& motion,
                                                      const std::string& name);

/// How far the emulator is off on a run, from set points alone. Root mean squares over the
/// observations.
struct RunFit {
  std::string name;
  double positionRmsMm = 0.0;  ///< distance of emulated and observed position
  double positionMaxMm = 0.0;
  double contourRmsMm = 0.0;          ///< of the machine: distance from the path of its set points
  double emulatedContourRmsMm = 0.0;  ///< of the emulator
  double speedRmsShare = 0.0;  ///< error of the velocity outside corners, by the largest path speed
};

/// Samples this long after a large acceleration belong to the corner. A large one is more than
/// kCornerShare of the largest of the run.
inline constexpr double kCornerS = 0.15;
inline constexpr double kCornerShare = 0.6;

/// @return error EmulatorError::NoMotion if the run moves an axis that was not learned; what
/// checkRun says
[[nodiscard]] base::Result<RunFit> testRun(const Emulator& emulator, const TrainingRun& run);

/// An axis that was not learned may be recorded, but must not move.
/// @return error EmulatorError::NoMotion
[[nodiscard]] base::Result<void> requireToStand(const AxisTrack& track, const std::string& run);

/// What must be added to the times of the observations so that the emulator is off least: the
/// clock of a trace need not begin with the program. @param reachS  largest shift looked at
[[nodiscard]] double bestTimeShift(const Emulator& emulator, const TrainingRun& run, double reachS);

/// The file of an emulator. Other tables of the file are left alone: it is a preset of the virtual
/// machine too (machine/config.h).
[[nodiscard]] std::string printEmulator(const Emulator& emulator);
/// @return error EmulatorError::BadFile
[[nodiscard]] base::Result<Emulator> parseEmulator(std::string_view text,
                                                   const std::string& origin);

}  // namespace rivulet::emulator
