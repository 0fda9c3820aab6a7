// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One line about a run that has ended, as a list of runs shows it. @threadsafety plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "streaming/run/job_times.h"
#include "streaming/run/run.h"
#include "trace/analysis/tool_use.h"

namespace rivulet::streaming {

struct RunSummary {
  // Given by whoever made the run.
  std::string id;           ///< by which the history knows it; empty: not kept there
  std::string programFile;  ///< absolute path; may be empty
  std::string programHash;  ///< may be empty
  std::string endpoint;
  std::string toolVersion;
  std::string recording;  ///< file; empty: none
  /// The recording was made for the history, which removes it together with the run.
  bool ownsRecording = false;
  std::optional<JobTimes> jobTimes{};  ///< of a whole job; nothing: the motion alone was run
  /// Of a whole job, by the control's trace; empty: it was not kept, or the machine told nothing.
  std::vector<trace::ToolUse> tools{};
  double dryRunMm = 0.0;  ///< > 0: it was a dry run, so much higher

  // Taken from its report.
  std::string programName;
  RunOrigin origin;  ///< who, where and when
  base::MethodKind method = base::kDefaultMethod;
  int pointsPerLoop = 0;
  double feedMmPerS = 0.0;
  /// The feeds of the program scaled by this; nothing: `feedMmPerS` for every move.
  std::optional<double> overrideFactor;
  double deltaMm = 0.0;
  int runNumber = 0;  ///< by which the control knew it; 0: it had none
  Outcome outcome = Outcome::Failed;
  RunFinding finding = RunFinding::Faulty;
  bool judged = false;       ///< `executed` to `outOfOrder` are from the trace of the control
  std::size_t executed = 0;  ///< points
  std::size_t total = 0;
  std::size_t repeated = 0;
  std::size_t skipped = 0;
  std::size_t foreign = 0;
  std::size_t outOfOrder = 0;
  base::Duration duration{};
  std::size_t pauses = 0;
  base::Duration paused{};
};

/// @param known  its first part is kept, the second is taken from the report
[[nodiscard]] RunSummary summaryOf(const RunReport& report, RunSummary known);

}  // namespace rivulet::streaming
