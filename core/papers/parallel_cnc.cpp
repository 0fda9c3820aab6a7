// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/parallel_cnc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace rivulet::papers {

namespace {

constexpr double kSeconds = kFigure13S;
constexpr double kPerSecond = 1e6;      // the net counts microseconds
constexpr petri::Word kProcessors = 5;  // the plots; [P3] gives no number
constexpr petri::Word kExecutionUs = 10'000;
constexpr std::array<petri::Word, 3> kCyclesMs{2, 10, 15};

struct Policy {
  petri::Word number;
  const char* name;
};
constexpr std::array<Policy, 2> kPolicies{{{0, "task dependency"}, {1, "data flow"}}};

petri::ParameterValues parametersOf(petri::Word cycleMs, petri::Word policy,
                                    petri::Word processors = kProcessors,
                                    petri::Word executionUs = kExecutionUs) {
  return {{"position_cycle", 1000 * cycleMs},
          {"policy", policy},
          {"processors", processors},
          {"execution", executionUs}};
}

double sum(const std::array<double, kBufferCount>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

Plot plotOf(const ParallelRun& run, petri::Word cycleMs, const Policy& policy) {
  Plot plot;
  plot.title = fmt::format("Cycle of position control {} ms, {}", cycleMs, policy.name);
  plot.xLabel = "time (s)";
  plot.yLabel = "data in the buffer";
  for (std::size_t buffer = 0; buffer < kBufferCount; ++buffer) {
    Series series;
    series.name = fmt::format("B{}", buffer + 1);
    series.style = SeriesStyle::Steps;
    for (const ParallelRun::Level& level : run.levels[buffer]) {
      series.x.push_back(level.timeS);
      series.y.push_back(level.level);
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::vector<std::string> rowOf(const std::string& first, const std::string& second,
                               const ParallelRun& run) {
  std::vector<std::string> row{first, second};
  for (std::size_t buffer = 0; buffer < kBufferCount; ++buffer) {
    row.push_back(
        fmt::format("{:.1f} ({:.0f} %)", run.mean[buffer], 100.0 * run.emptyShare[buffer]));
  }
  row.push_back(fmt::format("{:.0f}", run.setPoints));
  row.push_back(fmt::format("{:.0f}", 100.0 * run.waitingShare));
  row.push_back(fmt::format("{:.0f}", run.preemptions));
  return row;
}

const std::vector<std::string> kColumns{
    "B1", "B2", "B3", "B4", "B5", "set points", "position control waits (%)", "preemptions"};

std::vector<std::string> columnsAfter(std::vector<std::string> first) {
  first.insert(first.end(), kColumns.begin(), kColumns.end());
  return first;
}

/// Period in which the tasks make a set point, where position control does not hold them up.
double productionMs(const ParallelRun& run) {
  return 1000.0 * kSeconds / run.setPoints;
}

/// What [P3] finds in its Figure 13; runs by cycle and policy.
using Runs = std::array<std::array<ParallelRun, kPolicies.size()>, kCyclesMs.size()>;

void addChecks(const Runs& runs, Experiment& experiment) {
  const auto check = [&](std::string what, std::string unit, double ours, double lowest,
                         double highest) {
    Check one;
    one.what = std::move(what);
    one.unit = std::move(unit);
    one.source = "[P3] Fig. 13";
    one.ours = ours;
    one.lowest = lowest;
    one.highest = highest;
    experiment.checks.push_back(std::move(one));
  };
  for (std::size_t policy = 0; policy < kPolicies.size(); ++policy) {
    const std::string by = std::string(", ") + kPolicies[policy].name;
    check("2 ms: B5 is near 0, average" + by, "", runs[0][policy].mean[4], 0.0, 1.0);
    check("2 ms: position control often waits for data" + by, "%",
          100.0 * runs[0][policy].waitingShare, 30.0, 100.0);
    check("10 ms: time in which a set point is made, about a cycle" + by, "ms",
          productionMs(runs[1][policy]), 8.0, 12.5);
    check("15 ms: position control is not affected, waits" + by, "%",
          100.0 * runs[2][policy].waitingShare, 0.0, 5.0);
  }
  const auto emptiest = [](const ParallelRun& run) {
    return *std::max_element(run.emptyShare.begin(), run.emptyShare.begin() + 4);
  };
  check("10 ms: B1 to B4 are far above 0, average of the lowest, data flow", "",
        *std::min_element(runs[1][1].mean.begin(), runs[1][1].mean.begin() + 4), 1.0, 50.0);
  check("10 ms: a task often waits for data, share of time at 0, task dependency", "%",
        100.0 * emptiest(runs[1][0]), 50.0, std::numeric_limits<double>::infinity());
}

void addFindings(const Runs& runs, Experiment& experiment) {
  const auto note = [&](std::string text) { experiment.notes.push_back(std::move(text)); };
  note(fmt::format(
      "Finding 1, cycle of 2 ms: the levels stay near 0 and position control often waits. "
      "Supported "
      "for B5 and for task dependency: position control waits {:.0f} % of the time under task "
      "dependency and {:.0f} % under data flow, and B5 holds {:.2f} and {:.2f} on average. "
      "Contradicted for B1 to B4 under data flow, which hold {:.1f} to {:.1f}: that policy serves "
      "a "
      "task only when more waits before it than after it.",
      100.0 * runs[0][0].waitingShare, 100.0 * runs[0][1].waitingShare, runs[0][0].mean[4],
      runs[0][1].mean[4], runs[0][1].mean[3], runs[0][1].mean[0]));
  note(fmt::format(
      "Finding 2, cycle of 10 ms: data is made about as fast as it is used. Supported: a set point "
      "every {:.1f} ms under task dependency and every {:.1f} ms under data flow.",
      productionMs(runs[1][0]), productionMs(runs[1][1])));
  note(fmt::format(
      "Finding 3, cycle of 10 ms: by data flow the levels are far above 0, by task dependency some "
      "tasks are often without data. Supported: on average B1 to B4 hold {:.1f} together by data "
      "flow and {:.2f} by task dependency.",
      sum(runs[1][1].mean) - runs[1][1].mean[4], sum(runs[1][0].mean) - runs[1][0].mean[4]));
  note(fmt::format(
      "Finding 4: data flow therefore needs less time and is more efficient. Contradicted: in {:g} "
      "s "
      "at a cycle of 10 ms, position control sends {:.0f} set points by data flow and {:.0f} by "
      "task "
      "dependency. What lies in the buffers has been worked on and not been used, and a task whose "
      "buffers are level does not run although its data would be needed.",
      kSeconds, runs[1][1].setPoints, runs[1][0].setPoints));
  note(fmt::format(
      "Finding 5, cycle of 15 ms: position control is not affected. Supported: it waits {:.1f} % "
      "and "
      "{:.1f} % of the time, and both policies send {:.0f} and {:.0f} set points. [P3] says here "
      "that "
      "the cycle of the other tasks is greater than that of position control; it is less.",
      100.0 * runs[2][0].waitingShare, 100.0 * runs[2][1].waitingShare, runs[2][0].setPoints,
      runs[2][1].setPoints));
  note(fmt::format(
      "Finding 6: data flow balances the levels only if both are about equally fast. Contradicted: "
      "the average levels of B1 to B5 differ between the policies by {:.1f} in all at 2 ms, {:.1f} "
      "at "
      "10 ms and {:.1f} at 15 ms. What decides is whether processors are scarce: with six there is "
      "nothing to schedule, and both policies give the same run.",
      std::abs(sum(runs[0][1].mean) - sum(runs[0][0].mean)),
      std::abs(sum(runs[1][1].mean) - sum(runs[1][0].mean)),
      std::abs(sum(runs[2][1].mean) - sum(runs[2][0].mean))));
}

/// Table 1 says "execution time 10 ms" and "task cycle 5 ms".
base::Result<Table> readings(Experiment& experiment) {
  Table table;
  table.title =
      "Readings of Table 1 at a cycle of 10 ms: average level (share of time empty) in 3 s";
  table.columns = columnsAfter({"execution (ms), task cycle (ms), processors", "policy"});
  struct Reading {
    petri::Word executionUs;
    petri::Word taskCycleUs;
  };
  std::array<double, 3> made{};
  std::array<double, 3> waits{};
  constexpr std::array<Reading, 3> kReadings{{{10'000, 0}, {10'000, 5'000}, {5'000, 5'000}}};
  for (std::size_t i = 0; i < kReadings.size(); ++i) {
    for (const petri::Word processors : {1, 3, 4, 5, 6}) {
      for (const Policy& policy : kPolicies) {
        petri::ParameterValues parameters =
            parametersOf(10, policy.number, processors, kReadings[i].executionUs);
        parameters["task_cycle"] = kReadings[i].taskCycleUs;
        auto run = runParallelCnc(parameters, kSeconds);
        if (!run) {
          return base::fail(run.error());
        }
        table.rows.push_back(rowOf(fmt::format("{}, {}, {}", kReadings[i].executionUs / 1000,
                                               kReadings[i].taskCycleUs / 1000, processors),
                                   policy.name, *run));
        if (processors == kProcessors && policy.number == 0) {
          made[i] = run->mean[4];
          waits[i] = run->waitingShare;
        }
      }
    }
  }
  experiment.notes.push_back(fmt::format(
      "Table 1 of [P3] contradicts itself: tasks 2 to 5 take 10 ms each time and have "
      "a cycle of 5 ms. "
      "Its text decides: at 10 ms the other tasks are about as fast as position control. "
      "With an execution of 10 ms and five processors they are a little slower (B5 holds "
      "{:.1f}, position control waits {:.0f} % of the time), and starts at multiples of "
      "5 ms change little (B5 {:.1f}, waits {:.0f} %). With 5 ms they are twice as fast, "
      "and B5 fills to {:.1f} on average: 10 ms is the reading that comes nearer.",
      made[0], 100.0 * waits[0], made[1], 100.0 * waits[1], made[2]));
  return table;
}

}  // namespace

petri::ParameterValues figure13Parameters(petri::Word cycleMs, petri::Word policy) {
  return parametersOf(cycleMs, policy);
}

LevelReader::LevelReader(const petri::Net& net) : m_place(net.placeOf("datarec")) {
  const petri::ColourId drec = net.places[m_place].colour;
  m_time = net.offsetOf(drec, "tm");
  m_number = net.offsetOf(drec, "BNO");
  m_data = net.offsetOf(drec, "data");
}

std::optional<BufferLevel> LevelReader::read(const petri::Recorded& recorded) const {
  if (recorded.place != m_place) {
    return std::nullopt;
  }
  const petri::Words& value = *recorded.value;
  return BufferLevel{static_cast<std::size_t>(value[m_number] - 1),
                     static_cast<double>(value[m_time]) / kPerSecond,
                     static_cast<double>(value[m_data])};
}

base::Result<ParallelRun> runParallelCnc(const petri::ParameterValues& parameters, double seconds) {
  const auto net = petri::loadNet("p3", parameters);
  if (!net) {
    return base::fail(net.error());
  }
  ParallelRun run;
  for (auto& levels : run.levels) {
    levels.push_back({});
  }
  const std::size_t timeoutPlace = net->placeOf("Top.CNC.Position.timeout");
  const LevelReader reader(*net);
  petri::Simulator simulator(*net);
  simulator.setRecorder([&](const petri::Recorded& recorded) {
    if (const auto level = reader.read(recorded)) {
      run.levels[level->buffer].push_back(*level);
    } else if (recorded.place == timeoutPlace) {
      run.timeouts += static_cast<double>((*recorded.value)[0]);
    }
  });
  simulator.run(static_cast<petri::Word>(seconds * kPerSecond));
  for (std::size_t buffer = 0; buffer < kBufferCount; ++buffer) {
    auto& levels = run.levels[buffer];
    levels.push_back({buffer, seconds, levels.back().level});
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
      const double lasts = (levels[i + 1].timeS - levels[i].timeS) / seconds;
      run.mean[buffer] += lasts * levels[i].level;
      run.emptyShare[buffer] += levels[i].level == 0.0 ? lasts : 0.0;
    }
  }
  for (std::size_t place = 0; place < net->places.size(); ++place) {
    const std::string& name = net->places[place].name;
    if (!name.ends_with(".record")) {
      continue;
    }
    const petri::Words& record = simulator.marking()[place][0].value;
    const petri::ColourId trec = net->places[place].colour;
    run.preemptions += static_cast<double>(record[net->offsetOf(trec, "ppt")]);
    if (name == "Top.CNC.Position.record") {
      run.setPoints = static_cast<double>(record[net->offsetOf(trec, "cnt")]);
      run.waitingShare =
          static_cast<double>(record[net->offsetOf(trec, "ttwd")]) / kPerSecond / seconds;
    }
  }
  return run;
}

base::Result<Experiment> parallelCncExperiment() {
  Experiment experiment;
  experiment.name = "figure13";
  experiment.title = "Levels of the buffers between the six tasks";
  experiment.setup = fmt::format(
      "The net of [P3] (resources/nets/p3.toml) for {:g} s of simulated time: execution 10 ms for "
      "tasks 1 to 5 and 5 ms for position control, buffers for 50, {} processors, a program "
      "without "
      "end, all buffers empty at the start. [P3] gives neither capacity nor number of processors.",
      kSeconds, kProcessors);
  Table table;
  table.title = "Average level of each buffer (share of time empty) in 3 s";
  table.columns = columnsAfter({"cycle (ms)", "policy"});
  Runs runs;
  for (std::size_t cycle = 0; cycle < kCyclesMs.size(); ++cycle) {
    for (std::size_t policy = 0; policy < kPolicies.size(); ++policy) {
      auto run = runParallelCnc(parametersOf(kCyclesMs[cycle], kPolicies[policy].number), kSeconds);
      if (!run) {
        return base::fail(run.error());
      }
      table.rows.push_back(rowOf(std::to_string(kCyclesMs[cycle]), kPolicies[policy].name, *run));
      experiment.plots.push_back(plotOf(*run, kCyclesMs[cycle], kPolicies[policy]));
      runs[cycle][policy] = std::move(*run);
    }
  }
  experiment.tables.push_back(std::move(table));
  addChecks(runs, experiment);
  addFindings(runs, experiment);
  auto comparison = readings(experiment);
  if (!comparison) {
    return base::fail(comparison.error());
  }
  experiment.tables.push_back(std::move(*comparison));
  return experiment;
}

}  // namespace rivulet::papers
