// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Small statistics the experiments share. @threadsafety pure.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/quantile.h"

namespace rivulet::papers {

[[nodiscard]] double meanOf(const std::vector<double>& values);
/// Standard deviation of a sample (n - 1). 0 for fewer than two values.
[[nodiscard]] double deviationOf(const std::vector<double>& values);
/// `base::quantile` of values in any order. @param values not empty @param perMille  0 to 1000
[[nodiscard]] double quantileOf(std::vector<double> values, std::size_t perMille);
[[nodiscard]] inline double medianOf(std::vector<double> values) {
  return quantileOf(std::move(values), base::kPerMille / 2);
}

/// A share seen in a number of trials, and the interval that holds the true one with 95 %
/// (Wilson's score interval).
struct Share {
  double seen = 0.0;
  double low = 0.0;
  double high = 1.0;
};
[[nodiscard]] Share shareOf(std::size_t hits, std::size_t trials);

}  // namespace rivulet::papers
