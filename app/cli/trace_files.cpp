// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/trace_files.h"

namespace rivulet::cli {

base::Result<trace::Trace> openTrace(const std::string& file, const AnalyseOptions& options) {
  auto trace = report::openTrace(file, options.columns, options.rateHz, memoryBudget());
  return trace && options.hasWindow() ? trace->cut(options.fromS, options.untilS) : trace;
}

trace::AnalysisOptions analysisOf(const AnalyseOptions& options, const gcode::Program* program) {
  trace::AnalysisOptions analysis;
  analysis.program = program;
  if (options.toleranceMm > 0.0) {
    analysis.toleranceMm = options.toleranceMm;
  }
  return analysis;
}

}  // namespace rivulet::cli
