// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Set points of a motion controller that plans trapezoids of speed in whole cycles and has no jerk
/// limit (LinuxCNC), where a trace has only actual positions. Frame: machine. @threadsafety pure.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "machine/prepared.h"

namespace rivulet::training {

/// The rules of that planner, as far as they are known.
struct TrapezoidRules {
  std::array<double, base::kAxisCount> accelerationMmPerS2{600.0, 500.0, 350.0};
  double exactStopShare = 0.9;  ///< of the acceleration, with exact stops
  double acrossShare = 0.866;   ///< of the acceleration, across an arc
  double alongShare = 0.5;      ///< along an arc
  double cycleS = 0.001;
};

/// One set point each cycle. The path begins to move in the first one; commands run through a cubic
/// spline, which makes them late by two cycles. Corners with a tolerance become arcs.
[[nodiscard]] std::vector<base::Vec3> trapezoidCourse(
    std::span<const machine::PreparedMotion> blocks, base::Vec3 startMm,
    const TrapezoidRules& rules = {});

}  // namespace rivulet::training
