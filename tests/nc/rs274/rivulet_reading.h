// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What Rivulet makes of a LinuxCNC program. @threadsafety pure.
#pragma once

#include <string_view>

#include "nc/rs274/path_reading.h"

namespace rivulet::tests {

[[nodiscard]] PathReading readAsRivulet(std::string_view text);

}  // namespace rivulet::tests
