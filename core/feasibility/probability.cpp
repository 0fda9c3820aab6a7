// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/probability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/contract.h"
#include "feasibility/client_turn.h"
#include "feasibility/equations.h"

namespace rivulet::feasibility {

namespace {

/// Sums of so many node times are taken as normal.
constexpr int kNormalFrom = 8;
/// Probability below this is dropped: far below any feed limit of interest.
constexpr double kNegligible = 1e-13;
/// A client that has been idle for this long may be anywhere in its poll.
constexpr double kForgottenMs = 100.0;
/// Steps of the time grids. Method position has more to follow and blurs more by itself.
constexpr double kSignalStepMs = 0.5;
constexpr double kPositionStepMs = 1.0;
/// A path shorter than this is no motion.
constexpr double kLengthMmMin = 1e-9;
constexpr double kDeviationsKept = 6.0;
/// Dwell in the waiting loop of the flexible program, see core/templates.
constexpr double kWaitDwellMs = 20.0;

double normalBelow(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

/// Distribution of a duration: mass[i] is the probability of (first + i) grid steps.
struct Kernel {
  int first = 0;
  std::vector<double> mass;

  [[nodiscard]] int end() const { return first + static_cast<int>(mass.size()); }
  [[nodiscard]] double mean() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
      sum += mass[i] * (first + static_cast<double>(i));
    }
    return sum;
  }
  /// Probability that the duration is at most `steps`.
  [[nodiscard]] double upTo(double steps) const {
    const int last = static_cast<int>(std::floor(steps + 1e-9)) - first;
    double sum = 0.0;
    for (int i = 0; i <= last && i < static_cast<int>(mass.size()); ++i) {
      sum += mass[static_cast<std::size_t>(i)];
    }
    return std::min(sum, 1.0);
  }
};

/// The time of one node on a fine grid: exact mean and variance of what is cut off below.
class NodeTimes {
 public:
  explicit NodeTimes(const AccessTimes& access)
      : m_meanMs(base::toMilliseconds(access.nodeMean)),
        m_deviationMs(base::toMilliseconds(access.nodeDeviation)),
        m_minMs(base::toMilliseconds(access.nodeMin)) {
    const double fromMs = std::max(m_minMs, m_meanMs - kDeviationsKept * m_deviationMs);
    const double toMs = std::max(fromMs, m_meanMs + kDeviationsKept * m_deviationMs);
    const int cells = std::max(1, static_cast<int>(std::ceil((toMs - fromMs) / kFineMs)) + 1);
    m_one.assign(static_cast<std::size_t>(cells), 0.0);
    m_originMs = fromMs;
    if (m_deviationMs <= 0.0) {
      m_one.assign(1, 1.0);
      return;
    }
    // Cell i holds what lies around originMs + i·fine; all that is below goes to the first.
    double below = 0.0;
    for (int i = 0; i < cells; ++i) {
      const double edge =
          i + 1 == cells ? 1.0
                         : normalBelow((fromMs + (i + 0.5) * kFineMs - m_meanMs) / m_deviationMs);
      m_one[static_cast<std::size_t>(i)] = edge - below;
      below = edge;
    }
  }

  [[nodiscard]] double meanMs() const {
    double mean = m_originMs;
    for (std::size_t i = 0; i < m_one.size(); ++i) {
      mean += m_one[i] * static_cast<double>(i) * kFineMs;
    }
    return mean;
  }

  /// Overhead and `nodes` node times, on a grid of `stepMs`. The mean is kept: a cell between two
  /// grid points is shared by both.
  [[nodiscard]] Kernel sum(double overheadMs, int nodes, double stepMs) const {
    RIVULET_ASSERT(nodes >= 1);
    std::vector<double> fine;
    double originMs = overheadMs;
    if (nodes < kNormalFrom) {
      fine = {1.0};
      for (int n = 0; n < nodes; ++n) {
        std::vector<double> next(fine.size() + m_one.size() - 1, 0.0);
        for (std::size_t i = 0; i < fine.size(); ++i) {
          for (std::size_t j = 0; fine[i] > kNegligible && j < m_one.size(); ++j) {
            next[i + j] += fine[i] * m_one[j];
          }
        }
        fine = std::move(next);
      }
      originMs += nodes * m_originMs;
    } else {
      const double oneMs = meanMs();
      double variance = 0.0;
      for (std::size_t i = 0; i < m_one.size(); ++i) {
        const double off = m_originMs + static_cast<double>(i) * kFineMs - oneMs;
        variance += m_one[i] * off * off;
      }
      const double deviationMs = std::sqrt(variance * nodes);
      const double halfMs = kDeviationsKept * deviationMs;
      const int cells = 2 * static_cast<int>(std::ceil(halfMs / kFineMs)) + 1;
      originMs += nodes * oneMs - kFineMs * (cells / 2);
      if (cells == 1) {
        fine = {1.0};
      } else {
        fine.resize(static_cast<std::size_t>(cells));
        for (int i = 0; i < cells; ++i) {
          const double off = (i - cells / 2) * kFineMs / deviationMs;
          fine[static_cast<std::size_t>(i)] = std::exp(-0.5 * off * off);
        }
      }
    }
    return onGrid(fine, originMs, stepMs);
  }

 private:
  static constexpr double kFineMs = 0.1;

  static Kernel onGrid(const std::vector<double>& fine, double originMs, double stepMs) {
    Kernel kernel;
    kernel.first = std::max(0, static_cast<int>(std::floor(originMs / stepMs)));
    const double lastMs = originMs + static_cast<double>(fine.size() - 1) * kFineMs;
    const int last = static_cast<int>(std::floor(lastMs / stepMs)) + 1;
    kernel.mass.assign(static_cast<std::size_t>(std::max(1, last - kernel.first + 1)), 0.0);
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const double at = std::max(0.0, (originMs + static_cast<double>(i) * kFineMs) / stepMs);
      const double floor = std::floor(at);
      const auto cell = static_cast<std::size_t>(static_cast<int>(floor) - kernel.first);
      kernel.mass[cell] += fine[i] * (1.0 - (at - floor));
      if (cell + 1 < kernel.mass.size()) {
        kernel.mass[cell + 1] += fine[i] * (at - floor);
      }
    }
    // A request takes time: without that a client would never let the time go on.
    if (kernel.first == 0 && kernel.mass.size() == 1) {
      kernel.mass.push_back(0.0);
    }
    if (kernel.first == 0) {
      kernel.mass[1] += kernel.mass[0];
      kernel.mass.erase(kernel.mass.begin());
      kernel.first = 1;
    }
    while (kernel.mass.size() > 1 && kernel.mass.back() < kNegligible) {
      kernel.mass.pop_back();
    }
    const auto begin = std::find_if(kernel.mass.begin(), kernel.mass.end() - 1,
                                    [](double mass) { return mass >= kNegligible; });
    kernel.first += static_cast<int>(begin - kernel.mass.begin());
    kernel.mass.erase(kernel.mass.begin(), begin);
    const double sum = std::accumulate(kernel.mass.begin(), kernel.mass.end(), 0.0);
    for (double& mass : kernel.mass) {
      mass /= sum;
    }
    return kernel;
  }

