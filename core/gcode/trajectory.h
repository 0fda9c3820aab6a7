// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a CAM program says the tool is to do: end points in program order, workpiece frame.
/// Everything right of `gcode` sees programs only as a `Trajectory`. @threadsafety plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/axes.h"
#include "base/id.h"
#include "base/vec3.h"
#include "nc/modal/vocabulary.h"

namespace rivulet::gcode {

enum class MoveKind : unsigned char {
  Rapid,
  Feed,
  ArcPiece,     ///< a chord of an arc
  SplinePiece,  ///< a chord of a spline
  Arc,          ///< a whole arc, with `LoadOptions::keepArcs` only: see `Trajectory::arcs`
};

struct TrajectoryPoint {
  /// End point, workpiece frame, mm. A coordinate is NaN until the program has named its axis:
  /// it means "where the machine stands".
  base::Vec3 positionMm;
  /// Programmed feed, converted from G93 and G95; deg/s of a move that only turns. 0 for rapids,
  /// and where it is not known.
  double feedMmPerS = 0.0;
  base::LineNumber line;
  MoveKind kind = MoveKind::Feed;
};

/// Where the rotary axes A, B, C stand at a point, degrees; NaN until the program names one.
struct RotaryPosition {
  base::RotaryDeg degrees{std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::quiet_NaN()};
};

/// An arc or helix that was kept as one point.
struct KeptArc {
  std::size_t point = 0;  ///< whose end it is
  base::Vec3 centreMm;    ///< a point on the axis
  base::Vec3 axis;        ///< unit vector; the turn is counterclockwise seen against it
  double sweepRad = 0.0;  ///< > 0; more than a full circle with TURN=
};

/// What the program orders between two points, for the machine and not for the path.
struct PathEvent {
  using Kind = nc::MachineWord;
  std::size_t point = 0;  ///< happens before this point is approached; may be points.size()
  double value = 0.0;
  base::LineNumber line;
  Kind kind = Kind::M;
};

struct Trajectory {
  std::vector<TrajectoryPoint> points;
  /// One per point where the program moves a rotary axis, else empty.
  std::vector<RotaryPosition> rotary;
  /// Direction of the tool at each point (A3= B3= C3=, unit vectors), workpiece frame; else empty.
  std::vector<base::Vec3> toolDirections;
  std::vector<KeptArc> arcs;
  std::vector<PathEvent> events;  ///< in the order of the program
  std::vector<std::string> toolNames;
};

/// One point as a streaming method sends it.
struct StreamPoint {
  base::Vec3 positionMm;           ///< finite, workpiece frame
  base::LineNumber line;           ///< where it comes from in the CAM program
  MoveKind kind = MoveKind::Feed;  ///< of the move that ends here
  base::RotaryDeg rotaryDeg{};     ///< A, B, C; finite
  /// Commanded feed of that move, deg/s if it only turns; 0: that of the run, the same for all
  double feedMmPerS = 0.0;
};

struct ProgramFeeds;  // gcode/feeds.h

struct PointList {
  std::vector<StreamPoint> points;
  std::size_t merged = 0;  ///< points left out because they repeat their predecessor exactly
};

/// The points to stream, one after another. Coordinates and angles the program leaves open are
/// taken from the start; a point equal to its predecessor is left out (it would not move an axis).
/// @param startMm   present tool position, workpiece frame, mm; all finite
/// @param startDeg  where the rotary axes stand; all finite
/// @param feeds  the run takes its feeds from the program; null: they stay 0
/// @param indices  takes the index of each point in the trajectory; null: not wanted
/// @threadsafety pure; O(points).
[[nodiscard]] PointList streamPoints(const Trajectory& trajectory, base::Vec3 startMm,
                                     const base::RotaryDeg& startDeg = {},
                                     const ProgramFeeds* feeds = nullptr,
                                     std::vector<std::uint32_t>* indices = nullptr);

/// Rotary axes the program turns on its path: they stand differently at some points, or are named
/// first when X, Y or Z has moved. An axis that is only set at the beginning is none of them.
[[nodiscard]] base::RotarySet turnedAxes(const Trajectory& trajectory);

}  // namespace rivulet::gcode
