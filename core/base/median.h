// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The middle of values in any order; `base::quantile` needs them sorted. @threadsafety pure.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// The same of whole numbers that are in no list: they are gone through several times, in memory
/// that does not depend on how many they are.
/// @param forEach  calls the function that it is given with each number; there is one or more
template <class ForEach>
[[nodiscard]] std::uint64_t medianOfEach(const ForEach& forEach) {
  constexpr unsigned kDigitBits = 16;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t greatest = 0;
  std::size_t count = 0;
  forEach([&](std::uint64_t number) {
    least = std::min(least, number);
    greatest = std::max(greatest, number);
    ++count;
  });
  RIVULET_ASSERT(count > 0);
  // Digit by digit, from the highest: how many numbers that begin as the wanted one have which.
  std::size_t rank = count / 2;
  std::uint64_t prefix = 0;  // of the distance from the least
  const auto width = static_cast<unsigned>(std::bit_width(greatest - least));
  std::vector<std::size_t> counts(std::size_t{1} << kDigitBits);
  for (unsigned digits = (width + kDigitBits - 1) / kDigitBits; digits > 0; --digits) {
    const unsigned shift = kDigitBits * (digits - 1);
    const bool isTop = shift + kDigitBits >= 64;
    std::ranges::fill(counts, 0);
    forEach([&](std::uint64_t number) {
      const std::uint64_t distance = number - least;
      if (isTop || distance >> (shift + kDigitBits) == prefix) {
        ++counts[(distance >> shift) & (counts.size() - 1)];
      }
    });
    std::size_t digit = 0;
    while (rank >= counts[digit]) {
      rank -= counts[digit++];
    }
    prefix = prefix << kDigitBits | digit;
  }
  return least + prefix;
}

}  // namespace rivulet::base