  double m_meanMs;
  double m_deviationMs;
  double m_minMs;
  double m_originMs = 0.0;
  std::vector<double> m_one;
};

/// Time to the next event of a renewal process that has run for long: (1 - P(T <= t)) / mean.
std::vector<double> residual(const Kernel& kernel) {
  const double mean = kernel.mean();
  std::vector<double> rest(static_cast<std::size_t>(kernel.end()), 0.0);
  double left = 1.0;
  for (int t = 0; t < kernel.end(); ++t) {
    rest[static_cast<std::size_t>(t)] = left / mean;
    if (t + 1 >= kernel.first && t + 1 < kernel.end()) {
      left -= kernel.mass[static_cast<std::size_t>(t + 1 - kernel.first)];
    }
  }
  const double sum = std::accumulate(rest.begin(), rest.end(), 0.0);
  for (double& mass : rest) {
    mass /= sum;
  }
  return rest;
}

/// The motion between two stops: one leg per point, accelerated from a stand to a stand.
class EvenMotion {
 public:
  EvenMotion(std::span<const gcode::StreamPoint> points, base::Vec3 fromMm, double feedMmPerS,
             const ControlTimes& control)
      : m_accelerationMmPerS2(control.accelerationMmPerS2) {
    m_legs.reserve(points.size());
    base::Vec3 at = fromMm;
    for (const gcode::StreamPoint& point : points) {
      Leg leg;
      leg.fromMm = at;
      leg.lengthMm = base::distance(at, point.positionMm);
      if (leg.lengthMm > kLengthMmMin) {
        leg.direction = (1.0 / leg.lengthMm) * (point.positionMm - at);
      } else {
        leg.lengthMm = 0.0;
      }
      if (!m_legs.empty()) {
        leg.entry = cornerSpeed(m_legs.back(), leg, feedMmPerS, control.cornerStepMmPerS);
      }
      m_legs.push_back(leg);
      at = point.positionMm;
    }
    m_endMm = at;
    plan(feedMmPerS);
  }

  [[nodiscard]] double durationS() const { return m_durationS; }
  [[nodiscard]] base::Vec3 endMm() const { return m_endMm; }

  /// Set points on a grid from the start of the motion on; stays at the end.
  void sample(double stepS, std::vector<base::Vec3>& out) const {
    std::size_t leg = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double t = static_cast<double>(i) * stepS;
      while (leg < m_legs.size() && t >= m_legs[leg].startS + m_legs[leg].durationS) {
        ++leg;
      }
      out[i] = leg < m_legs.size() ? m_legs[leg].at(t - m_legs[leg].startS, m_accelerationMmPerS2)
                                   : m_endMm;
    }
  }

 private:
  struct Leg {
    base::Vec3 fromMm;
    base::Vec3 direction;
    double lengthMm = 0.0;
    double entry = 0.0;
    double top = 0.0;
    double exit = 0.0;
    double startS = 0.0;
    double durationS = 0.0;

    [[nodiscard]] base::Vec3 at(double t, double a) const {
      const double upS = (top - entry) / a;
      const double downS = (top - exit) / a;
      double path = 0.0;
      if (t < upS) {
        path = entry * t + 0.5 * a * t * t;
      } else if (t < durationS - downS) {
        path = 0.5 * (entry + top) * upS + top * (t - upS);
      } else {
        const double left = durationS - t;
        path = lengthMm - (exit * left + 0.5 * a * left * left);
      }
      return fromMm + std::clamp(path, 0.0, lengthMm) * direction;
    }
  };

  static double cornerSpeed(const Leg& before, const Leg& after, double feedMmPerS,
                            double stepMmPerS) {
    if (before.lengthMm == 0.0 || after.lengthMm == 0.0) {
      return 0.0;
    }
    double speed = feedMmPerS;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double turn = std::abs(after.direction[axis] - before.direction[axis]);
      if (turn > 1e-12) {
        speed = std::min(speed, stepMmPerS / turn);
      }
    }
    return speed;
  }

  void plan(double feedMmPerS) {
    const double a = m_accelerationMmPerS2;
    double exit = 0.0;
    for (std::size_t i = m_legs.size(); i-- > 0;) {
      m_legs[i].exit = exit;
      m_legs[i].entry =
          std::min(m_legs[i].entry, std::sqrt(exit * exit + 2.0 * a * m_legs[i].lengthMm));
      exit = m_legs[i].entry;
    }
    double entry = 0.0;
    for (std::size_t i = 0; i < m_legs.size(); ++i) {
      Leg& leg = m_legs[i];
      leg.entry = entry;
      leg.startS = m_durationS;
      if (leg.lengthMm > 0.0) {
        leg.exit = std::min(leg.exit, std::sqrt(entry * entry + 2.0 * a * leg.lengthMm));
        const double peak =
            std::sqrt(a * leg.lengthMm + 0.5 * (entry * entry + leg.exit * leg.exit));
        leg.top = std::max({std::min(feedMmPerS, peak), entry, leg.exit});
        const double upMm = (leg.top * leg.top - entry * entry) / (2.0 * a);
        const double downMm = (leg.top * leg.top - leg.exit * leg.exit) / (2.0 * a);
        const double cruiseMm = std::max(0.0, leg.lengthMm - upMm - downMm);
        leg.durationS = (leg.top - entry) / a + (leg.top - leg.exit) / a + cruiseMm / leg.top;
        entry = leg.exit;
      } else {
        entry = 0.0;
      }
      m_durationS += leg.durationS;
    }
  }

  double m_accelerationMmPerS2;
  std::vector<Leg> m_legs;
  base::Vec3 m_endMm;
  double m_durationS = 0.0;
};

/// The motion between two stops, by the model's own motion or the simple one.
class Stretch {
 public:
  Stretch(std::span<const gcode::StreamPoint> points, base::Vec3 fromMm, double feedMmPerS,
          const StreamModel& model)
      : m_endMm(points.empty() ? fromMm : points.back().positionMm) {
    if (model.motion) {
      m_stepS = base::toSeconds(model.control.interpolationCycle);
      m_motion = model.motion->move(points, fromMm, feedMmPerS, m_stepS);
      m_durationS = m_motion.durationS;
    } else {
      m_even.emplace(points, fromMm, feedMmPerS, model.control);
      m_durationS = m_even->durationS();
    }
  }

  [[nodiscard]] double durationS() const { return m_durationS; }
  [[nodiscard]] base::Vec3 endMm() const { return m_endMm; }

  /// Set points on a grid from the start of the motion on; stays at the end.
  void sample(double stepS, std::vector<base::Vec3>& out) const {
    if (m_even) {
      m_even->sample(stepS, out);
      return;
    }
    const std::vector<base::Vec3>& points = m_motion.setPointsMm;
    for (std::size_t i = 0; i < out.size(); ++i) {
      // Between two cycles the set point goes straight on, as it does for the servo.
      const double place = static_cast<double>(i) * stepS / m_stepS;
      const auto before = static_cast<std::size_t>(place);
      out[i] = before + 1 < points.size()
                   ? points[before] + (place - static_cast<double>(before)) *
                                          (points[before + 1] - points[before])
                   : m_endMm;
    }
  }

