// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whether a motion stays within the software limits of the axes. @threadsafety pure.
#pragma once

#include <optional>

#include "machine/alarm.h"
#include "machine/config.h"
#include "machine/prepared.h"

namespace rivulet::machine {

/// The end of a motion beyond a limit. Machine coordinates: mm, or degrees for A, B and C.
struct BeyondTravel {
  char axis = 'X';
  double target = 0.0;
  double min = 0.0;
  double max = 0.0;

  [[nodiscard]] bool isRotary() const { return axis < 'X'; }
};

/// The first axis that would leave its travel; nothing if none does.
[[nodiscard]] std::optional<BeyondTravel> beyondTravel(const MachineConfig& config,
                                                       const PreparedMotion& motion);

/// The alarm of a motion that would leave the travel; nothing if it does not.
[[nodiscard]] std::optional<Alarm> travelAlarm(const MachineConfig& config,
                                               const PreparedMotion& motion);

}  // namespace rivulet::machine
