// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/speed_profile.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::machine {

namespace {

/// Steps of a search that closes in by halving at worst; it ends earlier.
constexpr int kBisectionSteps = 100;
/// Halvings of an interval; more would be below the last bit.
constexpr int kHalvings = 60;

/// A step of Newton's by less than this share is the last one: the next would be below the last
/// bit.
constexpr double kNewtonShare = 1e-9;

double lengthOf(double seconds, const SpeedState& begin, double jerk) {
  return seconds *
         (begin.speedMmPerS + seconds * (0.5 * begin.accelerationMmPerS2 + seconds * jerk / 6.0));
}

SpeedState stateAfter(double seconds, const SpeedState& begin, double jerk) {
  return {std::max(0.0, begin.speedMmPerS +
                            seconds * (begin.accelerationMmPerS2 + 0.5 * seconds * jerk)),
          begin.accelerationMmPerS2 + seconds * jerk};
}

/// When a phase has covered a length. The length never falls in a phase, so Newton's steps are
/// kept within a bracket.
double secondsFor(double mm, const SpeedState& begin, double jerk, double durationS) {
  const double v = begin.speedMmPerS;
  const double a = begin.accelerationMmPerS2;
  if (jerk == 0.0) {
    const double root = std::sqrt(std::max(0.0, v * v + 2.0 * a * mm));
    return v + root > 0.0 ? std::min(durationS, 2.0 * mm / (v + root)) : 0.0;
  }
  double low = 0.0;
  double high = durationS;
  double t = v > 0.0 ? std::min(durationS, mm / v) : 0.5 * durationS;
  for (int i = 0; i < kBisectionSteps && high > low; ++i) {
    const double error = lengthOf(t, begin, jerk) - mm;
    (error > 0.0 ? high : low) = t;
    const double speed = v + t * (a + 0.5 * t * jerk);
    const double next = speed > 0.0 ? t - error / speed : low;
    if (std::abs(next - t) <= kNewtonShare * t) {
      return std::clamp(next, 0.0, durationS);
    }
    t = next > low && next < high ? next : 0.5 * (low + high);
  }
  return t;
}

/// A motion of which no more than its length and its end are asked.
struct Way {
  SpeedState end;
  double lengthMm = 0.0;

  void add(double durationS, double jerkMmPerS3) {
    if (durationS > 0.0) {
      lengthMm += lengthOf(durationS, end, jerkMmPerS3);
      end = stateAfter(durationS, end, jerkMmPerS3);
    }
  }
};

/// The greatest value that is allowed, to the last bit. @param low  allowed  @param high  not
template <class IsAllowed>
double greatest(double low, double high, IsAllowed isAllowed) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const bool isLast = middle == low || middle == high;
    (isAllowed(middle) ? low : high) = middle;
    if (isLast) {
      break;
    }
  }
  return low;
}

}  // namespace

double fadedSpeedMmPerS(const SpeedState& state, double jerkMmPerS3) {
  const double a = state.accelerationMmPerS2;
  return state.speedMmPerS + 0.5 * a * std::abs(a) / jerkMmPerS3;
}

ConstantJerk::ConstantJerk(const SpeedState& from, double durationS, double jerkMmPerS3)
    : m_begin(from), m_jerkMmPerS3(jerkMmPerS3), m_end(from) {
  if (durationS > 0.0) {
    m_durationS = durationS;
    m_lengthMm = lengthOf(durationS, from, jerkMmPerS3);
    m_end = stateAfter(durationS, from, jerkMmPerS3);
  }
}

double ConstantJerk::lengthMmAt(double seconds) const {
  return seconds >= m_durationS ? m_lengthMm : lengthOf(seconds, m_begin, m_jerkMmPerS3);
}

SpeedState ConstantJerk::stateAt(double seconds) const {
  return seconds >= m_durationS ? m_end : stateAfter(seconds, m_begin, m_jerkMmPerS3);
}

double ConstantJerk::secondsAt(double mm) const {
  return mm >= m_lengthMm ? m_durationS
                          : secondsFor(std::max(0.0, mm), m_begin, m_jerkMmPerS3, m_durationS);
}