 private:
  base::Vec3 m_endMm;
  double m_stepS = 0.0;
  double m_durationS = 0.0;
  TimedMotion m_motion;
  std::optional<EvenMotion> m_even;
};

/// Times of the control in ms, and what its cycles make of them.
struct Clockwork {
  explicit Clockwork(const ControlTimes& control)
      : cycleMs(base::toMilliseconds(control.interpolationCycle)),
        standMs(base::toMilliseconds(control.standstillMean)),
        standDeviationMs(base::toMilliseconds(control.standstillDeviation)),
        relatchMs(base::toMilliseconds(control.relatch)),
        blockMs(base::toMilliseconds(control.blockPreparation)) {
    RIVULET_ASSERT(cycleMs > 0.0);
  }

  /// Whole cycles: the stop is seen at the end of the cycle in which the motion ended.
  [[nodiscard]] double up(double ms) const { return std::ceil(ms / cycleMs - 1e-9) * cycleMs; }
  /// Latest moment at which a cell must have been written to be visible at `ms`.
  [[nodiscard]] double down(double ms) const { return std::floor(ms / cycleMs + 1e-9) * cycleMs; }

  double cycleMs;
  double standMs;
  double standDeviationMs;
  double relatchMs;
  double blockMs;
};

/// One stand-still: from the cycle in which the stop was seen to the begin of the next motion.
struct Stand {
  double ms = 0.0;
  double probability = 0.0;
};

/// @param seenLateMs  how long the axes have stood when the stop is seen
/// @param readyMs  after that, when the first block is ready to move
std::vector<Stand> stands(const Clockwork& clock, double seenLateMs, double readyMs, bool moved) {
  // The cycle in which a block becomes ready is the first that can move it.
  const double earliest = std::max(0.0, clock.up(readyMs) - clock.cycleMs);
  if (!moved) {
    return {{earliest, 1.0}};
  }
  const double mean = std::max(0.0, clock.standMs) - seenLateMs;
  if (clock.standDeviationMs <= 0.0) {
    return {{std::max(earliest, clock.up(mean - 0.5 * clock.cycleMs)), 1.0}};
  }
  std::vector<Stand> list;
  double below = 0.0;
  const double last = std::max(earliest, clock.up(mean + kDeviationsKept * clock.standDeviationMs));
  for (double at = earliest; at <= last + 1e-9; at += clock.cycleMs) {
    // To the nearest cycle, as the machine does it.
    const double upTo =
        at + 0.5 * clock.cycleMs > last
            ? 1.0
            : normalBelow((at + 0.5 * clock.cycleMs - mean) / clock.standDeviationMs);
    if (upTo - below > kNegligible) {
      list.push_back({at, upTo - below});
    }
    below = upTo;
  }
  return list;
}

double meanOf(const std::vector<Stand>& list) {
  double mean = 0.0;
  for (const Stand& stand : list) {
    mean += stand.ms * stand.probability;
  }
  return mean;
}

/// Sums up what both methods tell.
struct Tally {
  double alive = 1.0;
  double seconds = 0.0;
  double standingS = 0.0;
  std::size_t stops = 0;
  std::size_t weakest = 0;
  double weakestLoss = 0.0;

  void lose(double mass, std::size_t point) {
    alive -= mass;
    if (mass > weakestLoss) {
      weakestLoss = mass;
      weakest = point;
    }
  }
  [[nodiscard]] Prediction result() const {
    Prediction prediction;
    prediction.failureProbability = std::clamp(1.0 - alive, 0.0, 1.0);
    prediction.duration = base::fromSeconds(seconds);
    prediction.standing = base::fromSeconds(standingS);
    prediction.stops = stops;
    prediction.weakest = {static_cast<std::uint32_t>(weakest)};
    prediction.weakestProbability = weakestLoss;
    return prediction;
  }
};

// --- method signal -----------------------------------------------------------------------------

/// Follows the client from signal to signal. The state is the distribution of the end of the first
/// read that sees a signal, counted from the moment the control sets it.
class SignalModel {
 public:
  SignalModel(const std::vector<gcode::StreamPoint>& points, const OperatingPoint& operatingPoint,
              const StreamModel& model)
      : m_points(points),
        m_point(operatingPoint),
        m_clock(model.control),
        m_model(model),
        m_writeOverheadMs(base::toMilliseconds(model.access.writeOverhead)),
        m_nodes(model.access),
        m_poll(m_nodes.sum(base::toMilliseconds(model.access.readOverhead), 1, kSignalStepMs)),
        m_rest(residual(m_poll)) {
    const auto count = static_cast<std::size_t>(operatingPoint.pointsPerLoop);
    m_sizes = {count / 2, count - count / 2};
    for (std::size_t half = 0; half < 2; ++half) {
      // The slots, and the signal cell as the answer.
      const int nodes = operatingPoint.cellsPerPoint * static_cast<int>(m_sizes[half]) + 1;
      m_refill[half] = m_nodes.sum(m_writeOverheadMs, nodes, kSignalStepMs);
    }
    m_stop = m_nodes.sum(m_writeOverheadMs, 1, kSignalStepMs);
  }

  Prediction run(base::Vec3 startMm) {
    const std::size_t perLoop = m_sizes[0] + m_sizes[1];
    const std::size_t lastLoop = (m_points.size() - 1) / perLoop;
    const std::size_t windows = 2 * (lastLoop + 1);
    Stretch motion = stretch(0, startMm);
    m_tally.seconds += motion.durationS();
    std::vector<double> seen = m_rest;
    for (std::size_t window = 0; window + 1 < windows; ++window) {
      const double motionMs = motion.durationS() * 1e3;
      const bool moved = motionMs > 0.0;
      const double seenMs = std::max(m_clock.up(motionMs), m_clock.cycleMs);
      // After the relatch the signal is set, then (from the loop's end) the branch is read.
      const int blocks = window % 2 == 0 ? 2 : 3;
      const std::vector<Stand> still = stands(m_clock, moved ? seenMs - motionMs : 0.0,
                                              m_clock.relatchMs + blocks * m_clock.blockMs, moved);
      motion = stretch(window + 1, motion.endMm());
      const bool movesOn = motion.durationS() > 0.0;
      if (moved && movesOn) {
        m_tally.seconds += (seenMs - motionMs + meanOf(still)) * 1e-3;
        m_tally.standingS += (seenMs - motionMs + meanOf(still)) * 1e-3;
        ++m_tally.stops;
      }
      m_tally.seconds += motion.durationS();
      const double nextMs = std::max(m_clock.up(motion.durationS() * 1e3), m_clock.cycleMs);
      // A last loop of one point moves nothing when it is repeated: there is time for it.
      const bool endsAlone = (m_points.size() - 1) % perLoop == 0;
      if (window + 2 < windows) {
        const bool signalMayBeLost = endsAlone && window + 3 == windows;
        seen = follow(seen, m_refill[window % 2], still, nextMs, window, signalMayBeLost);
      } else if (!endsAlone) {
        // The last loop: only the stop cell must be there in time.
        endInTime(seen, still, nextMs, window);
      }
    }
    m_tally.seconds += m_clock.relatchMs * 1e-3;
    return m_tally.result();
  }

