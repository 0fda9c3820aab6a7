// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The pauses of a run as the client sees them: measured from samples of the feed, or inferred from
/// the edges of the handshake. @threadsafety one object, one thread.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "trace/analysis/pauses.h"

namespace rivulet::streaming {

class PauseLog {
 public:
  /// @param nominal  length of an inferred pause
  explicit PauseLog(base::Duration nominal) : m_nominal(nominal) {}

  /// @param stopsPassed  STOPREs known to be passed
  void infer(std::size_t stopsPassed, base::Instant now) {
    for (; m_stopsSeen < stopsPassed; ++m_stopsSeen) {
      m_inferred.push_back({now - m_nominal / 2, m_nominal, trace::PauseOrigin::Inferred});
    }
  }

  /// The next inferred pause that no measured one has replaced in time.
  /// @param all  nothing more will be measured
  [[nodiscard]] std::optional<trace::Pause> settle(bool all, base::Instant now) {
    if (m_inferred.empty() || (!all && now - m_inferred.front().start < kSettles)) {
      return std::nullopt;
    }
    const trace::Pause pause = m_inferred.front();
    m_inferred.pop_front();
    m_pauses.push_back(pause);
    return pause;
  }

  /// @return a pause that has ended with this sample
  [[nodiscard]] std::optional<trace::Pause> measure(base::Instant at, double feedMmPerS) {
    const auto measured = m_detector.add(at, feedMmPerS);
    if (!measured) {
      return std::nullopt;
    }
    // The same stand-still may have been inferred from the handshake already.
    if (!m_inferred.empty()) {
      m_inferred.pop_front();
    }
    return m_pauses.emplace_back(measured->pause);
  }

  [[nodiscard]] const std::vector<trace::Pause>& pauses() const { return m_pauses; }

 private:
  /// An inferred pause gives way to a measured one that comes within this time.
  static constexpr base::Duration kSettles = std::chrono::milliseconds{200};

  base::Duration m_nominal;
  trace::LivePauseDetector m_detector;
  std::deque<trace::Pause> m_inferred;  ///< waiting for a measurement to take their place
  std::vector<trace::Pause> m_pauses;
  std::size_t m_stopsSeen = 0;
};

}  // namespace rivulet::streaming
