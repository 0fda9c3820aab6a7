// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/catalogue.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "base/text.h"
#include "papers/access_experiments.h"
#include "papers/equations.h"
#include "papers/methods.h"
#include "papers/stream_experiments.h"
#include "papers/verdict_draws.h"
#include "papers/wrong_machines.h"

namespace rivulet::papers {

namespace {

using base::Result;

struct Entry {
  std::string_view name;
  Result<Experiment> (*run)(const ExperimentOptions& options);
  Result<Experiment> (*runOn)(const Endpoint& endpoint, const ExperimentOptions& options);
  bool isShareable = false;  ///< its runs go to Executor::numbersOf
};

Result<Experiment> equations(const ExperimentOptions& options) {
  EquationsOptions grid;
  if (options.seeds > 0) {
    grid.runsPerPoint = options.seeds;
  }
  auto result = runEquations(
      grid, options.machine, options.executor, [&](std::size_t done, std::size_t total) {
        return !options.progress ||
               options.progress(static_cast<double>(done) / static_cast<double>(total));
      });
  if (options.progress && !options.progress(1.0)) {
    return base::fail(ExperimentError::Cancelled, "The experiment was cancelled.");
  }
  return result;
}

constexpr std::array kEntries{
    Entry{"table1", runTable1, runTable1On},
    Entry{"figure2", runFigure2, runFigure2On},
    Entry{"subscription", runSubscription, nullptr},
    Entry{"figure3", runFigure3, nullptr},
    Entry{"figure4", runFigure4, nullptr, true},
    Entry{"method2", runMethod2, nullptr},
    Entry{"delta", runDelta, nullptr, true},
    Entry{"equations", equations, nullptr, true},
    Entry{"methods", runMethods, nullptr, true},
    Entry{"verdict", runVerdictDraws, nullptr, true},
    Entry{"wrong", runWrongMachines, nullptr},
};

Result<Entry> find(const std::string& name) {
  for (const Entry& entry : kEntries) {
    if (entry.name == name) {
      return entry;
    }
  }
  return base::fail(ExperimentError::UnknownName,
                    fmt::format("There is no experiment \"{}\". Choose one of {}.", name,
                                fmt::join(experimentNames(), ", ")));
}

}  // namespace

std::error_code make_error_code(ExperimentError code) {
  static const base::NamedCategory category("experiments");
  return {static_cast<int>(code), category};
}

std::vector<std::string> experimentNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) {
    names.emplace_back(entry.name);
  }
  return names;
}

std::vector<std::string> shareableExperiments() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) {
    if (entry.isShareable) {
      names.emplace_back(entry.name);
    }
  }
  return names;
}

Result<Experiment> runExperiment(const std::string& name, const ExperimentOptions& options) {
  const Result<Entry> entry = find(name);
  return entry ? entry->run(options) : base::fail(entry.error());
}

Result<Experiment> runExperimentOn(const std::string& name, const Endpoint& endpoint,
                                   const ExperimentOptions& options) {
  const Result<Entry> entry = find(name);
  if (!entry) {
    return base::fail(entry.error());
  }
  if (entry->runOn == nullptr) {
    return base::fail(ExperimentError::NotOverOpcUa,
                      fmt::format("\"{}\" needs virtual time: leave out --endpoint.", name));
  }
  return entry->runOn(endpoint, options);
}

}  // namespace rivulet::papers
