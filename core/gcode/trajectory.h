// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a CAM program says the tool is to do: end points in program order, workpiece frame.
/// Everything right of `gcode` sees programs only as a `Trajectory`. @threadsafety plain values.
#pragma once

#include <optional>
#include <vector>

#include "base/id.h"
#include "base/vec3.h"

namespace rivulet::gcode {

enum class MoveKind : unsigned char { Rapid, Feed, ArcPiece };

struct TrajectoryPoint {
  /// End point, workpiece frame, mm. A coordinate is NaN until the program has named its axis:
  /// it means "where the machine stands".
  base::Vec3 positionMm;
  double feedMmPerS = 0.0;  ///< programmed feed; 0 for rapids and where no F was given
  base::LineNumber line;
  MoveKind kind = MoveKind::Feed;
};

struct Trajectory {
  std::vector<TrajectoryPoint> points;
};

/// One point as a streaming method sends it.
struct StreamPoint {
  base::Vec3 positionMm;  ///< finite, workpiece frame
  base::LineNumber line;  ///< where it comes from in the CAM program
};

struct PointList {
  std::vector<StreamPoint> points;
  std::size_t merged = 0;  ///< points left out because they repeat their predecessor exactly
};

/// The points to stream, one after another. Coordinates the program leaves open are taken from
/// `startMm`; a point equal to its predecessor is left out (it would not move an axis).
/// @param startMm  present tool position, workpiece frame, mm; all finite
/// @threadsafety pure; O(points).
[[nodiscard]] PointList streamPoints(const Trajectory& trajectory, base::Vec3 startMm);

}  // namespace rivulet::gcode
