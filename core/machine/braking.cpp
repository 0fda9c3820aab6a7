// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/braking.h"

#include <algorithm>

namespace rivulet::machine {

base::Duration brakingTime(const MachineConfig& config, double mmPerS) {
  double acceleration = config.axes[0].accelerationMmPerS2Max;
  double jerk = config.axes[0].jerkMmPerS3Max;
  for (const AxisLimits& axis : config.axes) {
    acceleration = std::min(acceleration, axis.accelerationMmPerS2Max);
    jerk = std::min(jerk, axis.jerkMmPerS3Max);
  }
  const double fadesS = acceleration / jerk;
  const double fastest = mmPerS + 0.5 * acceleration * fadesS;
  return base::fromSeconds(fadesS + fastest / acceleration + fadesS);
}

}  // namespace rivulet::machine
