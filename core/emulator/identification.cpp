// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/identification.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unsupported/Eigen/NonLinearOptimization>

#include "base/error.h"
#include "base/random.h"
#include "emulator/emulator_error.h"

namespace rivulet::emulator {

namespace {

using P = AxisParameter;
using Parts = std::vector<P>;  ///< the parameters that a structure has, in their order

constexpr double kGridStepS = 1e-3;
constexpr double kStretchS = 1.0;
constexpr double kStretchesMin = 6.0;  ///< shorter stretches of short runs
constexpr double kWarmUpS = 0.3;       ///< simulated before a stretch, from an assumed state
constexpr double kMovingShare = 0.05;  ///< of the largest step of a run: its first one, in motion
constexpr double kShortRunS = 3.0;
constexpr double kDenseS = 10.0;   ///< of all stretches, in traces of a control
constexpr double kSparseS = 45.0;  ///< the same if observations are rare
constexpr double kSparseSpacingS = 0.02;
constexpr std::size_t kStepsToFinish = 30'000;  ///< longer runs leave little to be found
constexpr double kMotionMmMin = 0.01;
constexpr std::size_t kObservationsMin = 60;
constexpr int kStartsTried = 24;
constexpr int kStartsFollowed = 2;
constexpr int kStartsFollowedAlone = 4;  ///< for a structure that is given
constexpr double kWorthAPart = 1.1;      ///< each further parameter must lower the error by as much
constexpr double kHopeless = 4.0;        ///< a fit so much worse than the best one is not finished
constexpr double kStraightWorth = 0.9;   ///< of the error, for a machine that goes straight
constexpr double kNoMatterMm = 1e-5;     ///< differences of errors below are not looked at
constexpr double kLostMm = 1e3;          ///< error of a model that diverges

/// Of a structure with a speed loop.
constexpr std::array<P, 5> kCascade{P::PositionGain, P::SpeedGain, P::ResetTime, P::Coulomb,
                                    P::CoulombSpeed};

/// A part of a run on the grid, and what was observed in it.
struct Stretch {
  const SetPointGrid* grid = nullptr;
  std::size_t first = 0;  ///< set point at which the simulation begins
  std::size_t end = 0;    ///< after the last one
  std::span<const double> atS;
  std::span<const double> observedMm;
};

/// A run as far as one axis is concerned.
struct Source {
  std::string run;
  SetPointGrid grid;
  std::vector<double> atS;
  std::vector<double> observedMm;
};

AxisState slopedAt(const SetPointGrid& grid, std::size_t index) {
  if (index == 0) {
    return {grid.mm.front(), grid.startMmPerS};
  }
  const std::size_t after = std::min(index + 1, grid.mm.size() - 1);
  const double steps = static_cast<double>(after - index + 1);
  return {grid.mm[index], (grid.mm[after] - grid.mm[index - 1]) / (steps * grid.stepS)};
}

/// Speed of the set point when a run begins, from its first two steps at even acceleration; 0 if it
/// stood two periods before at most: the axis has hardly moved then.
double startMmPerS(const std::vector<double>& mm, double periodS) {
  constexpr double kPeriodsOfRest = 2.0;
  if (mm.size() < 3) {
    return mm.size() < 2 ? 0.0 : (mm[1] - mm[0]) / periodS;
  }
  const double first = mm[1] - mm[0];
  const double gain = (mm[2] - mm[1]) - first;  // of the step, in a period
  const double step = first - 0.5 * gain;       // at the beginning
  const bool rests =
      step * first <= 0.0 || std::abs(step) < kPeriodsOfRest * gain * std::copysign(1.0, step);
  return rests ? 0.0 : step / periodS;
}

/// Between two states of an axis: the cubic that has their positions and speeds.
AxisState between(const AxisState& a, const AxisState& b, double share, double stepS) {
  const double m0 = a.mmPerS * stepS;
  const double m1 = b.mmPerS * stepS;
  const double rise = b.mm - a.mm;
  const double c2 = 3.0 * rise - 2.0 * m0 - m1;
  const double c3 = m0 + m1 - 2.0 * rise;
  return {a.mm + share * (m0 + share * (c2 + share * c3)),
          (m0 + share * (2.0 * c2 + 3.0 * share * c3)) / stepS};
}

/// Runs the axis over set points and calls `take(i, state)` for every time i.
template <class Take>
void follow(const AxisParameters& parameters, const Stretch& stretch, const Take& take) {
  const SetPointGrid& grid = *stretch.grid;
  AxisSimulator axis(parameters, grid.stepS, slopedAt(grid, stretch.first));
  AxisState before = axis.actual();
  AxisState now = before;
  std::size_t index = stretch.first;  // of `now`
  for (std::size_t i = 0; i < stretch.atS.size(); ++i) {
    const double place = stretch.atS[i] / grid.stepS;
    while (static_cast<double>(index) < place && index + 1 < stretch.end) {
      before = now;
      now = axis.step(grid.mm[++index]);
    }
    const double share = std::clamp(place - static_cast<double>(index) + 1.0, 0.0,
                                    index > stretch.first ? 1.0 : 0.0);
    take(i, between(before, now, index > stretch.first ? share : 0.0, grid.stepS));
  }
}

/// The fit of one structure to stretches. Every parameter is searched between its bounds on a
/// logarithmic scale, as x of bound_min·(max/min)^(1/(1+e^-x)), so that none can leave them.
class Fit {
 public:
  /// @param isCancelled  asked before each simulation; may be empty
  Fit(Parts parts, std::span<const Stretch> stretches, const std::function<bool()>& isCancelled)
      : m_parts(std::move(parts)), m_stretches(stretches), m_isCancelled(isCancelled) {
    for (const Stretch& stretch : stretches) {
      m_count += stretch.atS.size();
    }
  }

