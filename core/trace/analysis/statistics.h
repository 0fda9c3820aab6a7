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
  base::Duration p90{};
  base::Duration p95{};
  base::Duration p99{};
  base::Duration max{};
};

/// Quantiles by nearest rank. O(n log n). @param durations  in any order; copied and sorted
[[nodiscard]] DurationStatistics durationStatistics(std::vector<base::Duration> durations);

/// The same of durations that arrive one by one, in bounded memory: beyond `kValuesMax` values,
/// quantiles are those of every second, fourth, … value. Count, mean and maximum are exact.
class DurationCounter {
 public:
  static constexpr std::size_t kValuesMax = 65'536;

  void add(base::Duration duration);
  [[nodiscard]] std::size_t count() const { return m_count; }
  [[nodiscard]] DurationStatistics statistics() const;

 private:
  std::vector<base::Duration> m_values;
  std::size_t m_stride = 1;  ///< one value in so many is kept
  std::size_t m_count = 0;
  long double m_sum = 0;  ///< ns
  base::Duration m_max{};
};

}  // namespace rivulet::trace
