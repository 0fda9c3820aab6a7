// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The emulator of [P2] on any traces: what `experiment p2` does with three designs.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/commands.h"
#include "cli/emulator_runs.h"
#include "cli/status_line.h"
#include "emulator/paper/study.h"
#include "platform/interrupt.h"
#include "platform/thread_executor.h"
#include "training/sparse_learning.h"

namespace rivulet::cli {

namespace {

using emulator::TrainingRun;
using emulator::paper::Course;
using emulator::paper::LearnSettings;
using emulator::paper::TrainTestMatrix;
using nlohmann::ordered_json;

constexpr double kStepS = 0.001;
constexpr std::size_t kMostImportant = 10;

/// Speeds of the axes as an OPC UA client could have read them.
void addSpeeds(TrainingRun& run) {
  const std::vector<double>& atS = run.observedAt;
  for (emulator::AxisTrack& track : run.axes) {
    track.observedMmPerS.assign(atS.size(), 0.0);
    for (std::size_t i = 1; i + 1 < atS.size(); ++i) {
      track.observedMmPerS[i] =
          (track.observed[i + 1] - track.observed[i - 1]) / (atS[i + 1] - atS[i - 1]);
    }
  }
}

LearnSettings learnSettings(const EmulatorOptions& options) {
  LearnSettings settings;
  settings.lambda = options.lambda;
  settings.genetic.generations = options.generations;
  settings.genetic.seed = options.seed;
  return settings;
}

base::Result<std::vector<Course>> loadCourses(const EmulatorOptions& options) {
  auto recordings = loadRecordings(options);
  if (!recordings) {
    return base::fail(recordings.error());
  }
  std::vector<TrainingRun> runs;
  for (learning::Recording& one : *recordings) {
    runs.push_back(std::move(one.run));
  }
  if (!options.programs.empty()) {
    const auto known = training::learnWithClocks(runs);
    if (!known) {
      return base::fail(known.error());
    }
    for (TrainingRun& run : runs) {
      training::alignClock(run, *known);
      if (auto fits = training::requireSteadyClock(run, *known); !fits) {
        return base::fail(fits.error());
      }
      std::erase_if(run.axes, [](const emulator::AxisTrack& track) { return track.axis == 'Z'; });
    }
  }
  std::vector<Course> courses;
  for (TrainingRun& run : runs) {
    if (options.lambda > 0.0) {
      addSpeeds(run);
    }
    auto course = emulator::paper::makeCourse(emulator::paper::atChangesOfCourse(run), kStepS);
    if (!course) {
      return base::fail(course.error());
    }
    courses.push_back(std::move(*course));
  }
  return courses;
}

base::Result<TrainTestMatrix> study(const EmulatorOptions& options) {
  const auto courses = loadCourses(options);
  if (!courses) {
    return base::fail(courses.error());
  }
  interrupt::watch();
  parallel::ThreadExecutor executor(options.threads);
  StatusLine line;
  return emulator::paper::trainAndTest(
      *courses, learnSettings(options), executor, [&line](double share) {
        line.show(fmt::format("learning: {:.0f} %", 100.0 * share));
        return !interrupt::wasSeen();
      });
}

}  // namespace

Exit emulatorMatrix(const EmulatorOptions& options) {
  const auto matrix = study(options);
  if (!matrix) {
    return reportError(matrix.error(), options.json);
  }
  ordered_json json{{"lambda", matrix->lambda}, {"tests", ordered_json::array()}};
  if (!options.json) {
    fmt::print("root of Q(x, y) in mm, tested (rows) and learned (columns), λ = {:g}\n{:24}",
               options.lambda, "");
    for (const auto& learned : matrix->learned) {
      fmt::print(" {:>20.20}", learned.design);
    }
    fmt::print("\n");
  }
  for (std::size_t test = 0; test < matrix->tests.size(); ++test) {
    const std::string& design = matrix->learned[test].design;
    if (!options.json) {
      fmt::print("{:24.24}", design);
    }
    for (std::size_t from = 0; from < matrix->tests[test].size(); ++from) {
      const emulator::paper::Misfit& misfit = matrix->tests[test][from];
      const double rootMm = std::sqrt(misfit.positionMm2());
      json["tests"].push_back({{"tested_on", design},
                               {"learned_from", matrix->learned[from].design},
                               {"root_q_mm", rootMm},
                               {"objective", misfit.objective(options.lambda)},
                               {"stable_share", misfit.stableShare}});
      if (!options.json) {
        fmt::print(" {:>20}",
                   misfit.stableShare < 1.0 ? "ran away" : fmt::format("{:.4f}", rootMm));
      }
    }
    if (!options.json) {
      fmt::print("\n");
    }
  }
  if (options.json) {
    for (const auto& learned : matrix->learned) {
      json["learned"].push_back({{"from", learned.design},
                                 {"objective", learned.objective()},
                                 {"parameters", learned.values}});
    }
    printJson(json);
  }
  return Exit::Done;
}

Exit emulatorImportance(const EmulatorOptions& options) {
  const auto matrix = study(options);
  if (!matrix) {
    return reportError(matrix.error(), options.json);
  }
  std::vector<emulator::paper::Importance> designs;
  for (const emulator::paper::Learning& learning : matrix->learned) {
    designs.push_back(emulator::paper::importanceOf(learning));
  }
  ordered_json json = ordered_json::array();
  const auto ranked = emulator::paper::rankByImportance(designs);
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    const emulator::paper::ImportanceSpread& one = ranked[i];
    const auto& info = emulator::paper::parameterTable()[static_cast<std::size_t>(one.index - 1)];
    json.push_back({{"parameter", fmt::format("p{}", one.index)},
                    {"meaning", std::string(info.meaning)},
                    {"mean", one.mean},
                    {"least", one.min},
                    {"lower_quartile", one.lowerQuartile},
                    {"median", one.median},
                    {"upper_quartile", one.upperQuartile},
                    {"greatest", one.max}});
    if (!options.json && i < kMostImportant) {
      fmt::print("{:>2}. p{:<3} {:5.1f} % ({:.1f} to {:.1f})  {}\n", i + 1, one.index,
                 100.0 * one.mean, 100.0 * one.min, 100.0 * one.max, info.meaning);
    }
  }
  if (options.json) {
    printJson(json);
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
