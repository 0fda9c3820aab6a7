// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "base/random.h"
#include "base/units.h"
#include "papers/figures.h"
#include "papers/meter.h"
#include "streaming/simulation/scenario.h"

namespace rivulet::papers {

namespace {

using base::MethodKind;
using streaming::RunReport;

constexpr std::size_t kPoints = 140;
constexpr int kComparedPointsPerLoop = 7;
constexpr double kPointDistanceMm = 0.15;  // as in [P1], Fig. 4
constexpr double kComparedRestMmMean = 0.15;

/// One line of the comparison. A file can hold any number of points: it is compared with N as for
/// the others, and with ten times as many.
struct Contender {
  MethodKind method;
  int pointsPerLoop;
  const char* name;
};
constexpr std::array<Contender, 6> kContenders{
    {{MethodKind::Position, kComparedPointsPerLoop, "position"},
     {MethodKind::Signal, kComparedPointsPerLoop, "signal"},
     {MethodKind::Window, kComparedPointsPerLoop, "window"},
     {MethodKind::Credit, kComparedPointsPerLoop, "credit"},
     {MethodKind::File, kComparedPointsPerLoop, "file"},
     {MethodKind::File, 10 * kComparedPointsPerLoop, "file, N 70"}}};
constexpr std::array<double, 12> kFeeds{100.0,  200.0,  300.0,  500.0,  700.0,  1000.0,
                                        1500.0, 2000.0, 3000.0, 5000.0, 8000.0, 12000.0};

/// One run, according to the machine's own trace and its variable service. Numbers only: another
/// computer can make it.
struct Measured {
  double isRight = 0.0;  ///< 1 or 0
  double pauses = 0.0;
  double standingS = 0.0;
  double waitingS = 0.0;  ///< standstill in excess of that with a client that needs no time
  double totalS = 0.0;
  double executed = 0.0;
  double nodes = 0.0;
  double requests = 0.0;

