// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <filesystem>

#include "base/file.h"
#include "base/sha256.h"
#include "base/utc.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "emulator/emulator.h"
#include "emulator/emulator_error.h"
#include "report/trace_source.h"
#include "trace/analysis/trace_analysis.h"
#include "utc/now.h"

namespace rivulet::cli {

namespace {

using emulator::Emulator;
using emulator::TrainingRun;
using nlohmann::ordered_json;

/// "data/G1_g61_250hz.csv.zst" is run G1_g61_250hz.
std::string runName(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.'));
}

base::Result<TrainingRun> loadRun(const std::string& file, const std::string& columns) {
  const auto source = report::openTrace(file, columns, 0.0);
  if (!source) {
    return base::fail(source.error());
  }
  return emulator::trainingRunOf(trace::motionOf(source->subject()), runName(file));
}

base::Result<Emulator> loadEmulator(const std::string& file) {
  const auto text = base::readFile(file);
  return text ? emulator::parseEmulator(*text, file) : base::fail(text.error());
}

ordered_json axisJson(const emulator::LearnedAxis& axis) {
  ordered_json json{{"axis", std::string(1, axis.axis)},
                    {"fit_rms_mm", axis.fitRmsMm},
                    {"held_out_rms_mm", axis.heldOutRmsMm}};
  for (const emulator::ParameterEstimate& estimate : axis.estimates) {
    const emulator::AxisParameterFacts& facts = emulator::factsOf(estimate.parameter);
    json["parameters"][std::string(facts.key)] = {{"value", estimate.value},
                                                  {"low", estimate.low},
                                                  {"high", estimate.high},
                                                  {"unit", std::string(facts.unit)}};
  }
  return json;
}

void printAxis(const emulator::LearnedAxis& axis) {
  fmt::print("axis {}: {:.3f} µm RMS on the runs, {:.3f} µm on stretches held out\n", axis.axis,
             1e3 * axis.fitRmsMm, 1e3 * axis.heldOutRmsMm);
  for (const emulator::ParameterEstimate& estimate : axis.estimates) {
    const emulator::AxisParameterFacts& facts = emulator::factsOf(estimate.parameter);
    fmt::print("  {:18} {:>10.5g} {:6} [{:.5g}, {:.5g}]  {}\n", facts.key, estimate.value,
               facts.unit, estimate.low, estimate.high, facts.meaning);
  }
}

}  // namespace

Exit learnEmulator(const EmulatorOptions& options) {
  Emulator learned;
  std::vector<TrainingRun> runs;
  std::string hashes;
  for (const std::string& file : options.files) {
    auto run = loadRun(file, options.columns);
    const auto bytes = base::readFile(file);
    if (!run || !bytes) {
      return reportError(run ? bytes.error() : run.error(), options.json);
    }
    hashes += base::sha256Hex(*bytes);
    learned.runs.push_back(run->name);
    runs.push_back(std::move(*run));
  }
  watchForInterrupt();
  const std::clock_t begin = std::clock();
  auto axes = emulator::learnAxes(
      runs, {.progress = [](const emulator::LearnProgress& progress) {
        if (isTerminal()) {
          fmt::print(stderr, "\raxis {}: structure {} of {}, {:.3f} µm \x1b[K", progress.axis,
                     progress.step, progress.steps, 1e3 * progress.heldOutRmsMm);
        }
        return !wasInterrupted();
      }});
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (isTerminal()) {
    std::fputs("\r\x1b[K", stderr);
  }
  if (!axes) {
    return reportError(axes.error(), options.json);
  }
  learned.axes = std::move(*axes);
  learned.dataHash = base::sha256Hex(hashes);
  learned.date = base::utcText(utc::now());
  if (!options.output.empty()) {
    const std::string head =
        "# An emulator learned by rivulet-cli. docs/emulator.md explains it.\n";
    if (auto done = base::writeFile(options.output, head + emulator::printEmulator(learned));
        !done) {
      return reportError(done.error(), options.json);
    }
  }
  if (options.json) {
    ordered_json json{{"seconds", seconds}, {"data_sha256", learned.dataHash}};
    for (const emulator::LearnedAxis& axis : learned.axes) {
      json["axes"].push_back(axisJson(axis));
    }
    printJson(json);
    return Exit::Done;
  }
  for (const emulator::LearnedAxis& axis : learned.axes) {
    printAxis(axis);
  }
  fmt::print("learned from {} runs in {:.2f} s of one core\n", runs.size(), seconds);
  return Exit::Done;
}

Exit testEmulator(const EmulatorOptions& options) {
  const auto known = loadEmulator(options.emulator);
  if (!known) {
    return reportError(known.error(), options.json);
  }
  ordered_json json = ordered_json::array();
  for (const std::string& file : options.files) {
    const auto run = loadRun(file, options.columns);
    const auto fit = run ? emulator::testRun(*known, *run)
                         : base::Result<emulator::RunFit>(base::fail(run.error()));
    if (!fit) {
      return reportError(fit.error(), options.json);
    }
    if (options.json) {
      json.push_back({{"run", fit->name},
                      {"position_rms_mm", fit->positionRmsMm},
                      {"position_max_mm", fit->positionMaxMm},
                      {"contour_rms_mm", fit->contourRmsMm},
                      {"emulated_contour_rms_mm", fit->emulatedContourRmsMm},
                      {"speed_rms_share", fit->speedRmsShare}});
      continue;
    }
    fmt::print(
        "{}: position {:.3f} µm RMS, {:.3f} µm at most; contour error {:.3f} µm RMS, "
        "emulated {:.3f} µm; speed {:.3f} % of the feed outside corners\n",
        fit->name, 1e3 * fit->positionRmsMm, 1e3 * fit->positionMaxMm, 1e3 * fit->contourRmsMm,
        1e3 * fit->emulatedContourRmsMm, 1e2 * fit->speedRmsShare);
  }
  if (options.json) {
    printJson(json);
  }
  return Exit::Done;
}

Exit simulateEmulator(const EmulatorOptions& options) {
  const auto known = loadEmulator(options.emulator);
  const auto run = loadRun(options.files.front(), options.columns);
  if (!known || !run) {
    return reportError(known ? run.error() : known.error(), options.json);
  }
  std::string csv = "t_s";
  std::vector<std::vector<emulator::AxisState>> states;
  std::vector<const emulator::AxisTrack*> tracks;
  for (const emulator::LearnedAxis& axis : known->axes) {
    for (const emulator::AxisTrack& track : run->axes) {
      if (track.axis == axis.axis) {
        csv += fmt::format(",{0}_set,{0}_emulated,{0}_speed", track.axis);
        tracks.push_back(&track);
        states.push_back(emulator::predict(
            axis.parameters, emulator::setPointGrid(track, run->period, axis.goesStraight),
            run->observedAt));
      }
    }
  }
  csv += '\n';
  for (std::size_t i = 0; i < run->observedAt.size(); ++i) {
    csv += fmt::format("{:.6f}", run->observedAt[i]);
    for (std::size_t axis = 0; axis < tracks.size(); ++axis) {
      csv +=
          fmt::format(",{:.6f},{:.6f},{:.5f}",
                      emulator::cubicAt(tracks[axis]->reference, run->observedAt[i] / run->period),
                      states[axis][i].mm, states[axis][i].mmPerS);
    }
    csv += '\n';
  }
  if (options.output.empty()) {
    std::fputs(csv.c_str(), stdout);
  } else if (auto done = base::writeFile(options.output, csv); !done) {
    return reportError(done.error(), options.json);
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
