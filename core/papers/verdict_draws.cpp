// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/verdict_draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "base/contract.h"
#include "base/random.h"
#include "base/units.h"
#include "forecast/machine_verdict.h"
#include "forecast/region.h"
#include "papers/figures.h"
#include "papers/meter.h"
#include "streaming/simulation/scenario.h"

namespace rivulet::papers {

namespace {

using base::MethodKind;

constexpr std::array kPresets{"dmu75", "dmu75-5axis", "dmu75-arrays", "ideal", "plc"};
enum class Course { Even, Uneven, Corners, Arcs };
constexpr std::array kCourses{"even", "uneven", "corners", "arcs"};
constexpr int kPointsPerLoopLeast = 3;
constexpr int kPointsPerLoopMost = 33;
/// Enough for two windows of that many points.
constexpr int kRParameters = 400;
constexpr double kFactorLeast = 0.80;
constexpr double kFactorMost = 1.05;
/// Of methods that wait instead: faster than the client as well.
constexpr double kWaitingFactorMost = 4.0;
/// No axis moves faster.
constexpr double kFeedMmPerSMost = 40000.0 / 60.0;
/// Of every so many draws, the largest right feed is looked for.
constexpr std::size_t kSearched = 24;
constexpr double kSearchStep = 1.1;
constexpr int kSearchSteps = 10;
constexpr std::size_t kSearchRuns = 10;
/// Of each draw of a method that can go wrong, at its feed.
constexpr std::size_t kRuns = 3;
/// A wait that is shorter than this is none: a pass of the waiting loop is as long.
constexpr double kWaitS = 0.02;
/// A run that repeats its points for ever is ended.
constexpr base::Duration kStallDeadline = std::chrono::seconds{10};
constexpr base::Duration kRunLimit = std::chrono::minutes{10};
constexpr std::size_t kWrongShown = 20;
constexpr double kFailuresMost = 1e-3;

/// One draw; follows from its number alone.
struct Draw {
  machine::MachineConfig machine;
  std::size_t preset = 0;
  bool isSoft = false;
  Course course = Course::Even;
  feasibility::OperatingPoint point;
  std::vector<gcode::StreamPoint> points;
  base::Vec3 startMm;
  double factor = 1.0;  ///< feed, of the limit
  bool isSearched = false;
};

std::vector<base::Vec3> courseOf(Course course, std::size_t count, double stepMm,
                                 base::Random& random) {
  if (course == Course::Even || course == Course::Uneven) {
    return streaming::drawContour({count, stepMm, course == Course::Even ? 0.0 : stepMm}, random);
  }
  // Corners: a staircase; arcs: S-bends. Both go on in X and Y and stay where the axes reach.
  const auto perSide = static_cast<std::size_t>(1 + random.below(6));
  const double radiusMm = stepMm * (3.0 + 30.0 * random.uniform());
  std::vector<base::Vec3> points;
  base::Vec3 at{};
  double angle = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(at);
    if (course == Course::Corners) {
      angle = (i / perSide) % 2 == 0 ? 0.0 : std::numbers::pi / 2.0;
    } else {
      const double turn = stepMm / radiusMm;
      const double swung = std::fmod(turn * static_cast<double>(i), 2.0 * std::numbers::pi);
      angle += swung < std::numbers::pi ? turn : -turn;
    }
    at = at + stepMm * base::Vec3{std::cos(angle), std::sin(angle), 0.0};
  }
  return points;
}

MethodKind methodOf(base::Random& random) {
  // Methods that can go wrong need the most runs.
  constexpr std::array kMethods{MethodKind::Position, MethodKind::Position, MethodKind::Position,
                                MethodKind::Position, MethodKind::Signal,   MethodKind::Signal,
                                MethodKind::Signal,   MethodKind::Signal,   MethodKind::Window,
                                MethodKind::Credit,   MethodKind::File};
  return kMethods[random.below(kMethods.size())];
}

Draw drawOf(std::size_t index, const std::vector<machine::MachineConfig>& machines) {
  base::Random random = base::Random(1).fork(index);
  Draw draw;
  draw.preset = random.below(machines.size());
  draw.machine = machines[draw.preset];
  draw.isSoft = random.below(2) == 0;
  draw.machine.resetDynamics = draw.isSoft ? machine::Dynamics::Soft : machine::Dynamics::Brisk;
  draw.machine.rParameterCount = kRParameters;
  draw.course = static_cast<Course>(random.below(kCourses.size()));
  draw.point.method = methodOf(random);
  draw.point.pointsPerLoop =
      kPointsPerLoopLeast + static_cast<int>(random.below(kPointsPerLoopMost - 2));
  const double stepMm = 0.05 * std::pow(10.0, random.uniform());
  draw.point.deltaMm = stepMm * (0.3 + random.uniform());
  const auto count = 60 + static_cast<std::size_t>(random.below(81));
  for (const base::Vec3& positionMm : courseOf(draw.course, count, stepMm, random)) {
    draw.points.push_back({positionMm, base::LineNumber{}});
  }
  draw.startMm = forecast::regionStartMm(draw.points, draw.point.deltaMm);
  const bool hasLimit = !base::hasWindows(draw.point.method);
  const double share = random.uniform();
  draw.factor = hasLimit || random.below(2) == 0
                    ? kFactorLeast + (kFactorMost - kFactorLeast) * share
                    : kFactorMost * std::pow(kWaitingFactorMost / kFactorMost, share);
  draw.isSearched = hasLimit && index % kSearched == 0;
  return draw;
}

streaming::Scenario scenarioOf(const Draw& draw, double feedMmPerS, std::uint64_t seed) {
  streaming::Scenario scenario;
  scenario.machine = draw.machine;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    scenario.machine.axes[axis].startMm = draw.startMm[axis];
  }
  std::vector<base::Vec3> positions;
  for (const gcode::StreamPoint& point : draw.points) {
    positions.push_back(point.positionMm);
  }
  scenario.program = streaming::programOf(positions);
  templates::TemplateParameters& parameters = scenario.settings.parameters;
  parameters.method = draw.point.method;
  parameters.pointsPerLoop = draw.point.pointsPerLoop;
  parameters.layout = templates::Layout::Contiguous;
  parameters.rParameterCount = kRParameters;
  scenario.settings.deltaMm = draw.point.deltaMm;
  scenario.settings.feedMmPerS = feedMmPerS;
  scenario.settings.isCommissioned = true;
  scenario.settings.monitor = false;  // reads only what the method needs
  scenario.settings.stallDeadline = kStallDeadline;
  scenario.limit = kRunLimit;
  scenario.seed = seed;
  return scenario;
}

