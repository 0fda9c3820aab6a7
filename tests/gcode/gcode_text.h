// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Prints trajectories and findings as short text, so that a test reads like a listing.
#pragma once

#include <cmath>
#include <string>

#include "base/text.h"
#include "base/units.h"
#include "gcode/interpreter.h"

namespace rivulet::test {

/// "1 R X0 Y0 Z10 | 2 L X5 Y0 Z10 F600": line, kind (Rapid, Line, Arc piece), position, feed in
/// mm/min; "?" is a coordinate the program never named. Six decimals.
inline std::string printPoints(const gcode::Trajectory& trajectory) {
  std::string text;
  for (const gcode::TrajectoryPoint& point : trajectory.points) {
    text += text.empty() ? "" : " | ";
    text += std::to_string(point.line.value);
    text += point.kind == gcode::MoveKind::Rapid  ? " R"
            : point.kind == gcode::MoveKind::Feed ? " L"
                                                  : " A";
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double value = point.positionMm[axis];
      text += std::string(" ") + base::kAxisNames[axis] +
              (std::isnan(value) ? "?" : base::formatFixed(value, 6));
    }
    if (point.feedMmPerS > 0.0) {
      text += " F" + base::formatFixed(base::mmPerMinFromMmPerS(point.feedMmPerS), 6);
    }
  }
  return text;
}

/// "3:7 error unknown-word A10 | …", without what is said of every text that does not begin with
/// G21: those of the tests are short.
inline std::string printFindings(const std::vector<gcode::Diagnostic>& diagnostics) {
  std::string text;
  for (const gcode::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.code == gcode::DiagnosticCode::UnitsNotSaid) {
      continue;
    }
    text += text.empty() ? "" : " | ";
    text += std::to_string(diagnostic.line.value) + ":" + std::to_string(diagnostic.column) + " " +
            std::string(gcode::severityName(diagnostic.severity)) + " " +
            std::string(gcode::diagnosticName(diagnostic.code));
    const std::string parameter = gcode::parameterOf(diagnostic);
    text += parameter.empty() ? "" : " " + parameter;
  }
  return text;
}

/// The findings that are warnings or errors.
inline std::string printProblems(const std::vector<gcode::Diagnostic>& diagnostics) {
  std::vector<gcode::Diagnostic> problems;
  for (const gcode::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != gcode::Severity::Note) {
      problems.push_back(diagnostic);
    }
  }
  return printFindings(problems);
}

}  // namespace rivulet::test
