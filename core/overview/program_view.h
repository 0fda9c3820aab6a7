// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Everything the page shows of a program, computed outside the GUI thread: streamed points with
/// their kind and feed, levels of detail, line index, figures. A million points take about a
/// second; after that the page only passes pointers.
/// @threadsafety immutable once made; `makeProgramView` is pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "feasibility/path_statistics.h"
#include "feasibility/verdict.h"
#include "gcode/feeds.h"
#include "gcode/program.h"
#include "job/plan.h"
#include "overview/job_outline.h"
#include "overview/path_levels.h"
#include "overview/text_index.h"

namespace rivulet::overview {

/// A pass over so many points takes some milliseconds: the GUI thread may make it.
inline constexpr std::size_t kPointsAtOnce = 50'000;

/// Path lengths by kind of move, mm.
struct KindLengths {
  double rapidMm = 0.0;
  double lineMm = 0.0;
  double arcMm = 0.0;     ///< along the chords
  double splineMm = 0.0;  ///< along the chords
};

struct DrawnClasses;

struct ProgramView {
  std::shared_ptr<const gcode::Program> program;
  /// The program as a job; null: it was not split. If `program` is not that of the plan, all motion
  /// of the program is streamed and native blocks are left out; the plan then has no program.
  std::shared_ptr<const job::Plan> plan;
  JobOutline outline;  ///< of the plan

  /// `program` has the stretches of a job alone.
  [[nodiscard]] bool isJob() const { return plan && program.get() == &plan->program; }
  base::Vec3 startMm;
  /// The program leaves coordinates open: its points depend on the tool's position.
  bool dependsOnStart = false;

  /// With the feeds of the program at 100 %, within the limits of `feeds`.
  gcode::PointList points;
  std::optional<gcode::ProgramFeeds> feeds;         ///< at 100 %; nothing: the points have no feeds
  double fastestMmPerS = 0.0;                       ///< largest of those feeds
  std::optional<base::LineNumber> lineWithoutFeed;  ///< see `gcode::lineWithoutFeed`
  /// Least and largest feed that the program gives its cutting moves, mm/s; nothing: it names none.
  std::optional<std::pair<double, double>> cuttingMmPerS;
  base::RotarySet turnedAxes{};  ///< rotary axes that the program moves on its path
  /// Feed as programmed, of the move that ends at a streamed point.
  [[nodiscard]] float programmedMmPerS(std::size_t point) const {
    return static_cast<float>(program->trajectory.points[trajectoryIndices[point]].feedMmPerS);
  }
  std::vector<std::uint32_t> trajectoryIndices;  ///< of the streamed points in the trajectory
  PathLevels levels;
  std::shared_ptr<const DrawnClasses> kinds;  ///< of the moves (`overview/path_classes.h`)

  /// A move to a streamed point that does not begin where the point before it is: the control moves
  /// in between. The path to the point begins at `fromMm`.
  struct Gap {
    std::uint32_t point = 0;
    base::Vec3 fromMm;  ///< NaN: only the control knows
    [[nodiscard]] bool isKnown() const { return base::isFinite(fromMm); }
  };
  std::vector<Gap> gaps;  ///< of a job, ascending
  /// Streamed points at which the stretches of a job begin, ascending; as many as there are.
  std::vector<std::uint32_t> stretchStarts;
  struct ToolChange {
    std::uint32_t point = 0;  ///< the first with the tool
    std::string tool;
  };
  std::vector<ToolChange> toolChanges;  ///< of a job, ascending

  TextIndex text;
  std::optional<feasibility::PathStatistics> statistics;  ///< of two points or more
  KindLengths lengths;
  std::vector<double> smallestDistancesMm;  ///< ascending, at most 200: shown in the region
  /// The same as long as the largest feed goes in the time of each move.
  std::vector<double> smallestTimedMm;
  /// d_min and d_min^N for the requested N; nothing for fewer than two points.
  std::optional<feasibility::ProgramDistances> distances;
  /// The same as long as the largest feed goes in the time of each move.
  std::optional<feasibility::ProgramDistances> timedDistances;
  int distancesFor = 0;  ///< that N

  /// Indices of the streamed points that come from a line, ascending.
  [[nodiscard]] std::vector<std::uint32_t> pointsOfLine(base::LineNumber line) const;

  /// Streamed points in the order of their lines; empty if they are in it anyway.
  std::vector<std::uint32_t> byLine;
};

/// @param startMm        present tool position, all finite
/// @param pointsPerLoop  N of the distances, >= 2
/// @param progress  called with the share done, 0 to 1; false: cancel
/// @param feeds  limits of the feeds of the program, at 100 %; nothing: its feeds are not used
/// @param plan  see `ProgramView::plan`
/// @return null if it was cancelled
[[nodiscard]] std::shared_ptr<const ProgramView> makeProgramView(
    std::shared_ptr<const gcode::Program> program, base::Vec3 startMm, int pointsPerLoop,
    const std::function<bool(double)>& progress = {},
    const std::optional<gcode::ProgramFeeds>& feeds = {},
    std::shared_ptr<const job::Plan> plan = {});

/// How long a run takes: with its feed and its pauses.
struct RunTime {
  std::vector<float> atS;  ///< when the run passes each streamed point, with its pauses
  double totalS = 0.0;
  double standingS = 0.0;  ///< part of it that is standstill in pauses
  std::size_t pauses = 0;
  double withoutPausesS = 0.0;  ///< time with the same feed and no pauses

  /// Cost of the pauses: standstill, braking and acceleration.
  [[nodiscard]] double pausesCostS() const { return totalS - withoutPausesS; }
};

/// Where a run will pause: streamed points after which the axes stop, each list ascending.
/// streaming/pause_placement.h defines "off the cut".
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
  std::string machine;         ///< whose axes were used
};

}  // namespace rivulet::overview
