// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/equations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "base/contract.h"
#include "base/random.h"
#include "base/units.h"
#include "feasibility/equations.h"
#include "papers/figures.h"
#include "papers/meter.h"

namespace rivulet::papers {

namespace {

using base::MethodKind;
using feasibility::Equation;

// Feeds as multiples of the verdict's limit at the contour: from one at which nothing should fail
// to one at which everything does.
constexpr double kLowestFactor = 0.35;
constexpr double kFactorStep = 1.12;
constexpr std::size_t kFactors = 20;
/// Requirement on a corrected equation: at most this share of the runs it allows may fail.
constexpr double kAllowedShare = 1e-3;
/// Requirement on the verdict as it is.
constexpr double kVerdictShare = 1e-2;

/// Added to the fate of a run as a number: 0 is a run that was not made.
constexpr double kExecuted = 1.0;

/// One combination of method, d_min, N and δ.
struct Setting {
  MethodKind method = MethodKind::Position;
  double pointDistanceMmMin = 0.15;
  int pointsPerLoop = 7;
  double deltaMm = 0.15;
};

const std::vector<Setting>& settings() {
  static const std::vector<Setting> list{
      {MethodKind::Position, 0.10, 7, 0.10}, {MethodKind::Position, 0.15, 7, 0.15},
      {MethodKind::Position, 0.20, 7, 0.20}, {MethodKind::Position, 0.30, 7, 0.30},
      {MethodKind::Position, 0.50, 7, 0.50}, {MethodKind::Position, 0.20, 7, 0.06},
      {MethodKind::Position, 0.20, 7, 0.09}, {MethodKind::Position, 0.20, 7, 0.12},
      {MethodKind::Position, 0.20, 7, 0.15}, {MethodKind::Position, 0.20, 4, 0.20},
      {MethodKind::Signal, 0.15, 3, 0.15},   {MethodKind::Signal, 0.15, 5, 0.15},
      {MethodKind::Signal, 0.15, 6, 0.15},   {MethodKind::Signal, 0.15, 7, 0.15},
      {MethodKind::Signal, 0.15, 8, 0.15},   {MethodKind::Signal, 0.15, 9, 0.15},
      {MethodKind::Signal, 0.05, 7, 0.15},   {MethodKind::Signal, 0.10, 7, 0.15},
      {MethodKind::Signal, 0.30, 7, 0.15},
  };
  return list;
}

/// An equation as it is judged here: its limit is a feed at each contour.
enum class Rule { One, Two, TwoSafe, VerdictPosition, Three, ThreeReal };
constexpr std::array kRules{Rule::One,   Rule::Two,      Rule::TwoSafe, Rule::VerdictPosition,
                            Rule::Three, Rule::ThreeReal};

std::string ruleName(Rule rule) {
  switch (rule) {
    case Rule::One:
      return "(1)";
    case Rule::Two:
      return "(2)";
    case Rule::TwoSafe:
      return "(2) with factor 1.5";
    case Rule::VerdictPosition:
      return "verdict, method position: (1) and (2) with factor 1.5";
    case Rule::Three:
      return "(3)";
    case Rule::ThreeReal:
      break;
  }
  return "verdict, method signal: (3) with d_min^N";
}

MethodKind methodOf(Rule rule) {
  return rule == Rule::Three || rule == Rule::ThreeReal ? MethodKind::Signal : MethodKind::Position;
}

/// Largest feed the rule allows; with the longer Δt, as the verdict.
double borderMmPerS(Rule rule, const Setting& setting,
                    const feasibility::ProgramDistances& distances, base::Duration accessTime) {
  // At 1 mm/s the margin is the limit in mm/s.
  const base::Duration poll = feasibility::pollTime(accessTime).max;
  const double one = feasibility::pointDistanceMargin(1.0, poll, distances.pointDistanceMmMin, 1.0);
  const feasibility::SafetyFactors safety;
  const double twoSafe = feasibility::deltaMargin(1.0, poll, setting.deltaMm, safety.delta);
  switch (rule) {
    case Rule::One:
      return one;
    case Rule::Two:
      return feasibility::deltaMargin(1.0, poll, setting.deltaMm, 1.0);
    case Rule::TwoSafe:
      return twoSafe;
    case Rule::VerdictPosition:
      return std::min(one, twoSafe);
    case Rule::Three:
      return feasibility::windowMargin(1.0, accessTime, setting.pointsPerLoop,
                                       distances.pointDistanceMmMin, 1.0);
    case Rule::ThreeReal:
      break;
  }
  return feasibility::realWindowMargin(1.0, accessTime, setting.pointsPerLoop,
                                       distances.windowLengthMmMin, safety.window);
}

/// One contour of one setting.
struct Contour {
  std::size_t setting = 0;
  std::vector<gcode::StreamPoint> points;
  std::shared_ptr<const gcode::Program> program;
  base::Vec3 startMm;
  feasibility::ProgramDistances distances;
  double referenceMmPerS = 0.0;  ///< limit of the verdict
};

/// One simulated run, and one point of the grid it belongs to.
struct Run {
  std::size_t contour = 0;
  std::size_t factor = 0;
  double feedMmPerS = 0.0;
  forecast::RunFate fate = forecast::RunFate::Cancelled;
};

/// A run as one rule sees it: how far its feed was above the rule's limit.
struct Seen {
  double excess = 0.0;  ///< feed / limit; the rule allows it below 1
  bool failed = false;
};

/// Largest excess below which at most the allowed share of runs failed, for the share itself and
/// for both of its bounds.
struct Threshold {
  double best = 0.0;
  double lowest = 0.0;   ///< with the upper bound of the share: certainly right
  double highest = 0.0;  ///< with the lower bound: not certainly wrong
};

Threshold thresholdOf(std::vector<Seen> runs) {
  std::sort(runs.begin(), runs.end(),
            [](const Seen& a, const Seen& b) { return a.excess < b.excess; });
  Threshold threshold;
  std::size_t failed = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    failed += runs[i].failed ? 1 : 0;
    const Share share = shareOf(failed, i + 1);
    if (share.seen <= kAllowedShare) {
      threshold.best = runs[i].excess;
    }
    if (share.high <= kAllowedShare) {
      threshold.lowest = runs[i].excess;
    }
    if (share.low <= kAllowedShare) {
      threshold.highest = runs[i].excess;
    }
  }
  return threshold;
}

/// Excess at which half of the runs fail: between two bins of equal width in its logarithm.
std::optional<double> halfOf(const std::vector<Seen>& runs) {
  constexpr double kBin = 0.12;
  constexpr std::size_t kFewest = 20;
  std::map<int, std::pair<std::size_t, std::size_t>> bins;
  for (const Seen& run : runs) {
    auto& [failed, total] = bins[static_cast<int>(std::floor(std::log(run.excess) / kBin))];
    failed += run.failed ? 1 : 0;
    ++total;
  }
  std::optional<std::pair<double, double>> before;
  for (const auto& [bin, counts] : bins) {
    if (counts.second < kFewest) {
      continue;
    }
    const double at = (bin + 0.5) * kBin;
    const double share = static_cast<double>(counts.first) / static_cast<double>(counts.second);
    if (share >= 0.5) {
      if (!before) {
        return std::nullopt;  // even the lowest feeds fail
      }
      const double part = (0.5 - before->second) / (share - before->second);
      return std::exp(before->first + part * (at - before->first));
    }
    before = {at, share};
  }
  return std::nullopt;
}

std::string number(double value, int digits) {
  return fmt::format("{:.{}f}", value, digits);
}

std::string percent(double share) {
  return fmt::format("{:.2f}", 100.0 * share);
}

double mmPerMin(double mmPerS) {
  return base::mmPerMinFromMmPerS(mmPerS);
}

class Equations {
 public:
  Equations(const EquationsOptions& options, const machine::MachineConfig& machine)
      : m_options(options),
        m_machine(machine),
        m_model(forecast::streamModelOf(machine)),
        m_access(machine.access.nodeTimeMean) {
    RIVULET_ASSERT(options.contours > 0 && options.runsPerPoint > 0 && options.pointsPerRun >= 20);
    drawContours();
  }

