// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The time of day. It jumps when the clock is set: durations are measured with another clock.
/// @threadsafety reads the system's clock; shares nothing.
#pragma once

#include "base/utc.h"

namespace rivulet::utc {

[[nodiscard]] base::UtcMs now();

}  // namespace rivulet::utc
