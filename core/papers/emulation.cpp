// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/emulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include "base/file.h"
#include "base/vec3.h"
#include "emulator/emulator.h"
#include "emulator/limits.h"
#include "papers/learned_machine.h"
#include "papers/planned_run.h"
#include "trace/import/import.h"
#include "trace/motion.h"
#include "training/recorded_run.h"
#include "training/sparse_learning.h"

namespace rivulet::papers {

namespace {

namespace fs = std::filesystem;
using emulator::Emulator;
using emulator::TrainingRun;

/// What may be learned from; the names of all other designs are for tests.
constexpr std::array<std::string_view, 4> kLearnedFrom{"G1", "G2", "G3", "circle"};

struct Runs {
  std::vector<TrainingRun> learned;
  std::vector<TrainingRun> tested;
};

bool isForLearning(std::string_view name) {
  const std::string_view design = name.substr(0, name.find('_'));
  return std::ranges::count(kLearnedFrom, design) > 0;
}

base::Result<Runs> loadRuns(const fs::path& folder) {
  std::error_code error;
  const fs::path data = fs::is_directory(folder / "data", error) ? folder / "data" : folder;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(data, error)) {
    if (entry.is_regular_file(error) && entry.path().string().find(".csv") != std::string::npos) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  Runs runs;
  for (const fs::path& file : files) {
    const auto bytes = base::readFile(file);
    if (!bytes) {
      return base::fail(bytes.error());
    }
    const auto imported = trace::importTrace(*bytes);
    if (!imported) {
      continue;
    }
    const std::string name = file.filename().string();
    auto run = emulator::trainingRunOf(trace::motionOf(*imported), name.substr(0, name.find('.')));
    if (run) {
      (isForLearning(run->name) ? runs.learned : runs.tested).push_back(std::move(*run));
    }
  }
  // "G1_g61" is left out if there is "G1_g61_250hz".
  std::erase_if(runs.learned, [&](const TrainingRun& run) {
    return std::ranges::any_of(
        runs.learned, [&](const TrainingRun& other) { return other.name == run.name + "_250hz"; });
  });
  if (runs.learned.empty() || runs.tested.empty()) {
    return base::fail(training::RecordedRunError::FileUnreadable,
                      "There must be traces of G1, G2, G3 or circles to learn from, and of other "
                      "designs to test.",
                      data.string());
  }
  return runs;
}

std::vector<TrainingRun> loadSparseRuns(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder / "data" / "opcua", error)) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<TrainingRun> runs;
  for (const fs::path& file : files) {
    const auto bytes = base::readFile(file);
    const auto program = base::readFile(folder / "programs" / (file.stem().string() + ".ngc"));
    const auto imported = bytes && program ? trace::importTrace(*bytes)
                                           : base::Result<trace::ImportedTrace>(base::fail(
                                                 bytes ? program.error() : bytes.error()));
    if (!imported) {
      continue;
    }
    auto run =
        training::runOfProgram(trace::motionOf(*imported), *program, file.stem().string(), {});
    if (run) {
      runs.push_back(std::move(*run));
    }
  }
  return runs;
}

std::string number(double value) {
  return fmt::format("{:.3f}", value);
}

Table parameterTable(const Emulator& emulator) {
  Table table{"Learned parameters, with simultaneous 99 % intervals",
              {"axis", "parameter", "value", "interval", "unit", "meaning"},
              {}};
  for (const emulator::LearnedAxis& axis : emulator.axes) {
    for (const emulator::ParameterEstimate& estimate : axis.estimates) {
      const emulator::AxisParameterFacts& facts = emulator::factsOf(estimate.parameter);
      table.rows.push_back(
          {std::string(1, axis.axis), std::string(facts.key), fmt::format("{:.5g}", estimate.value),
           estimate.hasInterval() ? fmt::format("{:.5g} to {:.5g}", estimate.low, estimate.high)
                                  : std::string("none"),
           std::string(facts.unit), std::string(facts.meaning)});
    }
  }
  return table;
}

void addRow(Table& table, const emulator::RunFit& fit) {
  table.rows.push_back({fit.name, number(1e3 * fit.positionRmsMm), number(1e3 * fit.positionMaxMm),
                        number(1e3 * fit.contourRmsMm), number(1e3 * fit.emulatedContourRmsMm),
                        number(1e2 * fit.speedRmsShare)});
}

