// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Everything that is said of one trace: the same figures for command line, HMI and tests.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "gcode/program.h"
#include "trace/analysis/integrity.h"
#include "trace/analysis/motion_quality.h"
#include "trace/analysis/path_match.h"
#include "trace/analysis/standstills.h"
#include "trace/motion.h"
#include "trace/trace.h"

namespace rivulet::trace {

struct AnalysisOptions {
  const gcode::Program* program = nullptr;  ///< null: none, or that of the recording
  double toleranceMm = 0.05;                ///< `PathMatchOptions`
};

struct TraceAnalysis {
  Motion motion;
  std::vector<Standstill> stops;  ///< with their causes
  Integrity blocks;               ///< judged from the blocks that the control executed
  PathMatch path;                 ///< judged from the positions
  std::shared_ptr<const ProgramPath> programPath;  ///< null: no program
  MotionQuality quality;
};

/// What the axes did; the same that the analysis is about.
[[nodiscard]] Motion motionOf(const Trace& trace);

[[nodiscard]] TraceAnalysis analyseTrace(const Trace& trace, const AnalysisOptions& options = {});

}  // namespace rivulet::trace
