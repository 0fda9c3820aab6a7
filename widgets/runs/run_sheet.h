// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run on one page of paper, in the operator's language: what was executed, where, how, with
/// which result, and a line to sign. @threadsafety GUI thread.
#pragma once

#include <QRectF>
#include <QString>
#include <vector>

#include "gcode/sketch.h"
#include "streaming/run_summary.h"

class QPainter;

namespace rivulet::widgets {

struct RunSheet {
  streaming::RunSummary summary;
  streaming::RunReport report;
  std::vector<gcode::SketchPoint> sketch;  ///< empty: the path was not kept
  QString appVersion;
};

/// @param page  in the painter's units, the margins excluded
/// @param millimetre  in the same units
void paintRunSheet(QPainter& painter, const QRectF& page, double millimetre, const RunSheet& sheet);

/// Writes an A4 page. @return false: the file cannot be written
[[nodiscard]] bool writeRunSheet(const QString& path, const RunSheet& sheet);

}  // namespace rivulet::widgets
