// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// @threadsafety plain values.
#pragma once

#include <string>

#include "nc/fault.h"

namespace rivulet::machine {

/// Why an evaluation or a block stopped the program; numbers as on the control.
struct Alarm {
  int number = 0;  ///< 0: none
  std::string text;
};

/// The alarm the control would show for it.
[[nodiscard]] Alarm alarmOf(const nc::Fault& fault);

}  // namespace rivulet::machine
