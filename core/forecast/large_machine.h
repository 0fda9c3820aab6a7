// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A virtual machine that is large enough for a job. @threadsafety pure.
#pragma once

#include <string>
#include <vector>

#include "job/plan.h"
#include "machine/config.h"

namespace rivulet::forecast {

/// Widens the travel of X, Y and Z where the job leaves it, and takes tools with radius 0 if one is
/// too large for a contour (alarm 10751).
/// @return one English sentence for each change
/// @pre plan.isWhole()
[[nodiscard]] std::vector<std::string> enlarge(machine::MachineConfig& config,
                                               const job::Plan& plan);

}  // namespace rivulet::forecast
