// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/control/control_alarm.h"

#include <fmt/format.h>

#include "streaming/run/run.h"

namespace rivulet::streaming {

std::string describeControlAlarm(std::string_view number) {
  return fmt::format("The control reports alarm {}. Clear it at the control.", number);
}

base::Result<void> requireNoAlarm(double number) {
  if (number == 0.0) {
    return {};
  }
  return base::fail(StreamError::ControlAlarm, describeControlAlarm(fmt::format("{:.0f}", number)));
}

}  // namespace rivulet::streaming