  // What Eigen's Levenberg-Marquardt asks for.
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  [[nodiscard]] int inputs() const { return static_cast<int>(m_parts.size()); }
  [[nodiscard]] int values() const { return static_cast<int>(m_count); }
  int operator()(const InputType& x, ValueType& errors) const {
    errors.resize(values());
    if (m_isCancelled && m_isCancelled()) {
      errors.setZero();
      return -1;  // ends the search
    }
    Eigen::Index row = 0;
    const AxisParameters parameters = parametersAt(x);
    for (const Stretch& stretch : m_stretches) {
      follow(parameters, stretch, [&](std::size_t i, const AxisState& state) {
        const double error = state.mm - stretch.observedMm[i];
        errors[row++] = std::abs(error) < kLostMm ? error : kLostMm;
      });
    }
    m_at = x;
    m_errors = errors;
    return 0;
  }
  int df(const InputType& x, JacobianType& jacobian) const {
    constexpr double kStep = 1e-3;  // larger than what divided steps add to the errors
    ValueType at = m_errors;        // nearly always asked for at the last place
    ValueType beside;
    if (x.size() != m_at.size() || x != m_at) {
      (*this)(x, at);
    }
    const InputType place = x;
    jacobian.resize(values(), inputs());
    for (Eigen::Index column = 0; column < x.size(); ++column) {
      InputType moved = place;
      moved[column] += kStep;
      (*this)(moved, beside);
      jacobian.col(column) = (beside - at) / kStep;
    }
    return 0;
  }

  [[nodiscard]] AxisParameters parametersAt(const InputType& x) const {
    AxisParameters parameters;
    parameters[P::CoulombSpeed] = 1.0;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
      const AxisParameterFacts& facts = factsOf(m_parts[i]);
      const double share = 1.0 / (1.0 + std::exp(-x[static_cast<Eigen::Index>(i)]));
      parameters[m_parts[i]] = facts.min * std::pow(facts.max / facts.min, share);
    }
    return parameters;
  }
  [[nodiscard]] InputType inputOf(const AxisParameters& parameters) const {
    InputType x(inputs());
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
      const AxisParameterFacts& facts = factsOf(m_parts[i]);
      const double value = parameters[m_parts[i]] > 0.0 ? parameters[m_parts[i]] : facts.typical;
      const double share =
          std::clamp(std::log(value / facts.min) / std::log(facts.max / facts.min), 1e-3, 0.999);
      x[static_cast<Eigen::Index>(i)] = std::log(share / (1.0 - share));
    }
    return x;
  }
  [[nodiscard]] double rmsMm(const InputType& x) const {
    ValueType errors;
    (*this)(x, errors);
    return std::sqrt(errors.squaredNorm() / static_cast<double>(std::max(1, values())));
  }
  void improve(InputType& x, int evaluationsMax, double tolerance = 1e-6) {
    Eigen::LevenbergMarquardt<Fit> search(*this);
    search.parameters.maxfev = evaluationsMax;
    search.parameters.ftol = tolerance;
    search.parameters.xtol = tolerance;
    search.minimize(x);
  }
  /// In a narrow valley a search ends early: it begins again as long as that helps.
  void finish(InputType& x) {
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4 && rmsMm(x) < 0.9999 * before; ++i) {
      before = rmsMm(x);
      improve(x, 20, 1e-9);
    }
  }
  [[nodiscard]] const Parts& parts() const { return m_parts; }

 private:
  Parts m_parts;
  std::span<const Stretch> m_stretches;
  const std::function<bool()>& m_isCancelled;
  std::size_t m_count = 0;
  mutable InputType m_at;  ///< where the errors were asked for last
  mutable ValueType m_errors;
};

