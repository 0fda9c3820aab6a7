// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A file as a run that an emulator can be learned from or tested on. @threadsafety any thread.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "emulator/training_run.h"
#include "machine/config.h"

namespace rivulet::learning {

/// What is read.
struct RecordingFile {
  std::string trace;    ///< recording, trace of the control, or table of another tool
  std::string program;  ///< what ran, if the trace is not to be taken for its own set points
  std::string columns;  ///< `trace::parseTableMapping`; empty: as remembered, or guessed

  friend bool operator==(const RecordingFile&, const RecordingFile&) = default;
};

struct Recording {
  RecordingFile file;
  emulator::TrainingRun run;
  std::string hash;  ///< SHA-256 of the trace
};

/// @param machine  its limits plan the set points where they come from a program
/// @return errors of files and traces; EmulatorError::WrongProgram without set points
[[nodiscard]] base::Result<Recording> readRecording(const RecordingFile& file,
                                                    const machine::MachineConfig& machine,
                                                    const base::Budget& budget = {});

/// What is said of a recording beside its name.
struct RecordingFacts {
  double lengthS = 0.0;
  double samplesPerS = 0.0;  ///< of the positions
  std::string axes;          ///< letters of those that move
  double feedMmPerSMax = 0.0;
};
[[nodiscard]] RecordingFacts factsOf(const Recording& recording);

}  // namespace rivulet::learning
