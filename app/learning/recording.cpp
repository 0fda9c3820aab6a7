// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "learning/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/file.h"
#include "base/sha256.h"
#include "emulator/emulator.h"
#include "emulator/emulator_error.h"
#include "emulator/identification.h"
#include "report/trace_source.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/import/import.h"
#include "trace/remark.h"
#include "training/sparse_learning.h"

namespace rivulet::learning {

namespace {

/// Speeds are taken over so long, at least: less is noise.
constexpr double kSpeedOverS = 0.02;
/// Of the values of a column: if more are missing, it was recorded less often than others.
constexpr double kDamagedShare = 0.1;

/// "data/G1_g61_250hz.csv.zst" is run G1_g61_250hz.
std::string runName(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.'));
}

/// A table can be looked at where some of its rows are damaged; a model would learn the damage.
base::Result<void> requireSound(const trace::ImportedTrace& imported, const std::string& name) {
  for (const trace::Remark& remark : imported.trace.remarks) {
    if (remark.code == trace::RemarkCode::TimeBackwards ||
        remark.code == trace::RemarkCode::RowsSorted ||
        remark.code == trace::RemarkCode::Sections) {
      return base::fail(emulator::EmulatorError::BadTimes,
                        fmt::format("Time runs backwards at row {}: record the run again, or cut "
                                    "the file there.",
                                    remark.values[1]),
                        name);
    }
  }
  for (const trace::ColumnRole& column : imported.columns) {
    const auto signal =
        std::ranges::find(imported.trace.signalList, column.column, &trace::Signal::name);
    if (!trace::isPosition(column.role) || signal == imported.trace.signalList.end()) {
      continue;
    }
    const auto isBad = [](double value) { return !std::isfinite(value); };
    const auto bad = std::ranges::find_if(signal->values, isBad);
    const auto count = static_cast<double>(std::ranges::count_if(signal->values, isBad));
    if (count > 0.0 && count < kDamagedShare * static_cast<double>(signal->values.size())) {
      return base::fail(emulator::EmulatorError::BadNumbers,
                        fmt::format("Value {} of {} is not a number: leave its row out of the "
                                    "file.",
                                    bad - signal->values.begin() + 1, column.column),
                        name);
    }
  }
  return {};
}

}  // namespace

base::Result<Recording> readRecording(const RecordingFile& file,
                                      const machine::MachineConfig& machine,
                                      const base::Budget& budget) {
  const auto bytes = base::readFile(file.trace, budget);
  if (!bytes) {
    return base::fail(bytes.error());
  }
  const auto source =
      report::openTrace(file.trace, file.columns, 0.0, budget.without(bytes->capacity()));
  if (!source) {
    return base::fail(source.error());
  }
  if (source->imported() != nullptr) {
    if (auto sound = requireSound(*source->imported(), file.trace); !sound) {
      return base::fail(sound.error());
    }
  }
  const trace::Motion motion = trace::motionOf(*source);
  Recording recording{file, {}, base::sha256Hex(*bytes)};
  if (file.program.empty()) {
    auto run = emulator::trainingRunOf(motion, runName(file.trace));
    if (!run) {
      return base::fail(run.error());
    }
    recording.run = std::move(*run);
    return recording;
  }
  const auto program = base::readFile(file.program);
  if (!program) {
    return base::fail(program.error());
  }
  training::TrapezoidRules rules;
  for (std::size_t axis = 0; axis < rules.accelerationMmPerS2.size(); ++axis) {
    rules.accelerationMmPerS2[axis] = machine.axes[axis].accelerationMmPerS2Max;
  }
  auto run = training::runOfProgram(motion, *program, runName(file.trace), rules);
  if (!run) {
    return base::fail(run.error());
  }
  recording.run = std::move(*run);
  return recording;
}

RecordingFacts factsOf(const Recording& recording) {
  const emulator::TrainingRun& run = recording.run;
  RecordingFacts facts;
  if (run.observedAt.size() > 1) {
    facts.lengthS = run.observedAt.back() - run.observedAt.front();
    facts.samplesPerS = static_cast<double>(run.observedAt.size() - 1) / facts.lengthS;
  }
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(kSpeedOverS / run.period)));
  std::vector<double> squares;
  for (const emulator::AxisTrack& track : run.axes) {
    if (emulator::moves(track)) {
      facts.axes += track.axis;
    }
    squares.resize(std::max(squares.size(), track.reference.size()), 0.0);
    for (std::size_t i = stride; i < track.reference.size(); ++i) {
      const double speed = (track.reference[i] - track.reference[i - stride]) /
                           (run.period * static_cast<double>(stride));
      squares[i] += speed * speed;
    }
  }
  if (!squares.empty()) {
    facts.feedMmPerSMax = std::sqrt(*std::ranges::max_element(squares));
  }
  return facts;
}

}  // namespace rivulet::learning
