// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which numbers are taken at all where they enter: from programs, settings, options and live
/// sources. What a machine can do is narrower, and another question. @threadsafety pure.
#pragma once

namespace rivulet::base {

/// 1 mm in 17 hours: whoever programs less has mistyped it, and the axes would seem to stand.
inline constexpr double kFeedMmPerMinLeast = 0.001;
/// 1 km a minute.
inline constexpr double kFeedMmPerMinMost = 1e6;

/// False as well for what is no number.
[[nodiscard]] constexpr bool isFeedMmPerMin(double feedMmPerMin) {
  return feedMmPerMin >= kFeedMmPerMinLeast && feedMmPerMin <= kFeedMmPerMinMost;
}

}  // namespace rivulet::base
