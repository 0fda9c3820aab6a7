// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/calibration.h"

#include <fmt/format.h>

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/contract.h"
#include "base/random.h"
#include "opcua/await.h"
#include "streaming/control/access_probe.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Result;
using opcua::Grouping;
using opcua::LinkError;

constexpr std::array<int, 7> kCounts{1, 2, 5, 10, 20, 50, 100};
constexpr std::array kArrays{Grouping::ArrayCount, Grouping::ArrayRange};
/// Shots of each kind that show how long the rest takes.
constexpr int kFirstShots = 5;
/// Before them, one that does not count: a control may have to look a node up once.
constexpr int kIdleShots = 1;
/// [P1] Table I.
constexpr double kAssumedNodeNs = 4.3e6;
/// Deviation from a straight line, as a share of a duration; see `AccessFit`.
constexpr double kLineShare = 0.005;
constexpr double kLineMs = 0.001;
constexpr int kTailPerMille = 990;

constexpr const char* kUntouched = " The scratch cells have their old values.";

double nanoseconds(Duration duration) {
  return static_cast<double>(duration.count());
}

Duration fromNanoseconds(double value) {
  return Duration{std::llround(value)};
}

/// Of a request with this many cells.
Duration deadlineOf(Duration deadline, std::size_t cells) {
  constexpr Duration kPerCell = std::chrono::milliseconds{20};
  return deadline + kPerCell * static_cast<Duration::rep>(cells);
}

/// Requests that are alike, while they are measured.
struct Kind {
  bool write = false;
  int nodes = 1;
  Grouping grouping = Grouping::List;
  std::vector<Duration> durations;
  double sumNs = 0.0;
  double assumedNs = 0.0;  ///< of one request, as long as none has been measured
  int planned = 0;
  bool refused = false;

  [[nodiscard]] double meanNs() const {
    return durations.empty() ? assumedNs : sumNs / static_cast<double>(durations.size());
  }
};

std::vector<Kind> kindsOf(int cells, const std::vector<Grouping>& forms) {
  std::vector<Kind> kinds;
  for (const int count : kCounts) {
    for (const Grouping form : forms) {
      for (const bool write : {false, true}) {
        if (count <= cells) {
          kinds.push_back({write, count, form, {}, 0.0, kAssumedNodeNs * count, 0, false});
        }
      }
    }
  }
  return kinds;
}

/// Every kind gets the same time, unless it needs less. @param budgetNs  of all shots; 0: no limit
void planShots(std::vector<Kind>& kinds, int shots, double budgetNs) {
  const auto within = [shots](const Kind& kind, double timeNs) {
    const double most = timeNs / std::max(kind.meanNs(), 1.0);
    return kind.refused ? 0
                        : static_cast<int>(std::clamp(
                              std::floor(most), static_cast<double>(std::min(kFirstShots, shots)),
                              static_cast<double>(shots)));
  };
  const auto total = [&](double timeNs) {
    double sum = 0.0;
    for (const Kind& kind : kinds) {
      sum += kind.meanNs() * within(kind, timeNs);
    }
    return sum;
  };
  double longest = 0.0;
  for (const Kind& kind : kinds) {
    longest = std::max(longest, kind.meanNs() * (shots + 1));
  }
  double share = longest;
  if (budgetNs > 0.0 && total(longest) > budgetNs) {
    double low = 0.0;
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + share) / 2.0;
      (total(middle) > budgetNs ? share : low) = middle;
    }
    share = low;
  }
  for (Kind& kind : kinds) {
    kind.planned = within(kind, share);
  }
}

/// Cost of the proof of the forms, the last write and the last read.
double besideNs(int cells, const std::vector<Grouping>& forms) {
  constexpr double kAccessesPerCell = 4.0;
  return kAssumedNodeNs * cells * kAccessesPerCell * static_cast<double>(forms.size());
}

struct Line {
  double intercept = 0.0;
  double slope = 0.0;
};

struct WeightedPoint {
  double x = 0.0;
  double y = 0.0;
  double weight = 1.0;
};

