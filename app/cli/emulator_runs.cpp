// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/emulator_runs.h"

#include <filesystem>

#include "base/file.h"
#include "emulator/emulator.h"
#include "emulator/emulator_error.h"
#include "experiments/sparse_learning.h"
#include "machine/config.h"
#include "report/trace_source.h"
#include "trace/analysis/trace_analysis.h"

namespace rivulet::cli {

namespace {

using emulator::TrainingRun;

/// "data/G1_g61_250hz.csv.zst" is run G1_g61_250hz.
std::string runName(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.'));
}

}  // namespace

base::Result<TrainingRun> loadRun(const std::string& file, const std::string& columns) {
  const auto source = report::openTrace(file, columns, 0.0);
  if (!source) {
    return base::fail(source.error());
  }
  return emulator::trainingRunOf(trace::motionOf(source->subject()), runName(file));
}

base::Result<std::vector<TrainingRun>> loadRuns(const EmulatorOptions& options) {
  std::vector<TrainingRun> runs;
  if (options.programs.empty()) {
    for (const std::string& file : options.files) {
      auto run = loadRun(file, options.columns);
      if (!run) {
        return base::fail(run.error());
      }
      runs.push_back(std::move(*run));
    }
    return runs;
  }
  if (options.programs.size() != options.files.size()) {
    return base::fail(emulator::EmulatorError::WrongProgram,
                      "Give one --program for each trace, in the same order.");
  }
  const auto machine = machine::loadPreset(options.preset);
  if (!machine) {
    return base::fail(machine.error());
  }
  experiments::TrapezoidRules rules;
  for (std::size_t axis = 0; axis < rules.accelerationMmPerS2.size(); ++axis) {
    rules.accelerationMmPerS2[axis] = machine->axes[axis].accelerationMmPerS2Max;
  }
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    const auto source = report::openTrace(options.files[i], options.columns, 0.0);
    if (!source) {
      return base::fail(source.error());
    }
    const auto program = base::readFile(options.programs[i]);
    if (!program) {
      return base::fail(program.error());
    }
    auto run = experiments::runOfProgram(trace::motionOf(source->subject()), *program,
                                         runName(options.files[i]), rules);
    if (!run) {
      return base::fail(run.error());
    }
    runs.push_back(std::move(*run));
  }
  return runs;
}

}  // namespace rivulet::cli
