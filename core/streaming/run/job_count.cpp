// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/job_count.h"

#include <algorithm>
#include <numeric>

namespace rivulet::streaming {

std::size_t JobCount::startOf(int stretch) const {
  const auto index = static_cast<std::size_t>(std::max(stretch, 1)) - 1;
  return index < m_starts.size() ? m_starts[index] : m_total;
}

std::size_t JobCount::before(int stretch) const {
  return startOf(stretch) + (stretch == m_resumedIn ? m_resumedAt : 0);
}

Counters JobCount::inJob(int stretch, const Counters& ofStretch) const {
  const std::size_t begin = before(stretch);
  const std::size_t size = std::max(begin, startOf(stretch + 1)) - begin;
  return {begin + std::min(ofStretch.sent, size), begin + std::min(ofStretch.accepted, size),
          begin + std::min(ofStretch.executed, size), m_total};
}

RunReport JobCount::reportOf(const WholeJobReport& job, const RunSettings& settings,
                             const std::string& programName) const {
  RunReport report;
  report.outcome = job.outcome;
  report.error = job.error;
  report.programName = programName;
  report.settings = settings;
  report.settings.runNumber = job.runNumber;
  report.counters.total = m_total;
  report.duration = job.times.total();
  for (const StretchReport& stretch : job.stretches) {
    const RunReport& run = stretch.run;
    report.counters = inJob(stretch.number, run.counters);
    report.settings.grouping = run.settings.grouping;
    report.stopConfirmedAfter = run.stopConfirmedAfter;
    report.wrong = report.wrong ? report.wrong : run.wrong;
    report.checkpoint = run.checkpoint;
  }
  report.pauses = job.pauses;
  report.access = job.access;
  report.integrity = job.integrity;
  if (job.outcome == Outcome::Completed) {
    // What the stretches have streamed: a point may repeat the last one before native blocks.
    const std::size_t streamed =
        std::accumulate(job.stretches.begin(), job.stretches.end(), std::size_t{0},
                        [](std::size_t sum, const auto& one) { return sum + one.points.size(); });
    report.counters = {streamed, streamed, job.integrity.judged ? job.integrity.executed : streamed,
                       streamed};
  }
  report.factor = job.factor;
  report.controlTrace = job.controlTrace;
  return report;
}

}  // namespace rivulet::streaming
