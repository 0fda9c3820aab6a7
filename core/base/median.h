// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The middle of values in any order; `base::quantile` needs them sorted. @threadsafety pure.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/contract.h"

namespace rivulet::base {

/// Of an even number of values the upper one of the two in the middle. @param values  not empty
template <class Value>
[[nodiscard]] Value median(std::vector<Value> values) {
  RIVULET_ASSERT(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace rivulet::base
