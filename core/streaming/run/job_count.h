// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A whole job counted in all its points, as one run. @threadsafety plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "streaming/run/whole_job.h"

namespace rivulet::streaming {

class JobCount {
 public:
  /// @param stretchStarts  which of the streamed points each stretch begins with, ascending
  /// @param total  streamed points of the whole job
  /// @param resumedIn  stretch in which the job goes on; 0: it begins at its beginning
  /// @param resumedAt  points of that stretch that were executed before
  JobCount(std::vector<std::uint32_t> stretchStarts, std::size_t total, int resumedIn = 0,
           std::size_t resumedAt = 0)
      : m_starts(std::move(stretchStarts)),
        m_total(total),
        m_resumedIn(resumedIn),
        m_resumedAt(resumedAt) {}

  [[nodiscard]] std::size_t total() const { return m_total; }
  /// Points before those that a stretch streams. @param stretch  from 1; one more than there are:
  /// all points
  [[nodiscard]] std::size_t before(int stretch) const;
  /// Counters of a stretch, in those of the job.
  [[nodiscard]] Counters inJob(int stretch, const Counters& ofStretch) const;
  /// The job as one run.
  [[nodiscard]] RunReport reportOf(const WholeJobReport& job, const RunSettings& settings,
                                   const std::string& programName) const;

 private:
  /// Points before a stretch, wherever the job went on.
  [[nodiscard]] std::size_t startOf(int stretch) const;

  std::vector<std::uint32_t> m_starts;
  std::size_t m_total;
  int m_resumedIn;
  std::size_t m_resumedAt;
};

}  // namespace rivulet::streaming