Parts partsOf(const AxisParameters& parameters) {
  Parts parts;
  for (const AxisParameterFacts& facts : axisParameterFacts()) {
    if (parameters[facts.parameter] > 0.0) {
      parts.push_back(facts.parameter);
    }
  }
  return parts;
}

Parts with(std::initializer_list<P> optional) {
  Parts parts(kCascade.begin(), kCascade.end());
  parts.insert(parts.end(), optional);
  std::ranges::sort(parts);
  return parts;
}

double rangeOf(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  return high - low;
}

/// What the set points were at the times of the observations.
std::vector<double> askedMm(const Source& source) {
  std::vector<double> asked;
  for (const double atS : source.atS) {
    asked.push_back(cubicAt(source.grid.mm, atS / source.grid.stepS));
  }
  return asked;
}

base::Result<void> requireSameUnits(const Source& source, char axis) {
  const double asked = rangeOf(askedMm(source));
  const double seen = rangeOf(source.observedMm);
  if (asked < kMotionMmMin || (seen > 0.5 * asked && seen < 2.0 * asked)) {
    return {};
  }
  return base::fail(
      EmulatorError::BadUnits,
      fmt::format(
          "Axis {} was asked to move over {:.6g} mm and was seen moving over {:.6g} mm: the "
          "two columns have different units, or belong to different programs.",
          axis, asked, seen),
      source.run);
}

/// From when on a trace says how the axis follows: if it moves already when the trace begins, what
/// it did before is not known. A short trace is taken as it is.
double knownFromS(const AxisTrack& track, double endS) {
  const std::vector<double>& mm = track.reference;
  double largest = 0.0;
  for (std::size_t i = 1; i < mm.size(); ++i) {
    largest = std::max(largest, std::abs(mm[i] - mm[i - 1]));
  }
  const bool isMoving = mm.size() > 1 && std::abs(mm[1] - mm[0]) > kMovingShare * largest;
  return isMoving && endS > kShortRunS ? kWarmUpS : 0.0;
}

/// The position of an axis in a run is learned from only if it moves there.
base::Result<std::vector<Source>> sourcesOf(std::span<const TrainingRun> runs, char axis,
                                            bool goesStraight) {
  std::vector<Source> sources;
  std::size_t observations = 0;
  for (const TrainingRun& run : runs) {
    if (auto checked = checkRun(run); !checked) {
      return base::fail(checked.error());
    }
    const auto track = std::ranges::find(run.axes, axis, &AxisTrack::axis);
    if (track == run.axes.end() || run.observedAt.empty()) {
      continue;
    }
    if (!moves(*track)) {
      continue;
    }
    Source source{run.name, setPointGrid(*track, run.period, goesStraight), {}, {}};
    const double endS = source.grid.stepS * static_cast<double>(source.grid.mm.size() - 1);
    const double fromS = knownFromS(*track, endS);
    for (std::size_t i = 0; i < run.observedAt.size(); ++i) {
      if (run.observedAt[i] >= fromS && run.observedAt[i] <= endS) {
        source.atS.push_back(run.observedAt[i]);
        source.observedMm.push_back(track->observed[i]);
      }
    }
    observations += source.atS.size();
    if (!source.atS.empty()) {
      sources.push_back(std::move(source));
    }
  }
  if (sources.empty()) {
    return base::fail(EmulatorError::NoMotion,
                      fmt::format("Axis {} does not move in any of the runs: record a program that "
                                  "moves it.",
                                  axis));
  }
  if (observations < kObservationsMin) {
    return base::fail(EmulatorError::TooShort,
                      fmt::format("Axis {} was observed {} times: a model needs {} at least, so "
                                  "record a longer program or more often.",
                                  axis, observations, kObservationsMin));
  }
  for (const Source& source : sources) {
    if (auto same = requireSameUnits(source, axis); !same) {
      return base::fail(same.error());
    }
  }
  return sources;
}

