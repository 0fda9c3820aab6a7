// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The analysis of one trace as a page for a person: what ran, where, with which result, path and
/// speed as pictures, the longest stops. @threadsafety GUI thread.
#pragma once

#include <optional>
#include <string>

#include "report/stream_quality.h"
#include "streaming/run/run.h"
#include "trace/analysis/trace_analysis.h"
#include "widgets/paper/page.h"

namespace rivulet::trace_report {

/// What is known of the trace besides its analysis.
struct TraceFacts {
  const trace::TraceAnalysis* analysis = nullptr;              ///< never null
  const trace::Recording* recording = nullptr;                 ///< null: a trace of another kind
  const report::StreamQuality* stream = nullptr;               ///< null: nothing was streamed
  streaming::Outcome outcome = streaming::Outcome::Completed;  ///< of a recording
  streaming::RunFinding finding = streaming::RunFinding::NotJudged;
  std::string format;       ///< of a trace of another kind
  std::string file;         ///< name of the trace
  std::string fileHash;     ///< SHA-256
  std::string programFile;  ///< the trace was compared with it; may be empty
  std::string appVersion;
};

/// In the language of the application.
[[nodiscard]] paper::Page tracePage(const TraceFacts& facts);

}  // namespace rivulet::trace_report