 private:
  [[nodiscard]] std::size_t begin(std::size_t window) const {
    return window / 2 * (m_sizes[0] + m_sizes[1]) + (window % 2 == 0 ? 0 : m_sizes[0]);
  }

  /// Nodes of the very last refill behind the last one that changes a coordinate.
  [[nodiscard]] double spareNodes() const {
    const base::Vec3 before = m_points[m_points.size() - 2].positionMm;
    const base::Vec3 after = m_points.back().positionMm;
    double spare = 1.0;  // the signal
    for (std::size_t axis = base::kAxisCount; axis-- > 0 && before[axis] == after[axis];) {
      spare += 1.0;
    }
    return spare;
  }

  [[nodiscard]] Stretch stretch(std::size_t window, base::Vec3 fromMm) const {
    const std::size_t from = std::min(begin(window), m_points.size());
    const std::size_t to = std::min(begin(window + 1), m_points.size());
    return Stretch(std::span<const gcode::StreamPoint>(m_points).subspan(from, to - from), fromMm,
                   m_point.feedMmPerS, m_model);
  }

  /// Time from one signal to the next.
  [[nodiscard]] static double gapMs(const Stand& stand, double motionMs) {
    return stand.ms + motionMs;
  }
  /// The signal cell is to be visible when the next signal is set, or it would undo it.
  [[nodiscard]] double deadlineMs(double gap) const {
    return m_clock.down(gap + m_clock.relatchMs) - m_clock.relatchMs;
  }

  std::vector<double> follow(const std::vector<double>& seen, const Kernel& write,
                             const std::vector<Stand>& still, double motionMs, std::size_t window,
                             bool signalMayBeLost) {
    // Behind the slots comes the signal cell; if it may be late, only the slots must be in time,
    // and they are latched one after the other.
    const double graceMs = signalMayBeLost
                               ? spareNodes() * m_nodes.meanMs() +
                                     m_clock.blockMs * static_cast<double>(m_sizes[window % 2])
                               : 0.0;
    // When the write is done.
    std::vector<double> done(seen.size() + static_cast<std::size_t>(write.end()), 0.0);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i] < kNegligible) {
        continue;
      }
      for (std::size_t j = 0; j < write.mass.size(); ++j) {
        done[i + static_cast<std::size_t>(write.first) + j] += seen[i] * write.mass[j];
      }
    }
    const double longest = gapMs(still.back(), motionMs);
    std::vector<double> next(m_rest.size(), 0.0);
    // The ends of all reads after it: the write's end is where the polling begins again.
    const auto steps = static_cast<std::size_t>(std::ceil(longest / kSignalStepMs)) + 1;
    const bool forgets =
        static_cast<double>(done.size()) * kSignalStepMs + kForgottenMs < gapMs(still[0], motionMs);
    std::vector<double> ends;
    if (!forgets) {
      ends.assign(steps, 0.0);
      std::copy(done.begin(),
                done.begin() + static_cast<std::ptrdiff_t>(std::min(done.size(), steps)),
                ends.begin());
      for (std::size_t i = 0; i < steps; ++i) {
        for (std::size_t j = 0; ends[i] > kNegligible && j < m_poll.mass.size(); ++j) {
          const std::size_t to = i + static_cast<std::size_t>(m_poll.first) + j;
          if (to < steps) {
            ends[to] += ends[i] * m_poll.mass[j];
          }
        }
      }
    }
    for (const Stand& stand : still) {
      const double gap = gapMs(stand, motionMs);
      const auto deadline = static_cast<std::ptrdiff_t>(
          std::floor((deadlineMs(gap) + graceMs) / kSignalStepMs + 1e-9));
      double inTime = 0.0;
      for (std::ptrdiff_t i = 0; i <= deadline && i < static_cast<std::ptrdiff_t>(done.size());
           ++i) {
        inTime += done[static_cast<std::size_t>(i)];
      }
      const double total = std::accumulate(done.begin(), done.end(), 0.0);
      m_tally.lose(stand.probability * std::max(0.0, total - inTime), begin(window));
      if (forgets) {
        for (std::size_t i = 0; i < m_rest.size(); ++i) {
          next[i] += stand.probability * inTime * m_rest[i];
        }
        continue;
      }
      const auto signal = static_cast<std::ptrdiff_t>(std::llround(gap / kSignalStepMs));
      for (std::ptrdiff_t i = 0; i < signal && i < static_cast<std::ptrdiff_t>(steps); ++i) {
        const auto at = static_cast<std::size_t>(i);
        // Writes that end too late are no polls; what follows from them lies behind the signal.
        const double begins = ends[at] - (i > deadline && at < done.size() ? done[at] : 0.0);
        if (begins < kNegligible) {
          continue;
        }
        for (std::size_t j = 0; j < m_poll.mass.size(); ++j) {
          const std::ptrdiff_t to = i + m_poll.first + static_cast<std::ptrdiff_t>(j) - signal;
          if (to >= 0 && to < static_cast<std::ptrdiff_t>(next.size())) {
            next[static_cast<std::size_t>(to)] += stand.probability * begins * m_poll.mass[j];
          }
        }
      }
    }
    // Cut-off ends of the distributions must not count as failures.
    const double sum = std::accumulate(next.begin(), next.end(), 0.0);
    if (sum > 0.0) {
      for (double& mass : next) {
        mass *= std::max(0.0, m_tally.alive) / sum;
      }
    }
    return next;
  }

  void endInTime(const std::vector<double>& seen, const std::vector<Stand>& still, double motionMs,
                 std::size_t window) {
    for (const Stand& stand : still) {
      // The branch is read one block after the second signal.
      const double branchMs =
          m_clock.down(gapMs(stand, motionMs) + m_clock.relatchMs + m_clock.blockMs) -
          m_clock.relatchMs;
      double late = 0.0;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        late += seen[i] * (1.0 - m_stop.upTo(branchMs / kSignalStepMs - static_cast<double>(i)));
      }
      m_tally.lose(stand.probability * late, begin(window));
    }
  }

  const std::vector<gcode::StreamPoint>& m_points;
  OperatingPoint m_point;
  Clockwork m_clock;
  StreamModel m_model;
  double m_writeOverheadMs;
  NodeTimes m_nodes;
  Kernel m_poll;
  std::vector<double> m_rest;
  std::array<std::size_t, 2> m_sizes{};
  std::array<Kernel, 2> m_refill;
  Kernel m_stop;
  Tally m_tally;
};

// --- method position ---------------------------------------------------------------------------

