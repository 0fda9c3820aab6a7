// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/trace_files.h"

namespace rivulet::cli {

base::Result<report::TraceSource> openTrace(const std::string& file,
                                            const AnalyseOptions& options) {
  auto source = report::openTrace(file, options.columns, options.rateHz);
  if (source && options.hasWindow()) {
    source->cut(options.fromS, options.untilS);
  }
  return source;
}

trace::TraceSubject subjectOf(const report::TraceSource& source, const AnalyseOptions& options,
                              const gcode::Program* program) {
  trace::TraceSubject subject = source.subject();
  subject.program = program;
  if (options.toleranceMm > 0.0) {
    subject.toleranceMm = options.toleranceMm;
  }
  return subject;
}

}  // namespace rivulet::cli
