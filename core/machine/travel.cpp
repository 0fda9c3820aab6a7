// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/travel.h"

namespace rivulet::machine {

std::optional<BeyondTravel> beyondTravel(const MachineConfig& config,
                                         const PreparedMotion& motion) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const AxisLimits& limits = config.axes[axis];
    const double target = motion.targetMm[axis];
    if (target < limits.positionMmMin || target > limits.positionMmMax) {
      return BeyondTravel{base::kAxisNames[axis], target, limits.positionMmMin,
                          limits.positionMmMax};
    }
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const std::optional<RotaryLimits>& limits = config.rotaryAxes[axis];
    const double target = motion.targetDeg[axis];
    if (limits && (target < limits->positionDegMin || target > limits->positionDegMax)) {
      return BeyondTravel{base::kRotaryAxisNames[axis], target, limits->positionDegMin,
                          limits->positionDegMax};
    }
  }
  return std::nullopt;
}

}  // namespace rivulet::machine
