// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/histogram.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/nice_step.h"
#include "base/quantile.h"

namespace rivulet::trace {

namespace {

using base::Duration;

constexpr std::size_t kMedian = 500;
constexpr std::size_t kLowerQuarter = 250;
constexpr std::size_t kUpperQuarter = 750;
constexpr std::size_t kTail = 990;
constexpr std::array<std::size_t, 5> kShown{kMedian, 900, 950, kTail, 999};
constexpr double kBinsMax = 40.0;
/// If all durations are the same, a bin of one microsecond is enough.
constexpr double kWidthMinNs = 1000.0;

}  // namespace

std::vector<Percentile> percentiles(const std::vector<Duration>& ascending) {
  std::vector<Percentile> result;
  for (const std::size_t perMille : kShown) {
    if (ascending.size() * (base::kPerMille - perMille) >= base::kPerMille ||
        (perMille == kMedian && !ascending.empty())) {
      result.push_back({static_cast<int>(perMille), base::quantile(ascending, perMille)});
    }
  }
  return result;
}

Histogram histogram(const std::vector<Duration>& ascending) {
  Histogram result;
  if (ascending.empty()) {
    return result;
  }
  const auto count = [](Duration duration) { return static_cast<double>(duration.count()); };
  const double spread = count(base::quantile(ascending, kUpperQuarter)) -
                        count(base::quantile(ascending, kLowerQuarter));
  const double least = count(ascending.front());
  const double tail = count(base::quantile(ascending, kTail));
  const double wanted = 2.0 * spread / std::cbrt(static_cast<double>(ascending.size()));
  const double width =
      std::max(base::niceStepBelow(std::max(wanted, kWidthMinNs)),
               base::niceStepAbove(std::max((tail - least) / kBinsMax, kWidthMinNs)));
  result.width = Duration{std::llround(width)};
  result.from = Duration{std::llround(std::floor(least / width) * width)};
  const Duration end = Duration{std::llround(tail)};
  const auto bins = static_cast<std::size_t>((end - result.from) / result.width) + 1;
  result.counts.assign(bins, 0);
  for (const Duration duration : ascending) {
    const auto bin = static_cast<std::size_t>((duration - result.from) / result.width);
    if (bin < bins) {
      ++result.counts[bin];
    } else {
      ++result.above;
    }
  }
  return result;
}

}  // namespace rivulet::trace
