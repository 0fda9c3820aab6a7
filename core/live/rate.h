// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How fast a counter grows, over the last two seconds. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>

#include "base/instant.h"

namespace rivulet::live {

class Rate {
 public:
  /// @param count  so far; not less than before @param now  not before the last one
  void add(base::Instant now, std::size_t count);
  /// Per second; 0 until there are two values.
  [[nodiscard]] double perS() const;

 private:
  static constexpr base::Duration kWindow = std::chrono::seconds{2};
  static constexpr base::Duration kStep = std::chrono::milliseconds{100};

  /// Each at least `kStep` after the one before, but for the last.
  std::deque<std::pair<base::Instant, std::size_t>> m_values;
};

}  // namespace rivulet::live
