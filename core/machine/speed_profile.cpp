// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/speed_profile.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::machine {

namespace {

/// Halvings of an interval of speeds; more would be below the last bit.
constexpr int kHalvings = 60;
/// Newton steps towards a root that is approached from one side; far more than are needed.
constexpr int kNewtonSteps = 40;

/// A profile may be longer than its stretch by this much: rounding, also of earlier profiles that
/// led to the state it starts from.
constexpr double kRoundingMm = 1e-8;

/// Speed at which the acceleration would be at rest if it began to fade now.
double fadedSpeed(const SpeedState& state, const SpeedLimits& limits) {
  const double a = state.accelerationMmPerS2;
  return state.speedMmPerS + 0.5 * a * std::abs(a) / limits.jerkMmPerS3;
}

/// The value nearest to `high` that halving finds with `fits`; it holds for `low`. Where it holds
/// in several intervals between the two, it may be a nearer one to `low`: such a profile is
/// slower, but keeps every limit.
template <class Fits>
double bisect(double low, double high, Fits fits) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

double lengthOf(double seconds, double speed, double acceleration, double jerk) {
  return seconds * (speed + seconds * (0.5 * acceleration + seconds * jerk / 6.0));
}

}  // namespace

double brakingSpeedMmPerS(double speedMmPerS, double lengthMm, const SpeedLimits& limits) {
  const double a = limits.accelerationMmPerS2;
  const double j = limits.jerkMmPerS3;
  if (std::isinf(j)) {
    return std::sqrt(speedMmPerS * speedMmPerS + 2.0 * a * lengthMm);
  }
  // The change is symmetric in time: its length is the mean speed times its duration, which is
  // d/a + a/j with a phase of constant acceleration, and 2·sqrt(d/j) without; d the speed lost.
  const double threshold = a * a / j;
  const double thresholdMm = (2.0 * speedMmPerS + threshold) * a / j;
  if (lengthMm >= thresholdMm) {
    const double b = 2.0 * speedMmPerS / a + a / j;
    const double c = 2.0 * speedMmPerS * a / j - 2.0 * lengthMm;
    return speedMmPerS + 0.5 * a * (std::sqrt(b * b - 4.0 * c / a) - b);
  }
  // (2v + d)·sqrt(d/j) = length: with x = sqrt(d), x³ + 2·v·x = length·sqrt(j), from above.
  const double right = lengthMm * std::sqrt(j);
  double x = std::cbrt(right);
  if (speedMmPerS > 0.0) {
    x = std::min(x, right / (2.0 * speedMmPerS));
  }
  for (int i = 0; i < kNewtonSteps; ++i) {
    const double next = x - (x * x * x + 2.0 * speedMmPerS * x - right) /
                                (3.0 * x * x + 2.0 * speedMmPerS + 1e-300);
    if (next >= x) {
      break;
    }
    x = next;
  }
  return speedMmPerS + x * x;
}

void SpeedProfile::add(double durationS, double accelerationMmPerS2, double jerkMmPerS3) {
  if (!(durationS > 0.0)) {
    return;
  }
  RIVULET_ASSERT(m_count < kPhasesMax);
  const double speed = m_end.speedMmPerS;
  m_phases[m_count++] = {m_durationS, m_lengthMm, speed, accelerationMmPerS2, jerkMmPerS3};
  m_durationS += durationS;
  m_lengthMm += lengthOf(durationS, speed, accelerationMmPerS2, jerkMmPerS3);
  m_end.speedMmPerS =
      std::max(0.0, speed + durationS * (accelerationMmPerS2 + 0.5 * durationS * jerkMmPerS3));
  m_end.accelerationMmPerS2 = accelerationMmPerS2 + durationS * jerkMmPerS3;
}

void SpeedProfile::addChange(double speedMmPerS, const SpeedLimits& limits) {
  const double a = limits.accelerationMmPerS2;
  const double j = limits.jerkMmPerS3;
  if (std::isinf(j)) {
    const double gain = speedMmPerS - m_end.speedMmPerS;
    add(std::abs(gain) / a, gain < 0.0 ? -a : a, 0.0);
  } else {
    const double sign = speedMmPerS >= fadedSpeed(m_end, limits) ? 1.0 : -1.0;
    const double from = sign * m_end.accelerationMmPerS2;
    const double gain = sign * (speedMmPerS - m_end.speedMmPerS);
    double peak = std::sqrt(std::max(0.0, j * gain + 0.5 * from * from));
    double holdS = 0.0;
    if (peak > a) {
      peak = a;
      holdS = std::max(0.0, (gain - (2.0 * a * a - from * from) / (2.0 * j)) / a);
    }
    peak = std::max(peak, from);
    add((peak - from) / j, sign * from, sign * j);
    add(holdS, sign * peak, 0.0);
    add(peak / j, sign * peak, -sign * j);
  }
  m_end = {speedMmPerS, 0.0};
}

