// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Quantiles by nearest rank. Nothing is interpolated: the result is always one of the values, so
/// that a rare slow access is never averaged away. @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "base/contract.h"

namespace rivulet::base {

inline constexpr std::size_t kPerMille = 1000;

/// The smallest value such that at least `perMille` of a thousand values are not above it.
/// @param ascending  sorted, not empty   @param perMille  0 (the smallest) to 1000 (the largest)
template <class Value>
[[nodiscard]] Value quantile(const std::vector<Value>& ascending, std::size_t perMille) {
  RIVULET_ASSERT(!ascending.empty());
  RIVULET_ASSERT(perMille <= kPerMille);
  // ⌈perMille / 1000 · n⌉ in whole numbers: 0.95 · 20 is a little more than 19 as a double.
  const std::size_t rank = (ascending.size() * perMille + kPerMille - 1) / kPerMille;
  return ascending[rank == 0 ? 0 : rank - 1];
}

}  // namespace rivulet::base