/// Accelerations that the set points of exact stops reach, beside what is known of their planner.
void addLimits(Experiment& result, const std::vector<TrainingRun>& runs) {
  std::vector<TrainingRun> stops;
  std::ranges::copy_if(runs, std::back_inserter(stops), [](const TrainingRun& run) {
    return run.name.find("_g61") != std::string::npos;
  });
  const machine::MachineConfig known = recordedMachine(kExactStopShare);
  Table table{"Limits that the set points of exact stops show",
              {"axis", "acceleration (mm/s²)", "reached", "documented", "jerk"},
              {}};
  double worstShare = std::numeric_limits<double>::quiet_NaN();
  for (const emulator::AxisLimits& limits : emulator::limitsSeen(stops)) {
    const auto axis = static_cast<std::size_t>(std::ranges::find(base::kAxisNames, limits.axis) -
                                               base::kAxisNames.begin());
    const double isKnown = known.axes[axis].accelerationMmPerS2Max;
    const emulator::SeenLimit& seen = limits.accelerationMmPerS2;
    table.rows.push_back({std::string(1, limits.axis), fmt::format("{:.1f}", seen.value),
                          emulator::isReached(seen) ? fmt::format("{} times", seen.places) : "no",
                          fmt::format("{:.1f}", isKnown),
                          limits.showsJerk ? fmt::format("{:.4g} mm/s³", limits.jerkMmPerS3.value)
                                           : "too quick to be seen"});
    worstShare = std::fmax(worstShare, std::abs(seen.value / isKnown - 1.0));
  }
  result.checks.push_back({.what = "limits of acceleration, from set points, off by, worst axis",
                           .unit = "%",
                           .source = "",
                           .ours = 100.0 * worstShare,
                           .highest = 2.0});
  result.tables.push_back(std::move(table));
}

/// Not a number until a run was tested: without one, no check passes.
constexpr double kNotTested = std::numeric_limits<double>::quiet_NaN();

/// @return RMS of the position, mm
double addFit(Table& table, const emulator::RunFit& fit) {
  table.rows.push_back(
      {fit.name, number(1e3 * fit.positionRmsMm), number(1e3 * fit.positionMaxMm)});
  return fit.positionRmsMm;
}

/// The worst run of other designs, RMS.
struct WorstOfOthers {
  double mm = kNotTested;
  double fittedMm = kNotTested;  ///< with its clock fitted
};

WorstOfOthers testOnOthers(const Emulator& emulator, const std::vector<TrainingRun>& tested,
                           Table& table) {
  WorstOfOthers worst;
  for (TrainingRun run : tested) {
    const auto fit = emulator::testRun(emulator, run);
    const double beganS = run.observedAt.front();
    training::alignClock(run, emulator);
    const auto fitted = emulator::testRun(emulator, run);
    if (fit && fitted) {
      worst.mm = std::fmax(worst.mm, addFit(table, *fit));
      worst.fittedMm = std::fmax(worst.fittedMm, fitted->positionRmsMm);
      table.rows.back().push_back(fmt::format("{:.2f}", 1e3 * (run.observedAt.front() - beganS)));
      table.rows.back().push_back(number(1e3 * fitted->positionRmsMm));
    }
  }
  return worst;
}

/// Each design is predicted from the others. @return RMS of the worst run, mm
base::Result<double> leaveOneOut(const std::vector<TrainingRun>& sparse, Table& table) {
  double worstMm = kNotTested;
  for (const std::string_view design : {"G1", "G2", "G3"}) {
    std::vector<TrainingRun> rest;
    for (const TrainingRun& run : sparse) {
      if (!run.name.starts_with(design)) {
        rest.push_back(run);
      }
    }
    if (rest.empty() || rest.size() == sparse.size()) {
      continue;
    }
    const auto emulator = training::learnWithClocks(rest);
    if (!emulator) {
      return base::fail(emulator.error());
    }
    for (TrainingRun run : sparse) {
      if (run.name.starts_with(design)) {
        training::alignClock(run, *emulator);
        if (const auto fit = emulator::testRun(*emulator, run)) {
          worstMm = std::fmax(worstMm, addFit(table, *fit));
          const auto jitterS = training::sampleJitterS(run, *emulator);
          table.rows.back().push_back(jitterS ? fmt::format("{:.2f}", 1e3 * *jitterS) : "");
        }
      }
    }
  }
  return worstMm;
}

/// What 10 samples a second and the programs are enough for.
base::Result<void> addSparse(Experiment& result, const std::vector<TrainingRun>& sparse,
                             const std::vector<TrainingRun>& tested,
                             const std::function<double()>& cpuSeconds) {
  const double beginS = cpuSeconds();
  const auto all = training::learnWithClocks(sparse);
  const double learnS = cpuSeconds() - beginS;
  if (!all) {
    return base::fail(all.error());
  }
  Table others{
      "Learned from 10 samples a second of G1 to G3 and their programs; tested on the set "
      "points of other designs, with their clocks as they are and with their clocks fitted",
      {"run", "position RMS (µm)", "position max (µm)", "clock off by (ms)",
       "RMS with the clock fitted (µm)"},
      {}};
  Table matrix{
      "Learned from 10 samples a second of the other two of G1 to G3; tested on the "
      "program of the third alone (the clock of its trace is shifted)",
      {"run", "position RMS (µm)", "position max (µm)", "times of samples off by (ms)"},
      {}};
  const WorstOfOthers worst = testOnOthers(*all, tested, others);
  const base::Result<double> worstSparseMm = leaveOneOut(sparse, matrix);
  if (!worstSparseMm) {
    return base::fail(worstSparseMm.error());
  }
  result.checks.push_back({.what = "position on designs not learned from, 10 samples a second, RMS "
                                   "of the worst run, the clock of each fitted",
                           .unit = "mm",
                           .source = "[P2]",
                           .reference = 0.23,
                           .ours = worst.fittedMm,
                           .highest = 0.05});
  result.checks.push_back({.what = "the same on the programs of G1 to G3, each left out in turn",
                           .unit = "mm",
                           .source = "[P2]",
                           .reference = 0.23,
                           .ours = *worstSparseMm,
                           .highest = 0.05});
  result.checks.push_back({.what =
                               "position on designs not learned from, 10 samples a second, with a "
                               "clock that is not fitted",
                           .unit = "mm",
                           .source = "[P2]",
                           .reference = 0.23,
                           .ours = worst.mm,
                           .highest = 0.05});
  result.checks.push_back({.what = "time to learn from 10 samples a second, one core",
                           .unit = "s",
                           .source = "[P2]",
                           .reference = 182.0 * 60.0,
                           .ours = learnS,
                           .highest = 60.0});
  result.tables.push_back(std::move(others));
  result.tables.push_back(std::move(matrix));
  return {};
}

