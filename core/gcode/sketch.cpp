// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/sketch.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::gcode {

namespace {

/// Steps at first: a picture of a hand's breadth shows no more.
constexpr double kStepsPerDiagonal = 500.0;

}  // namespace

std::vector<SketchPoint> sketchOf(std::span<const StreamPoint> points, std::size_t pointsMax) {
  RIVULET_ASSERT(pointsMax >= 2);
  if (points.empty()) {
    return {};
  }
  base::Vec3 low = points.front().positionMm;
  base::Vec3 high = low;
  for (const StreamPoint& point : points) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      low.set(axis, std::min(low[axis], point.positionMm[axis]));
      high.set(axis, std::max(high[axis], point.positionMm[axis]));
    }
  }
  const double stepMm = base::distance(low, high) / kStepsPerDiagonal;
  std::vector<SketchPoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isEnd = i == 0 || i + 1 == points.size();
    if (isEnd || base::distance(points[i].positionMm, kept.back().positionMm) >= stepMm) {
      kept.push_back({points[i].positionMm, points[i].kind == MoveKind::Rapid});
    }
  }
  if (kept.size() > pointsMax) {
    std::vector<SketchPoint> fewer(pointsMax);
    for (std::size_t i = 0; i < pointsMax; ++i) {
      fewer[i] = kept[i * (kept.size() - 1) / (pointsMax - 1)];
    }
    return fewer;
  }
  return kept;
}

}  // namespace rivulet::gcode
