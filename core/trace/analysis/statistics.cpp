// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/statistics.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::trace {

base::Duration quantile(const std::vector<base::Duration>& ascending, std::size_t percent) {
  RIVULET_ASSERT(!ascending.empty());
  RIVULET_ASSERT(percent >= 1);
  RIVULET_ASSERT(percent <= 100);
  // ceil(percent / 100 * n) in whole numbers: 0.95 * 20 is a little more than 19 as a double.
  const std::size_t rank = (ascending.size() * percent + 99) / 100;
  return ascending[rank - 1];
}

DurationStatistics durationStatistics(std::vector<base::Duration> durations) {
  DurationStatistics figures;
  if (durations.empty()) {
    return figures;
  }
  std::sort(durations.begin(), durations.end());
  // A long double holds every sum of nanoseconds that a run can reach without overflow.
  long double sum = 0;
  for (const base::Duration duration : durations) {
    sum += static_cast<long double>(duration.count());
  }
  figures.count = durations.size();
  figures.mean = base::Duration{std::llround(sum / static_cast<long double>(durations.size()))};
  figures.p50 = quantile(durations, 50);
  figures.p95 = quantile(durations, 95);
  figures.p99 = quantile(durations, 99);
  figures.max = durations.back();
  return figures;
}

}  // namespace rivulet::trace