/// What came of a draw. Numbers only: another computer can make it.
struct Outcome {
  double isMade = 0.0;
  double limitMmPerS = 0.0;     ///< of the verdict; 0: it allows no feed
  double equationMmPerS = 0.0;  ///< of the equations alone
  double isAllowed = 0.0;       ///< by the verdict at the drawn share of the limit
  double wrongRuns = 0.0;       ///< at the drawn share of the limit
  double areWrong = 0.0;        ///< a run at this share of the limit of the equations alone
  double largestRight = 0.0;    ///< feed of the limit up to which all runs are right; 0: not sought
  double saysWaits = 0.0;
  double reachSaysWaits = 0.0;
  double predictedWaitS = 0.0;
  double waitS = 0.0;
  double predictedS = 0.0;
  double durationS = 0.0;

  [[nodiscard]] static constexpr auto members() {
    return std::array{&Outcome::isMade,         &Outcome::limitMmPerS, &Outcome::equationMmPerS,
                      &Outcome::isAllowed,      &Outcome::wrongRuns,   &Outcome::areWrong,
                      &Outcome::largestRight,   &Outcome::saysWaits,   &Outcome::reachSaysWaits,
                      &Outcome::predictedWaitS, &Outcome::waitS,       &Outcome::predictedS,
                      &Outcome::durationS};
  }
};

