// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How long the control is busy with the native blocks of a job, as far as they say it: tool
/// changes, dwells, spindle and coolant. The time of cycles, retracts and stops is not known.
/// @threadsafety pure.
#pragma once

#include <vector>

#include "job/plan.h"
#include "machine/config.h"

namespace rivulet::session {

/// Of the native blocks before one stretch.
struct NativeTime {
  double toolChangesS = 0.0;
  double othersS = 0.0;
};

/// @param machine  whose tool changer and spindle are taken
/// @return one for each stretch that moves, and one for the blocks after the last
[[nodiscard]] std::vector<NativeTime> nativeTimes(const job::Plan& plan,
                                                  const machine::MachineConfig& machine);

}  // namespace rivulet::session