void SpeedProfile::cutShort(double lengthMm) {
  if (m_lengthMm <= lengthMm + 2.0 * kRoundingMm) {
    return;
  }
  const double seconds = secondsAt(lengthMm);
  m_end = stateAt(seconds);
  m_durationS = seconds;
  m_lengthMm = lengthMm;
  while (m_count > 0 && m_phases[m_count - 1].beginS >= seconds) {
    --m_count;
  }
}

bool SpeedProfile::reaches(const SpeedState& state, double speedMmPerS, double lengthMm,
                           const SpeedLimits& limits) {
  SpeedProfile profile;
  profile.m_end = state;
  profile.addChange(speedMmPerS, limits);
  return profile.m_lengthMm <= lengthMm + kRoundingMm;
}

SpeedProfile SpeedProfile::along(const SpeedState& state, double capMmPerS, double exitMmPerS,
                                 double lengthMm, const SpeedLimits& limits) {
  const auto changes = [&](double cruise, double exit) {
    SpeedProfile profile;
    profile.m_end = state;
    profile.addChange(cruise, limits);
    profile.addChange(exit, limits);
    return profile;
  };
  double exit = exitMmPerS;
  double cruise = 0.0;
  if (std::isinf(limits.jerkMmPerS3)) {
    const double a = limits.accelerationMmPerS2;
    const double square = state.speedMmPerS * state.speedMmPerS;
    exit = std::clamp(exit, std::sqrt(std::max(0.0, square - 2.0 * a * lengthMm)),
                      std::sqrt(square + 2.0 * a * lengthMm));
    cruise =
        std::max(exit, std::min(capMmPerS, std::sqrt(a * lengthMm + 0.5 * (square + exit * exit))));
  } else {
    if (!reaches(state, exit, lengthMm, limits)) {
      exit = bisect(std::max(0.0, fadedSpeed(state, limits)), exit,
                    [&](double speed) { return reaches(state, speed, lengthMm, limits); });
    }
    const auto fits = [&](double speed) { return changes(speed, exit).m_lengthMm <= lengthMm; };
    const double cap = std::max(capMmPerS, exit);
    cruise = fits(cap) ? cap : bisect(exit, cap, fits);
  }
  const double spareMm = lengthMm - changes(cruise, exit).m_lengthMm;
  SpeedProfile profile;
  profile.m_end = state;
  profile.addChange(cruise, limits);
  if (cruise > 0.0 && spareMm > 0.0) {
    profile.add(spareMm / cruise, 0.0, 0.0);
  }
  profile.addChange(exit, limits);
  profile.cutShort(lengthMm);
  return profile;
}

SpeedProfile SpeedProfile::toStand(const SpeedState& state, const SpeedLimits& limits) {
  SpeedProfile profile;
  profile.m_end = state;
  profile.addChange(0.0, limits);
  return profile;
}

const SpeedProfile::Phase& SpeedProfile::phaseAt(double seconds) const {
  RIVULET_ASSERT(m_count > 0);
  std::size_t index = m_count - 1;
  while (index > 0 && m_phases[index].beginS > seconds) {
    --index;
  }
  return m_phases[index];
}

double SpeedProfile::lengthMmAt(double seconds) const {
  if (seconds >= m_durationS) {
    return m_lengthMm;
  }
  const Phase& phase = phaseAt(seconds);
  return phase.beginMm + lengthOf(seconds - phase.beginS, phase.speedMmPerS,
                                  phase.accelerationMmPerS2, phase.jerkMmPerS3);
}

SpeedState SpeedProfile::stateAt(double seconds) const {
  if (seconds >= m_durationS) {
    return m_end;
  }
  const Phase& phase = phaseAt(seconds);
  const double t = seconds - phase.beginS;
  return {std::max(0.0, phase.speedMmPerS +
                            t * (phase.accelerationMmPerS2 + 0.5 * t * phase.jerkMmPerS3)),
          phase.accelerationMmPerS2 + t * phase.jerkMmPerS3};
}

double SpeedProfile::secondsAt(double mm) const {
  if (mm >= m_lengthMm) {
    return m_durationS;
  }
  std::size_t index = m_count - 1;
  while (index > 0 && m_phases[index].beginMm > mm) {
    --index;
  }
  const Phase& phase = m_phases[index];
  const double left = mm - phase.beginMm;
  const double v = phase.speedMmPerS;
  const double a = phase.accelerationMmPerS2;
  const double endS = index + 1 < m_count ? m_phases[index + 1].beginS : m_durationS;
  if (phase.jerkMmPerS3 == 0.0) {
    const double root = std::sqrt(std::max(0.0, v * v + 2.0 * a * left));
    return v + root > 0.0 ? std::min(endS, phase.beginS + 2.0 * left / (v + root)) : phase.beginS;
  }
  const double seconds = bisect(0.0, endS - phase.beginS, [&](double t) {
    return lengthOf(t, v, a, phase.jerkMmPerS3) <= left;
  });
  return phase.beginS + seconds;
}

}  // namespace rivulet::machine