Stretch stretchOf(const Source& source, double fromS, double toS) {
  const SetPointGrid& grid = source.grid;
  const auto from = std::ranges::lower_bound(source.atS, fromS) - source.atS.begin();
  const auto to = std::ranges::lower_bound(source.atS, toS) - source.atS.begin();
  const auto count = static_cast<std::size_t>(to - from);
  const auto begin = static_cast<std::size_t>(from);
  const double warmFromS = std::max(0.0, fromS - kWarmUpS);
  return {&grid, static_cast<std::size_t>(warmFromS / grid.stepS),
          std::min(grid.mm.size(), static_cast<std::size_t>(toS / grid.stepS) + 2),
          std::span(source.atS).subspan(begin, count),
          std::span(source.observedMm).subspan(begin, count)};
}

std::vector<Stretch> wholeRuns(const std::vector<Source>& sources) {
  std::vector<Stretch> stretches;
  for (const Source& source : sources) {
    stretches.push_back({&source.grid, 0, source.grid.mm.size(), source.atS, source.observedMm});
  }
  return stretches;
}

/// Sum of the changes of speed, which tell most about an axis; 0: it stands still.
double activity(const Stretch& stretch) {
  double sum = 0.0;
  const std::vector<double>& mm = stretch.grid->mm;
  for (std::size_t i = stretch.first + 1; i + 1 < stretch.end; ++i) {
    sum += std::abs(mm[i + 1] - 2.0 * mm[i] + mm[i - 1]);
  }
  return sum / stretch.grid->stepS;
}

/// The stretches of a run that tell most, and others evenly spaced, in the order of time.
std::vector<Stretch> pick(const Source& source, std::size_t count, double lengthS) {
  std::vector<Stretch> all;
  const double endS = source.grid.stepS * static_cast<double>(source.grid.mm.size());
  for (double fromS = 0.0; fromS < endS; fromS += lengthS) {
    const Stretch stretch = stretchOf(source, fromS, fromS + lengthS);
    if (!stretch.atS.empty() && activity(stretch) > 0.0) {
      all.push_back(stretch);
    }
  }
  if (all.size() <= count) {
    return all;
  }
  std::vector<std::size_t> order(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return activity(all[a]) > activity(all[b]); });
  std::vector<bool> taken(all.size(), false);
  const std::size_t most = count / 2;
  for (std::size_t i = 0; i < most; ++i) {
    taken[order[i]] = true;
  }
  for (std::size_t i = most; i < count; ++i) {
    taken[(i - most) * all.size() / (count - most)] = true;
  }
  std::vector<Stretch> picked;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (taken[i]) {
      picked.push_back(all[i]);
    }
  }
  return picked;
}

struct Split {
  std::vector<Stretch> fitted;
  std::vector<Stretch> heldOut;
};

Split split(const std::vector<Source>& sources) {
  double durationS = 0.0;
  std::size_t observations = 0;
  for (const Source& source : sources) {
    durationS += source.atS.back() - source.atS.front();
    observations += source.atS.size();
  }
  const bool isSparse = durationS / static_cast<double>(observations) > kSparseSpacingS;
  const double lengthS = std::min(kStretchS, durationS / kStretchesMin);
  const auto count = static_cast<std::size_t>((isSparse ? kSparseS : kDenseS) / kStretchS);
  Split result;
  std::size_t index = 0;
  for (const Source& source : sources) {
    const std::size_t share = std::max<std::size_t>(2, count / sources.size());
    for (const Stretch& stretch : pick(source, share, lengthS)) {
      (index++ % 3 == 2 ? result.heldOut : result.fitted).push_back(stretch);
    }
  }
  return result;
}

/// Where the search for a structure begins: the best few of many seeded starts.
std::vector<Eigen::VectorXd> startsOf(const Fit& fit, const AxisParameters& known, int followed) {
  constexpr std::uint64_t kSeed = 16;
  base::Random random(kSeed);
  std::vector<std::pair<double, Eigen::VectorXd>> tried;
  for (int i = 0; i < kStartsTried; ++i) {
    AxisParameters start = known;
    for (const P part : fit.parts()) {
      double& value = start[part];
      value = (value > 0.0 ? value : factsOf(part).typical) *
              (i == 0 ? 1.0 : std::exp(0.8 * random.normal()));
    }
    Eigen::VectorXd x = fit.inputOf(start);
    const double rms = fit.rmsMm(x);
    tried.emplace_back(rms, std::move(x));
  }
  std::ranges::stable_sort(tried, {}, [](const auto& one) { return one.first; });
  std::vector<Eigen::VectorXd> best;
  for (int i = 0; i < followed; ++i) {
    best.push_back(tried[static_cast<std::size_t>(i)].second);
  }
  return best;
}