/// Weighted least squares with neither figure below zero: no request takes less time for more
/// cells. With only one x the line goes through the origin. @param points  x > 0
Line lineOf(const std::vector<WeightedPoint>& points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixX2d sides(count,
                         2);  // of each equation weight · (intercept + slope · x) = weight · y
  Eigen::VectorXd values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const WeightedPoint& point = points[static_cast<std::size_t>(i)];
    const double weight = std::sqrt(point.weight);
    sides.row(i) << weight, weight * point.x;
    values[i] = weight * point.y;
  }
  /// The best factor of one column alone.
  const auto along = [&](Eigen::Index column) {
    return sides.col(column).dot(values) / sides.col(column).squaredNorm();
  };
  if (points.empty()) {
    return {};
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX2d> solver(sides);
  if (solver.rank() < 2) {
    return {0.0, along(1)};
  }
  const Eigen::Vector2d line = solver.solve(values);
  if (line[1] <= 0.0) {
    return {std::max(along(0), 0.0), 0.0};
  }
  return line[0] >= 0.0 ? Line{line[0], line[1]} : Line{0.0, along(1)};
}

std::optional<AccessFit> fitOf(const std::vector<AccessSeries>& series, bool write,
                               Grouping grouping) {
  std::vector<WeightedPoint> means;
  std::vector<WeightedPoint> variances;
  for (const AccessSeries& one : series) {
    if (one.write != write || one.grouping != grouping || one.shotsMade == 0) {
      continue;
    }
    const double mean = base::toMilliseconds(one.mean);
    const double variance = one.deviationMs * one.deviationMs;
    const double shots = one.shotsMade;
    const double line = kLineShare * mean;
    means.push_back({static_cast<double>(one.nodes), mean,
                     1.0 / (variance / shots + line * line + kLineMs * kLineMs)});
    variances.push_back({static_cast<double>(one.nodes), variance,
                         shots / (variance * variance + kLineMs * kLineMs)});
  }
  if (means.empty()) {
    return std::nullopt;
  }
  const Line line = lineOf(means);
  AccessFit fit;
  fit.write = write;
  fit.grouping = grouping;
  fit.overheadMs = line.intercept;
  fit.nodeMs = line.slope;
  fit.nodeDeviationMs = std::sqrt(std::max(0.0, lineOf(variances).slope));
  double squares = 0.0;
  for (const WeightedPoint& point : means) {
    const double distance = point.y - line.intercept - line.slope * point.x;
    squares += distance * distance;
    fit.residualShare =
        std::max(fit.residualShare, std::abs(distance) / std::max(point.y, kLineMs));
  }
  fit.residualMs = std::sqrt(squares / static_cast<double>(means.size()));
  return fit;
}

AccessSeries seriesOf(Kind kind) {
  AccessSeries series;
  series.write = kind.write;
  series.nodes = kind.nodes;
  series.grouping = kind.grouping;
  series.refused = kind.refused;
  std::vector<Duration>& durations = kind.durations;
  if (kind.refused || durations.empty()) {
    return series;
  }
  std::sort(durations.begin(), durations.end());
  series.shotsMade = static_cast<int>(durations.size());
  series.min = durations.front();
  series.max = durations.back();
  series.mean = fromNanoseconds(kind.meanNs());
  double squares = 0.0;
  for (const Duration duration : durations) {
    squares += std::pow(base::toMilliseconds(duration - series.mean), 2);
  }
  series.deviationMs =
      std::sqrt(squares / std::max(1.0, static_cast<double>(durations.size()) - 1.0));
  series.percentiles = trace::percentiles(durations);
  series.histogram = trace::histogram(durations);
  return series;
}

Result<void> requireReset(opcua::Link& link, Duration deadline) {
  const std::array<opcua::Variable, 1> channel{{{opcua::VariableKind::ChannelStatus, 0}}};
  const auto status = opcua::readNow(link, channel, deadline);
  if (!status) {
    return base::fail(status.error());
  }
  if ((*status)[0].status || (*status)[0].number != opcua::kChannelReset) {
    return base::fail(
        CalibrationError::ChannelBusy,
        "A program is running on the control. Wait until it has ended, then measure.");
  }
  return {};
}

