// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "learning/learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "base/sha256.h"
#include "base/units.h"
#include "base/utc.h"
#include "emulator/emulator_error.h"
#include "emulator/monitor.h"
#include "machine/config.h"
#include "platform/utc_now.h"
#include "training/sparse_learning.h"

namespace rivulet::learning {

namespace {

using emulator::EmulatorError;
using emulator::TrainingRun;

/// In a comment, a line stays a line.
std::string oneLine(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c >= 0 && c < ' '; }, '_');
  return text;
}

/// Set points of all recordings come from their programs, or of none.
base::Result<bool> comeFromPrograms(const LearnRequest& request) {
  std::vector<const Recording*> all;
  for (const auto* list : {&request.learnFrom, &request.testOn}) {
    for (const Recording& one : *list) {
      all.push_back(&one);
    }
  }
  const auto planned =
      std::ranges::count_if(all, [](const Recording* one) { return !one->file.program.empty(); });
  if (planned != 0 && static_cast<std::size_t>(planned) != all.size()) {
    return base::fail(EmulatorError::WrongProgram,
                      "Some recordings have a program and others have not: give each its program, "
                      "or none.");
  }
  return planned != 0;
}

/// The limits of an axis in a preset, as far as they were seen.
std::string limitsText(const emulator::AxisLimits& limits) {
  const emulator::SeenLimit& acceleration = limits.accelerationMmPerS2;
  if (!emulator::isReached(acceleration)) {
    return fmt::format(
        "\n# Axis {} was asked for up to {:.4g} mm/s2, which need not be its limit.\n", limits.axis,
        acceleration.value);
  }
  std::string text = fmt::format(
      "\n[axes.{}]\n# Reached {} times by the set points.\naccelerationMmPerS2 = {:.6g}\n",
      limits.axis, acceleration.places, acceleration.value);
  const emulator::SeenLimit& jerk = limits.jerkMmPerS3;
  if (!limits.showsJerk) {
    text += "# Accelerations change too quickly for the jerk to be seen: it is this at least.\n";
  } else if (emulator::isReached(jerk)) {
    text += fmt::format("# Reached {} times.\n", jerk.places);
  } else {
    return text;
  }
  return text + fmt::format("jerkMmPerS3 = {:.6g}\n", jerk.value);
}

}  // namespace

base::Result<Learned> learn(LearnRequest request,
                            const std::function<bool(const emulator::LearnProgress&)>& progress,
                            const std::function<bool()>& isCancelled) {
  const auto isPlanned = comeFromPrograms(request);
  if (!isPlanned) {
    return base::fail(isPlanned.error());
  }
  std::vector<TrainingRun> runs;
  std::string hashes;
  Learned learned;
  for (const Recording& one : request.learnFrom) {
    runs.push_back(one.run);
    hashes += one.hash;
    learned.emulator.runs.push_back(one.run.name);
    learned.feedMmPerSMax = std::max(learned.feedMmPerSMax, factsOf(one).feedMmPerSMax);
  }
  const emulator::LearnOptions options{.progress = progress, .isCancelled = isCancelled};
  if (*isPlanned) {
    auto known = training::learnWithClocks(runs, options);
    if (!known) {
      return base::fail(known.error());
    }
    learned.emulator.axes = std::move(known->axes);
    for (auto* list : {&request.learnFrom, &request.testOn}) {
      for (Recording& one : *list) {
        training::alignClock(one.run, learned.emulator);
        if (auto fits = training::requireSteadyClock(one.run, learned.emulator); !fits) {
          return base::fail(fits.error());
        }
      }
    }
    std::ranges::transform(request.learnFrom, runs.begin(), &Recording::run);
  } else {
    auto axes = emulator::learnAxes(runs, options);
    if (!axes) {
      return base::fail(axes.error());
    }
    learned.emulator.axes = std::move(*axes);
    std::vector<TrainingRun> all = runs;
    std::ranges::transform(request.testOn, std::back_inserter(all), &Recording::run);
    learned.limits = emulator::limitsSeen(all);
  }
  // Short traces are enough to learn from, but not to say what is rare: who monitors is told so.
  static_cast<void>(emulator::measurePeaks(learned.emulator, runs));
  learned.emulator.preset = std::move(request.preset);
  learned.emulator.dataHash = base::sha256Hex(hashes);
  learned.emulator.date = base::utcText(utc::now());
  for (const auto* list : {&request.learnFrom, &request.testOn}) {
    for (const Recording& one : *list) {
      auto fit = emulator::testRun(learned.emulator, one.run);
      if (!fit) {
        return base::fail(fit.error());
      }
      const base::Result<double> jitterS =
          *isPlanned ? training::sampleJitterS(one.run, learned.emulator) : 0.0;
      if (!jitterS) {
        return base::fail(jitterS.error());
      }
      learned.tests.push_back({std::move(*fit), list == &request.testOn, *jitterS});
    }
  }
  learned.recordings = std::move(request.learnFrom);
  std::ranges::move(request.testOn, std::back_inserter(learned.recordings));
  return learned;
}

std::string presetBeside(const std::string& preset, const std::string& output) {
  if (!machine::isPresetPath(preset) || output.empty()) {
    return preset;
  }
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::absolute(output, error).parent_path();
  return fs::absolute(preset, error).lexically_proximate(folder).generic_string();
}

std::string presetText(const Learned& learned) {
  std::string text =
      "# An emulator learned by Rivulet, and a preset of the virtual machine: docs/emulator.md.\n";
  text += fmt::format(
      "# Learned at feeds up to {:.0f} mm/min; what it says of faster ones is not tested.\n",
      base::mmPerMinFromMmPerS(learned.feedMmPerSMax));
  for (const RunTest& test : learned.tests) {
    text += fmt::format("# {} {}: position {:.3f} µm RMS, {:.3f} µm at most.\n",
                        test.isUnseen ? "Tested on" : "Learned from", oneLine(test.fit.name),
                        1e3 * test.fit.positionRmsMm, 1e3 * test.fit.positionMaxMm);
  }
  text += emulator::printEmulator(learned.emulator);
  for (const emulator::AxisLimits& limits : learned.limits) {
    text += limitsText(limits);
  }
  return text;
}

}  // namespace rivulet::learning
