// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Least and largest of some values. @threadsafety pure.
#pragma once

#include <algorithm>
#include <limits>

namespace rivulet::trace {

/// Empty until something is added: then `min` is above `max`.
struct ValueRange {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  void add(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
  void add(const ValueRange& other) {
    min = std::min(min, other.min);
    max = std::max(max, other.max);
  }
  [[nodiscard]] bool isEmpty() const { return !(min <= max); }
};

}  // namespace rivulet::trace