/// Writes the values and reads them back.
Result<void> restore(opcua::Link& link, const std::vector<opcua::Assignment>& before,
                     Duration deadline) {
  const auto failed = [](const std::string& why) {
    return base::fail(CalibrationError::NotRestored,
                      "The scratch cells could not be restored and may hold test values: " + why);
  };
  const Duration all = deadlineOf(deadline, before.size());
  const auto written = opcua::awaitAnswer(link, link.write(before, all, Grouping::Single), all);
  if (!written) {
    return failed(written.error().text());
  }
  std::vector<opcua::Variable> variables;
  for (const opcua::Assignment& item : before) {
    variables.push_back(item.variable);
  }
  std::string problem;
  for (int attempt = 0; attempt < kReadBackTries; ++attempt) {
    const auto read = opcua::awaitAnswer(link, link.read(variables, all, Grouping::Single), all);
    if (!read) {
      return failed(read.error().text());
    }
    problem.clear();
    for (std::size_t i = 0; i < before.size() && problem.empty(); ++i) {
      if (read->readings[i].status || read->readings[i].number != before[i].value) {
        problem = fmt::format("R{} does not have its old value.", before[i].variable.index);
      }
    }
    if (problem.empty()) {
      return {};
    }
  }
  return failed(problem);
}

bool isLost(const base::Error& error) {
  return error.code == LinkError::ConnectionLost || error.code == LinkError::NotReachable;
}

class Measurement {
  using Phase = CalibrationProgress::Phase;

 public:
  Measurement(opcua::Link& link, const CalibrationPlan& plan, const CalibrationHooks& hooks,
              std::vector<opcua::Assignment> before)
      : m_link(link),
        m_plan(plan),
        m_hooks(hooks),
        m_before(std::move(before)),
        m_random(plan.seed),
        m_from(link.now()) {
    for (const opcua::Assignment& item : m_before) {
      m_variables.push_back(item.variable);
    }
  }

  Result<Calibration> run() {
    const Result<void> measured = measure();
    if (!measured && isLost(measured.error())) {
      return base::fail(restoredAnew(measured.error()));
    }
    tell(Phase::Restore);
    // If a program is running by now, nothing more is written. Apart from the proof, which restores
    // what it wrote, only the cells' own values were written.
    Result<void> done = requireReset(m_link, m_plan.deadline);
    if (done) {
      done = restore(m_link, m_before, m_plan.deadline);
      if (!done) {
        base::Error error = done.error();
        error.message = (measured ? "" : measured.error().text() + " ") + error.message;
        return base::fail(std::move(error));
      }
    }
    if (!measured || !done) {
      base::Error error = measured ? done.error() : measured.error();
      if (!isLost(error)) {
        error.message += kUntouched;
      }
      return base::fail(std::move(error));
    }
    return result();
  }

 private:
  /// Over a new connection, if there is one.
  base::Error restoredAnew(base::Error error) {
    opcua::Link* link = m_hooks.reconnect ? m_hooks.reconnect() : nullptr;
    if (link != nullptr && requireReset(*link, m_plan.deadline) &&
        restore(*link, m_before, m_plan.deadline)) {
      error.message += " The scratch cells were restored over a new connection.";
    } else if (m_proving) {
      error.message += " The scratch cells may hold test values: restore their old values.";
    } else {
      error.message += kUntouched;
    }
    return error;
  }

  Result<void> measure() {
    std::vector<Grouping> groupings{Grouping::List, Grouping::Single};
    if (m_plan.arrays && m_before.size() >= ScratchCells::kCountMin) {
      if (!tell(Phase::Forms)) {
        return cancelled();
      }
      m_proving = true;
      Result<AccessForms> forms =
          probeAccess(m_link, {m_plan.firstCell, m_plan.lastCell}, m_plan.deadline);
      if (!forms) {
        return base::fail(forms.error());
      }
      m_proving = false;
      for (const Grouping array : kArrays) {
        if (std::any_of(
                forms->proofs.begin(), forms->proofs.end(),
                [array](const FormProof& proof) { return proof.form == array && proof.works(); })) {
          groupings.push_back(array);
        }
      }
      m_forms = std::move(*forms);
    }
    m_kinds = kindsOf(static_cast<int>(m_before.size()), groupings);
    planShots(m_kinds, m_plan.shots, nanoseconds(m_plan.budget));
    if (Result<void> done = firstShots(); !done) {
      return done;
    }
    const double left = nanoseconds(m_plan.budget) - nanoseconds(m_link.now() - m_from);
    double made = 0.0;
    for (const Kind& kind : m_kinds) {
      made += kind.sumNs;
    }
    planShots(m_kinds, m_plan.shots, m_plan.budget > Duration{} ? std::max(left + made, 1.0) : 0.0);
    return otherShots();
  }