struct Candidate {
  Parts parts;
  AxisParameters parameters;
  double fitRmsMm = std::numeric_limits<double>::infinity();
  double heldOutRmsMm = std::numeric_limits<double>::infinity();
};

/// @param than  the best structure so far: its parameters are where the search begins besides the
///              seeded starts
Candidate tryStructure(const Parts& parts, const Split& data, const Candidate& than, int followed,
                       const LearnOptions& options) {
  Fit fit(parts, data.fitted, options.isCancelled);
  double best = std::numeric_limits<double>::infinity();
  Eigen::VectorXd bestX;
  for (Eigen::VectorXd& x : startsOf(fit, than.parameters, followed)) {
    fit.improve(x, 12);
    if (const double rms = fit.rmsMm(x); rms < best) {
      best = rms;
      bestX = x;
    }
  }
  if (bestX.size() > 0 && best < kHopeless * than.fitRmsMm) {
    fit.improve(bestX, 30);
  }
  Candidate candidate{parts, {}};
  if (bestX.size() > 0) {
    candidate.parameters = fit.parametersAt(bestX);
    candidate.fitRmsMm = fit.rmsMm(bestX);
    const Fit check(parts, data.heldOut, options.isCancelled);
    candidate.heldOutRmsMm = check.rmsMm(bestX);
  }
  return candidate;
}

bool isBetter(const Candidate& one, const Candidate& than) {
  const double parts =
      static_cast<double>(one.parts.size()) - static_cast<double>(than.parts.size());
  return (one.heldOutRmsMm + kNoMatterMm) * std::pow(kWorthAPart, parts) <
         than.heldOutRmsMm + kNoMatterMm;
}

Parts toggled(Parts parts, const Parts& toggles) {
  for (const P part : toggles) {
    const auto found = std::ranges::find(parts, part);
    if (found != parts.end()) {
      parts.erase(found);
    } else {
      parts.push_back(part);
    }
  }
  std::ranges::sort(parts);
  return parts;
}

bool isCancelled(const LearnOptions& options) {
  return options.isCancelled && options.isCancelled();
}

tl::unexpected<base::Error> cancelled() {
  return base::fail(EmulatorError::Cancelled, "Learning was cancelled: nothing was changed.");
}

/// Reports a part of the work as a part of the whole.
LearnOptions partOf(const LearnOptions& options, double from, double to) {
  LearnOptions part = options;
  if (options.progress) {
    part.progress = [outer = options.progress, from, to](LearnProgress progress) {
      progress.share = from + (to - from) * progress.share;
      return outer(progress);
    };
  }
  return part;
}

base::Result<Candidate> chooseStructure(const Split& data, char axis, const LearnOptions& options) {
  std::vector<Parts> first{
      {P::PositionGain},
      {P::PositionGain, P::FeedForward},
      with({P::Delay}),
      with({P::EffortLag, P::Delay}),
      with({P::FeedForward, P::Delay}),
      with({P::FeedForward, P::FeedForwardLag, P::Delay}),
      with({P::FeedForward, P::EffortLag, P::Delay}),
      with({P::FeedForward, P::FeedForwardLag, P::EffortLag, P::Delay}),
  };
  std::vector<Parts> changes{{P::Viscous}, {P::Delay}, {P::ResonanceHz, P::ResonanceDamping}};
  if (options.delay != DelayPart::Chosen) {
    for (Parts& parts : first) {
      std::erase(parts, P::Delay);
      if (options.delay == DelayPart::With) {
        parts.push_back(P::Delay);
        std::ranges::sort(parts);
      }
    }
    changes.erase(changes.begin() + 1);
  }
  Candidate best;
  LearnProgress progress{axis, 0, static_cast<int>(first.size() + changes.size()), {}};
  const auto consider = [&](const Parts& parts) {
    const Candidate candidate = tryStructure(parts, data, best, kStartsFollowed, options);
    if (best.parts.empty() || isBetter(candidate, best)) {
      best = candidate;
    }
    ++progress.step;
    progress.share = static_cast<double>(progress.step) / static_cast<double>(progress.steps);
    progress.triedRmsMm = candidate.heldOutRmsMm;
    progress.heldOutRmsMm = best.heldOutRmsMm;
    return !isCancelled(options) && (!options.progress || options.progress(progress));
  };
  for (const Parts& parts : first) {
    if (!consider(parts)) {
      return cancelled();
    }
  }
  for (const Parts& change : changes) {
    if (!consider(toggled(best.parts, change))) {
      return cancelled();
    }
  }
  return best;
}

