// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// From set point to actual position, by the law of an axis (emulator/axis_model): a first-order
/// lag where a preset has a time constant, what was learned where it has a learned emulator.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <optional>

#include "base/axes.h"
#include "base/vec3.h"
#include "emulator/axis_model.h"
#include "machine/config.h"

namespace rivulet::machine {

class ServoModel {
 public:
  /// The axes stand still. Solved in the position cycle, and in steps of 1 ms if that is longer.
  ServoModel(const MachineConfig& config, const base::AxisPosition& start);
  /// One interpolation cycle, in which the set point moves straight from `fromMm` to `toMm`.
  /// @return the actual position at its end, mm. Called every cycle: no allocation.
  base::Vec3 follow(base::Vec3 fromMm, base::Vec3 toMm);
  [[nodiscard]] base::Vec3 actualMm() const { return m_actualMm; }
  /// The same for the rotary axes, deg.
  base::RotaryDeg followDeg(const base::RotaryDeg& fromDeg, const base::RotaryDeg& toDeg);
  [[nodiscard]] base::RotaryDeg actualDeg() const { return m_actualDeg; }

 private:
  /// Nothing: the axis is where its set point is.
  using Axis = std::optional<emulator::AxisSimulator>;
  [[nodiscard]] double followOne(Axis& axis, double from, double to) const;

  int m_steps;
  std::array<Axis, base::kAxisCount> m_axes;
  std::array<Axis, base::kRotaryAxisCount> m_rotaryAxes;
  base::Vec3 m_actualMm;
  base::RotaryDeg m_actualDeg;
};

}  // namespace rivulet::machine
