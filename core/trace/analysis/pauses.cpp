// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/pauses.h"

#include <cmath>

namespace rivulet::trace {

using base::Duration;
using base::Instant;

namespace {

/// Live: samples farther apart do not show that the path stood between them.
constexpr Duration kSampleGapMax = std::chrono::milliseconds{100};

}  // namespace

std::vector<Pause> findPauses(const ControlTrace& trace, const PauseOptions& options) {
  std::vector<Pause> pauses;
  std::optional<Instant> lastMoving;
  std::optional<Instant> lastStanding;
  for (const ControlSample& sample : trace.samples) {
    if (sample.feedMmPerS <= options.standstillMmPerSMax) {
      lastStanding = sample.at;
      continue;
    }
    if (lastMoving && lastStanding) {
      const Duration duration = *lastStanding - *lastMoving;
      if (duration >= options.durationMin) {
        pauses.push_back({*lastMoving, duration, PauseOrigin::Measured});
      }
    }
    lastMoving = sample.at;
    lastStanding.reset();
  }
  return pauses;
}

std::optional<MeasuredPause> LivePauseDetector::add(Instant at, double feedMmPerS) {
  if (std::isnan(feedMmPerS) || (m_latest && at <= *m_latest)) {
    return std::nullopt;
  }
  const std::optional<Instant> before = m_latest;
  m_latest = at;
  const bool isAfterGap = before && at - *before > kSampleGapMax;
  if (isAfterGap) {
    // What happened in between is not known: this standstill is not measured.
    m_firstStanding.reset();
    m_lastMoving.reset();
  }
  if (feedMmPerS <= m_options.standstillMmPerSMax) {
    if (m_lastMoving && !m_firstStanding) {
      m_firstStanding = at;
    }
    return std::nullopt;
  }
  std::optional<MeasuredPause> found;
  if (m_firstStanding) {
    // The previous sample was a standing one, so `before` is the last standing sample.
    const Duration gapAtStart = *m_firstStanding - *m_lastMoving;
    const Duration gapAtEnd = at - *before;
    const Instant start = *m_lastMoving + gapAtStart / 2;
    const Instant end = *before + gapAtEnd / 2;
    // A single standing sample may be the one cycle of a reversal.
    if (*before - *m_firstStanding >= m_options.durationMin) {
      // Rounded up, so that the bound holds to the nanosecond.
      found = MeasuredPause{{start, end - start, PauseOrigin::Measured},
                            (gapAtStart + gapAtEnd) / 2 + Duration{1}};
    }
  }
  m_lastMoving = at;
  m_firstStanding.reset();
  return found;
}

std::optional<Instant> LivePauseDetector::standingSince() const {
  if (!m_firstStanding) {
    return std::nullopt;
  }
  return *m_lastMoving + (*m_firstStanding - *m_lastMoving) / 2;
}

}  // namespace rivulet::trace