/// Every point once and in order, to the end.
bool isRight(const streaming::RunReport& report) {
  return report.outcome == streaming::Outcome::Completed && report.integrity.isFaultless();
}

/// Makes one draw.
class Trial {
 public:
  Trial(const ExperimentOptions& options, const Draw& draw, std::size_t index)
      : m_options(options), m_draw(draw), m_random(base::Random(2).fork(index)) {}

  [[nodiscard]] Outcome run() {
    Outcome outcome;
    outcome.isMade = 1.0;
    if (m_draw.point.method == MethodKind::File) {
      runFile(outcome);
    } else if (base::hasWindows(m_draw.point.method)) {
      runWindows(outcome);
    } else {
      runLoop(outcome);
    }
    return outcome;
  }

 private:
  /// Measured exactly; each method with lists.
  [[nodiscard]] feasibility::AccessModel access() const {
    const machine::AccessCost& cost = m_draw.machine.access;
    feasibility::AccessModel model;
    model.measured = feasibility::MeasuredAccess{{cost.readOverhead, cost.nodeTimeMean},
                                                 {cost.writeOverhead, cost.nodeTimeMean}};
    return model;
  }
  [[nodiscard]] feasibility::Verdict verdictAt(double feedMmPerS, bool onMachine) const {
    feasibility::OperatingPoint point = m_draw.point;
    point.feedMmPerS = feedMmPerS;
    const auto distances = feasibility::programDistances(m_draw.points, point.pointsPerLoop);
    const auto verdict =
        onMachine ? forecast::judgeOn(m_draw.machine, m_draw.points, point, distances, access())
                  : feasibility::judge(point, distances, access());
    RIVULET_ASSERT(verdict);
    return *verdict;
  }
  [[nodiscard]] double limit(bool onMachine) const {
    constexpr double kAnyMmPerS = 10.0;
    return std::min(verdictAt(kAnyMmPerS, onMachine).feedMmPerSMax, kFeedMmPerSMost);
  }
  [[nodiscard]] streaming::Scenario scenario(double feedMmPerS) {
    streaming::Scenario scenario = scenarioOf(m_draw, feedMmPerS, m_random.bits());
    if (m_options.wrong) {
      m_options.wrong(scenario);
    }
    return scenario;
  }
  [[nodiscard]] bool isWrongAt(double feedMmPerS) {
    return !isRight(streaming::simulate(scenario(feedMmPerS)));
  }

  void runLoop(Outcome& outcome) {
    outcome.limitMmPerS = limit(true);
    outcome.equationMmPerS = limit(false);
    if (outcome.equationMmPerS > 0.0) {
      outcome.areWrong = isWrongAt(m_draw.factor * outcome.equationMmPerS) ? 1.0 : 0.0;
    }
    if (outcome.limitMmPerS <= 0.0) {
      return;
    }
    outcome.isAllowed = verdictAt(m_draw.factor * outcome.limitMmPerS, true).feasible ? 1.0 : 0.0;
    for (std::size_t run = 0; run < kRuns; ++run) {
      outcome.wrongRuns += isWrongAt(m_draw.factor * outcome.limitMmPerS) ? 1.0 : 0.0;
    }
    if (!m_draw.isSearched) {
      return;
    }
    double right = 1.0;
    for (int step = 0; step < kSearchSteps; ++step, right *= kSearchStep) {
      for (std::size_t run = 0; run < kSearchRuns; ++run) {
        if (isWrongAt(right * kSearchStep * outcome.limitMmPerS)) {
          outcome.largestRight = right;
          return;
        }
      }
    }
    outcome.largestRight = right;
  }

