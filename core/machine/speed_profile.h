// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How the speed along the path changes: with an acceleration limit, and with a jerk limit or
/// without one. All in closed form over time, so that nothing depends on where the interpolation
/// cycles fall. Units mm, s. @threadsafety pure.
///
/// A change from one speed to another with the acceleration at rest at its end goes in three
/// phases: the acceleration grows, holds, shrinks to zero. Without a jerk limit the first and the
/// last take no time. A profile along a stretch is a change to a cruising speed, cruising, and a
/// change to the speed at its end; the cruising speed is the highest for which both fit.
#pragma once

#include <array>
#include <cstddef>

namespace rivulet::machine {

struct SpeedLimits {
  double accelerationMmPerS2 = 0.0;
  double jerkMmPerS3 = 0.0;  ///< infinity: none

  friend bool operator==(const SpeedLimits&, const SpeedLimits&) = default;
};

struct SpeedState {
  double speedMmPerS = 0.0;
  double accelerationMmPerS2 = 0.0;  ///< of use only with a jerk limit
};

/// Highest speed from which `speedMmPerS` is reached within `lengthMm`, both at rest of the
/// acceleration.
[[nodiscard]] double brakingSpeedMmPerS(double speedMmPerS, double lengthMm,
                                        const SpeedLimits& limits);

class SpeedProfile {
 public:
  /// Whether the speed can be reached, with the acceleration at rest, within the length.
  [[nodiscard]] static bool reaches(const SpeedState& state, double speedMmPerS, double lengthMm,
                                    const SpeedLimits& limits);
  /// @param capMmPerS    speed not to be exceeded, > 0 (a faster state brakes down to it)
  /// @param exitMmPerS   speed at the end; where it cannot be reached, the nearest one
  /// @param lengthMm     > 0
  [[nodiscard]] static SpeedProfile along(const SpeedState& state, double capMmPerS,
                                          double exitMmPerS, double lengthMm,
                                          const SpeedLimits& limits);
  /// Brakes to a stand, wherever that is.
  [[nodiscard]] static SpeedProfile toStand(const SpeedState& state, const SpeedLimits& limits);

  [[nodiscard]] double durationS() const { return m_durationS; }
  [[nodiscard]] double lengthMm() const { return m_lengthMm; }
  [[nodiscard]] double lengthMmAt(double seconds) const;
  [[nodiscard]] SpeedState stateAt(double seconds) const;
  /// When the length is reached. @param mm 0 to lengthMm
  [[nodiscard]] double secondsAt(double mm) const;

 private:
  struct Phase {
    double beginS = 0.0;
    double beginMm = 0.0;
    double speedMmPerS = 0.0;  ///< at its begin
    double accelerationMmPerS2 = 0.0;
    double jerkMmPerS3 = 0.0;
  };
  static constexpr std::size_t kPhasesMax = 9;

  void add(double durationS, double accelerationMmPerS2, double jerkMmPerS3);
  void addChange(double speedMmPerS, const SpeedLimits& limits);
  void cutShort(double lengthMm);
  [[nodiscard]] const Phase& phaseAt(double seconds) const;

  std::array<Phase, kPhasesMax> m_phases;
  std::size_t m_count = 0;
  double m_durationS = 0.0;
  double m_lengthMm = 0.0;
  SpeedState m_end;
};

}  // namespace rivulet::machine