/// Share of a standard normal variable above `z`, solved for z by bisection.
double normalQuantileAbove(double probability) {
  double low = 0.0;
  double high = 12.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(middle / std::sqrt(2.0)) > probability ? low : high) = middle;
  }
  return high;
}

/// Covariance of the estimates from the curvature of the sum of squares. Errors of a model are not
/// independent of their neighbours; so the products of neighbours are summed too (Newey and West),
/// and the larger variance of both formulas counts.
Eigen::VectorXd standardErrors(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& errors) {
  const Eigen::Index count = jacobian.rows();
  const Eigen::Index free = jacobian.cols();
  // Scaled, so that a parameter without effect does not spoil the others.
  Eigen::VectorXd scale = jacobian.colwise().norm();
  for (double& value : scale) {
    value = value > 0.0 ? value : 1.0;
  }
  const Eigen::MatrixXd unit = jacobian * scale.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd inverse =
      (unit.transpose() * unit).completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::MatrixXd pushes = errors.asDiagonal() * unit;
  const Eigen::Index lags = std::min<Eigen::Index>(100, count / 20);
  Eigen::MatrixXd middle = pushes.transpose() * pushes;
  for (Eigen::Index lag = 1; lag <= lags; ++lag) {
    const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(lags + 1);
    const Eigen::MatrixXd product =
        pushes.bottomRows(count - lag).transpose() * pushes.topRows(count - lag);
    middle += weight * (product + product.transpose());
  }
  const double freedom = static_cast<double>(std::max<Eigen::Index>(1, count - free));
  const Eigen::VectorXd robust =
      (inverse * middle * inverse).diagonal() * (static_cast<double>(count) / freedom);
  const Eigen::VectorXd classical = inverse.diagonal() * (errors.squaredNorm() / freedom);
  return robust.cwiseMax(classical).cwiseMax(0.0).cwiseSqrt().cwiseQuotient(scale);
}

/// The calculation itself leaves up to this: a fiftieth of a micrometre.
constexpr double kResolvedMm = 2e-5;

/// Ljung and Box's test: neighbours of chance have nothing in common.
bool isChance(const Eigen::VectorXd& errors) {
  constexpr Eigen::Index kLags = 20;
  constexpr double kMost = 45.31;  // of chi squared with 20 degrees, exceeded by 0.1 %
  const Eigen::Index count = errors.size();
  if (errors.norm() <= kResolvedMm * std::sqrt(static_cast<double>(count))) {
    return true;
  }
  if (count <= 2 * kLags) {
    return false;  // too few to tell
  }
  const Eigen::VectorXd centred = errors.array() - errors.mean();
  double sum = 0.0;
  for (Eigen::Index lag = 1; lag <= kLags; ++lag) {
    const double share =
        centred.tail(count - lag).dot(centred.head(count - lag)) / centred.squaredNorm();
    sum += share * share / static_cast<double>(count - lag);
  }
  return static_cast<double>(count) * static_cast<double>(count + 2) * sum <= kMost;
}

std::vector<ParameterEstimate> estimatesOf(const Fit& fit, const Eigen::VectorXd& x,
                                           double confidence) {
  Eigen::VectorXd errors;
  Eigen::MatrixXd jacobian;
  fit(x, errors);
  fit.df(x, jacobian);
  const Eigen::VectorXd deviation = standardErrors(jacobian, errors);
  const double quantile =
      normalQuantileAbove(0.5 * (1.0 - confidence) / static_cast<double>(x.size()));
  const AxisParameters parameters = fit.parametersAt(x);
  const bool hasIntervals = isChance(errors);
  std::vector<ParameterEstimate> estimates;
  for (std::size_t i = 0; i < fit.parts().size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const AxisParameterFacts& facts = factsOf(fit.parts()[i]);
    const double share = 1.0 / (1.0 + std::exp(-x[row]));
    const double perX = share * (1.0 - share) * std::log(facts.max / facts.min);
    const double value = parameters[facts.parameter];
    if (!hasIntervals) {
      estimates.push_back({facts.parameter, value, value, value});
      continue;
    }
    // What has no effect on the errors is not known.
    const double reach =
        jacobian.col(row).norm() > 0.0 ? std::min(quantile * deviation[row] * perX, 50.0) : 50.0;
    estimates.push_back({facts.parameter, value, std::max(facts.min, value * std::exp(-reach)),
                         std::min(facts.max, value * std::exp(reach))});
  }
  return estimates;
}

