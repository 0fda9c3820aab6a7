// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/pauses.h"

#include <cmath>

#include "base/units.h"

namespace rivulet::trace {

using base::Duration;
using base::Instant;

namespace {

/// Live: samples farther apart do not show that the path stood between them.
constexpr Duration kSampleGapMax = std::chrono::milliseconds{100};
/// A pause may begin and end in a gap that is longer, but only a small part of it.
constexpr int kGapsOfPause = 4;

bool isShort(Duration gap, Duration seen) {
  return gap <= kSampleGapMax || kGapsOfPause * gap <= seen;
}

}  // namespace

std::optional<Pause> PauseFinder::add(const ControlSample& sample) {
  if (sample.feedMmPerS <= m_options.standstillMmPerSMax) {
    m_lastStanding = sample.at;
    return std::nullopt;
  }
  std::optional<Pause> found;
  if (m_lastMoving && m_lastStanding) {
    const Duration duration = *m_lastStanding - *m_lastMoving;
    if (duration >= m_options.durationMin) {
      found = Pause{*m_lastMoving, duration, PauseOrigin::Measured};
    }
  }
  m_lastMoving = sample.at;
  m_lastStanding.reset();
  return found;
}

std::vector<Pause> findPauses(const ControlTrace& trace, const PauseOptions& options) {
  std::vector<Pause> pauses;
  PauseFinder finder(options);
  for (const ControlSample& sample : trace.samples) {
    if (const std::optional<Pause> pause = finder.add(sample)) {
      pauses.push_back(*pause);
    }
  }
  return pauses;
}

std::optional<MeasuredPause> LivePauseDetector::add(Instant at, double feedMmPerS) {
  if (std::isnan(feedMmPerS) || (m_latest && at <= *m_latest)) {
    return std::nullopt;
  }
  const std::optional<Instant> before = m_latest;
  m_latest = at;
  if (feedMmPerS <= m_options.standstillMmPerSMax) {
    if (m_firstStanding && at - *before > kSampleGapMax) {
      // What happened in between is not known: this standstill is not measured.
      m_firstStanding.reset();
      m_lastMoving.reset();
    }
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
    const Duration seen = *before - *m_firstStanding;
    // A single standing sample may be the one cycle of a reversal.
    if (seen >= m_options.durationMin && isShort(gapAtStart, seen) && isShort(gapAtEnd, seen)) {
      // Rounded up, so that the bound holds to the nanosecond.
      found = MeasuredPause{{start, end - start, PauseOrigin::Measured},
                            (gapAtStart + gapAtEnd) / 2 + Duration{1}};
    }
  }
  m_lastMoving = at;
  m_firstStanding.reset();
  return found;
}

std::optional<double> StandstillByPosition::add(Instant at, base::Vec3 positionMm,
                                                double feedMmPerS) {
  constexpr Duration kIntervalMin = std::chrono::milliseconds{8};
  /// Slower than this share of the feed the tool stands: the axes still settle.
  constexpr double kStandingShare = 0.02;
  if (!m_before) {
    m_before = Sample{at, positionMm};
    return std::nullopt;
  }
  const Duration passed = at - m_before->at;
  if (passed < kIntervalMin) {
    return std::nullopt;
  }
  const double speedMmPerS =
      base::distance(positionMm, m_before->positionMm) / base::toSeconds(passed);
  m_before = Sample{at, positionMm};
  const bool stood = m_stands;
  m_stands = speedMmPerS < kStandingShare * feedMmPerS;
  if (m_stands) {
    return 0.0;
  }
  return stood ? std::optional(speedMmPerS) : std::nullopt;
}

std::optional<Instant> LivePauseDetector::standingSince() const {
  if (!m_firstStanding) {
    return std::nullopt;
  }
  return *m_lastMoving + (*m_firstStanding - *m_lastMoving) / 2;
}

}  // namespace rivulet::trace
