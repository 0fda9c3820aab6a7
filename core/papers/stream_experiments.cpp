// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/stream_experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "base/random.h"
#include "base/units.h"
#include "feasibility/equations.h"
#include "feasibility/verdict.h"
#include "papers/figures.h"
#include "papers/meter.h"
#include "streaming/simulation/scenario.h"

namespace rivulet::papers {

namespace {

using base::MethodKind;
using base::Result;
using base::Vec3;
using streaming::PassedBy;
using streaming::RunReport;
using streaming::Scenario;

constexpr int kPointsPerLoop = 7;     // N of the paper's experiments
constexpr double kRestMmMean = 0.15;  // mean excess of a step of the contour over d_min

Scenario scenarioOf(const ExperimentOptions& options, MethodKind method, double feedMmPerMin,
                    double deltaMm, const std::vector<Vec3>& contour, std::uint64_t seed) {
  Scenario scenario;
  scenario.machine = options.machine;
  scenario.program = streaming::programOf(contour);
  scenario.settings.parameters.method = method;
  scenario.settings.parameters.pointsPerLoop = kPointsPerLoop;
  scenario.settings.deltaMm = deltaMm;
  scenario.settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  // As in the paper: the client reads only what its method needs.
  scenario.settings.monitor = false;
  // A run without progress is ended soon.
  scenario.settings.stallDeadline = std::chrono::seconds{3};
  scenario.seed = seed;
  scenario.limit = std::chrono::minutes{10};
  if (options.wrong) {
    options.wrong(scenario);
  }
  return scenario;
}

/// Every point once and in order, to the last one.
bool ranRight(const RunReport& report) {
  return report.outcome == streaming::Outcome::Completed && report.integrity.isFaultless();
}

std::vector<Vec3> contourOf(std::size_t points, double pointDistanceMmMin, std::uint64_t seed) {
  base::Random random = base::Random(seed).fork(7);
  return streaming::drawContour({points, pointDistanceMmMin, kRestMmMean}, random);
}

/// Axis X over time, with the pauses as a series of its own at the height of the axis.
Plot positionPlot(const std::string& title, const RunReport& report, double seconds) {
  Plot plot{title, "time (s)", "X (mm)", {}};
  Series axis{"X, set point", SeriesStyle::Line, false, {}, {}, {}};
  Series pauses{"standstill", SeriesStyle::Points, false, {}, {}, {}};
  if (!report.controlTrace || report.integrity.faults.size() > 1000) {
    return plot;
  }
  const auto& samples = report.controlTrace->samples;
  // The approach is left out: the first pause is where the contour begins.
  const base::Instant origin =
      report.pauses.empty() ? samples.front().at : report.pauses.front().start;
  const auto inPlot = [&](base::Instant at) {
    return at >= origin && at <= origin + base::fromSeconds(seconds);
  };
  for (const trace::ControlSample& sample : samples) {
    if (inPlot(sample.at)) {
      axis.x.push_back(base::toSeconds(sample.at - origin));
      axis.y.push_back(sample.commandMm.x);
    }
  }
  for (const trace::Pause& pause : report.pauses) {
    const auto at = std::find_if(samples.begin(), samples.end(),
                                 [&](const auto& sample) { return sample.at >= pause.start; });
    if (at != samples.end() && inPlot(pause.start)) {
      pauses.x.push_back(base::toSeconds(pause.start + pause.duration / 2 - origin));
      pauses.y.push_back(at->commandMm.x);
    }
  }
  plot.series = {std::move(axis), std::move(pauses)};
  return plot;
}

/// A contour with steps down to 0.001 mm (0.001 mm plus an exponential rest) whose windows of
/// ⌊N/2⌋ steps are never shorter than `windowMmMin`.
std::vector<Vec3> contourWithTinySteps(std::size_t points, double windowMmMin, std::uint64_t seed) {
  base::Random random = base::Random(seed).fork(8);
  constexpr std::size_t kWindowSteps = kPointsPerLoop / 2;
  constexpr double kTinyMm = 0.001;
  std::vector<double> steps;
  std::vector<Vec3> contour{{}};
  double courseRad = 0.0;
  while (contour.size() < points) {
    // One step in ten has the smallest length.
    double step = kTinyMm + (random.below(10) == 0 ? 0.0 : kRestMmMean * random.exponential());
    double window = step;
    for (std::size_t i = 0; i + 1 < kWindowSteps && i < steps.size(); ++i) {
      window += steps[steps.size() - 1 - i];
    }
    if (steps.size() + 1 >= kWindowSteps && window < windowMmMin) {
      step += windowMmMin - window;
    }
    steps.push_back(step);
    courseRad += 0.1 * random.normal();
    contour.push_back(contour.back() + step * Vec3{std::cos(courseRad), std::sin(courseRad), 0.0});
  }
  return contour;
}

}  // namespace

Result<Experiment> runFigure3(const ExperimentOptions& options) {
  const std::size_t seeds = options.seeds > 0 ? options.seeds : 10;
  constexpr std::size_t kPoints = 210;  // 30 loops
  constexpr double kPointDistanceMm = 0.4;
  Experiment result;
  result.name = "figure3";
  result.title = "Standstills of both methods";
  result.setup = fmt::format(
      "{} points, steps of {} mm plus an exponential rest of mean {} mm; method position with F "
      "500 and δ = d_min, method signal with F 700; N 7; {} runs each. The pauses are found in the "
      "control's own trace.",
      kPoints, kPointDistanceMm, kRestMmMean, seeds);
  Table table{"Standstills",
              {"method", "runs right", "mean (ms)", "deviation (ms)", "shortest (ms)",
               "longest (ms)", "per loop"},
              {}};
  for (const MethodKind method : base::kPaperMethods) {
    const bool position = method == MethodKind::Position;
    std::vector<RunReport> reports(seeds);
    Meter meter(options, 2 * seeds);
    options.executor.forEach(seeds, [&](std::size_t i) {
      if (!meter.isCancelled()) {
        reports[i] = streaming::simulate(
            scenarioOf(options, method, position ? 500.0 : 700.0, kPointDistanceMm,
                       contourOf(kPoints, kPointDistanceMm, i + 1), i + 1));
        meter.add();
      }
    });
    if (meter.isCancelled()) {
      return Meter::cancelled();
    }
    std::vector<double> durationsMs;
    std::size_t right = 0;
    std::size_t pauses = 0;
    constexpr double kLoops = static_cast<double>(kPoints) / kPointsPerLoop;
    for (const RunReport& report : reports) {
      right += ranRight(report) ? 1 : 0;
      for (const trace::Pause& pause : report.pauses) {
        durationsMs.push_back(base::toMilliseconds(pause.duration));
      }
      pauses += report.pauses.size() + 1;  // after the last loop nothing moves: no pause
    }
    const double perLoop = static_cast<double>(pauses) / (kLoops * static_cast<double>(seeds));
    const std::string name(base::methodName(method));
    if (durationsMs.empty()) {
      durationsMs.push_back(0.0);
    }
    const double mean = meanOf(durationsMs);
    table.rows.push_back({name, fmt::format("{} of {}", right, seeds), fmt::format("{:.1f}", mean),
                          fmt::format("{:.1f}", deviationOf(durationsMs)),
                          fmt::format("{:.0f}", quantileOf(durationsMs, 0)),
                          fmt::format("{:.0f}", quantileOf(durationsMs, base::kPerMille)),
                          fmt::format("{:.2f}", perLoop)});
    result.checks.push_back(
        {"mean standstill, method " + name, "ms", "[P1] VI", 40.0, mean, 36.0, 44.0, Mark::Input});
    const double expected = position ? 1.0 : 2.0;
    result.checks.push_back({"standstills per loop, method " + name, "",
                             position ? "[P1] VI" : "one per signal of the template", expected,
                             perLoop, 0.999 * expected, 1.001 * expected, Mark::ByConstruction});
    result.plots.push_back(
        positionPlot(position ? "Method position, F 500, N 7" : "Method signal, F 700, N 7",
                     reports.front(), 3.0));
  }
  result.tables.push_back(std::move(table));
  result.notes = {
      "The paper reports one standstill per loop. Our template of method signal has a STOPRE at "
      "each of its two signals, because otherwise a signal that is set in the pre-run says nothing "
      "about the motion: two standstills per loop."};
  return result;
}

namespace {

/// What method position watches; each has rows and checks of its own.
constexpr std::array<PassedBy, 2> kWatched{PassedBy::Position, PassedBy::DistanceToGo};

std::string_view watchedText(PassedBy passedBy) {
  return passedBy == PassedBy::Position ? "position" : "distance to go";
}

// Figure 4: from a large d_min downwards, until a run fails. One trial each, as in the paper.
constexpr std::size_t kFigure4Points = 140;
constexpr double kFigure4StepMm = 0.01;
constexpr int kFigure4StepsMax = 60;
constexpr double kFigure4DeviationMm = 0.053;  // of the paper's trials from its theoretical curve
constexpr std::array<double, 8> kFigure4Feeds{100.0, 200.0, 300.0, 400.0,
                                              500.0, 600.0, 800.0, 1000.0};

/// Smallest d_min with which a run was right, mm.
double smallestDistanceMm(const ExperimentOptions& options, PassedBy passedBy, double feed,
                          std::uint64_t seed) {
  int steps = kFigure4StepsMax;
  for (; steps >= 1; --steps) {
    const double distanceMm = steps * kFigure4StepMm;
    Scenario scenario = scenarioOf(options, MethodKind::Position, feed, distanceMm,
                                   contourOf(kFigure4Points, distanceMm, seed),
                                   seed * 1000003 + static_cast<std::uint64_t>(steps));
    scenario.settings.passedBy = passedBy;
    if (!ranRight(streaming::simulate(scenario))) {
      break;
    }
  }
  return (steps + 1) * kFigure4StepMm;
}

/// The border of equation (1), between the shorter and the longer Δt.
struct DistanceBand {
  double lowMm;
  double highMm;

