// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/rs274/rivulet_reading.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "gcode/interpreter.h"

namespace rivulet::tests {

namespace {

MoveForm formOf(gcode::MoveKind kind) {
  switch (kind) {
    case gcode::MoveKind::Rapid:
      return MoveForm::Rapid;
    case gcode::MoveKind::SplinePiece:
      return MoveForm::Spline;
    case gcode::MoveKind::Arc:
      return MoveForm::Arc;
    case gcode::MoveKind::Feed:
    case gcode::MoveKind::ArcPiece:
      break;
  }
  return MoveForm::Feed;
}

std::vector<ReadMove> movesOf(const gcode::Trajectory& trajectory) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<ReadMove> moves;
  auto arc = trajectory.arcs.begin();
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const gcode::TrajectoryPoint& point = trajectory.points[i];
    ReadMove move;
    move.form = formOf(point.kind);
    move.endMm = point.positionMm;
    move.rotaryDeg = trajectory.rotary.empty() ? base::RotaryDeg{kNaN, kNaN, kNaN}
                                               : trajectory.rotary[i].degrees;
    move.feedPerMin = point.feedMmPerS * 60.0;
    if (arc != trajectory.arcs.end() && arc->point == i) {
      move.centreMm = arc->centreMm;
      move.axis = arc->axis;
      move.sweepRad = arc->sweepRad;
      ++arc;
    }
    // A curve is one move, however many chords it has.
    if (move.form == MoveForm::Spline && !moves.empty() && moves.back().form == MoveForm::Spline) {
      moves.pop_back();
    }
    moves.push_back(move);
  }
  return moves;
}

}  // namespace

PathReading readAsRivulet(std::string_view text) {
  gcode::LoadOptions options;
  options.keepArcs = true;
  options.dialect = gcode::Dialect::LinuxCnc;
  options.units = gcode::FileUnits::Millimetres;  // as `rs274` begins
  options.repeatedLinesMax = 20'000;
  const gcode::Interpretation read = gcode::interpret(text, options);
  PathReading reading;
  const auto error = std::find_if(
      read.diagnostics.begin(), read.diagnostics.end(),
      [](const gcode::Diagnostic& each) {
        // Without a feed a program runs with a fixed one alone, and not before what is asked has
        // an answer.
        return each.severity == gcode::Severity::Error ||
               each.code == gcode::DiagnosticCode::FeedMissing ||
               each.code == gcode::DiagnosticCode::ControlSettingOpen;
      });
  reading.accepted = error == read.diagnostics.end();
  if (!reading.accepted) {
    reading.refusal = describe(*error);
    reading.word = std::string(gcode::diagnosticName(error->code));
    const bool isWord = error->code == gcode::DiagnosticCode::UnsupportedGCode ||
                        error->code == gcode::DiagnosticCode::UnknownGCode ||
                        error->code == gcode::DiagnosticCode::CycleNotRun ||
                        error->code == gcode::DiagnosticCode::MachineCoordinates;
    const std::string& word = error->argument;
    reading.word += word.empty() ? "" : " " + (isWord ? word : word.substr(0, 1));
  }
  reading.moves = movesOf(read.trajectory);
  return reading;
}

}  // namespace rivulet::tests
