// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "learning/recording.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/file.h"
#include "base/sha256.h"
#include "emulator/emulator.h"
#include "emulator/identification.h"
#include "experiments/sparse_learning.h"
#include "report/trace_source.h"
#include "trace/analysis/trace_analysis.h"

namespace rivulet::learning {

namespace {

/// Speeds are taken over so long, at least: less is noise.
constexpr double kSpeedOverS = 0.02;

/// "data/G1_g61_250hz.csv.zst" is run G1_g61_250hz.
std::string runName(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.'));
}

}  // namespace

base::Result<Recording> readRecording(const RecordingFile& file,
                                      const machine::MachineConfig& machine) {
  const auto bytes = base::readFile(file.trace);
  if (!bytes) {
    return base::fail(bytes.error());
  }
  const auto source = report::openTrace(file.trace, file.columns, 0.0);
  if (!source) {
    return base::fail(source.error());
  }
  const trace::Motion motion = trace::motionOf(source->subject());
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
  experiments::TrapezoidRules rules;
  for (std::size_t axis = 0; axis < rules.accelerationMmPerS2.size(); ++axis) {
    rules.accelerationMmPerS2[axis] = machine.axes[axis].accelerationMmPerS2Max;
  }
  auto run = experiments::runOfProgram(motion, *program, runName(file.trace), rules);
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
