// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whole runs drawn from a seed: method, N, layout, feed over decades, contours with tiny steps,
/// sharp corners, returning and coinciding points, machines fast and slow, stops at any moment.
/// @threadsafety pure.
#pragma once

#include "streaming/simulation/scenario.h"

namespace rivulet::streaming {

struct RandomScenario {
  Scenario scenario;
  std::vector<base::Vec3> pointsMm;  ///< of its program
};

/// @param preset  the machine that is varied
[[nodiscard]] RandomScenario drawScenario(std::uint64_t seed, const machine::MachineConfig& preset);

}  // namespace rivulet::streaming
