// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How the speed along the path changes: a motion in phases of constant jerk, in closed form over
/// time, so that nothing depends on where the interpolation cycles fall. Units mm, s.
/// @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>

namespace rivulet::machine {

/// Both finite and > 0. A motion without a jerk limit has one so high that the acceleration
/// changes within nanoseconds.
struct SpeedLimits {
  double accelerationMmPerS2 = 0.0;
  double jerkMmPerS3 = 0.0;

  friend bool operator==(const SpeedLimits&, const SpeedLimits&) = default;
};

struct SpeedState {
  double speedMmPerS = 0.0;
  double accelerationMmPerS2 = 0.0;

  friend bool operator==(const SpeedState&, const SpeedState&) = default;
};

/// Speed that is left when the acceleration, starting now, goes to zero: the lowest one of a
/// motion that brakes, the highest one of a motion that accelerates.
[[nodiscard]] double fadedSpeedMmPerS(const SpeedState& state, double jerkMmPerS3);

/// A motion of one phase. What a `SpeedProfile` of that phase would say, for less.
class ConstantJerk {
 public:
  /// @param durationS  it does not move unless > 0
  ConstantJerk(const SpeedState& from, double durationS, double jerkMmPerS3);

  [[nodiscard]] double durationS() const { return m_durationS; }
  [[nodiscard]] double lengthMm() const { return m_lengthMm; }
  [[nodiscard]] double lengthMmAt(double seconds) const;
  [[nodiscard]] SpeedState stateAt(double seconds) const;
  /// When the length is reached. @param mm 0 to lengthMm
  [[nodiscard]] double secondsAt(double mm) const;

 private:
  SpeedState m_begin;
  double m_jerkMmPerS3;
  double m_durationS = 0.0;
  double m_lengthMm = 0.0;
  SpeedState m_end;
};

class SpeedProfile {
 public:
  struct Phase {
    double beginS = 0.0;
    double beginMm = 0.0;
    SpeedState begin;
    double jerkMmPerS3 = 0.0;
  };

  explicit SpeedProfile(const SpeedState& from = {}) : m_end(from) {}

  /// As fast as possible over a length: the acceleration grows, holds, and fades so that the
  /// speed limit is met at rest of the acceleration.
  /// @param capMmPerS           not below the faded speed of `from`
  /// @param endMmPerS2Max       acceleration at the end, not above it; must be within reach
  [[nodiscard]] static SpeedProfile climb(const SpeedState& from, double lengthMm, double capMmPerS,
                                          const SpeedLimits& limits, double endMmPerS2Max);
  /// Shortest change to a speed, with the acceleration at rest at the end.
  [[nodiscard]] static SpeedProfile change(const SpeedState& from, double speedMmPerS,
                                           const SpeedLimits& limits);
  /// The same motion backwards in time.
  [[nodiscard]] SpeedProfile reversed() const;

  /// Goes on with constant jerk. @param durationS  nothing is added unless > 0
  void add(double durationS, double jerkMmPerS3);
  /// Goes on with the motion of another profile. @param fromMm  place on it, 0 to its length
  /// @param slower  factor of the speed, 0 to 1: the same motion in slower time
  void addRest(const SpeedProfile& other, double fromMm, double slower = 1.0);
  /// Forgets what comes later. @param seconds  0 to durationS
  void cut(double seconds);
  /// Says what the end is where it is known exactly: the sum of the phases has rounding in it.
  void setEnd(double lengthMm, const SpeedState& state);

  [[nodiscard]] double durationS() const { return m_durationS; }
  [[nodiscard]] double lengthMm() const { return m_lengthMm; }
  [[nodiscard]] const SpeedState& end() const { return m_end; }
  [[nodiscard]] double lengthMmAt(double seconds) const;
  [[nodiscard]] SpeedState stateAt(double seconds) const;
  [[nodiscard]] SpeedState stateAtMm(double mm) const;
  /// When the length is reached. @param mm 0 to lengthMm
  [[nodiscard]] double secondsAt(double mm) const;

  [[nodiscard]] std::size_t phaseCount() const { return m_count; }
  [[nodiscard]] const Phase& phase(std::size_t index) const { return m_phases[index]; }
  [[nodiscard]] double phaseEndS(std::size_t index) const {
    return index + 1 < m_count ? m_phases[index + 1].beginS : m_durationS;
  }
  [[nodiscard]] double phaseEndMm(std::size_t index) const {
    return index + 1 < m_count ? m_phases[index + 1].beginMm : m_lengthMm;
  }
  [[nodiscard]] const SpeedState& phaseEnd(std::size_t index) const {
    return index + 1 < m_count ? m_phases[index + 1].begin : m_end;
  }

 private:
  static constexpr std::size_t kPhasesMax = 12;

  [[nodiscard]] std::size_t phaseAtMm(double mm) const;

  std::array<Phase, kPhasesMax> m_phases;
  std::size_t m_count = 0;
  double m_durationS = 0.0;
  double m_lengthMm = 0.0;
  SpeedState m_end;
};

}  // namespace rivulet::machine
