// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program chooses by a number: M functions, directions of the spindle, fixed points.
/// @threadsafety pure.
#pragma once

#include <optional>

#include "base/whole_number.h"

namespace rivulet::nc {

/// @return nothing: it is not a whole number, or beyond those of any control
[[nodiscard]] inline std::optional<int> functionNumber(double value) {
  constexpr int kFunctionsMax = 9'999;
  return base::wholeNumber(value, 0, kFunctionsMax);
}

}  // namespace rivulet::nc