/// Follows the client from point to point. The state is, for each point that may be due, the
/// distribution of the moment at which the client begins the next request, counted from the begin
/// of the loop's motion.
class PositionModel {
 public:
  PositionModel(const std::vector<gcode::StreamPoint>& points, const OperatingPoint& operatingPoint,
                const StreamModel& model)
      : m_points(points),
        m_point(operatingPoint),
        m_clock(model.control),
        m_model(model),
        m_perLoop(static_cast<std::size_t>(operatingPoint.pointsPerLoop)),
        m_lagMs(base::toMilliseconds(model.control.servoLag)) {
    const NodeTimes nodes(model.access);
    const double readMs = base::toMilliseconds(model.access.readOverhead);
    const double writeMs = base::toMilliseconds(model.access.writeOverhead);
    m_nodeMs = nodes.meanMs();
    const double aside = std::sqrt(3.0) * base::toMilliseconds(model.access.nodeDeviation);
    m_nodeCells = {std::max(0.0, m_nodeMs - aside) / kPositionStepMs, m_nodeMs / kPositionStepMs,
                   (m_nodeMs + aside) / kPositionStepMs};
    const ClientTurn turn = turnOf(operatingPoint.turn());
    m_poll = nodes.sum(readMs, turn.read, kPositionStepMs);
    m_rest = residual(m_poll);
    m_write.resize(1);
    for (int count = 1; count <= turn.content; ++count) {
      m_write.push_back(nodes.sum(writeMs, count, kPositionStepMs));
    }
  }

  Prediction run(base::Vec3 startMm) {
    const std::size_t lastLoop = (m_points.size() - 1) / m_perLoop;
    base::Vec3 standMm = startMm;
    m_due.assign(2 * m_perLoop + 1, {});
    const double early = seenAtOnce(startMm);
    m_tally.lose(early, 0);
    placeStationary(m_due[0], -kForgottenMs, 1.0 - early);
    for (std::size_t loop = 0; loop <= lastLoop; ++loop) {
      const std::size_t first = loop * m_perLoop;
      const std::size_t count = std::min(m_perLoop, m_points.size() - first);
      const Stretch motion(std::span<const gcode::StreamPoint>(m_points).subspan(first, count),
                           standMm, m_point.feedMmPerS, m_model);
      const double motionMs = motion.durationS() * 1e3;
      m_seenMs = std::max(m_clock.up(motionMs), m_clock.cycleMs);
      m_tally.seconds += motion.durationS();
      standMm = motion.endMm();
      sampleTool(motion);
      if (loop == lastLoop) {
        m_tally.seconds += (m_seenMs - motionMs + m_clock.relatchMs) * 1e-3;
        endInTime(first);
        break;
      }
      for (std::size_t slot = 0; slot < m_perLoop && m_tally.alive > kNegligible; ++slot) {
        followPoint(first, slot);
      }
      const bool moved = motionMs > 0.0;
      const std::vector<Stand> still = stands(m_clock, moved ? m_seenMs - motionMs : 0.0,
                                              m_clock.relatchMs + 2.0 * m_clock.blockMs, moved);
      followStand(first, still.front().ms);
      enterNextLoop(still);
      m_tally.seconds += (m_seenMs - motionMs + meanOf(still)) * 1e-3;
      m_tally.standingS += (m_seenMs - motionMs + meanOf(still)) * 1e-3;
      ++m_tally.stops;
    }
    return m_tally.result();
  }

 private:
  /// Mass over time, from the offset on.
  using Density = std::vector<double>;
  /// Before the motion begins there is room for a stand-still and what precedes it.
  static constexpr int kOffset = 256;

  static std::size_t cell(double ms) {
    return static_cast<std::size_t>(
        std::max(0.0, std::floor(ms / kPositionStepMs + 1e-9) + kOffset));
  }
  static void add(Density& density, std::size_t at, double mass) {
    if (at >= density.size()) {
      density.resize(at + 64, 0.0);
    }
    density[at] += mass;
  }

  static std::size_t firstMass(const Density& density) {
    const auto first = std::find_if(density.begin(), density.end(),
                                    [](double mass) { return mass >= kNegligible; });
    return static_cast<std::size_t>(first - density.begin());
  }

  void placeStationary(Density& density, double ms, double mass) const {
    const std::size_t from = cell(ms);
    for (std::size_t i = 0; i < m_rest.size(); ++i) {
      add(density, from + i, mass * m_rest[i]);
    }
  }

  /// If the tool stands at the first point before the run, the client takes that point for passed
  /// and overwrites it, unless the control leaves its waiting loop first.
  [[nodiscard]] double seenAtOnce(base::Vec3 startMm) const {
    const int node = changingNode(0, m_perLoop, false);
    if (base::distance(startMm, pointMm(0)) >= m_point.deltaMm || node == 0) {
      return 0.0;
    }
    // The waiting loop of the flexible program: a STOPRE, a dwell, two branches.
    const double loopMs =
        m_clock.up(kWaitDwellMs) + m_clock.cycleMs + m_clock.relatchMs + 4.0 * m_clock.blockMs;
    const int steps = static_cast<int>(loopMs / kPositionStepMs);
    double early = 0.0;
    for (int left = 0; left < steps; ++left) {
      for (std::size_t j = 0; j < m_poll.mass.size(); ++j) {
        early += m_poll.mass[j] *
                 m_write[static_cast<std::size_t>(node)].upTo(
                     left - 0.5 * m_clock.cycleMs / kPositionStepMs - m_poll.first -
                     static_cast<double>(j)) /
                 steps;
      }
    }
    return early;
  }

  [[nodiscard]] base::Vec3 pointMm(std::size_t index) const {
    return m_points[std::min(index, m_points.size() - 1)].positionMm;
  }

  /// When the control latches a slot for the next loop: after the relatch the branch is read.
  [[nodiscard]] double latchMs(std::size_t slot) const {
    return m_seenMs + m_clock.relatchMs + m_clock.blockMs * (1.0 + static_cast<double>(slot));
  }

  /// The tool's position as it is read, over time from the offset to the latch of the next loop.
  void sampleTool(const Stretch& motion) {
    const std::size_t before = kOffset;
    const double endMs = latchMs(m_perLoop) + 4.0 * m_nodeMs + 64.0;
    m_set.resize(static_cast<std::size_t>(endMs / kPositionStepMs) + 1);
    motion.sample(kPositionStepMs * 1e-3, m_set);
    m_tool.resize(before + m_set.size());
    // Before the motion the axis still runs up to where the set point stands.
    const double share = m_lagMs > 0.0 ? 1.0 - std::exp(-kPositionStepMs / m_lagMs) : 1.0;
    base::Vec3 actual = m_set.front();
    for (std::size_t i = 0; i < before; ++i) {
      m_tool[i] = actual;
    }
    // The control knows a new position once per cycle; in between it answers with the old one.
    const auto cycle =
        static_cast<std::size_t>(std::max(1L, std::lround(m_clock.cycleMs / kPositionStepMs)));
    base::Vec3 known = actual;
    for (std::size_t i = 0; i < m_set.size(); ++i) {
      actual = actual + share * (m_set[i] - actual);
      known = i % cycle == 0 ? actual : known;
      m_tool[before + i] = known;
    }
  }

