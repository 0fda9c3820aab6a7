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

/// Quantiles by nearest rank. O(n log n). @param durations  in any order; copied and sorted
[[nodiscard]] DurationStatistics durationStatistics(std::vector<base::Duration> durations);

}  // namespace rivulet::trace
