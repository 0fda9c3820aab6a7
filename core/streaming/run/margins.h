// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How close the next points of a run came to being late, and how often they were.
/// @threadsafety one object, one thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/instant.h"

namespace rivulet::streaming {

class Margins {
 public:
  /// @param margin  see `LiveUpdate::margin`
  void add(base::Duration margin) {
    const bool isLate = margin < base::Duration::zero();
    const bool wasLate = m_last && *m_last < base::Duration::zero();
    m_lateWindows += isLate && !wasLate ? 1 : 0;
    m_least = m_last ? std::min(m_least, margin) : margin;
    m_last = margin;
  }
  /// How often the next points were due before they could be there.
  [[nodiscard]] std::size_t lateWindows() const { return m_lateWindows; }
  /// The smallest time that was left; 0: not known yet.
  [[nodiscard]] base::Duration least() const { return m_least; }
  /// The last one; nothing: not known yet.
  [[nodiscard]] std::optional<base::Duration> last() const { return m_last; }

 private:
  std::size_t m_lateWindows = 0;
  base::Duration m_least{};
  std::optional<base::Duration> m_last;
};

}  // namespace rivulet::streaming
