// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/file.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/emulator_runs.h"
#include "cli/status_line.h"
#include "emulator/design.h"
#include "emulator/emulator.h"
#include "emulator/emulator_error.h"
#include "emulator/limits.h"
#include "emulator/monitor.h"
#include "learning/learning.h"
#include "machine/config.h"
#include "papers/design_study.h"
#include "platform/interrupt.h"

namespace rivulet::cli {

namespace {

using emulator::Emulator;
using emulator::TrainingRun;
using nlohmann::ordered_json;

base::Result<Emulator> loadEmulator(const std::string& file) {
  const auto text = base::readFile(file, machine::kPresetBytesMax);
  return text ? emulator::parseEmulator(*text, file) : base::fail(text.error());
}

ordered_json axisJson(const emulator::LearnedAxis& axis) {
  ordered_json json{{"axis", std::string(1, axis.axis)},
                    {"fit_rms_mm", axis.fitRmsMm},
                    {"held_out_rms_mm", axis.heldOutRmsMm}};
  for (const emulator::ParameterEstimate& estimate : axis.estimates) {
    const emulator::AxisParameterFacts& facts = emulator::factsOf(estimate.parameter);
    const auto bound = [&estimate](double value) {
      return estimate.hasInterval() ? ordered_json(value) : ordered_json();
    };
    json["parameters"][std::string(facts.key)] = {{"value", estimate.value},
                                                  {"low", bound(estimate.low)},
                                                  {"high", bound(estimate.high)},
                                                  {"unit", std::string(facts.unit)}};
  }
  return json;
}

void printAxis(const emulator::LearnedAxis& axis) {
  fmt::print("axis {}: {:.3f} µm RMS on the runs, {:.3f} µm on stretches held out\n", axis.axis,
             1e3 * axis.fitRmsMm, 1e3 * axis.heldOutRmsMm);
  for (const emulator::ParameterEstimate& estimate : axis.estimates) {
    const emulator::AxisParameterFacts& facts = emulator::factsOf(estimate.parameter);
    fmt::print("  {:18} {:>10.5g} {:6} {}  {}\n", facts.key, estimate.value, facts.unit,
               estimate.hasInterval() ? fmt::format("[{:.5g}, {:.5g}]", estimate.low, estimate.high)
                                      : std::string("no interval"),
               facts.meaning);
  }
  if (std::ranges::none_of(axis.estimates, &emulator::ParameterEstimate::hasInterval)) {
    fmt::print("  No intervals: {}\n", emulator::kNoIntervals);
  }
}

void printLimits(const emulator::AxisLimits& limits) {
  const emulator::SeenLimit& acceleration = limits.accelerationMmPerS2;
  fmt::print("axis {}: {}acceleration {:.5g} mm/s²{}", limits.axis,
             emulator::isReached(acceleration) ? "" : "largest ", acceleration.value,
             emulator::isReached(acceleration)
                 ? fmt::format(", reached {} times", acceleration.places)
                 : std::string(", which need not be its limit"));
  const emulator::SeenLimit& jerk = limits.jerkMmPerS3;
  if (!limits.showsJerk) {
    fmt::print("; jerk at least {:.5g} mm/s³\n", jerk.value);
  } else if (emulator::isReached(jerk)) {
    fmt::print("; jerk {:.5g} mm/s³, reached {} times\n", jerk.value, jerk.places);
  } else {
    fmt::print("\n");
  }
}

ordered_json limitsJson(const emulator::AxisLimits& limits) {
  const auto seen = [](const emulator::SeenLimit& limit) {
    return ordered_json{
        {"value", limit.value}, {"places", limit.places}, {"is_limit", emulator::isReached(limit)}};
  };
  return {{"axis", std::string(1, limits.axis)},
          {"speed_mm_per_s", limits.speedMmPerS},
          {"acceleration_mm_per_s2", seen(limits.accelerationMmPerS2)},
          {"jerk_mm_per_s3", seen(limits.jerkMmPerS3)},
          {"shows_jerk", limits.showsJerk}};
}

void printTest(const emulator::RunFit& fit) {
  fmt::print(
      "{}: position {:.3f} µm RMS, {:.3f} µm at most; contour error {:.3f} µm RMS, "
      "emulated {:.3f} µm; speed {:.3f} % of the feed outside corners\n",
      fit.name, 1e3 * fit.positionRmsMm, 1e3 * fit.positionMaxMm, 1e3 * fit.contourRmsMm,
      1e3 * fit.emulatedContourRmsMm, 1e2 * fit.speedRmsShare);
}

}  // namespace

Exit learnEmulator(const EmulatorOptions& options) {
  auto recordings = loadRecordings(options);
  if (!recordings) {
    return reportError(recordings.error(), options.json);
  }
  interrupt::watch();
  StatusLine line;
  const auto showProgress = [&line](const emulator::LearnProgress& progress) {
    line.show(fmt::format("axis {}: structure {} of {}, {:.3f} µm", progress.axis, progress.step,
                          progress.steps, 1e3 * progress.heldOutRmsMm));
    return true;
  };
  const std::clock_t begin = std::clock();
  const auto learned =
      learning::learn({.learnFrom = std::move(*recordings),
                       .testOn = {},
                       .preset = learning::presetBeside(options.preset, options.output)},
                      showProgress, interrupt::wasSeen);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  line.clear();
  if (!learned) {
    return reportError(learned.error(), options.json);
  }
  if (!options.output.empty()) {
    if (auto done = base::writeFile(options.output, learning::presetText(*learned)); !done) {
      return reportError(done.error(), options.json);
    }
  }
  const std::vector<emulator::LearnedAxis>& axes = learned->emulator.axes;
  if (options.json) {
    ordered_json json{{"seconds", seconds}, {"data_sha256", learned->emulator.dataHash}};
    for (const emulator::LearnedAxis& axis : axes) {
      json["axes"].push_back(axisJson(axis));
    }
    for (const emulator::AxisLimits& limits : learned->limits) {
      json["limits"].push_back(limitsJson(limits));
    }
    printJson(json);
    return Exit::Done;
  }
  for (const emulator::LearnedAxis& axis : axes) {
    printAxis(axis);
  }
  for (const emulator::AxisLimits& limits : learned->limits) {
    printLimits(limits);
  }
  for (const learning::RunTest& test : learned->tests) {
    printTest(test.fit);
    if (test.jitterS > 0.0) {
      fmt::print("{}: times of samples are off by {:.2g} ms (standard deviation)\n", test.fit.name,
                 1e3 * test.jitterS);
    }
  }
  fmt::print("learned from {} runs in {:.2f} s of one core\n", learned->recordings.size(), seconds);
  if (std::ranges::any_of(axes, [](const auto& axis) { return axis.peaks.windows == 0; })) {
    fmt::print(
        stderr,
        "The runs are too short to say how large deviations are at most: \"emulator monitor\" "
        "needs {} s at least.\n",
        emulator::kPeaksMin);
  }
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
    printTest(*fit);
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

Exit monitorEmulator(const EmulatorOptions& options) {
  const auto known = loadEmulator(options.emulator);
  if (!known) {
    return reportError(known.error(), options.json);
  }
  const emulator::MonitorOptions monitor{.falseAlarmsPerHour = options.falseAlarmsPerHour};
  ordered_json json = ordered_json::array();
  bool departs = false;
  for (const std::string& file : options.files) {
    const auto run = loadRun(file, options.columns);
    const auto found =
        run ? emulator::findDeviations(*known, *run, monitor)
            : base::Result<std::vector<emulator::Deviation>>(base::fail(run.error()));
    if (!found) {
      return reportError(found.error(), options.json);
    }
    departs = departs || !found->empty();
    ordered_json marks = ordered_json::array();
    for (const emulator::Deviation& one : *found) {
      marks.push_back({{"axis", std::string(1, one.axis)},
                       {"from_s", one.fromS},
                       {"to_s", one.toS},
                       {"largest_mm", one.largestMm},
                       {"threshold_mm", one.thresholdMm}});
      if (!options.json) {
        fmt::print(
            "{}: axis {} departs from what was expected from {:.2f} s to {:.2f} s, by {:.3f} "
            "µm at most (threshold {:.3f} µm)\n",
            run->name, one.axis, one.fromS, one.toS, 1e3 * one.largestMm, 1e3 * one.thresholdMm);
      }
    }
    if (!options.json && found->empty()) {
      fmt::print("{}: as expected in {:.1f} s (", run->name, run->observedAt.back());
      for (const emulator::LearnedAxis& axis : known->axes) {
        fmt::print("{}{} within {:.3f} µm", &axis == known->axes.data() ? "" : ", ", axis.axis,
                   1e3 * emulator::peakThresholdMm(axis, known->axes.size(), monitor));
      }
      fmt::print(")\n");
    }
    const double beyondS = emulator::secondsBeyondPeaks(*known, *run);
    if (!options.json && beyondS > 0.0) {
      fmt::print(
          "{}: {:.1f} s are faster than what the emulator was learned from: the threshold is "
          "larger there, and no rate of false alarms is promised\n",
          run->name, beyondS);
    }
    json.push_back(
        {{"run", run->name}, {"deviations", std::move(marks)}, {"faster_than_learned_s", beyondS}});
  }
  if (options.json) {
    printJson(json);
  }
  return departs ? Exit::Wrong : Exit::Done;
}

Exit designProgram(const EmulatorOptions& options) {
  const auto known = loadEmulator(options.emulator);
  const auto machine = machine::loadPreset(options.emulator);
  if (!known || !machine) {
    return reportError(known ? machine.error() : known.error(), options.json);
  }
  if (options.box.size() % 2 != 0 || options.box.size() < 4 || options.feeds.size() != 2) {
    return reportError(
        {emulator::EmulatorError::BadNumbers,
         "--box needs least and greatest X, Y and perhaps Z, and --feeds two feeds.", ""},
        options.json);
  }
  emulator::DesignBox box;
  box.minMm.z = box.maxMm.z = machine->axes[2].startMm;
  for (std::size_t axis = 0; 2 * axis < options.box.size() && axis < base::kAxisCount; ++axis) {
    box.minMm.set(axis, options.box[2 * axis]);
    box.maxMm.set(axis, options.box[2 * axis + 1]);
  }
  box.feedMmPerSMin = base::mmPerSFromMmPerMin(options.feeds[0]);
  box.feedMmPerSMax = base::mmPerSFromMmPerMin(options.feeds[1]);
  box.durationS = options.seconds;
  interrupt::watch();
  StatusLine line;
  emulator::DesignOptions design{.seed = options.seed, .progress = [&line](double share) {
                                   line.show(fmt::format("searching: {:.0f} %", 100.0 * share));
                                   return !interrupt::wasSeen();
                                 }};
  // The noise of a position is not larger than what the emulator is off.
  for (const emulator::LearnedAxis& axis : known->axes) {
    design.noiseMm = std::max(design.noiseMm, axis.fitRmsMm);
  }
  const auto proposed =
      emulator::proposeProgram(*known, box, papers::planMovesOn(*machine), design);
  line.clear();
  if (!proposed) {
    return reportError(proposed.error(), options.json);
  }
  const std::string program = emulator::programText(box.minMm, proposed->moves);
  if (!options.output.empty()) {
    if (auto done = base::writeFile(options.output, program); !done) {
      return reportError(done.error(), options.json);
    }
  }
  ordered_json json{{"duration_s", proposed->durationS},
                    {"log_determinant", proposed->logDeterminant},
                    {"program", program},
                    {"parameters", ordered_json::array()}};
  if (!options.json && options.output.empty()) {
    std::fputs(program.c_str(), stdout);
  }
  for (const emulator::ParameterGain& gain : proposed->gains) {
    const emulator::AxisParameterFacts& facts = emulator::factsOf(gain.parameter);
    json["parameters"].push_back({{"axis", std::string(1, gain.axis)},
                                  {"parameter", std::string(facts.key)},
                                  {"known_within", gain.deviationBefore},
                                  {"then_within", gain.deviationAfter}});
    if (!options.json && !options.output.empty()) {
      fmt::print(
          "axis {}: {:18} known within {:.3f} %, then within {:.3f} % (standard deviation)\n",
          gain.axis, facts.key, 100.0 * gain.deviationBefore, 100.0 * gain.deviationAfter);
    }
  }
  if (options.json) {
    printJson(json);
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
