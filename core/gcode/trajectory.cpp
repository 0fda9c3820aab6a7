// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/trajectory.h"

#include "base/contract.h"

namespace rivulet::gcode {

PointList streamPoints(const Trajectory& trajectory, base::Vec3 startMm) {
  RIVULET_ASSERT(base::isFinite(startMm));
  PointList list;
  list.points.reserve(trajectory.points.size());
  for (const TrajectoryPoint& point : trajectory.points) {
    base::Vec3 positionMm = point.positionMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (std::isnan(positionMm[axis])) {
        positionMm.set(axis, startMm[axis]);
      }
    }
    if (!list.points.empty() && list.points.back().positionMm == positionMm) {
      ++list.merged;
      continue;
    }
    list.points.push_back({positionMm, point.line, point.kind});
  }
  return list;
}

}  // namespace rivulet::gcode
