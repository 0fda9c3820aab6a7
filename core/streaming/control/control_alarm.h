// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A control with an alarm starts nothing. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace rivulet::streaming {

/// One English sentence. @param number  of the alarm
[[nodiscard]] std::string describeControlAlarm(std::string_view number);

/// @param number  as read from the control; 0: none  @return StreamError::ControlAlarm
[[nodiscard]] base::Result<void> requireNoAlarm(double number);

}  // namespace rivulet::streaming