  base::Result<Experiment> run(base::Executor& executor, const forecast::RegionProgress& progress) {
    if (auto done = simulateAll(executor, progress); !done) {
      return base::fail(done.error());
    }
    const bool complete = m_missing == 0;
    predictAll(executor);
    Experiment experiment;
    experiment.name = "equations";
    experiment.title = "Equations (1) to (3) against simulated runs";
    experiment.setup = fmt::format(
        "{} combinations of d_min, N and delta; {} contours each ({} points, steps d_min plus an "
        "exponential rest of mean d_min, smallest step scaled to d_min); for each contour {} feeds "
        "from {:.2f} to {:.2f} times the limit of the verdict; {} runs with different seeds at "
        "each feed. Preset {}. {} runs in all.",
        settings().size(), m_options.contours, m_options.pointsPerRun, kFactors, kLowestFactor,
        factor(kFactors - 1), m_options.runsPerPoint, m_machine.name, m_runs.size());
    judgeRules(experiment);
    addStrictness(experiment);
    addModel(experiment);
    addPlots(experiment);
    addNotes(experiment);
    if (!complete) {
      experiment.notes.push_back(
          "Cancelled: the figures include only the runs completed until then.");
      experiment.checks.push_back({"runs left out", "", "", 0.0, static_cast<double>(m_missing),
                                   0.0, 0.0, Mark::ByConstruction});
    }
    if (m_refused > 0) {
      experiment.checks.push_back({"runs that could not be executed", "", "", 0.0,
                                   static_cast<double>(m_refused), 0.0, 0.0, Mark::ByConstruction});
      experiment.notes.push_back("A run could not be executed: " + m_error.text());
    }
    return experiment;
  }

