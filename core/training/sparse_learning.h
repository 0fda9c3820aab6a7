// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Learning from traces of positions alone, ten a second, as an OPC UA client sees them: the set
/// points come from the programs, by the rules of their planner, and the clock of a trace begins at
/// an unknown time. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "emulator/emulator.h"
#include "emulator/training_run.h"
#include "trace/motion.h"
#include "training/program_course.h"

namespace rivulet::training {

/// X and Y of a trace, with the set points that a planner of these rules makes of the program.
/// @param motion   actual positions; its own set points, if there are any, are not looked at
/// @param program  as `parseRecordedProgram` reads it
/// @return RecordedRunError::Malformed; EmulatorError::TooShort
[[nodiscard]] base::Result<emulator::TrainingRun> runOfProgram(const trace::Motion& motion,
                                                               std::string_view program,
                                                               const std::string& name,
                                                               const TrapezoidRules& rules);

/// Clocks and axes in turn: the shift of a clock is found with the axes, and the axes with it.
/// A part of the shift that is common to all axes cannot be told from a delay of the machine.
/// @param options  progress and isCancelled; the rest is decided here
/// @return what emulator::learnAxes returns
[[nodiscard]] base::Result<emulator::Emulator> learnWithClocks(
    std::vector<emulator::TrainingRun> runs, const emulator::LearnOptions& options = {});

/// Puts the times of a run on the time of its set points.
void alignClock(emulator::TrainingRun& run, const emulator::Emulator& emulator);

/// How far the times of single samples are off, as a standard deviation (by the median deviation,
/// so that corners do not count), s: what is left between trace and emulator, by the speed.
/// Errors of the emulator are in it: the jitter is not larger.
/// @param run  aligned
[[nodiscard]] base::Result<double> sampleJitterS(const emulator::TrainingRun& run,
                                                 const emulator::Emulator& emulator);

/// Set points that were planned with the limits of another machine are early in some places and
/// late in others: their clock cannot be put right.
/// @param run  aligned  @return EmulatorError::WrongProgram, with the place
[[nodiscard]] base::Result<void> requireSteadyClock(const emulator::TrainingRun& run,
                                                    const emulator::Emulator& emulator);

}  // namespace rivulet::training
