// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/access_times.h"

#include <fmt/format.h>

#include <algorithm>

#include "streaming/setup/calibration.h"

namespace rivulet::streaming {

namespace {

using base::Duration;

/// Answers that come late make the deadlines up to this many times as long.
constexpr int kPatienceMax = 4;
/// Accesses that take this many times their estimate slow the run.
constexpr double kSlowFactor = 5.0;
constexpr Duration kSlowAccess = std::chrono::milliseconds{50};
/// A single one is enough from here on.
constexpr Duration kHungAccess = std::chrono::milliseconds{500};

}  // namespace

AccessTimes::AccessTimes(const RunSettings& settings) : m_settings(settings) {
  if (settings.calibration) {
    const int nodes = templates::longestWrite(settings.parameters);
    m_calibratedTail = settings.calibration->tail(true, settings.grouping, nodes);
    if (!m_calibratedTail) {
      // A form that was not measured: lists always are.
      m_calibratedTail = settings.calibration->tail(true, opcua::Grouping::List, nodes);
    }
  }
}

Duration AccessTimes::expected(int nodes) const {
  const AccessFit* fit =
      m_settings.calibration ? m_settings.calibration->fit(false, opcua::Grouping::List) : nullptr;
  return fit == nullptr ? m_settings.accessTime * nodes : fit->at(nodes);
}

std::optional<Duration> AccessTimes::slow() const {
  std::optional<Duration> slow;
  if (!m_recent.isEmpty()) {
    slow = m_recent.quantile(990);
  }
  // A hundredth is seen among a hundred; until then what was measured before speaks too.
  if (!m_recent.isFull() && m_calibratedTail) {
    slow = std::max(slow.value_or(*m_calibratedTail), *m_calibratedTail);
  }
  return slow;
}

/// Every access slow: network or server. Some of them: somebody else is served in between.
std::string AccessTimes::slowness() const {
  if (!m_slowness.isFull()) {
    return {};
  }
  const Duration least = m_last.quantile(1);
  const Duration most = m_last.quantile(1000);
  const bool isSlow = m_slowness.quantile(900) >= kSlowFactor && most >= kSlowAccess;
  const bool hasHung = m_slowness.quantile(1000) >= kSlowFactor && most >= kHungAccess;
  if (!isSlow && !hasHung) {
    return {};
  }
  return fmt::format(
      "The control answered slowly: accesses took up to {:.2f} s, {:.0f} times as long as "
      "expected. {}",
      base::toSeconds(most), m_slowness.quantile(1000),
      least >= kSlowAccess
          ? fmt::format("Each took at least {:.2f} s: the network is slow, or the server is busy "
                        "with another OPC UA client.",
                        base::toSeconds(least))
          : "Others were fast: another OPC UA client keeps the server busy at times, or the "
            "network stalls.");
}

void AccessTimes::add(Duration took, int nodes) {
  // A deadline of one and a half times what an answer takes.
  m_patience = 1;
  while (m_patience < kPatienceMax && patient(m_settings.requestDeadline) < took + took / 2) {
    m_patience *= 2;
  }
  if (nodes > 0) {
    m_recent.add(took);
    m_last.add(took);
    m_slowness.add(base::toSeconds(took) / base::toSeconds(expected(nodes)));
  }
}

void AccessTimes::lost() {
  m_patience = std::min(2 * m_patience, kPatienceMax);
}

}  // namespace rivulet::streaming
