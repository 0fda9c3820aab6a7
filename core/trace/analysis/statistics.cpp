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
  figures.p90 = base::quantile(durations, 900);
  figures.p95 = base::quantile(durations, 950);
  figures.p99 = base::quantile(durations, 990);
  figures.max = durations.back();
  return figures;
}

void DurationCounter::add(base::Duration duration) {
  m_sum += static_cast<long double>(duration.count());
  m_max = std::max(m_max, duration);
  if (m_count++ % m_stride != 0) {
    return;
  }
  m_values.push_back(duration);
  if (m_values.size() == kValuesMax) {
    for (std::size_t i = 0; i < kValuesMax / 2; ++i) {
      m_values[i] = m_values[2 * i];
    }
    m_values.resize(kValuesMax / 2);
    m_stride *= 2;
  }
}

DurationStatistics DurationCounter::statistics() const {
  DurationStatistics figures = durationStatistics(m_values);
  if (m_count > 0) {
    figures.count = m_count;
    figures.mean = base::Duration{std::llround(m_sum / static_cast<long double>(m_count))};
    figures.max = m_max;
  }
  return figures;
}

}  // namespace rivulet::trace