  /// Probability that a poll which ends at `at` has found the tool within δ. It has read one axis
  /// after the other; the two times in between are random (a quadrature of three points each).
  [[nodiscard]] double nearness(std::size_t at, base::Vec3 targetMm) const {
    static constexpr std::array<double, 3> kWeights{1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0};
    const auto tool = [&](double ago) {
      const auto cells = static_cast<std::size_t>(std::lround(ago));
      return m_tool[std::min(at - std::min(at, cells), m_tool.size() - 1)];
    };
    // Far away whatever the times are: most cells are.
    const double agoMs = 2.0 * m_nodeCells.back() * kPositionStepMs + m_clock.cycleMs;
    const double farMm = m_point.deltaMm + m_point.feedMmPerS * 1e-3 * agoMs;
    if (base::distance(tool(0.0), targetMm) > farMm) {
      return 0.0;
    }
    double sum = 0.0;
    for (std::size_t last = 0; last < 3; ++last) {
      const double yAgo = m_nodeCells[last];
      for (std::size_t middle = 0; middle < 3; ++middle) {
        const base::Vec3 read{tool(yAgo + m_nodeCells[middle]).x, tool(yAgo).y, tool(0.0).z};
        if (base::distance(read, targetMm) < m_point.deltaMm) {
          sum += kWeights[last] * kWeights[middle];
        }
      }
    }
    return std::min(1.0, sum);
  }

  /// Nodes of the write until the last (first) one that changes a coordinate; 0 if none does.
  /// Which axes are not streamed is not known here: those that move are taken to come last.
  [[nodiscard]] int changingNode(std::size_t oldPoint, std::size_t newPoint, bool last) const {
    const base::Vec3 before = pointMm(oldPoint);
    const base::Vec3 after = pointMm(newPoint);
    int node = 0;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (before[axis] != after[axis]) {
        node = static_cast<int>(axis) + 1;
        if (!last) {
          break;
        }
      }
    }
    return std::min(node, static_cast<int>(m_write.size()) - 1);
  }

  /// The point of `slot` in the loop that begins with `first`: seen, refilled, next.
  void followPoint(std::size_t first, std::size_t slot) {
    Density& due = m_due[slot];
    if (due.empty()) {
      return;
    }
    const std::size_t index = first + slot;
    const base::Vec3 targetMm = pointMm(index);
    const double deadlineMs = m_clock.down(latchMs(slot));
    const std::size_t horizon = cell(deadlineMs) + 1;
    // Where a poll may end to see the point.
    std::size_t nearFrom = horizon;
    std::size_t nearTo = 0;
    m_near.assign(horizon, 0.0);
    for (std::size_t at = firstMass(due); at < horizon; ++at) {
      m_near[at] = nearness(at, targetMm);
      if (m_near[at] > 0.0) {
        nearFrom = std::min(nearFrom, at);
        nearTo = at + 1;
      }
    }
    forgetBefore(due, nearFrom);
    m_seen.assign(horizon, 0.0);
    double lost = 0.0;
    for (std::size_t at = 0; at < due.size(); ++at) {
      const double mass = due[at];
      if (mass < kNegligible) {
        continue;
      }
      if (at + static_cast<std::size_t>(m_poll.first) >= nearTo) {
        lost += mass;  // passed: it is waited for until the loop repeats
        continue;
      }
      for (std::size_t j = 0; j < m_poll.mass.size(); ++j) {
        const std::size_t end = at + static_cast<std::size_t>(m_poll.first) + j;
        const double part = mass * m_poll.mass[j];
        if (end < nearTo) {
          m_seen[end] += part * m_near[end];
          add(due, end, part * (1.0 - m_near[end]));
        } else {
          lost += part;
        }
      }
    }
    due.clear();
    const int node = changingNode(index, index + m_perLoop, true);
    lost += writeOff(
        m_seen,
        [&](std::size_t at) {
          return node == 0 ? 1.0
                           : m_write[static_cast<std::size_t>(node)].upTo(
                                 static_cast<double>(cell(deadlineMs)) - static_cast<double>(at));
        },
        m_due[slot + 1]);
    m_tally.lose(lost, index);
  }

  /// Passes on what was seen, after the write of a point; `share` of it is in time.
  template <class Share>
  double writeOff(const Density& seen, const Share& share, Density& next) {
    const Kernel& write = m_write.back();
    double lost = 0.0;
    for (std::size_t at = 0; at < seen.size(); ++at) {
      if (seen[at] < kNegligible) {
        continue;
      }
      const double kept = share(at);
      lost += seen[at] * (1.0 - kept);
      for (std::size_t j = 0; kept > 0.0 && j < write.mass.size(); ++j) {
        add(next, at + static_cast<std::size_t>(write.first) + j, seen[at] * kept * write.mass[j]);
      }
    }
    return lost;
  }

  /// A client that waits for long may be anywhere in its poll: its history need not be followed.
  void forgetBefore(Density& due, std::size_t nearFrom) const {
    const auto forgotten = static_cast<std::size_t>(kForgottenMs / kPositionStepMs);
    if (nearFrom < 2 * forgotten) {
      return;
    }
    const std::size_t until = nearFrom - forgotten;
    double mass = 0.0;
    for (std::size_t at = 0; at + forgotten / 2 < until && at < due.size(); ++at) {
      mass += due[at];
      due[at] = 0.0;
    }
    if (mass > kNegligible) {
      for (std::size_t i = 0; i < m_rest.size(); ++i) {
        add(due, until + i, mass * m_rest[i]);
      }
    }
  }

  /// While the axes stand, points of the next loop may be seen already: before the control has
  /// latched them that is too early, their slots are overwritten.
  void followStand(std::size_t first, double motionAtMs) {
    const std::size_t until = cell(m_seenMs + motionAtMs);
    for (std::size_t slot = 0; slot < m_perLoop; ++slot) {
      Density& due = m_due[m_perLoop + slot];
      const std::size_t index = first + m_perLoop + slot;
      if (due.empty() || index >= m_points.size()) {
        continue;
      }
      const base::Vec3 targetMm = pointMm(index);
      m_seen.assign(m_tool.size() + static_cast<std::size_t>(m_poll.end()), 0.0);
      // No poll that begins before the next motion ends after this.
      const std::size_t latest = until + static_cast<std::size_t>(m_poll.end());
      m_near.assign(latest, 0.0);
      for (std::size_t at = firstMass(due); at < latest; ++at) {
        m_near[at] = nearness(at, targetMm);
      }
      Density later;
      bool anySeen = false;
      for (std::size_t at = 0; at < due.size(); ++at) {
        const double mass = due[at];
        if (mass < kNegligible) {
          continue;
        }
        if (at >= until) {
          add(later, at, mass);
          continue;
        }
        for (std::size_t j = 0; j < m_poll.mass.size(); ++j) {
          const std::size_t end = at + static_cast<std::size_t>(m_poll.first) + j;
          const double part = mass * m_poll.mass[j];
          const double near = m_near[end];
          if (near > 0.0) {
            m_seen[end] += part * near;
            anySeen = true;
          }
          add(due, end, part * (1.0 - near));
        }
      }
      due = std::move(later);
      if (!anySeen) {
        continue;
      }
      const int node = changingNode(index, index + m_perLoop, false);
      const auto latch = static_cast<double>(cell(m_clock.down(latchMs(slot))));
      const double lost = writeOff(
          m_seen,
          [&](std::size_t at) {
            return node == 0 ? 1.0
                             : 1.0 - m_write[static_cast<std::size_t>(node)].upTo(
                                         latch - static_cast<double>(at));
          },
          m_due[m_perLoop + slot + 1 < m_due.size() ? m_perLoop + slot + 1 : m_perLoop]);
      m_tally.lose(lost, index);
    }
  }

  /// Time is counted from the next motion on.
  void enterNextLoop(const std::vector<Stand>& still) {
    std::vector<Density> next(m_due.size());
    for (std::size_t slot = 0; slot <= m_perLoop; ++slot) {
      Density& due = m_due[m_perLoop + slot];
      for (const Stand& stand : still) {
        const auto shift =
            static_cast<std::ptrdiff_t>(std::llround((m_seenMs + stand.ms) / kPositionStepMs));
        for (std::size_t at = 0; at < due.size(); ++at) {
          if (due[at] >= kNegligible) {
            const auto to = std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(at) - shift);
            add(next[slot], static_cast<std::size_t>(to), due[at] * stand.probability);
          }
        }
      }
    }
    m_due = std::move(next);
    // What was dropped for being negligible is no failure.
    double sum = 0.0;
    for (const Density& due : m_due) {
      sum = std::accumulate(due.begin(), due.end(), sum);
    }
    if (sum > 0.0) {
      for (Density& due : m_due) {
        for (double& mass : due) {
          mass *= std::max(0.0, m_tally.alive) / sum;
        }
      }
    }
  }

  /// The last loop: its first point must be seen, and the stop cell be there at the branch.
  void endInTime(std::size_t first) {
    if (first + 1 == m_points.size()) {
      return;  // one point alone: repeating it moves nothing
    }
    Density& due = m_due[0];
    const auto branch = static_cast<double>(cell(m_clock.down(m_seenMs + m_clock.relatchMs)));
    const Kernel& stop = m_write[1];
    double lost = 0.0;
    std::size_t nearFrom = m_tool.size();
    m_near.assign(m_tool.size() + static_cast<std::size_t>(m_poll.end()), 0.0);
    for (std::size_t at = 0; at < m_tool.size(); ++at) {
      m_near[at] = nearness(at, pointMm(first));
      if (m_near[at] > 0.0) {
        nearFrom = std::min(nearFrom, at);
      }
    }
    forgetBefore(due, nearFrom);
    for (std::size_t at = 0; at < due.size(); ++at) {
      const double mass = due[at];
      if (mass < kNegligible) {
        continue;
      }
      for (std::size_t j = 0; j < m_poll.mass.size(); ++j) {
        const std::size_t end = at + static_cast<std::size_t>(m_poll.first) + j;
        const double part = mass * m_poll.mass[j];
        if (static_cast<double>(end) >= branch) {
          lost += part;
        } else {
          const double near = m_near[end];
          lost += part * near * (1.0 - stop.upTo(branch - static_cast<double>(end)));
          add(due, end, part * (1.0 - near));
        }
      }
    }
    m_tally.lose(lost, first);
  }

  const std::vector<gcode::StreamPoint>& m_points;
  OperatingPoint m_point;
  Clockwork m_clock;
  StreamModel m_model;
  std::size_t m_perLoop;
  double m_lagMs;
  double m_nodeMs = 0.0;
  std::array<double, 3> m_nodeCells{};  ///< a short, a mean and a long node
  Kernel m_poll;
  std::vector<double> m_rest;
  std::vector<Kernel> m_write;  ///< by number of nodes; the last is a whole point
  double m_seenMs = 0.0;        ///< when the stop behind the loop is seen
  std::vector<base::Vec3> m_set;
  std::vector<base::Vec3> m_tool;
  std::vector<double> m_near;
  Density m_seen;
  std::vector<Density> m_due;  ///< by slot; behind the loop's slots those of the next loop
  Tally m_tally;
};

}  // namespace

