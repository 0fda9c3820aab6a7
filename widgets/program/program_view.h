// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Everything the page shows of a program, made from it away from the GUI thread: streamed points
/// with their kind and feed, levels of detail, line index, figures. A million points take a
/// second or so; the page then only hands pointers around.
/// @threadsafety immutable once made; `makeProgramView` is pure.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "feasibility/path_statistics.h"
#include "feasibility/verdict.h"
#include "gcode/program.h"
#include "widgets/program/path_levels.h"
#include "widgets/program/text_index.h"

namespace rivulet::widgets {

/// Path lengths by kind of move, mm.
struct KindLengths {
  double rapidMm = 0.0;
  double lineMm = 0.0;
  double arcMm = 0.0;     ///< along the chords
  double splineMm = 0.0;  ///< along the chords
};

struct ProgramView {
  std::shared_ptr<const gcode::Program> program;
  base::Vec3 startMm;
  /// The program leaves coordinates open: its points depend on where the tool stands.
  bool dependsOnStart = false;

  gcode::PointList points;
  base::RotarySet turnedAxes{};  ///< rotary axes the program turns on its path
  /// One per streamed point: the move that ends there.
  std::vector<gcode::MoveKind> kinds;
  std::vector<float> feedsMmPerS;
  std::vector<std::uint32_t> trajectoryIndices;  ///< of the streamed points in the trajectory
  PathLevels levels;

  TextIndex text;
  std::optional<feasibility::PathStatistics> statistics;  ///< of two points or more
  KindLengths lengths;
  std::vector<double> smallestDistancesMm;  ///< ascending, at most 200: what the region shows
  /// d_min and d_min^N for the N asked for; nothing for less than two points.
  std::optional<feasibility::ProgramDistances> distances;
  int distancesFor = 0;  ///< that N

  /// Indices of the streamed points that come from a line, ascending.
  [[nodiscard]] std::vector<std::uint32_t> pointsOfLine(base::LineNumber line) const;

  /// Streamed points in the order of their lines; empty if they are in it anyway.
  std::vector<std::uint32_t> byLine;
};

/// @param startMm        present tool position, all finite
/// @param pointsPerLoop  N of the distances, >= 2
/// @param progress       told the share done, 0 to 1; false: give up
/// @return null if it was given up
[[nodiscard]] std::shared_ptr<const ProgramView> makeProgramView(
    std::shared_ptr<const gcode::Program> program, base::Vec3 startMm, int pointsPerLoop,
    const std::function<bool(double)>& progress = {});

/// How long a run takes: with its feed and its pauses.
struct RunTime {
  double totalS = 0.0;
  double standingS = 0.0;  ///< of it, in pauses
  std::size_t pauses = 0;
  double withoutPausesS = 0.0;  ///< what it would take with the same feed

  /// What the pauses cost: standing, braking and accelerating.
  [[nodiscard]] double pausesCostS() const { return totalS - withoutPausesS; }
};

/// Where a run will pause: streamed points behind which the axes stand, each list ascending. What
/// off the cut means is told in streaming/pause_placement.h.
struct PauseMap {
  std::vector<std::uint32_t> offCut;
  std::vector<std::uint32_t> inCut;

  [[nodiscard]] std::size_t count() const { return offCut.size() + inCut.size(); }
};

/// When the machine passes each streamed point, and how long it takes in all.
struct ProgramTimes {
  std::vector<float> atS;      ///< one per streamed point, without pauses
  double programmedS = 0.0;    ///< with the feeds of the program, without pauses
  std::optional<RunTime> run;  ///< nothing: not known yet
  std::string machine;         ///< whose axes were taken
};

}  // namespace rivulet::widgets