  explicit DistanceBand(double feedMmPerMin) {
    const feasibility::PollTime poll = feasibility::pollTime(std::chrono::microseconds{4300});
    lowMm = base::mmPerSFromMmPerMin(feedMmPerMin) * base::toSeconds(poll.min);
    highMm = base::mmPerSFromMmPerMin(feedMmPerMin) * base::toSeconds(poll.max);
  }
};

/// Adds rows, checks and series of one variant. @param limits  feed by feed, all seeds of each
void addFigure4(Experiment& result, PassedBy passedBy, const std::vector<double>& limits,
                std::size_t seeds) {
  const bool isPosition = passedBy == PassedBy::Position;
  const std::string name(watchedText(passedBy));
  Series medians{"median, " + name, SeriesStyle::Points, false, {}, {}, {}};
  Series quartiles{"quartiles, " + name, SeriesStyle::Band, false, {}, {}, {}};
  double lowSquares = 0.0;   // of the single trials, from equation (1) with the shorter Δt
  double highSquares = 0.0;  // with the longer one
  double medianAt500 = 0.0;
  for (std::size_t i = 0; i < kFigure4Feeds.size(); ++i) {
    const double feed = kFigure4Feeds[i];
    const DistanceBand band(feed);
    const auto begin = limits.begin() + static_cast<std::ptrdiff_t>(i * seeds);
    const std::vector<double> trials(begin, begin + static_cast<std::ptrdiff_t>(seeds));
    const double median = medianOf(trials);
    const double low = quantileOf(trials, 250);
    const double high = quantileOf(trials, 750);
    medianAt500 = feed == 500.0 ? median : medianAt500;
    for (const double trial : trials) {
      lowSquares += std::pow(trial - band.lowMm, 2) / static_cast<double>(seeds);
      highSquares += std::pow(trial - band.highMm, 2) / static_cast<double>(seeds);
    }
    result.tables.front().rows.push_back(
        {name, fmt::format("{:.0f}", feed), fmt::format("{:.3f}", median),
         fmt::format("{:.3f} to {:.3f}", low, high),
         fmt::format("{:.3f} to {:.3f}", band.lowMm, band.highMm)});
    quartiles.x.push_back(feed);
    quartiles.y.push_back(low);
    quartiles.yUpper.push_back(high);
    medians.x.push_back(feed);
    medians.y.push_back(median);
  }
  if (isPosition) {  // the variant with which the paper's figures come out
    const double feeds = static_cast<double>(kFigure4Feeds.size());
    result.checks.push_back({"median limit at F 500", "mm", "[P1] VI.A, Fig. 4", 0.15, medianAt500,
                             0.10, 0.20, Mark::Fitted});
    // [P1] does not say which Δt its theoretical curve has.
    for (const auto& [deltaT, squares] : {std::pair{"12.9", lowSquares}, {"25.8", highSquares}}) {
      result.checks.push_back(
          {fmt::format("deviation of the single trials from (1) with Δt {} ms", deltaT), "mm",
           "[P1] VI.A", kFigure4DeviationMm, std::sqrt(squares / feeds), 0.5 * kFigure4DeviationMm,
           1.5 * kFigure4DeviationMm, Mark::Predicted});
    }
  } else {
    result.notes.push_back(fmt::format(
        "With the distance to go the median limit at F 500 is {:.3f} mm. Algorithm II does not say "
        "how a block is told from the one before; here the distance has to grow before another "
        "point counts, and a block whose end is not read is missed. The paper's 0.15 mm comes out "
        "with the position.",
        medianAt500));
  }
  result.plots.front().series.push_back(std::move(quartiles));
  result.plots.front().series.push_back(std::move(medians));
}

}  // namespace

Result<Experiment> runFigure4(const ExperimentOptions& options) {
  const std::size_t seeds = options.seeds > 0 ? options.seeds : 20;
  const std::size_t perVariant = kFigure4Feeds.size() * seeds;
  const std::size_t trials = kWatched.size() * perVariant;
  Meter meter(options, trials);
  const auto limits =
      options.executor.numbersOf(trials, 1, [&](std::size_t job, std::span<double> limit) {
        if (!meter.isCancelled()) {
          limit[0] = smallestDistanceMm(options, kWatched[job / perVariant],
                                        kFigure4Feeds[job % perVariant / seeds], job % seeds + 1);
          meter.add();
        }
      });
  if (auto end = meter.endOf(limits.has_value()); !end) {
    return base::fail(end.error());
  }
  Experiment result;
  result.name = "figure4";
  result.title = "Smallest d_min over the feed, method position";
  result.setup = fmt::format(
      "{} points, steps of d_min plus an exponential rest of mean {} mm, N 7, δ = d_min. d_min "
      "starts at {:.1f} mm and is reduced by {} mm until a run fails; one trial each, {} contours "
      "per feed. The client watches the tool's position, or the distance to go as in Algorithm II.",
      kFigure4Points, kRestMmMean, kFigure4StepsMax * kFigure4StepMm, kFigure4StepMm, seeds);
  result.tables.push_back(
      {"Smallest d_min that still ran",
       {"watched", "F (mm/min)", "median (mm)", "quartiles (mm)", "band of (1) (mm)"},
       {}});
  Series band{"equation (1), Δt 12.9 to 25.8 ms", SeriesStyle::Band, false, {}, {}, {}};
  for (const double feed : kFigure4Feeds) {
    const DistanceBand border(feed);
    band.x.push_back(feed);
    band.y.push_back(border.lowMm);
    band.yUpper.push_back(border.highMm);
  }
  result.plots.push_back({"Smallest d_min that ran, method position, δ = d_min, N 7",
                          "F (mm/min)",
                          "d_min (mm)",
                          {std::move(band)}});
  for (std::size_t i = 0; i < kWatched.size(); ++i) {
    const auto begin = limits->begin() + static_cast<std::ptrdiff_t>(i * perVariant);
    addFigure4(result, kWatched[i],
               std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(perVariant)), seeds);
  }
  result.plots.front().series.push_back(
      {"P1, F 500", SeriesStyle::Points, true, {500.0}, {0.15}, {}});
  result.notes.insert(
      result.notes.begin(),
      "The paper's contour comes from a CAM system and is thinned so that no two neighbours are "
      "closer than d_min: most of its steps are longer. So are ours; evenly spaced points would be "
      "harder on the method.");
  return result;
}