AccessTimes accessTimesFrom(std::span<const RequestSample> samples) {
  RIVULET_ASSERT(samples.size() >= 2);
  const auto total = static_cast<double>(samples.size());
  double nodes = 0.0;
  double tookMs = 0.0;
  for (const RequestSample& sample : samples) {
    RIVULET_ASSERT(sample.nodes >= 1);
    nodes += sample.nodes;
    tookMs += base::toMilliseconds(sample.took);
  }
  const double nodesMean = nodes / total;
  const double tookMeanMs = tookMs / total;
  double nodesVariance = 0.0;
  double covariance = 0.0;
  for (const RequestSample& sample : samples) {
    nodesVariance += (sample.nodes - nodesMean) * (sample.nodes - nodesMean);
    covariance += (sample.nodes - nodesMean) * (base::toMilliseconds(sample.took) - tookMeanMs);
  }
  const double slopeMs = nodesVariance > 0.0 ? covariance / nodesVariance : 0.0;
  // One number of nodes, or a slope that scatter alone has made: no overhead can be told.
  const bool hasSlope = slopeMs > 0.0 && slopeMs * nodesMean <= tookMeanMs;
  const double nodeMs = hasSlope ? slopeMs : tookMeanMs / nodesMean;
  std::array<double, 2> overheadMs{};
  std::array<double, 2> count{};
  for (const RequestSample& sample : samples) {
    overheadMs[sample.write ? 1 : 0] += base::toMilliseconds(sample.took) - nodeMs * sample.nodes;
    count[sample.write ? 1 : 0] += 1.0;
  }
  for (std::size_t kind = 0; kind < 2; ++kind) {
    overheadMs[kind] =
        hasSlope && count[kind] > 0.0 ? std::max(0.0, overheadMs[kind] / count[kind]) : 0.0;
  }
  double variance = 0.0;
  double leastMs = nodeMs;
  for (const RequestSample& sample : samples) {
    const double nodesMs = base::toMilliseconds(sample.took) - overheadMs[sample.write ? 1 : 0];
    const double off = nodesMs - nodeMs * sample.nodes;
    variance += off * off / sample.nodes;
    if (sample.nodes == 1) {
      leastMs = std::min(leastMs, nodesMs);
    }
  }
  AccessTimes access;
  access.readOverhead = base::fromMilliseconds(overheadMs[0]);
  access.writeOverhead = base::fromMilliseconds(overheadMs[1]);
  access.nodeMean = base::fromMilliseconds(nodeMs);
  access.nodeDeviation = base::fromMilliseconds(std::sqrt(variance / total));
  access.nodeMin = base::fromMilliseconds(std::clamp(leastMs, 0.0, nodeMs));
  return access;
}

