// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Figures of a set of durations, such as the access times of a run. @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "base/instant.h"

namespace rivulet::trace {

/// All zero for no durations.
struct DurationStatistics {
  std::size_t count = 0;
  base::Duration mean{};  ///< rounded to the nearest nanosecond
  base::Duration p50{};
  base::Duration p95{};
  base::Duration p99{};
  base::Duration max{};
};

/// The quantile by nearest rank: the smallest value such that at least `percent` of a hundred
/// values are not above it. It is always one of the values; nothing is interpolated, so a rare
/// slow access is never averaged away.
/// @param ascending  sorted, not empty   @param percent  1 to 100
[[nodiscard]] base::Duration quantile(const std::vector<base::Duration>& ascending,
                                      std::size_t percent);

/// Quantiles by nearest rank. O(n log n). @param durations  in any order; copied and sorted
[[nodiscard]] DurationStatistics durationStatistics(std::vector<base::Duration> durations);

}  // namespace rivulet::trace