  /// One request of each kind in turn, so that a control that slows down meanwhile slows down for
  /// all of them; each time in a different order.
  Result<void> firstShots() {
    for (int shot = 0; shot < kIdleShots + std::min(kFirstShots, m_plan.shots); ++shot) {
      std::vector<std::size_t> turn;
      for (std::size_t i = 0; i < m_kinds.size(); ++i) {
        turn.push_back(i);
      }
      if (Result<void> done = takeTurn(std::move(turn), Phase::First, shot >= kIdleShots); !done) {
        return done;
      }
    }
    return {};
  }

  /// Kinds with fewer shots are also spread over the whole time.
  Result<void> otherShots() {
    int rounds = 0;
    std::vector<int> rest;
    for (const Kind& kind : m_kinds) {
      rest.push_back(std::max(0, kind.planned - static_cast<int>(kind.durations.size())));
      rounds = std::max(rounds, rest.back());
    }
    for (int round = 0; round < rounds; ++round) {
      std::vector<std::size_t> turn;
      for (std::size_t i = 0; i < m_kinds.size(); ++i) {
        const auto due = [&](int upTo) {
          return static_cast<std::int64_t>(rest[i]) * upTo / rounds;
        };
        if (due(round + 1) > due(round)) {
          turn.push_back(i);
        }
      }
      if (Result<void> done = takeTurn(std::move(turn), Phase::Shots, true); !done) {
        return done;
      }
      if (m_plan.budget > Duration{} && m_link.now() - m_from >= m_plan.budget) {
        break;  // slower than at first
      }
    }
    return {};
  }

  Result<void> takeTurn(std::vector<std::size_t> turn, Phase phase, bool counts) {
    if (Result<void> reset = requireReset(m_link, m_plan.deadline); !reset) {
      return reset;
    }
    for (std::size_t i = turn.size(); i > 1; --i) {
      std::swap(turn[i - 1], turn[m_random.below(i)]);
    }
    for (const std::size_t index : turn) {
      Kind& kind = m_kinds[index];
      if (kind.refused) {
        continue;
      }
      const Result<Duration> took = shoot(kind);
      if (!took) {
        return base::fail(took.error());
      }
      if (counts && !kind.refused) {
        kind.durations.push_back(*took);
        kind.sumNs += nanoseconds(*took);
        ++m_shotsMade;
      }
      if (!tell(phase)) {
        return cancelled();
      }
    }
    return {};
  }

  /// One request, and how long it took.
  Result<Duration> shoot(Kind& kind) {
    const auto cells = static_cast<std::size_t>(kind.nodes);
    const Duration deadline = deadlineOf(m_plan.deadline, cells);
    const base::RequestId id =
        kind.write ? m_link.write(std::span(m_before).first(cells), deadline, kind.grouping)
                   : m_link.read(std::span(m_variables).first(cells), deadline, kind.grouping);
    const Result<opcua::Event> event = opcua::awaitAnswer(m_link, id, deadline);
    if (!event) {
      return base::fail(event.error());
    }
    std::error_code refused;
    for (const opcua::Reading& reading : event->readings) {
      refused = reading.status ? reading.status : refused;
    }
    for (const std::error_code& status : event->statuses) {
      refused = status ? status : refused;
    }
    if (refused) {
      if (!opcua::isArray(kind.grouping)) {
        return base::fail(refused, "A scratch cell cannot be accessed any more.");
      }
      kind.refused = true;  // longer than this control accepts
      kind.durations.clear();
      kind.sumNs = 0.0;
    }
    return event->at - event->sent;
  }

