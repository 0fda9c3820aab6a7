// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How long a machine goes on moving when its path override becomes 0. @threadsafety pure.
#pragma once

#include "base/instant.h"
#include "machine/config.h"

namespace rivulet::machine {

/// Longest time that the path takes to brake from this speed, whatever it does at that moment and
/// in whatever direction: first the acceleration fades, then the path brakes with jerk. Linear axes
/// only. @param mmPerS  >= 0
[[nodiscard]] base::Duration brakingTime(const MachineConfig& config, double mmPerS);

}  // namespace rivulet::machine
