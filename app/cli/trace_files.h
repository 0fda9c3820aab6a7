// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Traces as the options of `analyse` want them. @threadsafety reads files; shares nothing.
#pragma once

#include <string>

#include "base/result.h"
#include "cli/commands.h"
#include "report/trace_source.h"
#include "trace/analysis/trace_analysis.h"

namespace rivulet::cli {

/// The trace of a file, or the part of it that is asked for.
[[nodiscard]] base::Result<trace::Trace> openTrace(const std::string& file,
                                                   const AnalyseOptions& options);

/// @param program  null: the trace is not compared with one
[[nodiscard]] trace::AnalysisOptions analysisOf(const AnalyseOptions& options,
                                                const gcode::Program* program);

}  // namespace rivulet::cli
