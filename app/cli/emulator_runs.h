// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The runs that the commands of emulators work on. @threadsafety main thread.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "cli/commands.h"
#include "emulator/training_run.h"
#include "learning/recording.h"

namespace rivulet::cli {

/// A trace with set points and actual positions.
[[nodiscard]] base::Result<emulator::TrainingRun> loadRun(const std::string& file,
                                                          const std::string& columns);

/// All files; with programs, set points come from these, planned with the limits of the preset.
/// @return EmulatorError::WrongProgram if there is not one program for each file
[[nodiscard]] base::Result<std::vector<learning::Recording>> loadRecordings(
    const EmulatorOptions& options);

}  // namespace rivulet::cli
