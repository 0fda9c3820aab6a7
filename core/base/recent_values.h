// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The last values of a series and their quantiles, cheap enough to be asked after each value: the
/// values are kept in order of time and in order of size. @threadsafety none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

#include "base/contract.h"
#include "base/quantile.h"

namespace rivulet::base {

template <class Value>
class RecentValues {
 public:
  /// @param capacity  how many values are kept, at least 1
  explicit RecentValues(std::size_t capacity) : m_capacity(capacity) {
    RIVULET_ASSERT(capacity > 0);
  }

  /// The oldest value leaves once the capacity is reached.
  void add(Value value) {
    if (isFull()) {
      m_ascending.erase(std::lower_bound(m_ascending.begin(), m_ascending.end(), m_byTime.front()));
      m_byTime.pop_front();
    }
    m_byTime.push_back(value);
    m_ascending.insert(std::upper_bound(m_ascending.begin(), m_ascending.end(), value), value);
  }

  [[nodiscard]] bool isEmpty() const { return m_byTime.empty(); }
  [[nodiscard]] bool isFull() const { return m_byTime.size() == m_capacity; }
  /// As base::quantile; there must be a value.
  [[nodiscard]] Value quantile(std::size_t perMille) const {
    return base::quantile(m_ascending, perMille);
  }

 private:
  std::size_t m_capacity;
  std::deque<Value> m_byTime;
  std::vector<Value> m_ascending;
};

}  // namespace rivulet::base
