// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/wrong_machines.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/contract.h"
#include "papers/access_experiments.h"
#include "papers/meter.h"
#include "papers/stream_experiments.h"
#include "streaming/simulation/scenario.h"

namespace rivulet::papers {

namespace {

using machine::MachineConfig;
using streaming::Scenario;

/// A change of the machine, or of what the client and the program do on it; the other is null.
struct WrongOne {
  const char* name;
  void (*machine)(MachineConfig& config);
  void (*method)(Scenario& scenario);
};

constexpr std::array kWrong{
    WrongOne{"BRISK: no limit of jerk",
             [](MachineConfig& config) { config.resetDynamics = machine::Dynamics::Brisk; },
             nullptr},
    WrongOne{"a hundredth of the jerk",
             [](MachineConfig& config) {
               for (machine::AxisLimits& axis : config.axes) {
                 axis.jerkMmPerS3Max *= 0.01;
               }
             },
             nullptr},
    WrongOne{"twice the access time",
             [](MachineConfig& config) {
               config.access.nodeTimeMean *= 2;
               config.access.nodeTimeDeviation *= 2;
             },
             nullptr},
    WrongOne{"half the access time",
             [](MachineConfig& config) {
               config.access.nodeTimeMean /= 2;
               config.access.nodeTimeDeviation /= 2;
             },
             nullptr},
    WrongOne{"access times without scatter",
             [](MachineConfig& config) { config.access.nodeTimeDeviation = {}; }, nullptr},
    WrongOne{"access times with three times the scatter",
             [](MachineConfig& config) { config.access.nodeTimeDeviation *= 3; }, nullptr},
    WrongOne{"STOPRE without a standstill",
             [](MachineConfig& config) {
               config.standstillMean = {};
               config.standstillDeviation = {};
             },
             nullptr},
    WrongOne{"jumps stop as STOPRE does", [](MachineConfig& config) { config.jumpStops = true; },
             nullptr},
    WrongOne{"interpolation cycle of 8 ms",
             [](MachineConfig& config) { config.interpolationCycle *= 2; }, nullptr},
    WrongOne{
        "interpolation cycle of 5 ms",
        [](MachineConfig& config) { config.interpolationCycle = std::chrono::milliseconds{5}; },
        nullptr},
    WrongOne{"blocks prepared four times as slowly",
             [](MachineConfig& config) { config.blockPreparation *= 4; }, nullptr},
    WrongOne{"blocks prepared four times as fast",
             [](MachineConfig& config) { config.blockPreparation /= 4; }, nullptr},
    WrongOne{"latching 200 ms late", [](MachineConfig& config) { config.relatch *= 12; }, nullptr},
    WrongOne{"one STOPRE instead of two, method signal", nullptr,
             [](Scenario& scenario) {
               scenario.settings.parameters.signalStop = templates::SignalStop::OncePerLoop;
             }},
    WrongOne{"loops of 5 points instead of 7", nullptr,
             [](Scenario& scenario) { scenario.settings.parameters.pointsPerLoop = 5; }},
    WrongOne{"half the δ", nullptr, [](Scenario& scenario) { scenario.settings.deltaMm *= 0.5; }},
    WrongOne{"ten times the δ", nullptr,
             [](Scenario& scenario) { scenario.settings.deltaMm *= 10.0; }},
    WrongOne{"half the feed", nullptr,
             [](Scenario& scenario) { scenario.settings.feedMmPerS *= 0.5; }},
    WrongOne{"twice the feed", nullptr,
             [](Scenario& scenario) { scenario.settings.feedMmPerS *= 2.0; }},
};

/// So few runs that a wrong machine is looked at in seconds.
struct Probe {
  base::Result<Experiment> (*run)(const ExperimentOptions& options);
  std::size_t seeds;
};
/// The last one takes four times as long as all others together.
constexpr std::array kProbes{
    Probe{runTable1, 300}, Probe{runFigure2, 20}, Probe{runSubscription, 20}, Probe{runFigure3, 3},
    Probe{runMethod2, 12}, Probe{runDelta, 5},    Probe{runFigure4, 1}};

/// A check of an experiment on one machine.
struct CheckOutcome {
  std::string name;
  bool isInput = false;
  bool passed = false;
};

base::Result<std::vector<CheckOutcome>> outcomesOf(const ExperimentOptions& options,
                                                   const WrongOne* wrong,
                                                   std::span<const Probe> probes, Meter& meter) {
  ExperimentOptions changed{options.machine, 0, options.executor, {}};
  if (wrong != nullptr && wrong->machine != nullptr) {
    wrong->machine(changed.machine);
  }
  if (wrong != nullptr && wrong->method != nullptr) {
    changed.wrong = wrong->method;
  }
  std::vector<CheckOutcome> outcomes;
  for (const Probe& probe : probes) {
    if (meter.isCancelled()) {
      return Meter::cancelled();
    }
    changed.seeds = probe.seeds;
    const auto result = probe.run(changed);
    if (!result) {
      return base::fail(result.error());
    }
    for (const Check& check : result->checks) {
      outcomes.push_back({fmt::format("`{}`: {}", result->name, check.what),
                          check.mark == Mark::Input, check.passed()});
    }
    meter.add();
  }
  return outcomes;
}

Check zeroCheck(std::string what, double ours) {
  Check check;
  check.what = std::move(what);
  check.source = "this page";
  check.reference = check.lowest = check.highest = 0.0;
  check.ours = ours;
  check.mark = Mark::ByConstruction;
  return check;
}

}  // namespace

base::Result<Experiment> runWrongMachines(const ExperimentOptions& options) {
  const std::span probes(kProbes);
  const bool sparesLast = options.seeds == 1;
  Meter meter(options, (kWrong.size() + 1) * probes.size());
  const auto right = outcomesOf(options, nullptr, probes, meter);
  if (!right) {
    return base::fail(right.error());
  }
  std::vector<std::vector<std::string>> caughtBy(right->size());
  Table machines{"Wrong machines and methods, and the checks that catch them",
                 {"wrong", "caught by", "checks"},
                 {}};
  double missed = 0.0;
  for (const WrongOne& wrong : kWrong) {
    std::vector<std::string> caught;
    std::size_t checked = 0;
    for (const auto part : {probes.first(probes.size() - 1), probes.last(1)}) {
      if (sparesLast && !caught.empty()) {
        meter.add();
        break;
      }
      const auto outcomes = outcomesOf(options, &wrong, part, meter);
      if (!outcomes) {
        return base::fail(outcomes.error());
      }
      for (const CheckOutcome& outcome : *outcomes) {
        RIVULET_ASSERT((*right)[checked].name == outcome.name);
        if ((*right)[checked].passed && !outcome.passed) {
          caught.push_back(outcome.name);
          caughtBy[checked].emplace_back(wrong.name);
        }
        ++checked;
      }
    }
    missed += caught.empty() ? 1.0 : 0.0;
    machines.rows.push_back(
        {wrong.name, std::to_string(caught.size()), fmt::format("{}", fmt::join(caught, "; "))});
  }
  Table checks{"Checks, and the wrong machines and methods that they catch",
               {"check", "catches", "wrong machines and methods"},
               {}};
  double blind = 0.0;
  for (std::size_t i = 0; i < right->size(); ++i) {
    const bool isBlind = caughtBy[i].empty() && (*right)[i].passed && !(*right)[i].isInput;
    blind += isBlind ? 1.0 : 0.0;
    checks.rows.push_back(
        {(*right)[i].name,
         (*right)[i].passed ? std::to_string(caughtBy[i].size()) : "OUTSIDE on the right machine",
         fmt::format("{}", fmt::join(caughtBy[i], "; "))});
  }
  Experiment result;
  result.name = "wrong";
  result.title = "Which check catches which wrong machine";
  result.setup = fmt::format(
      "The experiments of [P1] above, with fewer runs, on the preset and on {} machines and "
      "methods that are wrong in one thing. A check catches one if it passes on the preset and "
      "fails on it.{}",
      kWrong.size(),
      sparesLast ? " Here `figure4` looks only at what no other experiment has caught." : "");
  result.checks = {zeroCheck(fmt::format("wrong machines and methods of {} that no check catches",
                                         kWrong.size()),
                             missed),
                   zeroCheck(fmt::format("checks of {} that catch none, without those of an input",
                                         right->size()),
                             blind)};
  result.tables = {std::move(machines), std::move(checks)};
  return result;
}

}  // namespace rivulet::papers