Result<Experiment> runMethod2(const ExperimentOptions& options) {
  const std::size_t seeds = options.seeds > 0 ? options.seeds : 100;
  constexpr std::size_t kPoints = 350;
  constexpr double kWindowMm = 0.1;
  constexpr double kFeed = 600.0;
  std::vector<RunReport> reports(seeds);
  std::vector<feasibility::ProgramDistances> distances(seeds);
  Meter meter(options, seeds);
  options.executor.forEach(seeds, [&](std::size_t i) {
    if (meter.isCancelled()) {
      return;
    }
    const Scenario scenario = scenarioOf(options, MethodKind::Signal, kFeed, 0.3,
                                         contourWithTinySteps(kPoints, kWindowMm, i + 1), i + 1);
    distances[i] = feasibility::programDistances(
        gcode::streamPoints(scenario.program->trajectory, {}).points, kPointsPerLoop);
    reports[i] = streaming::simulate(scenario);
    reports[i].controlTrace.reset();
    meter.add();
  });
  if (meter.isCancelled()) {
    return Meter::cancelled();
  }
  std::size_t wrong = 0;
  std::size_t repeated = 0;
  double stepMm = 1e9;
  double windowMm = 1e9;
  for (std::size_t i = 0; i < seeds; ++i) {
    wrong += ranRight(reports[i]) ? 0 : 1;
    repeated += reports[i].integrity.repeated;
    stepMm = std::min(stepMm, distances[i].pointDistanceMmMin);
    windowMm = std::min(windowMm, distances[i].windowLengthMmMin);
  }
  Experiment result;
  result.name = "method2";
  result.title = "Method signal at tiny distances";
  result.setup = fmt::format(
      "{} points with steps down to 0.001 mm; any three consecutive steps are at least 0.1 mm "
      "together (d_min^N); F 600, N 7; {} contours.",
      kPoints, seeds);
  result.checks.push_back({fmt::format("runs of {} that were not right", seeds), "", "[P1] VI.A",
                           0.0, static_cast<double>(wrong), 0.0, 0.0, Mark::Fitted});
  result.checks.push_back({"points repeated in all of them", "", "[P1] VI.A", 0.0,
                           static_cast<double>(repeated), 0.0, 0.0, Mark::Fitted});
  result.checks.push_back(
      {"smallest d_min", "mm", "[P1] VI.A", 0.001, stepMm, 0.0009, 0.0011, Mark::Input});
  result.checks.push_back(
      {"smallest d_min^N", "mm", "[P1] VI.A", 0.1, windowMm, 0.0999, 0.101, Mark::Input});
  const double margin =
      feasibility::windowMargin(base::mmPerSFromMmPerMin(kFeed), std::chrono::microseconds{4300},
                                kPointsPerLoop, stepMm, 1.0);
  result.notes = {
      fmt::format("Equation (3) forbids these runs by a factor of {:.0f}: it uses only d_min and "
                  "does not count the standstill.",
                  1.0 / margin)};
  return result;
}