/// How well a structure follows set points of either kind, also with a part less: what a wrong kind
/// was made up for with must not stay, and can become small, but not 0.
double quickRmsMm(const LearnedAxis& learned, const Split& data, const LearnOptions& options) {
  const Parts parts = partsOf(learned.parameters);
  std::vector<Parts> structures{parts};
  for (const P part : parts) {
    if (std::ranges::find(kCascade, part) == kCascade.end() && part != P::ResonanceHz &&
        part != P::ResonanceDamping) {
      structures.push_back(toggled(parts, {part}));
    }
  }
  double best = std::numeric_limits<double>::infinity();
  for (const Parts& structure : structures) {
    Fit fit(structure, data.fitted, options.isCancelled);
    Eigen::VectorXd x = fit.inputOf(learned.parameters);
    fit.improve(x, 12);
    best = std::min(best, fit.rmsMm(x));
  }
  return best;
}

/// A model must explain most of what keeps the axis from its set points.
base::Result<void> requireToFollow(const LearnedAxis& learned, const std::vector<Source>& sources) {
  double squares = 0.0;
  double count = 0.0;
  double range = 0.0;
  for (const Source& source : sources) {
    const std::vector<double> asked = askedMm(source);
    range = std::max(range, rangeOf(asked));
    for (std::size_t i = 0; i < asked.size(); ++i) {
      squares += (asked[i] - source.observedMm[i]) * (asked[i] - source.observedMm[i]);
      count += 1.0;
    }
  }
  const double lagRmsMm = std::sqrt(squares / count);
  const double allowedMm = std::max(0.5 * lagRmsMm, 0.01 * range);
  if (learned.heldOutRmsMm < kLostMm && learned.fitRmsMm < allowedMm) {
    return {};
  }
  for (const Source& source : sources) {
    const std::vector<AxisState> states = predict(learned.parameters, source.grid, source.atS);
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (!(std::abs(states[i].mm - source.observedMm[i]) < allowedMm)) {
        return base::fail(
            EmulatorError::Diverged,
            fmt::format(
                "No model follows axis {}; the best one departs from the trace by {:.3g} mm "
                "at {:.3f} s: check that trace and program belong together.",
                learned.axis, std::abs(states[i].mm - source.observedMm[i]), source.atS[i]),
            source.run);
      }
    }
  }
  return base::fail(EmulatorError::Diverged,
                    fmt::format("No model follows axis {}: check that trace and program belong "
                                "together.",
                                learned.axis));
}

base::Result<LearnedAxis> learnFrom(const std::vector<Source>& sources, char axis,
                                    const LearnOptions& options) {
  const Split data = split(sources);
  if (data.fitted.empty()) {
    return base::fail(EmulatorError::NoMotion,
                      fmt::format("Axis {} moves only where it was not observed: record the whole "
                                  "program.",
                                  axis));
  }
  if (data.heldOut.empty()) {
    return base::fail(EmulatorError::TooShort,
                      fmt::format("Axis {} moves too little to learn from some of it and to test "
                                  "on the rest: record a longer program.",
                                  axis));
  }
  Candidate chosen;
  if (options.structure != nullptr) {
    chosen = tryStructure(partsOf(*options.structure), data, {{}, *options.structure},
                          kStartsFollowedAlone, options);
  } else {
    auto found = chooseStructure(data, axis, options);
    if (!found) {
      return base::fail(found.error());
    }
    chosen = std::move(*found);
  }
  const std::vector<Stretch> whole = wholeRuns(sources);
  Fit fit(chosen.parts, whole, options.isCancelled);
  Eigen::VectorXd x = fit.inputOf(chosen.parameters);
  std::size_t steps = 0;
  for (const Stretch& stretch : whole) {
    steps += stretch.end;
  }
  if (steps < kStepsToFinish) {
    fit.finish(x);
  } else {
    fit.improve(x, 6);
  }
  LearnedAxis learned{axis, fit.parametersAt(x), estimatesOf(fit, x, options.confidence),
                      fit.rmsMm(x), chosen.heldOutRmsMm};
  if (isCancelled(options)) {
    return cancelled();
  }
  if (auto follows = requireToFollow(learned, sources); !follows) {
    return base::fail(follows.error());
  }
  return learned;
}