  static double standingS(const streaming::RunReport& report) {
    double sum = 0.0;
    for (const trace::Pause& pause : report.pauses) {
      sum += base::toSeconds(pause.duration);
    }
    return sum;
  }

  void runWindows(Outcome& outcome) {
    outcome.limitMmPerS = limit(true);
    outcome.equationMmPerS = limit(false);
    const double feedMmPerS =
        std::min(m_draw.factor * std::max(outcome.limitMmPerS, 1.0), kFeedMmPerSMost);
    outcome.saysWaits = verdictAt(feedMmPerS, true).waits ? 1.0 : 0.0;
    outcome.reachSaysWaits = verdictAt(feedMmPerS, false).waits ? 1.0 : 0.0;
    feasibility::OperatingPoint point = m_draw.point;
    point.feedMmPerS = feedMmPerS;
    const feasibility::Prediction prediction = feasibility::predict(
        m_draw.points, point, forecast::streamModelOf(m_draw.machine), m_draw.startMm);
    outcome.predictedWaitS = base::toSeconds(prediction.waiting);
    outcome.predictedS = base::toSeconds(prediction.duration);
    streaming::Scenario run = scenario(feedMmPerS);
    const streaming::RunReport report = streaming::simulate(run);
    outcome.wrongRuns = isRight(report) ? 0.0 : 1.0;
    // The same with a client that needs no time.
    run.machine.access.readOverhead = run.machine.access.writeOverhead = {};
    run.machine.access.nodeTimeMean = run.machine.access.nodeTimeDeviation = {};
    run.machine.access.nodeTimeMin = {};
    outcome.waitS = std::max(0.0, standingS(report) - standingS(streaming::simulate(run)));
    outcome.durationS = base::toSeconds(report.duration);
  }

  void runFile(Outcome& outcome) {
    outcome.limitMmPerS = kFeedMmPerSMost;
    const double feedMmPerS = kFeedMmPerSMost * std::pow(0.01, m_random.uniform());
    const streaming::RunReport report = streaming::simulate(scenario(feedMmPerS));
    outcome.wrongRuns = isRight(report) ? 0.0 : 1.0;
  }

  const ExperimentOptions& m_options;
  const Draw& m_draw;
  base::Random m_random;
};

/// The mean that is exceeded by its count with 95 % at least: of a Poisson distribution.
double boundOf(std::size_t count) {
  const auto atMost = [count](double mean) {
    double term = std::exp(-mean);
    double sum = term;
    for (std::size_t i = 1; i <= count; ++i) {
      term *= mean / static_cast<double>(i);
      sum += term;
    }
    return sum;
  };
  double low = 0.0;
  double high = 10.0 + 3.0 * static_cast<double>(count);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (atMost(middle) > 0.05 ? low : high) = middle;
  }
  return high;
}

/// Runs of a group, and how many of them went wrong.
struct Tally {
  std::size_t draws = 0;
  std::size_t none = 0;  ///< draws in which no feed is allowed
  std::size_t allowed = 0;
  std::size_t wrong = 0;
  std::size_t equationsAllowed = 0;
  std::size_t equationsWrong = 0;
  std::vector<double> givenAway;

