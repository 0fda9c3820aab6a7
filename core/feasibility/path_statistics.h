// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The points of a program as a streaming method sees them: distances, corners, repetitions.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "gcode/trajectory.h"

namespace rivulet::feasibility {

/// Distances of neighbouring points in classes of equal ratio.
struct DistanceHistogram {
  /// counts[i] is for [borders[i], borders[i+1]); the first class begins at the smallest
  /// distance, the last one holds the largest. mm.
  std::vector<double> bordersMm;
  std::vector<std::size_t> counts;
};

struct AngleChanges {
  /// Corners by change of direction: classes of 15 degrees, the last ends at 180.
  std::vector<std::size_t> counts;
  double degreesMax = 0.0;
  base::LineNumber line;  ///< of the block that ends at the sharpest corner
};

struct PathStatistics {
  std::size_t points = 0;
  std::size_t duplicates = 0;  ///< points equal to their predecessor, left out of the stream
  double distanceMmMin = 0.0;
  double distanceMmMedian = 0.0;
  double distanceMmMax = 0.0;
  DistanceHistogram distances;
  AngleChanges angles;
};

/// True if X, Y or Z moves between two of the points: only then there are statistics.
[[nodiscard]] bool hasDistances(const gcode::PointList& list);

/// @param list  at least 2 points
/// @threadsafety pure; O(n log n).
[[nodiscard]] PathStatistics pathStatistics(const gcode::PointList& list);

}  // namespace rivulet::feasibility
