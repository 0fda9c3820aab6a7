// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run on one page of paper, in the operator's language: what was executed, where, how, with
/// which result, and a line to sign. @threadsafety GUI thread.
#pragma once

#include <QString>
#include <vector>

#include "gcode/sketch.h"
#include "streaming/run/run_summary.h"
#include "widgets/paper/page.h"

namespace rivulet::widgets {

struct RunSheet {
  streaming::RunSummary summary;
  streaming::RunReport report;
  std::vector<gcode::SketchPoint> sketch;  ///< empty: the path was not kept
  QString appVersion;
};

[[nodiscard]] paper::Page runPage(const RunSheet& sheet);

}  // namespace rivulet::widgets