  void add(const Draw& draw, const Outcome& outcome) {
    ++draws;
    const bool hasWindows = base::hasWindows(draw.point.method);
    if (outcome.limitMmPerS <= 0.0) {
      ++none;
    } else if (hasWindows || outcome.isAllowed > 0.0) {
      allowed += hasWindows ? 1 : kRuns;
      wrong += static_cast<std::size_t>(outcome.wrongRuns);
    }
    if (outcome.equationMmPerS > 0.0 && (hasWindows || draw.factor < 1.0)) {
      ++equationsAllowed;
      equationsWrong += outcome.areWrong > 0.0 ? 1 : 0;
    }
    if (outcome.largestRight > 0.0) {
      givenAway.push_back(1.0 - 1.0 / outcome.largestRight);
    }
  }
  [[nodiscard]] double wrongShare() const {
    return allowed == 0 ? 0.0 : static_cast<double>(wrong) / static_cast<double>(allowed);
  }
  [[nodiscard]] double wrongBound() const {
    return allowed == 0 ? 1.0 : boundOf(wrong) / static_cast<double>(allowed);
  }
  [[nodiscard]] double wrongOfEquations() const {
    return equationsAllowed == 0
               ? 0.0
               : static_cast<double>(equationsWrong) / static_cast<double>(equationsAllowed);
  }
  [[nodiscard]] std::vector<std::string> row(const std::string& name) const {
    return {name,
            std::to_string(draws),
            std::to_string(none),
            std::to_string(allowed),
            std::to_string(wrong),
            fmt::format("{:.2f}", 1e3 * wrongBound()),
            fmt::format("{} of {}", equationsWrong, equationsAllowed),
            givenAway.empty() ? "" : fmt::format("{:.0f}", 100.0 * medianOf(givenAway))};
  }
};

/// Waits of methods with windows, as predicted and as made.
struct Waits {
  std::size_t runs = 0;
  std::size_t waited = 0;
  std::size_t within = 0;
  std::size_t timesWithin = 0;
  /// Says no, did not; says no, did; says, did not; says, did.
  std::array<std::size_t, 4> flags{};
  std::array<std::size_t, 4> flagsOfReach{};

  void add(const Outcome& outcome) {
    ++runs;
    const bool did = outcome.waitS > kWaitS;
    ++flags[(outcome.saysWaits > 0.0 ? 2U : 0U) + (did ? 1U : 0U)];
    ++flagsOfReach[(outcome.reachSaysWaits > 0.0 ? 2U : 0U) + (did ? 1U : 0U)];
    if (did) {
      ++waited;
      within += std::abs(outcome.predictedWaitS - outcome.waitS) <= 0.1 * outcome.waitS ? 1 : 0;
    }
    timesWithin +=
        std::abs(outcome.predictedS - outcome.durationS) <= 0.1 * outcome.durationS ? 1 : 0;
  }
  [[nodiscard]] double withinShare() const {
    return waited == 0 ? 1.0 : static_cast<double>(within) / static_cast<double>(waited);
  }
};

struct Groups {
  std::vector<std::pair<std::string, Tally>> methods;
  std::vector<std::pair<std::string, Tally>> parts;  ///< of position and signal
  std::vector<std::pair<std::string, Waits>> waits;
  std::vector<std::vector<std::string>> wrong;  ///< allowed runs that went wrong, each

  template <typename T>
  static T& in(std::vector<std::pair<std::string, T>>& list, const std::string& name) {
    for (auto& [known, value] : list) {
      if (known == name) {
        return value;
      }
    }
    return list.emplace_back(name, T{}).second;
  }
};

std::string rangeOf(int pointsPerLoop) {
  return pointsPerLoop < 8 ? "N 3 to 7" : pointsPerLoop < 17 ? "N 8 to 16" : "N 17 to 33";
}

/// An allowed run that went wrong.
std::vector<std::string> wrongRow(std::size_t index, const Draw& draw, const Outcome& outcome) {
  const double feedMmPerS = draw.factor * outcome.limitMmPerS;
  return {std::to_string(index),
          std::string(base::methodName(draw.point.method)),
          kPresets[draw.preset],
          draw.isSoft ? "SOFT" : "BRISK",
          kCourses[static_cast<std::size_t>(draw.course)],
          std::to_string(draw.points.size()),
          std::to_string(draw.point.pointsPerLoop),
          fmt::format("{:.3f}", feasibility::programDistances(draw.points, 2).pointDistanceMmMin),
          fmt::format("{:.3f}", draw.point.deltaMm),
          fmt::format("{:.0f}", base::mmPerMinFromMmPerS(feedMmPerS)),
          fmt::format("{:.3f}", draw.factor)};
}

