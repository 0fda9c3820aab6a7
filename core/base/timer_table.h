// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Timers by name, for code that is told the time. @threadsafety plain value.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/instant.h"

namespace rivulet::base {

/// A deadline for each name, or none. @tparam Name  an enum from 0 without gaps that ends with
/// `Count`
template <class Name>
class TimerTable {
 public:
  void set(Name name, Instant deadline) { m_deadlines[index(name)] = deadline; }
  void stop(Name name) { m_deadlines[index(name)].reset(); }

  /// Nothing: the timer is stopped.
  [[nodiscard]] std::optional<Instant> deadline(Name name) const {
    return m_deadlines[index(name)];
  }
  /// A timer that is stopped never expires.
  [[nodiscard]] bool isExpired(Name name, Instant now) const {
    return m_deadlines[index(name)] && now >= *m_deadlines[index(name)];
  }
  /// True until the deadline; for as long as the timer is stopped as well.
  [[nodiscard]] bool isAhead(Name name, Instant now) const {
    return !m_deadlines[index(name)] || now < *m_deadlines[index(name)];
  }

 private:
  [[nodiscard]] static constexpr std::size_t index(Name name) {
    return static_cast<std::size_t>(name);
  }
  std::array<std::optional<Instant>, static_cast<std::size_t>(Name::Count)> m_deadlines;
};

}  // namespace rivulet::base