 private:
  static double factor(std::size_t index) {
    return kLowestFactor * std::pow(kFactorStep, static_cast<double>(index));
  }

  void drawContours() {
    for (std::size_t setting = 0; setting < settings().size(); ++setting) {
      const Setting& one = settings()[setting];
      for (std::size_t number = 0; number < m_options.contours; ++number) {
        base::Random random =
            base::Random(m_options.seed).fork(1 + setting * m_options.contours + number);
        streaming::ContourOptions options;
        options.points = m_options.pointsPerRun;
        options.pointDistanceMmMin = one.pointDistanceMmMin;
        options.restMmMean = one.pointDistanceMmMin;
        Contour contour;
        contour.setting = setting;
        std::vector<base::Vec3> positions = streaming::drawContour(options, random);
        // The smallest of some hundred steps is a little above d_min: make it d_min.
        double smallestMm = base::distance(positions[0], positions[1]);
        for (std::size_t i = 2; i < positions.size(); ++i) {
          smallestMm = std::min(smallestMm, base::distance(positions[i - 1], positions[i]));
        }
        for (base::Vec3& position : positions) {
          position = (one.pointDistanceMmMin / smallestMm) * position;
          contour.points.push_back({position, base::LineNumber{}});
        }
        contour.program = streaming::programOf(positions);
        contour.startMm = forecast::regionStartMm(contour.points, one.deltaMm);
        contour.distances = feasibility::programDistances(contour.points, one.pointsPerLoop);
        contour.referenceMmPerS = borderMmPerS(
            one.method == MethodKind::Position ? Rule::VerdictPosition : Rule::ThreeReal, one,
            contour.distances, m_access);
        m_contours.push_back(std::move(contour));
      }
    }
    for (std::size_t contour = 0; contour < m_contours.size(); ++contour) {
      for (std::size_t index = 0; index < kFactors; ++index) {
        for (std::size_t run = 0; run < m_options.runsPerPoint; ++run) {
          m_runs.push_back({contour, index, m_contours[contour].referenceMmPerS * factor(index),
                            forecast::RunFate::Cancelled});
        }
      }
    }
  }

  base::Result<void> simulateAll(base::Executor& executor,
                                 const forecast::RegionProgress& progress) {
    std::atomic<bool> cancelled{false};
    std::atomic<std::size_t> done{0};
    std::vector<base::Error> errors(m_runs.size());
    const auto fates =
        executor.numbersOf(m_runs.size(), 1, [&](std::size_t index, std::span<double> fate) {
          if (cancelled) {
            return;
          }
          const Run& run = m_runs[index];
          const Contour& contour = m_contours[run.contour];
          const Setting& setting = settings()[contour.setting];
          streaming::Scenario scenario;
          scenario.machine = m_machine;
          for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
            scenario.machine.axes[axis].startMm = contour.startMm[axis];
          }
          scenario.program = contour.program;
          scenario.settings.parameters.method = setting.method;
          scenario.settings.parameters.pointsPerLoop = setting.pointsPerLoop;
          scenario.settings.deltaMm = setting.deltaMm;
          scenario.settings.feedMmPerS = run.feedMmPerS;
          scenario.seed = base::Random(m_options.seed).fork(1'000'000 + index).bits();
          fate[0] = kExecuted +
                    static_cast<double>(forecast::fateOf(std::move(scenario), &errors[index]));
          if (progress && !progress(++done, m_runs.size())) {
            cancelled = true;
          }
        });
    const auto refused =
        std::ranges::find_if(errors, [](const base::Error& error) { return bool{error.code}; });
    if (!fates) {
      // The text of a refusal is no number: whoever put the numbers together could not say it.
      return refused != errors.end() ? base::fail(*refused) : Meter::onlyShare();
    }
    m_error = refused != errors.end() ? *refused : base::Error{};
    for (std::size_t index = 0; index < m_runs.size(); ++index) {
      Run& run = m_runs[index];
      if ((*fates)[index] >= kExecuted) {
        run.fate = static_cast<forecast::RunFate>(static_cast<int>((*fates)[index] - kExecuted));
      }
      m_missing += run.fate == forecast::RunFate::Cancelled ? 1 : 0;
      m_refused += run.fate == forecast::RunFate::Refused ? 1 : 0;
    }
    return {};
  }