Groups groupsOf(const std::vector<double>& numbers, std::size_t draws,
                const std::vector<machine::MachineConfig>& machines) {
  Groups groups;
  for (const MethodKind method : {MethodKind::Position, MethodKind::Signal, MethodKind::Window,
                                  MethodKind::Credit, MethodKind::File}) {
    Groups::in(groups.methods, std::string(base::methodName(method)));
  }
  constexpr auto kMembers = Outcome::members();
  for (std::size_t index = 0; index < draws; ++index) {
    Outcome outcome;
    for (std::size_t i = 0; i < kMembers.size(); ++i) {
      outcome.*kMembers[i] = numbers[index * kMembers.size() + i];
    }
    const Draw draw = drawOf(index, machines);
    const std::string method(base::methodName(draw.point.method));
    Tally& tally = Groups::in(groups.methods, method);
    const std::size_t wrongBefore = tally.wrong;
    tally.add(draw, outcome);
    if (tally.wrong > wrongBefore && groups.wrong.size() < kWrongShown) {
      groups.wrong.push_back(wrongRow(index, draw, outcome));
    }
    if (base::fillsWindows(draw.point.method)) {
      Groups::in(groups.waits, method).add(outcome);
    }
    if (!base::hasWindows(draw.point.method)) {
      for (const std::string& part :
           {std::string(draw.isSoft ? "SOFT" : "BRISK"),
            std::string(kCourses[static_cast<std::size_t>(draw.course)]),
            std::string(kPresets[draw.preset]), rangeOf(draw.point.pointsPerLoop)}) {
        Groups::in(groups.parts, method + ", " + part).add(draw, outcome);
      }
    }
  }
  std::ranges::sort(groups.parts, {}, [](const auto& part) { return part.first; });
  return groups;
}

void addChecks(Experiment& experiment, const Groups& groups) {
  for (const auto& [method, tally] : groups.methods) {
    const bool canFail = method == "position" || method == "signal";
    if (!canFail) {
      experiment.checks.push_back({fmt::format("method {}: runs that went wrong", method), "",
                                   "promise of the method", 0.0, static_cast<double>(tally.wrong),
                                   0.0, 0.0, Mark::ByConstruction});
      continue;
    }
    experiment.checks.push_back(
        {fmt::format("method {}: share of the allowed runs that went wrong, 95 % bound", method),
         "", "promise of the verdict", 0.0, tally.wrongBound(), 0.0, kFailuresMost, Mark::Predicted,
         tally.wrongOfEquations()});
  }
  for (const auto& [name, tally] : groups.parts) {
    if (name.ends_with("BRISK") && !tally.givenAway.empty()) {
      experiment.checks.push_back(
          {fmt::format("method {}: median share of the largest right feed that is given away",
                       name),
           "", "wanted", 0.0, medianOf(tally.givenAway), 0.0, 0.15, Mark::Predicted});
    }
  }
  for (const auto& [method, waits] : groups.waits) {
    experiment.checks.push_back(
        {fmt::format("method {}: share of the runs with waits whose waits are predicted within 10 "
                     "%",
                     method),
         "", "wanted", 1.0, waits.withinShare(), 0.9, 1.0, Mark::Predicted});
  }
}