/// Runs of the emulator on set points, and what was worst of those that were not learned from.
base::Result<void> addFits(Experiment& result, const Emulator& emulator, const Runs& runs) {
  const std::vector<std::string> columns{"run",
                                         "position RMS (µm)",
                                         "position max (µm)",
                                         "contour error RMS (µm)",
                                         "emulated (µm)",
                                         "speed RMS outside corners (% of feed)"};
  Table tested{"Designs that were not learned from", columns, {}};
  Table learned{"Runs that were learned from", columns, {}};
  double positionMm = 0.0;
  double contourMm = 0.0;
  double speedShare = 0.0;
  for (const TrainingRun& run : runs.tested) {
    const auto fit = emulator::testRun(emulator, run);
    if (!fit) {
      return base::fail(fit.error());
    }
    addRow(tested, *fit);
    positionMm = std::max(positionMm, fit->positionRmsMm);
    contourMm = std::max(contourMm, std::abs(fit->contourRmsMm - fit->emulatedContourRmsMm));
    speedShare = std::max(speedShare, fit->speedRmsShare);
  }
  for (const TrainingRun& run : runs.learned) {
    if (const auto fit = emulator::testRun(emulator, run)) {
      addRow(learned, *fit);
    }
  }
  result.tables = {std::move(tested), std::move(learned), parameterTable(emulator)};
  result.checks = {
      {.what = "position on designs not learned from, RMS of the worst run",
       .unit = "mm",
       .source = "[P2]",
       .reference = 0.23,
       .ours = positionMm,
       .highest = 0.01},
      {.what = "contour error's RMS, off by, worst run",
       .unit = "mm",
       .source = "",
       .ours = contourMm,
       .highest = 0.005},
      {.what = "speed outside corners, RMS by the feed, worst run",
       .unit = "%",
       .source = "",
       .ours = 100.0 * speedShare,
       .highest = 1.0},
  };
  return {};
}

}  // namespace

base::Result<Experiment> runEmulation(const fs::path& folder,
                                      const std::function<double()>& cpuSeconds) {
  const auto runs = loadRuns(folder);
  if (!runs) {
    return base::fail(runs.error());
  }
  const double beginS = cpuSeconds();
  auto axes = emulator::learnAxes(runs->learned);
  const double learnS = cpuSeconds() - beginS;
  if (!axes) {
    return base::fail(axes.error());
  }
  const Emulator emulator{std::move(*axes), {}, {}, {}};
  Experiment result;
  result.name = "emulator";
  result.title = "An emulator learned from recordings of another controller";
  result.setup = fmt::format(
      "Learned from {} runs of G1, G2, G3 and circles; tested on {} runs of other designs, from "
      "their set points alone.",
      runs->learned.size(), runs->tested.size());
  if (auto done = addFits(result, emulator, *runs); !done) {
    return base::fail(done.error());
  }
  result.checks.push_back({.what = "time to learn, one core",
                           .unit = "s",
                           .source = "[P2]",
                           .reference = 182.0 * 60.0,
                           .ours = learnS,
                           .highest = 5.0});
  addLimits(result, runs->learned);
  std::error_code error;
  if (fs::is_directory(folder / "programs", error)) {
    if (auto done = addPredictedDesigns(result, folder, emulator, runs->tested); !done) {
      return base::fail(done.error());
    }
  }
  if (auto done = addKnownMachines(result); !done) {
    return base::fail(done.error());
  }
  if (const std::vector<TrainingRun> sparse = loadSparseRuns(folder); sparse.size() > 1) {
    if (auto done = addSparse(result, sparse, runs->tested, cpuSeconds); !done) {
      return base::fail(done.error());
    }
  }
  result.notes = {
      "[P2] gives 0.23 to 1.7 mm on the designs of its own machine, from 10 samples a second, "
      "after "
      "182 to 874 minutes; its traces are not public. So the references are not figures for the "
      "same data.",
      "The intervals hold if the model has the structure of the axis. The plant behind these "
      "recordings is not documented."};
  return result;
}

}  // namespace rivulet::papers