  void predictAll(base::Executor& executor) {
    m_predicted.assign(m_contours.size() * kFactors, 0.0);
    executor.forEach(m_predicted.size(), [&](std::size_t index) {
      const Contour& contour = m_contours[index / kFactors];
      m_predicted[index] =
          feasibility::predict(contour.points,
                               pointOf(contour, contour.referenceMmPerS * factor(index % kFactors)),
                               m_model, contour.startMm)
              .failureProbability;
    });
  }

  static feasibility::OperatingPoint pointOf(const Contour& contour, double feedMmPerS) {
    const Setting& setting = settings()[contour.setting];
    return {setting.method, setting.pointsPerLoop, setting.deltaMm, feedMmPerS};
  }

  static bool wasMade(const Run& run) {
    return run.fate == forecast::RunFate::Ran || run.fate == forecast::RunFate::Faulty ||
           run.fate == forecast::RunFate::Stalled;
  }

  [[nodiscard]] std::vector<Seen> seenBy(Rule rule) const {
    std::vector<Seen> seen;
    for (const Run& run : m_runs) {
      const Contour& contour = m_contours[run.contour];
      const Setting& setting = settings()[contour.setting];
      if (setting.method == methodOf(rule) && wasMade(run)) {
        seen.push_back({run.feedMmPerS / borderMmPerS(rule, setting, contour.distances, m_access),
                        run.fate != forecast::RunFate::Ran});
      }
    }
    return seen;
  }

  void judgeRules(Experiment& experiment) const {
    Table confusion;
    confusion.title = "Predictions of the equations and results of the runs";
    confusion.columns = {"equation",   "yes, ran",          "yes, failed",    "no, ran",
                         "no, failed", "failed of yes (%)", "95 % bounds (%)"};
    Table factors;
    factors.title = "Factor on the left side";
    factors.columns = {"equation", "for 99.9 % of the allowed runs to be right", "95 % bounds",
                       "at which half of the runs fail"};
    for (const Rule rule : kRules) {
      const std::vector<Seen> seen = seenBy(rule);
      std::array<std::array<std::size_t, 2>, 2> counts{};  // [yes][failed]
      for (const Seen& run : seen) {
        ++counts[run.excess < 1.0 ? 1 : 0][run.failed ? 1 : 0];
      }
      const Share share = shareOf(counts[1][1], counts[1][0] + counts[1][1]);
      confusion.rows.push_back({ruleName(rule), std::to_string(counts[1][0]),
                                std::to_string(counts[1][1]), std::to_string(counts[0][0]),
                                std::to_string(counts[0][1]), percent(share.seen),
                                percent(share.low) + " to " + percent(share.high)});
      const Threshold threshold = thresholdOf(seen);
      const std::optional<double> half = halfOf(seen);
      const auto text = [](double excess) {
        return excess > 0.0 ? number(1.0 / excess, 2) : std::string("more runs needed");
      };
      factors.rows.push_back({ruleName(rule), text(threshold.best),
                              text(threshold.highest) + " to " + text(threshold.lowest),
                              half ? number(1.0 / *half, 2) : std::string("none found")});
      if (rule == Rule::VerdictPosition || rule == Rule::ThreeReal) {
        experiment.checks.push_back({ruleName(rule) + ", share of the allowed runs that failed", "",
                                     "[P1] VI.A", 0.0, share.seen, 0.0, kVerdictShare,
                                     Mark::Predicted});
      }
      if (rule == Rule::ThreeReal) {
        // [P1] VI.A: (3) ignores the standstill.
        experiment.checks.push_back(
            {half ? "(3) with d_min^N, feed at which half of the runs fail beside its limit"
                  : "(3) with d_min^N, fastest feed tried beside its limit: half of the runs fail "
                    "nowhere",
             "", "[P1] VI.A: (3) is too strict", std::numeric_limits<double>::quiet_NaN(),
             half ? *half
                  : kLowestFactor * std::pow(kFactorStep, static_cast<double>(kFactors - 1)),
             1.0, std::numeric_limits<double>::infinity(), Mark::Predicted});
      }
    }
    experiment.tables.push_back(std::move(confusion));
    experiment.tables.push_back(std::move(factors));

    // δ = d_min as in Figure 4: (1) alone decides there.
    std::vector<Seen> figure;
    for (const Run& run : m_runs) {
      const Contour& contour = m_contours[run.contour];
      const Setting& setting = settings()[contour.setting];
      if (setting.method == MethodKind::Position && wasMade(run) &&
          setting.deltaMm == setting.pointDistanceMmMin) {
        figure.push_back(
            {run.feedMmPerS / borderMmPerS(Rule::One, setting, contour.distances, m_access),
             run.fate != forecast::RunFate::Ran});
      }
    }
    experiment.checks.push_back(
        {"(1) with delta = d_min, feed at which half of the runs fail beside the limit with "
         "25.8 ms (12.9 ms would be 2)",
         "", "[P1] V.B", std::nan(""), halfOf(figure).value_or(0.0), 1.0, 2.0, Mark::Predicted});
  }

