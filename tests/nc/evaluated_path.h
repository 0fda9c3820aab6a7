// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

/// What the second evaluator makes of a program, beside another path.

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "gcode/trajectory.h"
#include "nc/second_evaluator.h"

namespace rivulet::tests {

/// True if a subprogram of that name, in upper case, "100" for O100, is looked for in the file.
inline bool isFileOf(std::string_view file, std::string_view name) {
  const std::string stem = base::toUpper(file.substr(0, file.find('.')));
  return stem == name || stem == "O" + std::string(name) || stem == "O<" + std::string(name) + ">";
}

/// Of the files in the collection of programs of others.
inline bool isProgram(std::string_view path) {
  return path.find("/oracle/") == path.npos && path.find("LICENSE") == path.npos &&
         !path.ends_with(".md") && !path.ends_with(".tsv") && !path.ends_with(".gz");
}

inline base::Vec3 placeOf(const EvaluatedMove& move) {
  return {move.end[0], move.end[1], move.end[2]};
}

/// Moves that go nowhere are none.
inline std::vector<EvaluatedMove> withoutRests(const std::vector<EvaluatedMove>& moves) {
  std::vector<EvaluatedMove> kept;
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= 1e-9 || (std::isnan(a) && std::isnan(b));
  };
  for (const EvaluatedMove& move : moves) {
    bool rests = !kept.empty() && move.kind != EvaluatedMove::Kind::Arc;
    for (std::size_t axis = 0; rests && axis < move.end.size(); ++axis) {
      rests = same(move.end[axis], kept.back().end[axis]);
    }
    if (!rests) {
      kept.push_back(move);
    }
  }
  return kept;
}

/// A trajectory with whole arcs, in the same form. The program names a feed where `feed` is not 0.
inline std::vector<EvaluatedMove> movesOf(const gcode::Trajectory& trajectory) {
  std::vector<EvaluatedMove> moves;
  auto arc = trajectory.arcs.begin();
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const gcode::TrajectoryPoint& point = trajectory.points[i];
    // The chords of a spiral are one arc, of which nothing more is compared.
    const bool isPiece = point.kind == gcode::MoveKind::ArcPiece;
    const bool goesOn = isPiece && !moves.empty() && moves.back().line == point.line.value &&
                        std::isnan(moves.back().sweepDeg);
    EvaluatedMove move;
    move.kind = point.kind == gcode::MoveKind::Rapid            ? EvaluatedMove::Kind::Rapid
                : isPiece || point.kind == gcode::MoveKind::Arc ? EvaluatedMove::Kind::Arc
                                                                : EvaluatedMove::Kind::Line;
    move.sweepDeg = isPiece ? std::nan("") : 0.0;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      move.end[axis] = point.positionMm[axis];
      move.end[axis + base::kAxisCount] =
          trajectory.rotary.empty() ? std::nan("") : trajectory.rotary[i].degrees[axis];
    }
    for (; arc != trajectory.arcs.end() && arc->point <= i; ++arc) {
      move.centre = arc->centreMm;
      move.axis = arc->axis;
      move.sweepDeg = arc->sweepRad * 180.0 / std::acos(-1.0);
    }
    move.feed = point.feedMmPerS * 60.0;
    move.line = point.line.value;
    if (goesOn) {
      moves.pop_back();
    }
    moves.push_back(move);
  }
  return moves;
}

/// @return the first difference, ""; none
inline std::string differenceOf(const std::vector<EvaluatedMove>& evaluated,
                                const std::vector<EvaluatedMove>& read, double toleranceMm) {
  const std::vector<EvaluatedMove> expected = withoutRests(evaluated);
  const std::vector<EvaluatedMove> got = withoutRests(read);
  const auto differs = [](double a, double b, double tolerance) {
    return std::isnan(a) != std::isnan(b) || std::abs(a - b) > tolerance;
  };
  for (std::size_t i = 0; i < std::min(expected.size(), got.size()); ++i) {
    const EvaluatedMove& a = expected[i];
    const EvaluatedMove& b = got[i];
    const std::string where =
        "line " + std::to_string(a.line) + " (read: " + std::to_string(b.line) + "): ";
    for (std::size_t axis = 0; axis < a.end.size(); ++axis) {
      if (differs(a.end[axis], b.end[axis], toleranceMm)) {
        return where + "XYZABC"[axis] + base::formatFixed(a.end[axis], 9) + ", read " +
               base::formatFixed(b.end[axis], 9);
      }
    }
    if (a.kind != b.kind) {
      return where + "another kind of move";
    }
    if (a.kind == EvaluatedMove::Kind::Arc && !std::isnan(b.sweepDeg)) {
      const base::Vec3 apart = b.centre - a.centre;
      const double off = base::norm(apart - base::dot(apart, a.axis) * a.axis);
      const double share = a.mismatch / std::max(1e-3, base::distance(a.centre, placeOf(a)));
      if (off > 10.0 * toleranceMm + 2.0 * a.mismatch || base::norm(a.axis - b.axis) > 1e-9 ||
          std::abs(a.sweepDeg - b.sweepDeg) > 1e-6 + 120.0 * share) {
        return where + "turns by " + base::formatFixed(a.sweepDeg, 6) + ", read " +
               base::formatFixed(b.sweepDeg, 6) + ", centre " + base::formatFixed(off, 9) +
               " apart";
      }
    }
    if (a.kind != EvaluatedMove::Kind::Rapid && std::abs(a.feed - b.feed) > 1e-9 * (1.0 + a.feed)) {
      return where + "F" + base::formatNumber(a.feed) + ", read " + base::formatNumber(b.feed);
    }
  }
  return expected.size() == got.size()
             ? std::string()
             : std::to_string(expected.size()) + " moves, read " + std::to_string(got.size());
}

}  // namespace rivulet::tests
