// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads the result of a run from JSON: what the history keeps, and what `stream --json` printed,
/// also in earlier versions. @threadsafety pure, unless it is said to read a file.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/result.h"
#include "gcode/sketch.h"
#include "streaming/run/run_summary.h"

namespace rivulet::report {

enum class ReportError {
  NotAReport = 1,  ///< another kind of file
  NewerVersion,    ///< written by a later version of Rivulet
  Damaged,         ///< a member is missing or cannot be right
};

[[nodiscard]] std::error_code make_error_code(ReportError code);

/// A run that has ended, as far as it is kept: without the trace of the control, which is in the
/// recording.
struct FinishedRun {
  streaming::RunSummary summary;
  streaming::RunReport report;
  std::vector<gcode::SketchPoint> sketch;  ///< the path; empty: not kept
};

[[nodiscard]] nlohmann::ordered_json finishedRunJson(const FinishedRun& run);
/// @param file  for the error
/// @return ReportError; members that earlier versions did not write keep their defaults
[[nodiscard]] base::Result<FinishedRun> finishedRunOf(const nlohmann::json& json,
                                                      const std::filesystem::path& file);
/// Reads the file. @return also Unreadable
[[nodiscard]] base::Result<FinishedRun> readFinishedRun(const std::filesystem::path& file);

[[nodiscard]] nlohmann::ordered_json summaryJson(const streaming::RunSummary& summary);
/// @return as `finishedRunOf`
[[nodiscard]] base::Result<streaming::RunSummary> summaryOf(const nlohmann::json& json,
                                                            const std::filesystem::path& file);

}  // namespace rivulet::report

template <>
struct std::is_error_code_enum<rivulet::report::ReportError> : std::true_type {};
