// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The motion of a flexible program's window, computed with the look-ahead of the virtual machine:
/// input of the probability of a failed run. @threadsafety `move` from any thread.
#pragma once

#include "feasibility/probability.h"
#include "machine/config.h"

namespace rivulet::forecast {

class PlannerMotion final : public feasibility::MotionModel {
 public:
  explicit PlannerMotion(machine::MachineConfig machine) : m_machine(std::move(machine)) {}
  /// Blocks as the template has them: G1 with G64, dynamics as after reset. The set points come at
  /// the machine's interpolation cycle, which `stepS` must be.
  [[nodiscard]] feasibility::TimedMotion move(std::span<const gcode::StreamPoint> points,
                                              base::Vec3 fromMm, double feedMmPerS,
                                              double stepS) const override;

 private:
  machine::MachineConfig m_machine;
};

}  // namespace rivulet::forecast
