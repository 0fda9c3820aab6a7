// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How long the accesses of a run take, and what follows from that: deadlines, the time that a read
/// needs, and whether something slows the run. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/instant.h"
#include "base/recent_values.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

class AccessTimes {
 public:
  /// @param settings  outlive this object
  explicit AccessTimes(const RunSettings& settings);

  /// Of one read of this many variables.
  [[nodiscard]] base::Duration expected(int nodes) const;
  /// The 99th percentile of recent accesses; nothing: nothing is known.
  [[nodiscard]] std::optional<base::Duration> slow() const;
  /// A deadline, longer while answers come late.
  [[nodiscard]] base::Duration patient(base::Duration deadline) const {
    return m_patience * deadline;
  }
  /// What slows the accesses, in English; empty: nothing does.
  [[nodiscard]] std::string slowness() const;

  /// @param nodes  0: a program
  void add(base::Duration took, int nodes);
  /// No answer came in time.
  void lost();

 private:
  /// Durations of which `slow` is made.
  static constexpr std::size_t kRecentMax = 100;
  /// The same to see whether accesses are slow.
  static constexpr std::size_t kSlownessCount = 10;

  const RunSettings& m_settings;
  base::RecentValues<base::Duration> m_recent{kRecentMax};
  base::RecentValues<base::Duration> m_last{kSlownessCount};
  base::RecentValues<double> m_slowness{kSlownessCount};  ///< each access: times its estimate
  std::optional<base::Duration> m_calibratedTail;         ///< of the longest request of the method
  int m_patience = 1;                                     ///< factor of the deadlines
};

}  // namespace rivulet::streaming