namespace {

/// Two windows, mean times: the client brings window n+2 from the moment it sees that window n has
/// been copied; the control copies a window when it stands and the window is there.
Prediction predictWindows(const std::vector<gcode::StreamPoint>& points,
                          const OperatingPoint& operatingPoint, const StreamModel& model,
                          base::Vec3 startMm) {
  constexpr std::size_t kWindows = 2;
  const Clockwork clock(model.control);
  const auto perWindow = static_cast<std::size_t>(operatingPoint.pointsPerLoop);
  const std::size_t count = (points.size() + perWindow - 1) / perWindow;
  const double nodeMs = base::toMilliseconds(model.access.nodeMean);
  const double pollMs = base::toMilliseconds(model.access.readOverhead) + nodeMs;
  const ClientTurn turn = turnOf(operatingPoint.turn());
  const double bringMs = 2.0 * base::toMilliseconds(model.access.writeOverhead) +
                         (turn.content + turn.number) * nodeMs;
  // Relatch, the decision, and the copy with its check: see the generator.
  constexpr double kBlocksPerPoint = 1.4;
  constexpr double kBlocks = 9.0;
  const double readyMs =
      clock.relatchMs +
      clock.blockMs * (kBlocks + kBlocksPerPoint * static_cast<double>(perWindow));
  // A pass of the waiting loop: relatch, its blocks, and a dwell of 20 ms.
  const double passMs = clock.relatchMs + 10.0 * clock.blockMs + 20.0;
  std::vector<double> broughtMs(count, 0.0);
  std::vector<double> copiedMs(count, 0.0);
  double endMs = 0.0;
  double standingMs = 0.0;
  double waitingMs = 0.0;
  base::Vec3 fromMm = startMm;
  for (std::size_t window = 0; window < count; ++window) {
    if (window >= kWindows) {
      broughtMs[window] =
          std::max(broughtMs[window - 1], copiedMs[window - kWindows] + 1.5 * pollMs) + bringMs;
    }
    const double plannedMs =
        window == 0 ? endMs : endMs + std::max(clock.standMs, clock.up(readyMs));
    const double lateMs = broughtMs[window] - endMs;
    const double waitMs = window > 0 && lateMs > 0.0
                              ? std::max(0.0, lateMs + 0.5 * passMs + readyMs - (plannedMs - endMs))
                              : 0.0;
    const double beginMs = plannedMs + waitMs;
    copiedMs[window] = std::max(endMs, beginMs - 2.0 * clock.blockMs);
    if (window > 0) {
      standingMs += beginMs - endMs;
      waitingMs += waitMs;
    }
    const std::size_t begin = window * perWindow;
    const std::size_t end = std::min(begin + perWindow, points.size());
    const Stretch motion(std::span<const gcode::StreamPoint>(points).subspan(begin, end - begin),
                         fromMm, operatingPoint.feedMmPerS, model);
    fromMm = motion.endMm();
    endMs = beginMs + motion.durationS() * 1e3;
  }
  Prediction prediction;
  prediction.duration = base::fromMilliseconds(endMs + clock.relatchMs);
  prediction.standing = base::fromMilliseconds(standingMs);
  prediction.waiting = base::fromMilliseconds(waitingMs);
  prediction.stops = count - 1;
  return prediction;
}

}  // namespace

Prediction predict(const std::vector<gcode::StreamPoint>& points,
                   const OperatingPoint& operatingPoint, const StreamModel& model,
                   base::Vec3 startMm) {
  RIVULET_ASSERT(!points.empty());
  RIVULET_ASSERT(operatingPoint.feedMmPerS > 0.0);
  // Of method credit this is the slower end: it does not stand between windows.
  if (base::hasWindows(operatingPoint.method)) {
    RIVULET_ASSERT(operatingPoint.pointsPerLoop >= 1);
    return predictWindows(points, operatingPoint, model, startMm);
  }
  if (operatingPoint.method == base::MethodKind::Signal) {
    RIVULET_ASSERT(operatingPoint.pointsPerLoop >= 2);
    return SignalModel(points, operatingPoint, model).run(startMm);
  }
  RIVULET_ASSERT(operatingPoint.pointsPerLoop >= 1);
  RIVULET_ASSERT(operatingPoint.deltaMm > 0.0);
  return PositionModel(points, operatingPoint, model).run(startMm);
}

Prediction predict(const std::vector<gcode::StreamPoint>& points,
                   const OperatingPoint& operatingPoint, const StreamModel& model) {
  RIVULET_ASSERT(!points.empty());
  // A little above, so that the first point is not taken for passed before the run.
  const double aboveMm = 1.0 + 2.0 * operatingPoint.deltaMm;
  return predict(points, operatingPoint, model,
                 points.front().positionMm + base::Vec3{0.0, 0.0, aboveMm});
}

double feedMmPerSAt(double probability, const std::vector<gcode::StreamPoint>& points,
                    const OperatingPoint& operatingPoint, const StreamModel& model,
                    double feedMmPerSMin, double feedMmPerSMax) {
  RIVULET_ASSERT(feedMmPerSMin > 0.0);
  RIVULET_ASSERT(feedMmPerSMax > feedMmPerSMin);
  constexpr double kStride = 1.5;
  constexpr double kAccuracy = 1.01;
  const auto isTooFast = [&](double feedMmPerS) {
    OperatingPoint at = operatingPoint;
    at.feedMmPerS = feedMmPerS;
    return predict(points, at, model).failureProbability > probability;
  };
  if (isTooFast(feedMmPerSMin)) {
    return 0.0;
  }
  // From below: the first feed that is too fast is the limit, whatever comes above it.
  double fine = feedMmPerSMin;
  double fast = 0.0;
  while (fast == 0.0) {
    const double next = std::min(fine * kStride, feedMmPerSMax);
    if (isTooFast(next)) {
      fast = next;
    } else if (next >= feedMmPerSMax) {
      return feedMmPerSMax;
    } else {
      fine = next;
    }
  }
  while (fast / fine > kAccuracy) {
    const double middle = std::sqrt(fine * fast);
    (isTooFast(middle) ? fast : fine) = middle;
  }
  return fine;
}

base::Result<Strictness> strictness(const std::vector<gcode::StreamPoint>& points,
                                    const OperatingPoint& operatingPoint, const StreamModel& model,
                                    const SafetyFactors& safety) {
  constexpr double kProbability = 1e-3;
  constexpr double kReach = 50.0;
  RIVULET_ASSERT(points.size() >= 2);
  const base::Result<Verdict> verdict =
      judge(operatingPoint, programDistances(points, std::max(2, operatingPoint.pointsPerLoop)),
            {model.access.nodeMean}, safety);
  if (!verdict) {
    return base::fail(verdict.error());
  }
  Strictness result;
  result.equationMmPerS = verdict->feedMmPerSMax;
  result.modelMmPerS =
      feedMmPerSAt(kProbability, points, operatingPoint, model, verdict->feedMmPerSMax / kReach,
                   verdict->feedMmPerSMax * kReach);
  return result;
}

}  // namespace rivulet::feasibility
