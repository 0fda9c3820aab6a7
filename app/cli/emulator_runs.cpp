// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/emulator_runs.h"

#include <utility>

#include "emulator/emulator_error.h"
#include "machine/config.h"

namespace rivulet::cli {

base::Result<emulator::TrainingRun> loadRun(const std::string& file, const std::string& columns) {
  auto recording = learning::readRecording({file, {}, columns}, {}, memoryBudget());
  return recording ? base::Result<emulator::TrainingRun>(std::move(recording->run))
                   : base::fail(recording.error());
}

base::Result<std::vector<learning::Recording>> loadRecordings(const EmulatorOptions& options) {
  if (!options.programs.empty() && options.programs.size() != options.files.size()) {
    return base::fail(emulator::EmulatorError::WrongProgram,
                      "Give one --program for each trace, in the same order.");
  }
  const auto machine = machine::loadPreset(options.preset);
  if (!machine) {
    return base::fail(machine.error());
  }
  std::vector<learning::Recording> recordings;
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    auto recording = learning::readRecording(
        {options.files[i], options.programs.empty() ? std::string() : options.programs[i],
         options.columns},
        *machine, memoryBudget());
    if (!recording) {
      return base::fail(recording.error());
    }
    recordings.push_back(std::move(*recording));
  }
  return recordings;
}

}  // namespace rivulet::cli
