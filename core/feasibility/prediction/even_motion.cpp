// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/prediction/even_motion.h"

#include <algorithm>
#include <cmath>

namespace rivulet::feasibility {

namespace {

/// A path shorter than this is no motion.
constexpr double kLengthMmMin = 1e-9;

}  // namespace

EvenMotion::EvenMotion(std::span<const gcode::StreamPoint> points, base::Vec3 fromMm,
                       double feedMmPerS, const ControlTimes& control)
    : m_accelerationMmPerS2(control.accelerationMmPerS2) {
  m_legs.reserve(points.size());
  base::Vec3 at = fromMm;
  for (const gcode::StreamPoint& point : points) {
    Leg leg;
    leg.fromMm = at;
    leg.feedMmPerS = point.feedMmPerS > 0.0 ? point.feedMmPerS : feedMmPerS;
    leg.lengthMm = base::distance(at, point.positionMm);
    if (leg.lengthMm > kLengthMmMin) {
      leg.direction = (1.0 / leg.lengthMm) * (point.positionMm - at);
    } else {
      leg.lengthMm = 0.0;
    }
    if (!m_legs.empty()) {
      leg.entryMmPerS = cornerMmPerS(m_legs.back(), leg, control.cornerStepMmPerS);
    }
    m_legs.push_back(leg);
    at = point.positionMm;
  }
  m_endMm = at;
  plan();
}

void EvenMotion::sample(double stepS, std::vector<base::Vec3>& out) const {
  std::size_t leg = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double t = static_cast<double>(i) * stepS;
    while (leg < m_legs.size() && t >= m_legs[leg].startS + m_legs[leg].durationS) {
      ++leg;
    }
    out[i] = leg < m_legs.size() ? m_legs[leg].atMm(t - m_legs[leg].startS, m_accelerationMmPerS2)
                                 : m_endMm;
  }
}

base::Vec3 EvenMotion::Leg::atMm(double timeS, double accelerationMmPerS2) const {
  const double upS = (topMmPerS - entryMmPerS) / accelerationMmPerS2;
  const double downS = (topMmPerS - exitMmPerS) / accelerationMmPerS2;
  double path = 0.0;
  if (timeS < upS) {
    path = entryMmPerS * timeS + 0.5 * accelerationMmPerS2 * timeS * timeS;
  } else if (timeS < durationS - downS) {
    path = 0.5 * (entryMmPerS + topMmPerS) * upS + topMmPerS * (timeS - upS);
  } else {
    const double left = durationS - timeS;
    path = lengthMm - (exitMmPerS * left + 0.5 * accelerationMmPerS2 * left * left);
  }
  return fromMm + std::clamp(path, 0.0, lengthMm) * direction;
}

double EvenMotion::cornerMmPerS(const Leg& before, const Leg& after, double stepMmPerS) {
  if (before.lengthMm == 0.0 || after.lengthMm == 0.0) {
    return 0.0;
  }
  double speed = std::min(before.feedMmPerS, after.feedMmPerS);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double turn = std::abs(after.direction[axis] - before.direction[axis]);
    if (turn > 1e-12) {
      speed = std::min(speed, stepMmPerS / turn);
    }
  }
  return speed;
}

void EvenMotion::plan() {
  const double a = m_accelerationMmPerS2;
  double exit = 0.0;
  for (std::size_t i = m_legs.size(); i-- > 0;) {
    m_legs[i].exitMmPerS = exit;
    m_legs[i].entryMmPerS =
        std::min(m_legs[i].entryMmPerS, std::sqrt(exit * exit + 2.0 * a * m_legs[i].lengthMm));
    exit = m_legs[i].entryMmPerS;
  }
  double entry = 0.0;
  for (std::size_t i = 0; i < m_legs.size(); ++i) {
    Leg& leg = m_legs[i];
    leg.entryMmPerS = entry;
    leg.startS = m_durationS;
    if (leg.lengthMm > 0.0) {
      leg.exitMmPerS = std::min(leg.exitMmPerS, std::sqrt(entry * entry + 2.0 * a * leg.lengthMm));
      const double peak =
          std::sqrt(a * leg.lengthMm + 0.5 * (entry * entry + leg.exitMmPerS * leg.exitMmPerS));
      leg.topMmPerS = std::max({std::min(leg.feedMmPerS, peak), entry, leg.exitMmPerS});
      const double upMm = (leg.topMmPerS * leg.topMmPerS - entry * entry) / (2.0 * a);
      const double downMm =
          (leg.topMmPerS * leg.topMmPerS - leg.exitMmPerS * leg.exitMmPerS) / (2.0 * a);
      const double cruiseMm = std::max(0.0, leg.lengthMm - upMm - downMm);
      leg.durationS = (leg.topMmPerS - entry) / a + (leg.topMmPerS - leg.exitMmPerS) / a +
                      cruiseMm / leg.topMmPerS;
      entry = leg.exitMmPerS;
    } else {
      entry = 0.0;
    }
    m_durationS += leg.durationS;
  }
}

}  // namespace rivulet::feasibility
