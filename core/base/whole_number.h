// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A number that others have written or sent, as an int. @threadsafety pure.
#pragma once

#include <cmath>
#include <optional>

namespace rivulet::base {

/// @return nothing: it has a fraction, is NaN, or is not between the two
[[nodiscard]] inline std::optional<int> wholeNumber(double value, int least, int most) {
  const bool is = value >= least && value <= most && value == std::floor(value);
  return is ? std::optional(static_cast<int>(value)) : std::nullopt;
}

}  // namespace rivulet::base