void addTables(Experiment& experiment, const Groups& groups) {
  const std::vector<std::string> columns{"",
                                         "draws",
                                         "no feed allowed",
                                         "allowed runs",
                                         "wrong",
                                         "95 % bound (in 1000)",
                                         "wrong if the equations alone decide",
                                         "given away, median (%)"};
  Table methods{"Runs that the verdict allows, by method", columns, {}};
  for (const auto& [name, tally] : groups.methods) {
    methods.rows.push_back(tally.row(name));
  }
  Table parts{"Of them, by dynamics, path, machine and N", columns, {}};
  for (const auto& [name, tally] : groups.parts) {
    parts.rows.push_back(tally.row(name));
  }
  Table waits{"Waits of methods with windows",
              {"method", "runs", "waited", "predicted within 10 %", "time of the run within 10 %"},
              {}};
  Table flags{"Whether the machine is said to wait",
              {"method", "by", "said, did", "said, did not", "not said, did", "not said, did not"},
              {}};
  for (const auto& [name, one] : groups.waits) {
    waits.rows.push_back({name, std::to_string(one.runs), std::to_string(one.waited),
                          std::to_string(one.within), std::to_string(one.timesWithin)});
    for (const auto& [by, list] :
         {std::pair{"verdict", one.flags}, std::pair{"reach alone", one.flagsOfReach}}) {
      flags.rows.push_back({name, by, std::to_string(list[3]), std::to_string(list[2]),
                            std::to_string(list[1]), std::to_string(list[0])});
    }
  }
  Table wrong{fmt::format("Allowed runs that went wrong (the first {})", kWrongShown),
              {"draw", "method", "machine", "dynamics", "path", "points", "N", "d_min (mm)",
               "delta (mm)", "F (mm/min)", "F by the limit"},
              groups.wrong};
  experiment.tables = {std::move(methods), std::move(parts), std::move(waits), std::move(flags),
                       std::move(wrong)};
}

}  // namespace

base::Result<Experiment> runVerdictDraws(const ExperimentOptions& options) {
  std::vector<machine::MachineConfig> machines;
  for (const char* preset : kPresets) {
    auto machine = machine::loadPreset(preset);
    if (!machine) {
      return base::fail(machine.error());
    }
    machines.push_back(*std::move(machine));
  }
  const std::size_t draws = kDrawsPerSeed * (options.seeds > 0 ? options.seeds : kVerdictSeeds);
  Meter meter(options, draws);
  constexpr auto kMembers = Outcome::members();
  const auto numbers = options.executor.numbersOf(
      draws, kMembers.size(), [&](std::size_t index, std::span<double> results) {
        if (meter.isCancelled()) {
          return;
        }
        const Draw draw = drawOf(index, machines);
        const Outcome outcome = Trial(options, draw, index).run();
        for (std::size_t i = 0; i < kMembers.size(); ++i) {
          results[i] = outcome.*kMembers[i];
        }
        meter.add();
      });
  if (const auto ended = meter.endOf(numbers.has_value()); !ended) {
    return base::fail(ended.error());
  }
  Experiment experiment;
  experiment.name = "verdict";
  experiment.title = "What the verdict allows, and what comes of it";
  experiment.setup = fmt::format(
      "{} draws: presets {}; SOFT or BRISK after a reset; even, uneven, cornered and bent paths of "
      "60 to 140 points, steps of 0.05 to 0.5 mm; δ of 0.3 to 1.3 steps; N {} to {}; feeds of "
      "{:.2f} to {:.2f} times the largest that the verdict allows, up to {:.0f} times with methods "
      "that wait. The verdict knows the mean access times, and does not know the dynamics.",
      draws, fmt::join(kPresets, ", "), kPointsPerLoopLeast, kPointsPerLoopMost, kFactorLeast,
      kFactorMost, kWaitingFactorMost);
  const Groups groups = groupsOf(*numbers, draws, machines);
  addChecks(experiment, groups);
  addTables(experiment, groups);
  experiment.notes = {
      fmt::format(
          "Of each draw of position and signal {} runs are made. The bound takes all runs for "
          "independent; those of one draw share their path.",
          kRuns),
      "Null model: the equations of [P1] alone, at the same share of their own limit, one run.",
      fmt::format("Given away: of the largest feed up to which {} runs at each step of 10 % were "
                  "right, looked for in every {}th draw, up to {:.1f} times the limit.",
                  kSearchRuns, kSearched, std::pow(kSearchStep, kSearchSteps)),
      "Method file is drawn at any feed: what a transfer costs is not known, so nothing is "
      "predicted."};
  return experiment;
}

}  // namespace rivulet::papers