namespace {

constexpr std::size_t kDeltaPoints = 140;
constexpr double kDeltaDistanceMm = 0.2;
constexpr double kDeltaFeed = 400.0;
constexpr double kDeltaSure = 0.15;  // with a greater δ the paper's runs were right
constexpr std::array<double, 16> kDeltas{0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.10,
                                         0.12, 0.14, 0.16, 0.18, 0.20, 0.22, 0.24, 0.28};

/// Adds rows, checks and series of one variant. @param failed  δ by δ, all seeds of each
void addDelta(Experiment& result, PassedBy passedBy, const std::vector<double>& failed,
              std::size_t seeds) {
  const bool isPosition = passedBy == PassedBy::Position;
  const std::string name(watchedText(passedBy));
  Series band{"95 % interval, " + name, SeriesStyle::Band, false, {}, {}, {}};
  Series line{"runs with an error, " + name, SeriesStyle::Points, false, {}, {}, {}};
  double worstAbove = 0.0;
  double atSmallest = 0.0;
  double largestWrong = 0.0;
  for (std::size_t i = 0; i < kDeltas.size(); ++i) {
    const auto begin = failed.begin() + static_cast<std::ptrdiff_t>(i * seeds);
    const auto hits = static_cast<std::size_t>(
        std::count(begin, begin + static_cast<std::ptrdiff_t>(seeds), 1.0));
    const Share share = shareOf(hits, seeds);
    result.tables.front().rows.push_back({name, fmt::format("{:.2f}", kDeltas[i]),
                                          fmt::format("{:.3f}", share.seen),
                                          fmt::format("{:.3f} to {:.3f}", share.low, share.high)});
    band.x.push_back(kDeltas[i]);
    band.y.push_back(share.low);
    band.yUpper.push_back(share.high);
    line.x.push_back(kDeltas[i]);
    line.y.push_back(share.seen);
    if (kDeltas[i] > kDeltaSure && kDeltas[i] <= kDeltaDistanceMm) {
      worstAbove = std::max(worstAbove, share.seen);
    }
    if (hits > 0 && kDeltas[i] <= kDeltaDistanceMm) {
      largestWrong = kDeltas[i];
    }
    atSmallest = i == 0 ? share.seen : atSmallest;
  }
  if (isPosition) {  // the variant with which the paper's figures come out
    result.checks.push_back(
        {"share of errors at δ 0.01 mm", "", "[P1] VI.A", 1.0, atSmallest, 0.9, 1.0, Mark::Fitted});
    result.checks.push_back({"largest share of errors with δ above 0.15 mm, up to d_min", "",
                             "[P1] VI.A", 0.0, worstAbove, 0.0, 0.0, Mark::Fitted});
    // The δ that were tried beside it are 0.14 and 0.16 mm.
    result.checks.push_back({"largest δ up to d_min with an error", "mm", "[P1] VI.A", kDeltaSure,
                             largestWrong, 0.14, 0.16, Mark::Fitted});
  }
  result.plots.front().series.push_back(std::move(band));
  result.plots.front().series.push_back(std::move(line));
}

}  // namespace

