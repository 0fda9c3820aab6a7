// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/contract.h"

namespace rivulet::papers {

double meanOf(const std::vector<double>& values) {
  return values.empty() ? 0.0
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

double deviationOf(const std::vector<double>& values) {
  if (values.size() < 2) {
    return 0.0;
  }
  const double mean = meanOf(values);
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double quantileOf(std::vector<double> values, std::size_t perMille) {
  std::sort(values.begin(), values.end());
  return base::quantile(values, perMille);
}

Share shareOf(std::size_t hits, std::size_t trials) {
  if (trials == 0) {
    return {};
  }
  constexpr double kZ = 1.959963984540054;  // 95 %
  const auto n = static_cast<double>(trials);
  const double seen = static_cast<double>(hits) / n;
  const double weight = 1.0 / (1.0 + kZ * kZ / n);
  const double middle = weight * (seen + kZ * kZ / (2.0 * n));
  const double half = weight * kZ * std::sqrt(seen * (1.0 - seen) / n + kZ * kZ / (4.0 * n * n));
  return {seen, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace rivulet::papers
