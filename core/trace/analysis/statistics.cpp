// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/statistics.h"

#include <algorithm>
#include <cmath>

#include "base/quantile.h"

namespace rivulet::trace {

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
  figures.p50 = base::quantile(durations, 500);
  figures.p95 = base::quantile(durations, 950);
  figures.p99 = base::quantile(durations, 990);
  figures.max = durations.back();
  return figures;
}

}  // namespace rivulet::trace
