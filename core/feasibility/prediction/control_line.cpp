// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/prediction/control_line.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "feasibility/prediction/durations.h"

namespace rivulet::feasibility {

Stretch::Stretch(std::span<const gcode::StreamPoint> points, base::Vec3 fromMm, double feedMmPerS,
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

void Stretch::sample(double stepS, std::vector<base::Vec3>& out) const {
  if (m_even) {
    m_even->sample(stepS, out);
    return;
  }
  const std::vector<base::Vec3>& points = m_motion.setPointsMm;
  for (std::size_t i = 0; i < out.size(); ++i) {
    // Between two cycles the set point goes straight on, as it does for the servo.
    const double place = static_cast<double>(i) * stepS / m_stepS;
    const auto before = static_cast<std::size_t>(place);
    out[i] = before + 1 < points.size() ? points[before] + (place - static_cast<double>(before)) *
                                                               (points[before + 1] - points[before])
                                        : m_endMm;
  }
}

Clockwork::Clockwork(const ControlTimes& control)
    : cycleMs(base::toMilliseconds(control.interpolationCycle)),
      standMs(base::toMilliseconds(control.standstillMean)),
      standDeviationMs(base::toMilliseconds(control.standstillDeviation)),
      relatchMs(base::toMilliseconds(control.relatch)),
      blockMs(base::toMilliseconds(control.blockPreparation)) {
  RIVULET_ASSERT(cycleMs > 0.0);
}

double Clockwork::up(double ms) const {
  return std::ceil(ms / cycleMs - 1e-9) * cycleMs;
}

double Clockwork::down(double ms) const {
  return std::floor(ms / cycleMs + 1e-9) * cycleMs;
}

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

double meanMsOf(const std::vector<Stand>& list) {
  double mean = 0.0;
  for (const Stand& stand : list) {
    mean += stand.ms * stand.probability;
  }
  return mean;
}

void Tally::lose(double mass, std::size_t point) {
  alive -= mass;
  if (mass > weakestLoss) {
    weakestLoss = mass;
    weakest = point;
  }
}

Prediction Tally::result() const {
  Prediction prediction;
  prediction.failureProbability = std::clamp(1.0 - alive, 0.0, 1.0);
  prediction.duration = base::fromSeconds(seconds);
  prediction.standing = base::fromSeconds(standingS);
  prediction.stops = stops;
  prediction.weakest = {static_cast<std::uint32_t>(weakest)};
  prediction.weakestProbability = weakestLoss;
  return prediction;
}

}  // namespace rivulet::feasibility