  /// @return false: cancel
  bool tell(Phase phase) {
    CalibrationProgress progress;
    progress.phase = phase;
    progress.shotsMade = m_shotsMade;
    const auto cells = static_cast<int>(m_before.size());
    double leftNs = phase == Phase::Restore ? 0.0 : 2.0 * kAssumedNodeNs * cells;
    if (phase == Phase::Forms) {
      leftNs = nanoseconds(expectedDuration(m_plan));
    }
    for (const Kind& kind : m_kinds) {
      progress.shotsPlanned += kind.refused ? 0 : kind.planned;
      leftNs += kind.meanNs() * std::max(0, kind.planned - static_cast<int>(kind.durations.size()));
    }
    const double elapsed = nanoseconds(m_link.now() - m_from);
    if (m_plan.budget > Duration{} && phase != Phase::First) {
      leftNs = std::min(leftNs, std::max(0.0, nanoseconds(m_plan.budget) - elapsed));
    }
    m_share = std::max(m_share, phase == Phase::Restore ? 1.0 : elapsed / (elapsed + leftNs + 1.0));
    progress.share = m_share;
    progress.left = fromNanoseconds(leftNs);
    return !m_hooks.progress || m_hooks.progress(progress);
  }

  static Result<void> cancelled() {
    return base::fail(CalibrationError::Cancelled, "The measurement was cancelled.");
  }

  Calibration result() {
    Calibration calibration;
    calibration.plan = m_plan;
    calibration.took = m_link.now() - m_from;
    calibration.forms = std::move(m_forms);
    std::vector<Grouping> groupings;
    for (Kind& kind : m_kinds) {
      if (std::find(groupings.begin(), groupings.end(), kind.grouping) == groupings.end()) {
        groupings.push_back(kind.grouping);
      }
      calibration.series.push_back(seriesOf(std::move(kind)));
    }
    std::stable_sort(calibration.series.begin(), calibration.series.end(),
                     [](const AccessSeries& one, const AccessSeries& other) {
                       return std::tuple(one.grouping, one.write, one.nodes) <
                              std::tuple(other.grouping, other.write, other.nodes);
                     });
    for (const Grouping grouping : groupings) {
      for (const bool write : {false, true}) {
        if (const auto fit = fitOf(calibration.series, write, grouping)) {
          calibration.fits.push_back(*fit);
        }
      }
    }
    return calibration;
  }

  opcua::Link& m_link;
  const CalibrationPlan& m_plan;
  const CalibrationHooks& m_hooks;
  std::vector<opcua::Assignment> m_before;
  std::vector<opcua::Variable> m_variables;
  base::Random m_random;
  base::Instant m_from;
  std::optional<AccessForms> m_forms;
  std::vector<Kind> m_kinds;
  bool m_proving = false;
  int m_shotsMade = 0;
  double m_share = 0.0;
};

}  // namespace

std::error_code make_error_code(CalibrationError code) {
  static const base::NamedCategory category("calibration");
  return {static_cast<int>(code), category};
}

std::optional<Duration> AccessSeries::percentile(int perMille) const {
  for (const trace::Percentile& one : percentiles) {
    if (one.perMille == perMille) {
      return one.value;
    }
  }
  return std::nullopt;
}

Duration AccessSeries::tail() const {
  return percentile(kTailPerMille).value_or(max);
}

Duration AccessFit::at(double nodes) const {
  return base::fromMilliseconds(std::max(0.0, overheadMs + nodeMs * nodes));
}

const AccessFit* Calibration::fit(bool write, Grouping grouping) const {
  for (const AccessFit& one : fits) {
    if (one.write == write && one.grouping == grouping) {
      return &one;
    }
  }
  return nullptr;
}