  [[nodiscard]] static constexpr auto members() {
    return std::array{&Measured::isRight,  &Measured::pauses,  &Measured::standingS,
                      &Measured::waitingS, &Measured::totalS,  &Measured::executed,
                      &Measured::nodes,    &Measured::requests};
  }
};

double standingS(const RunReport& report) {
  double sum = 0.0;
  for (const trace::Pause& pause : report.pauses) {
    sum += base::toSeconds(pause.duration);
  }
  return sum;
}

machine::AccessCost freeAccess(machine::AccessCost access) {
  access.readOverhead = access.writeOverhead = {};
  access.nodeTimeMean = access.nodeTimeDeviation = access.nodeTimeMin = {};
  access.programOverhead = {};
  access.programBytesPerS = 1e12;
  return access;
}

Measured measure(const ExperimentOptions& options, const Contender& contender, double feedMmPerMin,
                 std::uint64_t seed) {
  base::Random random = base::Random(seed).fork(9);
  streaming::Scenario scenario;
  scenario.machine = options.machine;
  scenario.program = streaming::programOf(
      streaming::drawContour({kPoints, kPointDistanceMm, kComparedRestMmMean}, random));
  scenario.settings.parameters.method = contender.method;
  scenario.settings.parameters.pointsPerLoop = contender.pointsPerLoop;
  scenario.settings.isCommissioned =
      options.machine.rRead == machine::RParameterReading::AtInterpretation &&
      !options.machine.jumpStops;
  scenario.settings.deltaMm = kPointDistanceMm;
  scenario.settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  scenario.settings.monitor = false;  // reads only what the method needs
  scenario.settings.stallDeadline = std::chrono::seconds{3};
  scenario.seed = seed;
  scenario.limit = std::chrono::minutes{10};
  streaming::ServiceLoad load;
  const RunReport report = streaming::simulate(scenario, &load);
  Measured measured;
  const bool isRight = report.outcome == streaming::Outcome::Completed &&
                       report.integrity.isFaultless() && report.integrity.executed == kPoints;
  measured.isRight = isRight ? 1.0 : 0.0;
  measured.pauses = static_cast<double>(report.pauses.size());
  measured.standingS = standingS(report);
  if (base::hasWindows(contender.method)) {
    // The same run with access that costs nothing: the methods of [P1] never wait.
    scenario.machine.access = freeAccess(scenario.machine.access);
    measured.waitingS =
        std::max(0.0, measured.standingS - standingS(streaming::simulate(scenario)));
  }
  measured.totalS = base::toSeconds(report.duration);
  measured.executed = static_cast<double>(report.integrity.executed);
  measured.nodes = static_cast<double>(load.nodes);
  measured.requests = static_cast<double>(load.requests);
  return measured;
}

/// All runs of a method at a feed.
struct Summary {
  std::size_t right = 0;
  double pauses = 0.0;
  double standingShare = 0.0;
  double totalS = 0.0;
  double pointsPerS = 0.0;
  double nodesPerPoint = 0.0;
  double requestsPerPoint = 0.0;
  double waitingS = 0.0;
};

Summary summaryOf(const Measured* runs, std::size_t count) {
  Summary summary;
  Measured sum;
  for (std::size_t i = 0; i < count; ++i) {
    summary.right += runs[i].isRight > 0.0 ? 1 : 0;
    sum.pauses += runs[i].pauses;
    sum.standingS += runs[i].standingS;
    sum.waitingS += runs[i].waitingS;
    sum.totalS += runs[i].totalS;
    sum.executed += runs[i].executed;
    sum.nodes += runs[i].nodes;
    sum.requests += runs[i].requests;
  }
  const double number = static_cast<double>(count);
  const double points = std::max(sum.executed, 1.0);
  summary.pauses = sum.pauses / number;
  summary.totalS = sum.totalS / number;
  summary.waitingS = sum.waitingS / number;
  summary.standingShare = sum.totalS > 0.0 ? sum.standingS / sum.totalS : 0.0;
  summary.pointsPerS = sum.totalS > 0.0 ? sum.executed / sum.totalS : 0.0;
  summary.nodesPerPoint = sum.nodes / points;
  summary.requestsPerPoint = sum.requests / points;
  return summary;
}

std::vector<std::string> rowOf(const std::string& name, double feed, const Summary& summary,
                               std::size_t seeds) {
  return {name,
          fmt::format("{:.0f}", feed),
          fmt::format("{} of {}", summary.right, seeds),
          fmt::format("{:.1f}", summary.pauses),
          fmt::format("{:.1f}", 100.0 * summary.standingShare),
          fmt::format("{:.2f}", summary.totalS),
          fmt::format("{:.2f}", summary.pointsPerS),
          fmt::format("{:.1f}", summary.nodesPerPoint),
          fmt::format("{:.2f}", summary.requestsPerPoint),
          fmt::format("{:.2f}", summary.waitingS)};
}

/// The part of the report about one method.
struct Lines {
  std::vector<std::vector<std::string>> rows;  ///< one per feed
  std::optional<std::size_t> largest;          ///< feed up to which every run is right
  Series rates;
  Series shares;
  std::size_t wrong = 0;
};

/// @param runs  of the method: feed by feed, `seeds` each
Lines linesOf(const std::string& name, const Measured* runs, std::size_t seeds) {
  Lines lines;
  lines.rates = {name, SeriesStyle::Line, false, {}, {}, {}};
  lines.shares = {name, SeriesStyle::Line, false, {}, {}, {}};
  bool isStillRight = true;
  for (std::size_t f = 0; f < kFeeds.size(); ++f) {
    const Summary summary = summaryOf(runs + f * seeds, seeds);
    lines.rows.push_back(rowOf(name, kFeeds[f], summary, seeds));
    lines.wrong += seeds - summary.right;
    isStillRight = isStillRight && summary.right == seeds;
    if (isStillRight) {
      lines.largest = f;
      lines.rates.x.push_back(kFeeds[f]);
      lines.rates.y.push_back(summary.pointsPerS);
      lines.shares.x.push_back(kFeeds[f]);
      lines.shares.y.push_back(100.0 * summary.standingShare);
    }
  }
  return lines;
}

/// A method with windows promises that no run is ever wrong.
Check promiseOf(const std::string& name, std::size_t wrong) {
  Check never;
  never.what = fmt::format("runs of method {} with an error, all feeds", name);
  never.source = "promise of the method";
  never.reference = 0.0;
  never.ours = static_cast<double>(wrong);
  never.lowest = 0.0;
  never.highest = 0.0;
  never.mark = Mark::ByConstruction;
  return never;
}

std::vector<std::string> notesOf() {
  return {
      fmt::format("The largest feed is the largest of the {} tried feeds at which, and below "
                  "which, every run was right. At {:.0f} mm/min no limit was found.",
                  kFeeds.size(), kFeeds.back()),
      "With points this close, and a standstill in each loop, the axes never reach the larger "
      "feeds: points per second approach a limit, and so do the errors.",
      "Methods window, credit and file are right at any feed because the axes wait if the client "
      "is late. The methods of [P1] are right only if they are fast enough for the machine.",
      "Method credit is experimental: it needs a control that reads R-parameters each time it "
      "passes a block, as this virtual machine does.",
      "Method file is shown for comparison. No source says what it costs to store a program on a "
      "control; this machine uses the values of its preset.",
      "If runs went wrong, the figures of the second table include repeated or skipped points: "
      "they do not measure the method."};
}

/// Every contender at every feed, `seeds` runs each.
base::Result<std::vector<Measured>> measureAll(const ExperimentOptions& options,
                                               std::size_t seeds) {
  const std::size_t perMethod = kFeeds.size() * seeds;
  const std::size_t runs = kContenders.size() * perMethod;
  constexpr auto kMembers = Measured::members();
  Meter meter(options, runs);
  const auto numbers = options.executor.numbersOf(
      runs, kMembers.size(), [&](std::size_t job, std::span<double> results) {
        if (meter.isCancelled()) {
          return;
        }
        const double feed = kFeeds[job % perMethod / seeds];
        const Measured measured =
            measure(options, kContenders[job / perMethod], feed, job % seeds + 1);
        for (std::size_t i = 0; i < kMembers.size(); ++i) {
          results[i] = measured.*kMembers[i];
        }
        meter.add();
      });
  if (auto end = meter.endOf(numbers.has_value()); !end) {
    return base::fail(end.error());
  }
  std::vector<Measured> all(runs);
  for (std::size_t at = 0; at < numbers->size(); ++at) {
    all[at / kMembers.size()].*kMembers[at % kMembers.size()] = (*numbers)[at];
  }
  return all;
}

}  // namespace

base::Result<Experiment> runMethods(const ExperimentOptions& options) {
  const std::size_t seeds = options.seeds > 0 ? options.seeds : 40;
  const base::Result<std::vector<Measured>> runs = measureAll(options, seeds);
  if (!runs) {
    return base::fail(runs.error());
  }

  Experiment result;
  result.name = "methods";
  result.title = "The methods compared";
  result.setup = fmt::format(
      "{} points, steps of {} mm plus an exponential rest of mean {} mm; N {}, δ = d_min; {} feeds "
      "from {:.0f} to {:.0f} mm/min, {} runs each. All methods get the same contours, machines and "
      "seeds. Errors, pauses and times come from the machine's own trace; accesses are those that "
      "its variable service has served. Waiting is how much longer the axes were at standstill "
      "than with a client that needs no time.",
      kPoints, kPointDistanceMm, kComparedRestMmMean, kComparedPointsPerLoop, kFeeds.size(),
      kFeeds.front(), kFeeds.back(), seeds);
  const std::vector<std::string> columns{"method",       "F (mm/min)",         "runs right",
                                         "pauses",       "standstill (%)",     "total time (s)",
                                         "points per s", "accesses per point", "requests per point",
                                         "waiting (s)"};
  Table best{"At the largest feed without an error", columns, {}};
  Table all{"At all feeds", columns, {}};
  Plot rate{"Points per second, runs without error", "F (mm/min)", "points per s", {}};
  Plot standing{
      "Share of time at standstill, runs without error", "F (mm/min)", "standstill (%)", {}};
  for (std::size_t m = 0; m < kContenders.size(); ++m) {
    const std::string name(kContenders[m].name);
    Lines lines = linesOf(name, runs->data() + m * kFeeds.size() * seeds, seeds);
    all.rows.insert(all.rows.end(), lines.rows.begin(), lines.rows.end());
    if (lines.largest) {
      best.rows.push_back(lines.rows[*lines.largest]);
    }
    if (base::hasWindows(kContenders[m].method)) {
      result.checks.push_back(promiseOf(name, lines.wrong));
    }
    rate.series.push_back(std::move(lines.rates));
    standing.series.push_back(std::move(lines.shares));
  }
  result.tables = {std::move(best), std::move(all)};
  result.plots = {std::move(rate), std::move(standing)};
  result.notes = notesOf();
  return result;
}

}  // namespace rivulet::papers
