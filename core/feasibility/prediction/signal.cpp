// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/contract.h"
#include "feasibility/client_turn.h"
#include "feasibility/prediction/control_line.h"
#include "feasibility/prediction/durations.h"
#include "feasibility/prediction/methods.h"

namespace rivulet::feasibility {

namespace {

/// Step of the time grid.
constexpr double kSignalStepMs = 0.5;

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
        m_tally.seconds += (seenMs - motionMs + meanMsOf(still)) * 1e-3;
        m_tally.standingS += (seenMs - motionMs + meanMsOf(still)) * 1e-3;
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

  /// When the write that answers a signal is done. @param seen  the end of the read that sees it
  static std::vector<double> writesDone(const std::vector<double>& seen, const Kernel& write) {
    std::vector<double> done(seen.size() + static_cast<std::size_t>(write.end()), 0.0);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (std::size_t j = 0; seen[i] >= kNegligible && j < write.mass.size(); ++j) {
        done[i + static_cast<std::size_t>(write.first) + j] += seen[i] * write.mass[j];
      }
    }
    return done;
  }

  /// The ends of the write and of all reads after it, where polling goes on, up to `steps`.
  [[nodiscard]] std::vector<double> requestEnds(const std::vector<double>& done,
                                                std::size_t steps) const {
    std::vector<double> ends(steps, 0.0);
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
    return ends;
  }

  /// The read that sees the next signal, which is set `signal` steps after the last one.
  /// @param deadline  writes that end after it are too late, and no polls begin there
  void addReads(const std::vector<double>& ends, const std::vector<double>& done,
                std::ptrdiff_t deadline, std::ptrdiff_t signal, double probability,
                std::vector<double>& next) const {
    for (std::ptrdiff_t i = 0; i < signal && i < static_cast<std::ptrdiff_t>(ends.size()); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double begins = ends[at] - (i > deadline && at < done.size() ? done[at] : 0.0);
      for (std::size_t j = 0; begins >= kNegligible && j < m_poll.mass.size(); ++j) {
        const std::ptrdiff_t to = i + m_poll.first + static_cast<std::ptrdiff_t>(j) - signal;
        if (to >= 0 && to < static_cast<std::ptrdiff_t>(next.size())) {
          next[static_cast<std::size_t>(to)] += probability * begins * m_poll.mass[j];
        }
      }
    }
  }

  std::vector<double> follow(const std::vector<double>& seen, const Kernel& write,
                             const std::vector<Stand>& still, double motionMs, std::size_t window,
                             bool signalMayBeLost) {
    // After the slots comes the signal cell; if it may be late, only the slots must be in time,
    // and they are latched one after the other.
    const double graceMs = signalMayBeLost
                               ? spareNodes() * m_nodes.meanMs() +
                                     m_clock.blockMs * static_cast<double>(m_sizes[window % 2])
                               : 0.0;
    const std::vector<double> done = writesDone(seen, write);
    const double total = std::accumulate(done.begin(), done.end(), 0.0);
    const bool forgets =
        static_cast<double>(done.size()) * kSignalStepMs + kForgottenMs < gapMs(still[0], motionMs);
    std::vector<double> ends;
    if (!forgets) {
      const double longestMs = gapMs(still.back(), motionMs);
      ends = requestEnds(done, static_cast<std::size_t>(std::ceil(longestMs / kSignalStepMs)) + 1);
    }
    std::vector<double> next(m_rest.size(), 0.0);
    for (const Stand& stand : still) {
      const double gap = gapMs(stand, motionMs);
      const auto deadline = static_cast<std::ptrdiff_t>(
          std::floor((deadlineMs(gap) + graceMs) / kSignalStepMs + 1e-9));
      const std::ptrdiff_t until =
          std::clamp<std::ptrdiff_t>(deadline + 1, 0, static_cast<std::ptrdiff_t>(done.size()));
      const double inTime = std::accumulate(done.begin(), done.begin() + until, 0.0);
      m_tally.lose(stand.probability * std::max(0.0, total - inTime), begin(window));
      if (forgets) {
        for (std::size_t i = 0; i < m_rest.size(); ++i) {
          next[i] += stand.probability * inTime * m_rest[i];
        }
        continue;
      }
      const auto signal = static_cast<std::ptrdiff_t>(std::llround(gap / kSignalStepMs));
      addReads(ends, done, deadline, signal, stand.probability, next);
    }
    // Cut-off ends of the distributions must not count as failures.
    const double sum = std::accumulate(next.begin(), next.end(), 0.0);
    for (double& mass : next) {
      mass *= sum > 0.0 ? std::max(0.0, m_tally.alive) / sum : 1.0;
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

}  // namespace

Prediction predictSignal(const std::vector<gcode::StreamPoint>& points,
                         const OperatingPoint& operatingPoint, const StreamModel& model,
                         base::Vec3 startMm) {
  RIVULET_ASSERT(operatingPoint.pointsPerLoop >= 2);
  return SignalModel(points, operatingPoint, model).run(startMm);
}

}  // namespace rivulet::feasibility
