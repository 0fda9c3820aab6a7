// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/run_summary.h"

namespace rivulet::streaming {

RunSummary summaryOf(const RunReport& report, RunSummary known) {
  known.programName = report.programName;
  known.origin = report.settings.origin;
  known.method = report.settings.parameters.method;
  known.pointsPerLoop = report.settings.parameters.pointsPerLoop;
  known.feedMmPerS = report.settings.feedMmPerS;
  known.overrideFactor.reset();
  if (const auto& feeds = report.settings.programFeeds) {
    known.overrideFactor = feeds->overrideFactor;
  }
  known.deltaMm = report.settings.deltaMm;
  known.runNumber = report.checkpoint ? report.checkpoint->runNumber : report.settings.runNumber;
  known.outcome = report.outcome;
  known.finding = report.finding();
  known.judged = report.integrity.judged;
  known.executed = known.judged ? report.integrity.executed : report.counters.executed;
  known.total = report.counters.total;
  known.repeated = report.integrity.repeated;
  known.skipped = report.integrity.skipped;
  known.foreign = report.integrity.foreign;
  known.outOfOrder = report.integrity.outOfOrder;
  known.duration = report.duration;
  known.pauses = report.pauses.size();
  known.paused = {};
  for (const trace::Pause& pause : report.pauses) {
    known.paused += pause.duration;
  }
  return known;
}

}  // namespace rivulet::streaming
