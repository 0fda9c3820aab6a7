// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/travel.h"

#include <fmt/format.h>

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

std::optional<Alarm> travelAlarm(const MachineConfig& config, const PreparedMotion& motion) {
  const std::optional<BeyondTravel> beyond = beyondTravel(config, motion);
  if (!beyond) {
    return std::nullopt;
  }
  const char* const unit = beyond->isRotary() ? "deg" : "mm";
  return Alarm{10720, fmt::format("Line {}: axis {} is to go to {} {}, beyond its software limit "
                                  "({} to {} {}).",
                                  motion.line.value, beyond->axis, beyond->target, unit,
                                  beyond->min, beyond->max, unit)};
}

}  // namespace rivulet::machine