Result<Experiment> runDelta(const ExperimentOptions& options) {
  const std::size_t seeds = options.seeds > 0 ? options.seeds : 60;
  const std::size_t perVariant = kDeltas.size() * seeds;
  const std::size_t trials = kWatched.size() * perVariant;
  Meter meter(options, trials);
  const auto failed =
      options.executor.numbersOf(trials, 1, [&](std::size_t job, std::span<double> hasFailed) {
        if (meter.isCancelled()) {
          return;
        }
        // Both variants see the same contours and the same draws.
        const std::size_t trial = job % perVariant;
        Scenario scenario = scenarioOf(
            options, MethodKind::Position, kDeltaFeed, kDeltas[trial / seeds],
            contourOf(kDeltaPoints, kDeltaDistanceMm, trial % seeds + 1), 100 * trial + 17);
        scenario.settings.passedBy = kWatched[job / perVariant];
        hasFailed[0] = ranRight(streaming::simulate(scenario)) ? 0.0 : 1.0;
        meter.add();
      });
  if (auto end = meter.endOf(failed.has_value()); !end) {
    return base::fail(end.error());
  }
  Experiment result;
  result.name = "delta";
  result.title = "Errors over δ, method position";
  result.setup = fmt::format(
      "{} points, steps of {} mm plus an exponential rest of mean {} mm; F {:.0f}, N 7; {} runs "
      "per δ. The client watches the tool's position, or the distance to go as in Algorithm II.",
      kDeltaPoints, kDeltaDistanceMm, kRestMmMean, kDeltaFeed, seeds);
  result.tables.push_back(
      {"Share of runs with an error", {"watched", "δ (mm)", "errors", "95 % interval"}, {}});
  result.plots.push_back(
      {"Method position, F 400, d_min 0.2 mm", "δ (mm)", "share of runs with an error", {}});
  for (std::size_t i = 0; i < kWatched.size(); ++i) {
    const auto begin = failed->begin() + static_cast<std::ptrdiff_t>(i * perVariant);
    addDelta(result, kWatched[i],
             std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(perVariant)), seeds);
  }
  result.notes = {
      "Equation (2) requires δ above 0.043 mm with the shorter Δt and 0.086 mm with the longer "
      "one; the paper recommends a factor of 1.5, which gives 0.129 mm.",
      "Above d_min errors occur again: while the tool is at the end of a loop, the first point of "
      "the next loop may already be nearer than δ. It then counts as reached, and its slot is "
      "overwritten before the control has read it: a point is skipped. The paper does not mention "
      "this; δ should not exceed d_min.",
      "With the distance to go, d_min 0.2 mm at F 400 is below the limit that figure4 shows."};
  return result;
}

}  // namespace rivulet::papers