std::optional<Duration> Calibration::tail(bool write, Grouping grouping, int nodes) const {
  RIVULET_ASSERT(nodes >= 1);
  const AccessSeries* below = nullptr;
  const AccessSeries* above = nullptr;
  for (const AccessSeries& one : series) {  // in the order of their sizes
    if (one.write != write || one.grouping != grouping || one.shotsMade == 0) {
      continue;
    }
    if (one.nodes <= nodes) {
      below = &one;
    } else if (above == nullptr) {
      above = &one;
    }
  }
  if (below == nullptr) {
    return above == nullptr ? std::nullopt : std::optional(above->tail());
  }
  const double from = nanoseconds(below->tail());
  const double more = nodes - below->nodes;
  if (above != nullptr) {
    const double step = (nanoseconds(above->tail()) - from) / (above->nodes - below->nodes);
    return fromNanoseconds(from + step * more);
  }
  const AccessFit* line = fit(write, grouping);
  const double slopeMs = line == nullptr ? 0.0 : std::max(0.0, line->nodeMs);
  return fromNanoseconds(from + nanoseconds(base::fromMilliseconds(slopeMs)) * more);
}

Grouping Calibration::best() const {
  return forms ? forms->best() : Grouping::List;
}

bool Calibration::isCut() const {
  return std::any_of(series.begin(), series.end(), [this](const AccessSeries& one) {
    return !one.refused && one.shotsMade < plan.shots;
  });
}

Duration expectedDuration(const CalibrationPlan& plan, const Calibration* earlier) {
  const int cells = plan.lastCell - plan.firstCell + 1;
  if (cells < 1 || plan.shots < 1) {
    return {};
  }
  std::vector<Grouping> forms{Grouping::List, Grouping::Single};
  if (plan.arrays && cells >= ScratchCells::kCountMin) {
    for (const Grouping array : kArrays) {
      // A form that did not work before is not expected to work now.
      if (earlier == nullptr || !earlier->forms || earlier->fit(true, array) != nullptr) {
        forms.push_back(array);
      }
    }
  }
  std::vector<Kind> kinds = kindsOf(cells, forms);
  for (Kind& kind : kinds) {
    const AccessFit* fit = earlier == nullptr ? nullptr : earlier->fit(kind.write, kind.grouping);
    if (fit != nullptr) {
      kind.assumedNs = nanoseconds(fit->at(kind.nodes));
    }
  }
  const double beside = besideNs(cells, forms);
  const double budget = nanoseconds(plan.budget);
  planShots(kinds, plan.shots, budget > 0.0 ? std::max(budget - beside, 1.0) : 0.0);
  double total = beside;
  for (const Kind& kind : kinds) {
    total += kind.meanNs() * (kind.planned + kIdleShots);
  }
  return fromNanoseconds(total);
}

Result<std::vector<opcua::Assignment>> readScratchCells(opcua::Link& link,
                                                        const CalibrationPlan& plan) {
  const int cells = plan.lastCell - plan.firstCell + 1;
  if (plan.firstCell < 0 || cells < 1 || plan.shots < 2) {
    return base::fail(CalibrationError::NoCells,
                      "Name a range of R-parameters that nobody uses, and at least 2 shots.");
  }
  std::vector<opcua::Variable> variables;
  for (int cell = plan.firstCell; cell <= plan.lastCell; ++cell) {
    variables.push_back(opcua::rParameter(cell));
  }
  const auto readings =
      opcua::readNow(link, variables, deadlineOf(plan.deadline, variables.size()));
  if (!readings) {
    return base::fail(readings.error());
  }
  std::vector<opcua::Assignment> values;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if ((*readings)[i].status) {
      return base::fail(CalibrationError::NoCells,
                        fmt::format("R{} cannot be read. Choose cells that exist (MD28050).",
                                    variables[i].index));
    }
    values.push_back({variables[i], (*readings)[i].number});
  }
  return values;
}

Result<Calibration> calibrate(opcua::Link& link, const CalibrationPlan& plan,
                              const CalibrationHooks& hooks) {
  // Read before the channel is checked: an invalid range is rejected in any case.
  auto before = readScratchCells(link, plan);
  if (!before) {
    return base::fail(before.error());
  }
  if (Result<void> reset = requireReset(link, plan.deadline); !reset) {
    return base::fail(reset.error());
  }
  return Measurement(link, plan, hooks, std::move(*before)).run();
}

}  // namespace rivulet::streaming