  void addStrictness(Experiment& experiment) const {
    Table table;
    table.title = "Limit of the verdict beside the model (first contour of each combination)";
    table.columns = {"method",
                     "d_min (mm)",
                     "N",
                     "delta (mm)",
                     "verdict (mm/min)",
                     "model, 1 of 1000 fails (mm/min)",
                     "factor",
                     "model, half fail (mm/min)",
                     "simulated, first failure (mm/min)",
                     "simulated, half fail (mm/min)"};
    for (std::size_t setting = 0; setting < settings().size(); ++setting) {
      const Setting& one = settings()[setting];
      const Contour& contour = m_contours[setting * m_options.contours];
      const double reference = contour.referenceMmPerS;
      const auto limit = [&](double probability) {
        return feasibility::feedMmPerSAt(probability, contour.points, pointOf(contour, 1.0),
                                         m_model, 0.1 * reference, 10.0 * reference);
      };
      const double rare = limit(1e-3);
      const double half = limit(0.5);
      const Border border = borderOf(setting);
      const auto feed = [&](double mmPerS) {
        return mmPerS >= 10.0 * reference ? std::string("above all") : number(mmPerMin(mmPerS), 0);
      };
      table.rows.push_back({std::string(base::methodName(one.method)),
                            number(one.pointDistanceMmMin, 2), std::to_string(one.pointsPerLoop),
                            one.method == MethodKind::Position ? number(one.deltaMm, 2) : "",
                            number(mmPerMin(reference), 0), feed(rare),
                            rare >= 10.0 * reference ? "above 10" : number(rare / reference, 2),
                            feed(half), border.first ? number(mmPerMin(*border.first), 0) : "",
                            border.half ? number(mmPerMin(*border.half), 0) : ""});
    }
    experiment.tables.push_back(std::move(table));
  }