void SpeedProfile::add(double durationS, double jerkMmPerS3) {
  if (!(durationS > 0.0)) {
    return;
  }
  RIVULET_ASSERT(m_count < kPhasesMax);
  m_phases[m_count++] = {m_durationS, m_lengthMm, m_end, jerkMmPerS3};
  m_durationS += durationS;
  m_lengthMm += lengthOf(durationS, m_end, jerkMmPerS3);
  m_end = stateAfter(durationS, m_end, jerkMmPerS3);
}

void SpeedProfile::cut(double seconds) {
  if (seconds >= m_durationS) {
    return;
  }
  const double lengthMm = lengthMmAt(seconds);
  m_end = stateAt(seconds);
  m_durationS = seconds;
  m_lengthMm = lengthMm;
  while (m_count > 0 && m_phases[m_count - 1].beginS >= seconds) {
    --m_count;
  }
}

void SpeedProfile::setEnd(double lengthMm, const SpeedState& state) {
  m_lengthMm = lengthMm;
  m_end = state;
}

SpeedProfile SpeedProfile::change(const SpeedState& from, double speedMmPerS,
                                  const SpeedLimits& limits) {
  const double a = limits.accelerationMmPerS2;
  const double j = limits.jerkMmPerS3;
  SpeedProfile profile(from);
  const double sign = speedMmPerS >= fadedSpeedMmPerS(from, j) ? 1.0 : -1.0;
  const double begin = sign * from.accelerationMmPerS2;
  const double gain = sign * (speedMmPerS - from.speedMmPerS);
  double peak = std::sqrt(std::max(0.0, j * gain + 0.5 * begin * begin));
  double holdS = 0.0;
  if (peak > a) {
    peak = a;
    holdS = std::max(0.0, (gain - (2.0 * a * a - begin * begin) / (2.0 * j)) / a);
  }
  peak = std::max(peak, begin);
  profile.add((peak - begin) / j, sign * j);
  profile.add(holdS, 0.0);
  profile.add(peak / j, -sign * j);
  profile.m_end = {speedMmPerS, 0.0};
  return profile;
}

SpeedProfile SpeedProfile::climb(const SpeedState& from, double lengthMm, double capMmPerS,
                                 const SpeedLimits& limits, double endMmPerS2Max) {
  const double j = limits.jerkMmPerS3;
  SpeedProfile profile = change(from, std::max(capMmPerS, fadedSpeedMmPerS(from, j)), limits);
  if (profile.m_lengthMm <= lengthMm) {
    const double speed = profile.m_end.speedMmPerS;
    if (speed > 0.0) {
      profile.add((lengthMm - profile.m_lengthMm) / speed, 0.0);
    }
    profile.m_lengthMm = lengthMm;
    return profile;
  }
  profile.cut(profile.secondsAt(lengthMm));
  profile.m_lengthMm = lengthMm;
  if (profile.m_end.accelerationMmPerS2 <= endMmPerS2Max) {
    return profile;
  }
  // The acceleration has to fade earlier, to what the end can bear.
  const double begin = from.accelerationMmPerS2;
  const double low = std::max(begin, endMmPerS2Max);
  const auto shape = [&](auto& motion, double peak, double holdS) {
    motion.add((peak - begin) / j, j);
    motion.add(holdS, 0.0);
    motion.add((peak - endMmPerS2Max) / j, -j);
  };
  const auto fits = [&](double peak, double holdS) {
    Way way{from};
    shape(way, peak, holdS);
    return way.lengthMm <= lengthMm;
  };
  double peak = std::max(low, limits.accelerationMmPerS2);
  double holdS = 0.0;
  if (fits(peak, 0.0)) {
    holdS = greatest(0.0, profile.m_durationS, [&](double middle) { return fits(peak, middle); });
  } else {
    peak = greatest(low, peak, [&](double middle) { return fits(middle, 0.0); });
  }
  profile = SpeedProfile(from);
  shape(profile, peak, holdS);
  if (profile.m_lengthMm > lengthMm) {
    profile.cut(profile.secondsAt(lengthMm));
  } else if (profile.m_end.speedMmPerS > 0.0) {
    const double missingS = (lengthMm - profile.m_lengthMm) / profile.m_end.speedMmPerS;
    profile.add(missingS, 0.0);  // of rounding
  }
  profile.m_lengthMm = lengthMm;
  return profile;
}

