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

/// Step of the time grid: there is more to follow than with method signal, and it blurs more by
/// itself.
constexpr double kPositionStepMs = 1.0;
/// Dwell in the waiting loop of the flexible program, see core/templates.
constexpr double kWaitDwellMs = 20.0;

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
      m_tally.seconds += (m_seenMs - motionMs + meanMsOf(still)) * 1e-3;
      m_tally.standingS += (m_seenMs - motionMs + meanMsOf(still)) * 1e-3;
      ++m_tally.stops;
    }
    return m_tally.result();
  }

 private:
  /// Mass over time, from the offset on.
  using Density = std::vector<double>;
  /// Before the motion begins there is room for a standstill and what precedes it.
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

Prediction predictPosition(const std::vector<gcode::StreamPoint>& points,
                           const OperatingPoint& operatingPoint, const StreamModel& model,
                           base::Vec3 startMm) {
  RIVULET_ASSERT(operatingPoint.pointsPerLoop >= 1);
  RIVULET_ASSERT(operatingPoint.deltaMm > 0.0);
  return PositionModel(points, operatingPoint, model).run(startMm);
}

}  // namespace rivulet::feasibility