  void addModel(Experiment& experiment) const {
    // The mean of all contours of a setting at one factor, so that it is based on many runs.
    double sum = 0.0;
    std::size_t count = 0;
    Series seenSeries{"simulated against predicted", SeriesStyle::Points, false, {}, {}, {}};
    for (std::size_t setting = 0; setting < settings().size(); ++setting) {
      for (std::size_t index = 0; index < kFactors; ++index) {
        double predicted = 0.0;
        std::size_t failed = 0;
        std::size_t made = 0;
        for (std::size_t number = 0; number < m_options.contours; ++number) {
          const std::size_t contour = setting * m_options.contours + number;
          predicted += m_predicted[contour * kFactors + index];
          for (std::size_t run = 0; run < m_options.runsPerPoint; ++run) {
            const Run& one = m_runs[(contour * kFactors + index) * m_options.runsPerPoint + run];
            made += wasMade(one) ? 1 : 0;
            failed += wasMade(one) && one.fate != forecast::RunFate::Ran ? 1 : 0;
          }
        }
        if (made == 0) {
          continue;
        }
        predicted /= static_cast<double>(m_options.contours);
        const double seen = static_cast<double>(failed) / static_cast<double>(made);
        seenSeries.x.push_back(predicted);
        seenSeries.y.push_back(seen);
        sum += std::abs(predicted - seen);
        ++count;
      }
    }
    experiment.checks.push_back(
        {"extended model, mean difference of predicted probability and simulated frequency", "",
         "core/feasibility/probability.h", 0.0, count > 0 ? sum / static_cast<double>(count) : 1.0,
         0.0, feasibility::kProbabilityError, Mark::Predicted});
    Plot plot;
    plot.title = "Extended model beside the simulation";
    plot.xLabel = "predicted probability of a failed run";
    plot.yLabel = "share of simulated runs that failed";
    plot.series.push_back({"equal", SeriesStyle::Line, false, {0.0, 1.0}, {0.0, 1.0}, {}});
    plot.series.push_back(std::move(seenSeries));
    experiment.plots.push_back(std::move(plot));
  }

  struct Border {
    std::optional<double> first;  ///< lowest feed at which a run failed, mm/s
    std::optional<double> half;   ///< feed at which half of the runs fail, mm/s
  };

  /// Over all contours of a setting.
  [[nodiscard]] Border borderOf(std::size_t setting) const {
    Border border;
    std::optional<std::pair<double, double>> before;
    for (std::size_t index = 0; index < kFactors; ++index) {
      std::size_t failed = 0;
      std::size_t made = 0;
      double feedSum = 0.0;
      for (const Run& run : m_runs) {
        if (m_contours[run.contour].setting != setting || run.factor != index || !wasMade(run)) {
          continue;
        }
        ++made;
        feedSum += run.feedMmPerS;
        if (run.fate != forecast::RunFate::Ran) {
          ++failed;
          border.first = std::min(border.first.value_or(run.feedMmPerS), run.feedMmPerS);
        }
      }
      if (made == 0) {
        continue;
      }
      const double feed = feedSum / static_cast<double>(made);
      const double share = static_cast<double>(failed) / static_cast<double>(made);
      if (share >= 0.5 && before && !border.half) {
        border.half = before->first +
                      (0.5 - before->second) / (share - before->second) * (feed - before->first);
      }
      if (share < 0.5) {
        before = {feed, share};
      }
    }
    return border;
  }

  /// The settings of one plot, by what is on its axis.
  void addPlots(Experiment& experiment) const {
    const auto matches = [](const auto& accept, const auto& abscissa) {
      std::vector<std::pair<double, std::size_t>> list;
      for (std::size_t i = 0; i < settings().size(); ++i) {
        if (accept(settings()[i])) {
          list.emplace_back(abscissa(settings()[i]), i);
        }
      }
      std::sort(list.begin(), list.end());
      return list;
    };
    experiment.plots.push_back(
        plotOf("Method position, delta = d_min: feed over d_min", "d_min (mm)",
               matches(
                   [](const Setting& s) {
                     return s.method == MethodKind::Position && s.deltaMm == s.pointDistanceMmMin &&
                            s.pointsPerLoop == 7;
                   },
                   [](const Setting& s) { return s.pointDistanceMmMin; }),
               {Rule::One, Rule::TwoSafe}));
    experiment.plots.push_back(
        plotOf("Method signal, d_min 0.15 mm: feed over N", "N",
               matches(
                   [](const Setting& s) {
                     return s.method == MethodKind::Signal && s.pointDistanceMmMin == 0.15;
                   },
                   [](const Setting& s) { return static_cast<double>(s.pointsPerLoop); }),
               {Rule::Three, Rule::ThreeReal}));
    experiment.plots.push_back(
        plotOf("Method position, d_min 0.2 mm: feed over delta", "delta (mm)",
               matches(
                   [](const Setting& s) {
                     return s.method == MethodKind::Position && s.pointDistanceMmMin == 0.2 &&
                            s.pointsPerLoop == 7;
                   },
                   [](const Setting& s) { return s.deltaMm; }),
               {Rule::One, Rule::Two, Rule::TwoSafe}));
  }

