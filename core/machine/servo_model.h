// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// From set point to actual position. The first model is a first-order lag per axis; a learned
/// emulator can replace it. @threadsafety one object, one thread.
#pragma once

#include <array>

#include "base/axes.h"
#include "base/vec3.h"
#include "machine/config.h"

namespace rivulet::machine {

class ServoModel {
 public:
  virtual ~ServoModel() = default;
  /// One interpolation cycle, in which the set point moves straight from `fromMm` to `toMm`.
  /// @return the actual position at its end, mm. Called every cycle: no allocation.
  virtual base::Vec3 follow(base::Vec3 fromMm, base::Vec3 toMm) = 0;
  [[nodiscard]] virtual base::Vec3 actualMm() const = 0;
  /// The same for the rotary axes, deg.
  virtual base::RotaryDeg followDeg(const base::RotaryDeg& fromDeg,
                                    const base::RotaryDeg& toDeg) = 0;
  [[nodiscard]] virtual base::RotaryDeg actualDeg() const = 0;
};

/// actual' = (set point - actual) / T per axis, solved exactly for a set point that moves evenly
/// within each position cycle.
class LinearServo final : public ServoModel {
 public:
  LinearServo(const MachineConfig& config, const base::AxisPosition& start);
  base::Vec3 follow(base::Vec3 fromMm, base::Vec3 toMm) override;
  [[nodiscard]] base::Vec3 actualMm() const override { return m_actualMm; }
  base::RotaryDeg followDeg(const base::RotaryDeg& fromDeg, const base::RotaryDeg& toDeg) override;
  [[nodiscard]] base::RotaryDeg actualDeg() const override { return m_actualDeg; }

 private:
  struct Lag {
    double decay = 0.0;  ///< exp(-h/T)
    double drag = 0.0;   ///< T/h·(1 - exp(-h/T)): share of the step not yet followed
  };
  [[nodiscard]] static Lag lagOf(double timeConstantS, double stepS);
  [[nodiscard]] double followOne(const Lag& lag, double actual, double from, double to) const;

  int m_steps;
  std::array<Lag, base::kAxisCount> m_lags;
  std::array<Lag, base::kRotaryAxisCount> m_rotaryLags;
  base::Vec3 m_actualMm;
  base::RotaryDeg m_actualDeg;
};

}  // namespace rivulet::machine
