// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The distribution of a set of durations: the percentiles that their number allows, and a
/// histogram as data. @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "base/instant.h"

namespace rivulet::trace {

struct Percentile {
  int perMille = 0;  ///< 500, 900, 950, 990 or 999
  base::Duration value{};
  friend bool operator==(const Percentile&, const Percentile&) = default;
};

/// Those of 50, 90, 95, 99 and 99.9 % beyond which at least one duration lies: 99 % needs 100
/// durations, 99.9 % needs 1000. @param ascending  sorted
[[nodiscard]] std::vector<Percentile> percentiles(const std::vector<base::Duration>& ascending);

/// Bins of the same width; bin i counts from + i·width <= duration < from + (i + 1)·width.
struct Histogram {
  base::Duration from{};
  base::Duration width{};  ///< zero if there are no durations
  std::vector<std::size_t> counts;
  std::size_t above = 0;  ///< after the last bin: the few that would stretch the picture
  friend bool operator==(const Histogram&, const Histogram&) = default;
};

/// The width is about 2·IQR/∛n, and 1, 2 or 5 times a power of ten so that the borders are round
/// numbers; there are never more than 41 bins. The bins end shortly after the 99th percentile.
/// @param ascending  sorted
/// @source D. Freedman, P. Diaconis: On the histogram as a density estimator (1981), the width
[[nodiscard]] Histogram histogram(const std::vector<base::Duration>& ascending);

}  // namespace rivulet::trace
