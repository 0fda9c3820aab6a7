// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The one place where units are converted. Inside Rivulet: mm, s, mm/s. The control, NC text and
/// the operator speak mm/min.
#pragma once

namespace rivulet::base {

inline constexpr double kMmPerInch = 25.4;

[[nodiscard]] constexpr double mmPerSFromMmPerMin(double feedMmPerMin) {
  return feedMmPerMin / 60.0;
}
[[nodiscard]] constexpr double mmPerMinFromMmPerS(double feedMmPerS) {
  return feedMmPerS * 60.0;
}

}  // namespace rivulet::base
