// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program chooses by a number: M functions, directions of the spindle, fixed points.
/// @threadsafety pure.
#pragma once

#include <cmath>
#include <optional>

namespace rivulet::nc {

/// @return nothing: it is not a whole number, or beyond those of any control
[[nodiscard]] inline std::optional<int> functionNumber(double value) {
  constexpr double kFunctionsMax = 10'000.0;
  const bool is = value >= 0.0 && value < kFunctionsMax && value == std::floor(value);
  return is ? std::optional(static_cast<int>(value)) : std::nullopt;
}

}  // namespace rivulet::nc