  [[nodiscard]] Plot plotOf(const std::string& title, const std::string& xLabel,
                            const std::vector<std::pair<double, std::size_t>>& list,
                            const std::vector<Rule>& rules) const {
    Plot plot;
    plot.title = title;
    plot.xLabel = xLabel;
    plot.yLabel = "F (mm/min)";
    for (const Rule rule : rules) {
      Series series{rule == Rule::ThreeReal ? "(3) with d_min^N" : ruleName(rule),
                    SeriesStyle::Line,
                    true,
                    {},
                    {},
                    {}};
      for (const auto& [abscissa, setting] : list) {
        double sum = 0.0;
        for (std::size_t number = 0; number < m_options.contours; ++number) {
          const Contour& contour = m_contours[setting * m_options.contours + number];
          sum += borderMmPerS(rule, settings()[setting], contour.distances, m_access);
        }
        series.x.push_back(abscissa);
        series.y.push_back(mmPerMin(sum / static_cast<double>(m_options.contours)));
      }
      plot.series.push_back(std::move(series));
    }
    Series band{"extended model, 0.1 % to 50 %", SeriesStyle::Band, false, {}, {}, {}};
    Series first{"simulated, lowest feed with a failure", SeriesStyle::Points, false, {}, {}, {}};
    Series half{"simulated, half of the runs fail", SeriesStyle::Points, false, {}, {}, {}};
    for (const auto& [abscissa, setting] : list) {
      const Contour& contour = m_contours[setting * m_options.contours];
      const double reference = contour.referenceMmPerS;
      const auto limit = [&](double probability) {
        return mmPerMin(feasibility::feedMmPerSAt(probability, contour.points,
                                                  pointOf(contour, 1.0), m_model, 0.1 * reference,
                                                  factor(kFactors - 1) * reference));
      };
      band.x.push_back(abscissa);
      band.y.push_back(limit(1e-3));
      band.yUpper.push_back(limit(0.5));
      const Border border = borderOf(setting);
      if (border.first) {
        first.x.push_back(abscissa);
        first.y.push_back(mmPerMin(*border.first));
      }
      if (border.half) {
        half.x.push_back(abscissa);
        half.y.push_back(mmPerMin(*border.half));
      }
    }
    plot.series.push_back(std::move(band));
    plot.series.push_back(std::move(first));
    plot.series.push_back(std::move(half));
    return plot;
  }

  void addNotes(Experiment& experiment) const {
    experiment.notes.push_back(
        "A run failed if the oracle found repeated, skipped, foreign or misplaced points, or if it "
        "was not completed.");
    experiment.notes.push_back(
        "Each equation is judged alone, over all runs of its method: a run that (2) allows may "
        "have failed because of (1). Start depends on the lines named verdict.");
    experiment.notes.push_back(
        "The shares depend on which feeds were tried: roughly half of them are below the limit of "
        "the verdict and half above. The bounds follow from the number of runs alone (Wilson, 95 "
        "%); runs on the same contour are not independent of each other, so the true bounds are "
        "wider.");
    experiment.notes.push_back(
        fmt::format("With {} points and N 7 the last loop holds {}: the client must fill a whole "
                    "window while the control executes this rest. d_min^N does not include it; "
                    "where method signal fails far below the limit of the verdict, it fails there.",
                    m_options.pointsPerRun,
                    (m_options.pointsPerRun - 1) % 7 == 0
                        ? std::string("one point")
                        : fmt::format("{} points", (m_options.pointsPerRun - 1) % 7 + 1)));
    experiment.notes.push_back(
        "A factor below 1 means that the left side may be multiplied by it: the equation is too "
        "strict. (3) ignores the standstill, about 40 ms for every window ([P1] VI.A), but also "
        "the larger of the two windows, which has one point more if N is odd, and the scatter of "
        "access times. On average the first outweighs the others; for one failure in a thousand it "
        "need not.");
  }

  EquationsOptions m_options;
  machine::MachineConfig m_machine;
  feasibility::StreamModel m_model;
  base::Duration m_access;
  std::vector<Contour> m_contours;
  std::vector<Run> m_runs;
  std::vector<double> m_predicted;
  std::size_t m_missing = 0;
  std::size_t m_refused = 0;
  base::Error m_error;
};

}  // namespace

base::Result<Experiment> runEquations(const EquationsOptions& options,
                                      const machine::MachineConfig& machine,
                                      base::Executor& executor,
                                      const forecast::RegionProgress& progress) {
  return Equations(options, machine).run(executor, progress);
}

}  // namespace rivulet::papers
