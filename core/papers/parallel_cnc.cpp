// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/parallel_cnc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace rivulet::papers {

namespace {

constexpr double kSeconds = pipeline::kFigure13S;

std::string nameOf(const pipeline::Figure13Reading& reading) {
  return fmt::format("{}; {}, {}; {}", reading.asPrinted ? "printed" : "ordered",
                     reading.executionMs, reading.taskCycleMs, reading.processors);
}

Plot plotOf(const ParallelRun& run, petri::Word cycleMs, const char* policy) {
  Plot plot;
  plot.title = fmt::format("Cycle of position control {} ms, {}", cycleMs, policy);
  plot.xLabel = "time (s)";
  plot.yLabel = "data in the buffer";
  for (std::size_t buffer = 0; buffer < pipeline::kBufferCount; ++buffer) {
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
  for (std::size_t buffer = 0; buffer < pipeline::kBufferCount; ++buffer) {
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

// --- findings
// -------------------------------------------------------------------------------------

constexpr std::size_t kAt2Ms = 0;
constexpr std::size_t kAt10Ms = 1;
constexpr std::size_t kAt15Ms = 2;
constexpr double kOftenWaiting = 0.3;  ///< of the time
constexpr double kNotAffected = 0.05;  ///< of the time
constexpr double kNearZero = 1.0;      ///< items, on average
constexpr double kFarAboveZero = 2.0;  ///< items, on average
constexpr double kOftenEmpty = 0.5;    ///< of the time
constexpr double kEqualSpeed = 0.25;   ///< of the cycle
constexpr double kObvious = 2.0;       ///< times the gain at the other cycles
constexpr std::size_t kWithoutB5 = 4;  ///< buffers before that of position control

double leastLevel(const ParallelRun& run) {
  return *std::min_element(run.mean.begin(), run.mean.begin() + kWithoutB5);
}

double emptiest(const ParallelRun& run) {
  return *std::max_element(run.emptyShare.begin(), run.emptyShare.begin() + kWithoutB5);
}

/// Time in which the tasks make a set point. At 2 ms position control takes all that is made.
double productionMs(const ParallelRun& at2Ms) {
  return 1000.0 * kSeconds / at2Ms.setPoints;
}

Figure13Finding often2Ms(const ParallelRun& dependency, const ParallelRun& flow) {
  return {
      "2 ms: position control often waits for data",
      fmt::format("{:.0f} %, {:.0f} %", 100.0 * dependency.waitingShare, 100.0 * flow.waitingShare),
      std::min(dependency.waitingShare, flow.waitingShare) >= kOftenWaiting};
}

Figure13Finding nearZero2Ms(const ParallelRun& dependency, const ParallelRun& flow) {
  const double highest = *std::max_element(dependency.mean.begin(), dependency.mean.end());
  const double highestByFlow = *std::max_element(flow.mean.begin(), flow.mean.end());
  return {"2 ms: all buffers are near 0", fmt::format("{:.1f}, {:.1f}", highest, highestByFlow),
          std::max(highest, highestByFlow) <= kNearZero};
}

Figure13Finding equalSpeed10Ms(const ParallelRun& dependency, const ParallelRun& flow) {
  const auto isEqual = [](double ms) {
    const auto cycleMs = static_cast<double>(pipeline::kFigure13CyclesMs[kAt10Ms]);
    return std::abs(ms / cycleMs - 1.0) <= kEqualSpeed;
  };
  const double ms = productionMs(dependency);
  const double msByFlow = productionMs(flow);
  return {"10 ms: data is made about as fast as it is used",
          fmt::format("{:.1f} ms, {:.1f} ms", ms, msByFlow), isEqual(ms) && isEqual(msByFlow)};
}

Figure13Finding farAboveZero10Ms(const ParallelRun& dependency, const ParallelRun& flow) {
  return {"10 ms: by data flow the levels are far above 0, else a task is often without data",
          fmt::format("{:.1f}, {:.0f} %", leastLevel(flow), 100.0 * emptiest(dependency)),
          leastLevel(flow) >= kFarAboveZero && emptiest(dependency) >= kOftenEmpty};
}

Figure13Finding moreByFlow10Ms(const ParallelRun& dependency, const ParallelRun& flow) {
  return {"10 ms: data flow is more efficient",
          fmt::format("{:.0f}, {:.0f}", dependency.setPoints, flow.setPoints),
          flow.setPoints > dependency.setPoints};
}

Figure13Finding notAffected15Ms(const ParallelRun& dependency, const ParallelRun& flow) {
  return {
      "15 ms: position control is not affected",
      fmt::format("{:.0f} %, {:.0f} %", 100.0 * dependency.waitingShare, 100.0 * flow.waitingShare),
      std::max(dependency.waitingShare, flow.waitingShare) <= kNotAffected};
}

Figure13Finding balanceOnlyAt10Ms(const Figure13Runs& runs) {
  std::array<double, pipeline::kFigure13CyclesMs.size()> gain{};
  for (std::size_t i = 0; i < gain.size(); ++i) {
    gain[i] = leastLevel(runs.byDataFlow[i]) - leastLevel(runs.byDependency[i]);
  }
  return {"data flow balances obviously at 10 ms only",
          fmt::format("{:+.1f}, {:+.1f}, {:+.1f}", gain[kAt2Ms], gain[kAt10Ms], gain[kAt15Ms]),
          gain[kAt10Ms] > 0.0 && gain[kAt10Ms] >= kObvious * std::max(gain[kAt2Ms], gain[kAt15Ms])};
}

// --- tables
// ---------------------------------------------------------------------------------------

/// Which readings support which finding; the checks count them.
base::Result<Table> readings(Experiment& experiment) {
  Table table;
  table.title = "Readings of Table 1 and what [P3] finds: verdict (our figures)";
  table.columns = {"priorities; execution, task cycle (ms); processors"};
  std::vector<std::size_t> supporting;
  std::size_t alike = 0;
  const std::vector<pipeline::Figure13Reading> all = pipeline::figure13Readings();
  for (const pipeline::Figure13Reading& reading : all) {
    const auto runs = runFigure13(reading);
    if (!runs) {
      return base::fail(runs.error());
    }
    const std::vector<Figure13Finding> findings = findingsOf(*runs);
    supporting.resize(findings.size());
    std::vector<std::string> row{nameOf(reading)};
    std::size_t held = 0;
    for (std::size_t i = 0; i < findings.size(); ++i) {
      row.push_back(
          fmt::format("{} ({})", findings[i].isSupported ? "yes" : "no", findings[i].ours));
      supporting[i] += findings[i].isSupported ? 1U : 0U;
      held += findings[i].isSupported ? 1U : 0U;
      if (table.rows.empty()) {
        table.columns.emplace_back(findings[i].what);
        Check check;
        check.what = fmt::format("{}: readings that show it, of {}", findings[i].what, all.size());
        check.source = "[P3] Fig. 13";
        check.lowest = 1.0;
        experiment.checks.push_back(std::move(check));
      }
    }
    row.push_back(fmt::format("{} of {}", held, findings.size()));
    alike += runs->byDependency[kAt10Ms].mean == runs->byDataFlow[kAt10Ms].mean ? 1U : 0U;
    table.rows.push_back(std::move(row));
  }
  table.columns.emplace_back("supported");
  for (std::size_t i = 0; i < supporting.size(); ++i) {
    experiment.checks[i].ours = static_cast<double>(supporting[i]);
    experiment.notes.push_back(fmt::format(
        "{}: {} under {} of {} readings.",
        experiment.checks[i].what.substr(0, experiment.checks[i].what.find(": readings")),
        supporting[i] == 0 ? "contradicted; shown" : "shown", supporting[i], all.size()));
  }
  experiment.notes.push_back(fmt::format(
      "Under {} of {} readings both policies fill the buffers alike at 10 ms.", alike, all.size()));
  return table;
}

/// Where position control takes a processor from another task.
base::Result<Table> preemptions(Experiment& experiment) {
  constexpr std::array<petri::Word, 5> kCyclesMs{2, 10, 15, 12, 13};
  struct Count {
    double releases = 0.0;
    double atEnd = 0.0;
    double preemptions = 0.0;
  };
  Count published;  // the cycles of [P3], 10 ms
  Count others;
  Table table;
  table.title =
      "Preemptions, of the times that position control became ready (at an instant at which a task "
      "ended)";
  table.columns = {"priorities; execution, task cycle (ms); processors", "policy"};
  for (const petri::Word cycleMs : kCyclesMs) {
    table.columns.push_back(fmt::format("cycle {} ms", cycleMs));
  }
  for (const pipeline::Figure13Reading& reading : pipeline::figure13Readings()) {
    if (reading.processors != pipeline::Figure13Reading{}.processors) {
      continue;
    }
    for (const bool dataFlow : {false, true}) {
      if (dataFlow && !reading.asPrinted) {
        continue;  // the same run: by data flow the priorities are equal
      }
      std::vector<std::string> row{nameOf(reading), dataFlow ? "data flow" : "task dependency"};
      for (std::size_t i = 0; i < kCyclesMs.size(); ++i) {
        const auto run =
            runParallelCnc(pipeline::figure13Parameters(reading, kCyclesMs[i], dataFlow), kSeconds);
        if (!run) {
          return base::fail(run.error());
        }
        row.push_back(fmt::format("{:.0f} of {:.0f} ({:.0f})", run->preemptions, run->releases,
                                  run->releasesAtEnd));
        if (reading.executionMs == pipeline::Figure13Reading{}.executionMs) {
          Count& count = i < pipeline::kFigure13CyclesMs.size() ? published : others;
          count.releases += run->releases;
          count.atEnd += run->releasesAtEnd;
          count.preemptions += run->preemptions;
        }
      }
      table.rows.push_back(std::move(row));
    }
  }
  experiment.notes.push_back(fmt::format(
      "Position control takes a processor from another task only if it becomes ready while none is "
      "free. With tasks of 10 ms and the cycles of [P3] it became ready {:.0f} times, {:.0f} of "
      "these at an instant at which a task ended and gave its processor back, and preempted {:.0f} "
      "times: all times are multiples of 5 ms, or it had waited for the datum that the task that "
      "ended made. With cycles of 12 and 13 ms it became ready {:.0f} times, {:.0f} of these at "
      "such an instant, and preempted {:.0f} times.",
      published.releases, published.atEnd, published.preemptions, others.releases, others.atEnd,
      others.preemptions));
  return table;
}

}  // namespace

base::Result<Figure13Runs> runFigure13(const pipeline::Figure13Reading& reading) {
  Figure13Runs runs;
  for (std::size_t i = 0; i < pipeline::kFigure13CyclesMs.size(); ++i) {
    for (const bool dataFlow : {false, true}) {
      auto run = runParallelCnc(
          pipeline::figure13Parameters(reading, pipeline::kFigure13CyclesMs[i], dataFlow),
          kSeconds);
      if (!run) {
        return base::fail(run.error());
      }
      (dataFlow ? runs.byDataFlow : runs.byDependency)[i] = std::move(*run);
    }
  }
  return runs;
}

std::vector<Figure13Finding> findingsOf(const Figure13Runs& runs) {
  const auto both = [&](auto finding, std::size_t cycle) {
    return finding(runs.byDependency[cycle], runs.byDataFlow[cycle]);
  };
  return {both(often2Ms, kAt2Ms),        both(nearZero2Ms, kAt2Ms),
          both(equalSpeed10Ms, kAt2Ms),  both(farAboveZero10Ms, kAt10Ms),
          both(moreByFlow10Ms, kAt10Ms), both(notAffected15Ms, kAt15Ms),
          balanceOnlyAt10Ms(runs)};
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
  const pipeline::LevelReader reader(*net);
  petri::Simulator simulator(*net);
  simulator.setRecorder([&](const petri::Recorded& recorded) {
    if (const auto level = reader.read(recorded)) {
      run.levels[level->buffer].push_back(*level);
    } else if (recorded.place == timeoutPlace) {
      run.timeouts += static_cast<double>((*recorded.value)[0]);
    }
  });
  const std::size_t ready = net->transitionOf("Top.CNC.Position.datacheck");
  const std::size_t ended = net->transitionOf("Top.SCHED.complete");
  petri::Word endedAt = -1;
  simulator.setWatcher([&](std::size_t transition, petri::Word time) {
    if (transition == ended) {
      endedAt = time;
    } else if (transition == ready) {
      run.releases += 1.0;
      run.releasesAtEnd += endedAt == time ? 1.0 : 0.0;
    }
  });
  simulator.run(static_cast<petri::Word>(seconds * pipeline::kNetUnitsPerS));
  for (std::size_t buffer = 0; buffer < pipeline::kBufferCount; ++buffer) {
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
      run.waitingShare = static_cast<double>(record[net->offsetOf(trec, "ttwd")]) /
                         pipeline::kNetUnitsPerS / seconds;
    }
  }
  return run;
}

base::Result<Experiment> parallelCncExperiment() {
  Experiment experiment;
  experiment.name = "figure13";
  experiment.title = "Levels of the buffers between the six tasks";
  experiment.setup = fmt::format(
      "The net of [P3] (resources/nets/p3.toml) for {:g} s of simulated time: position control "
      "takes "
      "5 ms, buffers for 50, a program without end, all buffers empty at the start. [P3] gives "
      "neither capacity nor number of processors, and its Table 1 contradicts its text: it prints "
      "the priority 3 for tasks 1 to 5 (the function cptask then lets the smallest ID go first), "
      "while the text orders them by their nearness to position control; and it prints an "
      "execution "
      "of 10 ms within a task cycle of 5 ms. Each way to read it is a row of the last but one "
      "table.",
      kSeconds);
  Table table;
  table.title = "Average level of each buffer (share of time empty) in 3 s, five processors, 10 ms";
  table.columns = columnsAfter({"cycle (ms)", "policy"});
  struct Policy {
    const char* name;
    bool asPrinted;
    bool dataFlow;
  };
  constexpr std::array<Policy, 3> kPolicies{{{"task dependency, priorities printed", true, false},
                                             {"task dependency, ordered", false, false},
                                             {"data flow", true, true}}};
  for (const petri::Word cycleMs : pipeline::kFigure13CyclesMs) {
    for (const Policy& policy : kPolicies) {
      pipeline::Figure13Reading reading;
      reading.asPrinted = policy.asPrinted;
      const auto run =
          runParallelCnc(pipeline::figure13Parameters(reading, cycleMs, policy.dataFlow), kSeconds);
      if (!run) {
        return base::fail(run.error());
      }
      table.rows.push_back(rowOf(std::to_string(cycleMs), policy.name, *run));
      experiment.plots.push_back(plotOf(*run, cycleMs, policy.name));
    }
  }
  experiment.tables.push_back(std::move(table));
  for (const auto add : {readings, preemptions}) {
    auto more = add(experiment);
    if (!more) {
      return base::fail(more.error());
    }
    experiment.tables.push_back(std::move(*more));
  }
  return experiment;
}

}  // namespace rivulet::papers
