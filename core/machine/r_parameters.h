// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The R-parameters of the channel. Writes of the NC program act at once; writes from outside
/// become visible at the next interpolation boundary. @threadsafety one object, one thread.
#pragma once

#include <vector>

#include "base/contract.h"

namespace rivulet::machine {

class RParameters {
 public:
  explicit RParameters(int count) : m_values(static_cast<std::size_t>(count), 0.0) {}

  [[nodiscard]] bool has(int index) const {
    return index >= 0 && static_cast<std::size_t>(index) < m_values.size();
  }
  [[nodiscard]] double value(int index) const {
    RIVULET_ASSERT(has(index));
    return m_values[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const std::vector<double>& values() const { return m_values; }

  /// As the variable service returns it: a client reads what it has written, although the NC sees
  /// it only from the boundary on.
  [[nodiscard]] double serviceValue(int index) const {
    for (auto write = m_pending.rbegin(); write != m_pending.rend(); ++write) {
      if (write->index == index) {
        return write->value;
      }
    }
    return value(index);
  }

  /// From the NC program.
  void set(int index, double value) {
    RIVULET_ASSERT(has(index));
    m_values[static_cast<std::size_t>(index)] = value;
  }

  /// From outside: waits for `applyPending`.
  void setAtBoundary(int index, double value) {
    RIVULET_ASSERT(has(index));
    m_pending.push_back({index, value});
  }
  [[nodiscard]] bool hasPending() const { return !m_pending.empty(); }
  /// At an interpolation boundary: pending writes take effect, in the order in which they were
  /// made.
  void applyPending() {
    for (const auto& [index, value] : m_pending) {
      set(index, value);
    }
    m_pending.clear();
  }

 private:
  struct Write {
    int index;
    double value;
  };
  std::vector<double> m_values;
  std::vector<Write> m_pending;
};

}  // namespace rivulet::machine