/// As `cubicAt`, straight between neighbours.
double straightAt(std::span<const double> values, double place) {
  const auto index = std::min(static_cast<std::size_t>(place), values.size() - 1);
  const double next = values[std::min(index + 1, values.size() - 1)];
  return values[index] + (place - static_cast<double>(index)) * (next - values[index]);
}

}  // namespace

double knownFromS(const TrainingRun& run) {
  double latest = 0.0;
  for (const AxisTrack& track : run.axes) {
    const double endS = run.period * (static_cast<double>(track.reference.size()) - 1.0);
    latest = std::max(latest, knownFromS(track, endS));
  }
  return latest;
}

bool moves(const AxisTrack& track) {
  return !track.reference.empty() && rangeOf(track.reference) >= kMotionMmMin;
}

SetPointGrid setPointGrid(const AxisTrack& track, double periodS, bool goesStraight) {
  const auto parts =
      static_cast<std::size_t>(std::max(1.0, std::ceil(periodS / kGridStepS - 1e-6)));
  const double startSpeed = startMmPerS(track.reference, periodS);
  if (parts == 1) {
    return {periodS, track.reference, startSpeed};
  }
  SetPointGrid grid{periodS / static_cast<double>(parts), {}, startSpeed};
  const std::size_t count = (track.reference.size() - 1) * parts + 1;
  grid.mm.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = static_cast<double>(i) / static_cast<double>(parts);
    grid.mm.push_back(goesStraight ? straightAt(track.reference, place)
                                   : cubicAt(track.reference, place));
  }
  return grid;
}

std::vector<AxisState> predict(const AxisParameters& parameters, const SetPointGrid& grid,
                               std::span<const double> atS) {
  std::vector<AxisState> states(atS.size());
  follow(parameters, {&grid, 0, grid.mm.size(), atS, {}},
         [&](std::size_t i, const AxisState& state) { states[i] = state; });
  return states;
}

base::Result<LearnedAxis> learnAxis(std::span<const TrainingRun> runs, char axis,
                                    const LearnOptions& options) {
  const auto smooth = sourcesOf(runs, axis, false);
  if (!smooth) {
    return base::fail(smooth.error());
  }
  const bool isCoarse = std::ranges::any_of(
      runs, [](const TrainingRun& run) { return run.period > 1.5 * kGridStepS; });
  auto learned = learnFrom(*smooth, axis, isCoarse ? partOf(options, 0.0, 0.5) : options);
  if (!learned || !isCoarse) {
    return learned;
  }
  const auto straight = sourcesOf(runs, axis, true);
  if (!straight || !(quickRmsMm(*learned, split(*straight), options) <
                     kStraightWorth * quickRmsMm(*learned, split(*smooth), options))) {
    return learned;
  }
  auto other = learnFrom(*straight, axis, partOf(options, 0.5, 1.0));
  if (!other) {
    return other.error().code == EmulatorError::Cancelled ? other : learned;
  }
  other->goesStraight = true;
  return other->heldOutRmsMm < learned->heldOutRmsMm ? other : learned;
}

base::Result<std::vector<LearnedAxis>> learnAxes(std::span<const TrainingRun> runs,
                                                 const LearnOptions& options) {
  std::string letters;
  for (const TrainingRun& run : runs) {
    for (const AxisTrack& track : run.axes) {
      if (moves(track) && letters.find(track.axis) == std::string::npos) {
        letters += track.axis;
      }
    }
  }
  if (letters.empty()) {
    return base::fail(EmulatorError::NoMotion,
                      "No axis moves in any of the runs: record a program that moves the axes.");
  }
  std::vector<LearnedAxis> axes;
  const double part = 1.0 / static_cast<double>(letters.size());
  for (const char letter : letters) {
    const double from = part * static_cast<double>(axes.size());
    auto learned = learnAxis(runs, letter, partOf(options, from, from + part));
    if (!learned) {
      return base::fail(learned.error());
    }
    axes.push_back(std::move(*learned));
  }
  return axes;
}

}  // namespace rivulet::emulator