SpeedProfile SpeedProfile::reversed() const {
  SpeedProfile profile({m_end.speedMmPerS, -m_end.accelerationMmPerS2});
  profile.m_count = m_count;
  for (std::size_t i = 0; i < m_count; ++i) {
    const std::size_t source = m_count - 1 - i;
    const SpeedState& begin = phaseEnd(source);
    profile.m_phases[i] = {m_durationS - phaseEndS(source),
                           m_lengthMm - phaseEndMm(source),
                           {begin.speedMmPerS, -begin.accelerationMmPerS2},
                           m_phases[source].jerkMmPerS3};
  }
  profile.m_durationS = m_durationS;
  profile.m_lengthMm = m_lengthMm;
  const SpeedState& end = m_count > 0 ? m_phases[0].begin : m_end;
  profile.m_end = {end.speedMmPerS, -end.accelerationMmPerS2};
  return profile;
}

void SpeedProfile::addRest(const SpeedProfile& other, double fromMm, double slower) {
  const auto slowed = [&](const SpeedState& state) {
    return SpeedState{slower * state.speedMmPerS, slower * slower * state.accelerationMmPerS2};
  };
  const double fromS = other.secondsAt(fromMm);
  for (std::size_t i = 0; i < other.m_count; ++i) {
    if (other.phaseEndS(i) > fromS) {
      const double beginS = std::max(fromS, other.m_phases[i].beginS);
      m_end = slowed(other.stateAt(beginS));
      add((other.phaseEndS(i) - beginS) / slower,
          slower * slower * slower * other.m_phases[i].jerkMmPerS3);
    }
  }
  m_end = slowed(other.m_end);
}

std::size_t SpeedProfile::phaseAtMm(double mm) const {
  RIVULET_ASSERT(m_count > 0);
  std::size_t index = m_count - 1;
  while (index > 0 && m_phases[index].beginMm > mm) {
    --index;
  }
  return index;
}

double SpeedProfile::lengthMmAt(double seconds) const {
  if (seconds >= m_durationS) {
    return m_lengthMm;
  }
  std::size_t index = m_count - 1;
  while (index > 0 && m_phases[index].beginS > seconds) {
    --index;
  }
  const Phase& phase = m_phases[index];
  return phase.beginMm + lengthOf(seconds - phase.beginS, phase.begin, phase.jerkMmPerS3);
}

SpeedState SpeedProfile::stateAt(double seconds) const {
  if (seconds >= m_durationS) {
    return m_end;
  }
  std::size_t index = m_count - 1;
  while (index > 0 && m_phases[index].beginS > seconds) {
    --index;
  }
  const Phase& phase = m_phases[index];
  return stateAfter(seconds - phase.beginS, phase.begin, phase.jerkMmPerS3);
}

SpeedState SpeedProfile::stateAtMm(double mm) const {
  if (mm <= 0.0 && m_count > 0) {
    return m_phases[0].begin;
  }
  if (mm >= m_lengthMm || m_count == 0) {
    return m_end;
  }
  const std::size_t index = phaseAtMm(mm);
  const Phase& phase = m_phases[index];
  return stateAfter(secondsFor(std::max(0.0, mm - phase.beginMm), phase.begin, phase.jerkMmPerS3,
                               phaseEndS(index) - phase.beginS),
                    phase.begin, phase.jerkMmPerS3);
}

double SpeedProfile::secondsAt(double mm) const {
  if (mm >= m_lengthMm || m_count == 0) {
    return m_durationS;
  }
  const std::size_t index = phaseAtMm(mm);
  const Phase& phase = m_phases[index];
  return phase.beginS + secondsFor(std::max(0.0, mm - phase.beginMm), phase.begin,
                                   phase.jerkMmPerS3, phaseEndS(index) - phase.beginS);
}

}  // namespace rivulet::machine
