// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/trajectory.h"

#include "base/contract.h"
#include "gcode/feeds.h"

namespace rivulet::gcode {

PointList streamPoints(const Trajectory& trajectory, base::Vec3 startMm,
                       const base::RotaryDeg& startDeg, const ProgramFeeds* feeds) {
  RIVULET_ASSERT(base::isFinite(startMm));
  PointList list;
  list.points.reserve(trajectory.points.size());
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const TrajectoryPoint& point = trajectory.points[i];
    base::Vec3 positionMm = point.positionMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (std::isnan(positionMm[axis])) {
        positionMm.set(axis, startMm[axis]);
      }
    }
    base::RotaryDeg rotaryDeg = startDeg;
    for (std::size_t axis = 0; !trajectory.rotary.empty() && axis < base::kRotaryAxisCount;
         ++axis) {
      const double programmed = trajectory.rotary[i].degrees[axis];
      rotaryDeg[axis] = std::isnan(programmed) ? startDeg[axis] : programmed;
    }
    if (!list.points.empty() && list.points.back().positionMm == positionMm &&
        list.points.back().rotaryDeg == rotaryDeg) {
      ++list.merged;
      continue;
    }
    list.points.push_back({positionMm, point.line, point.kind, rotaryDeg,
                           feeds != nullptr ? commandedMmPerS(point, *feeds) : 0.0});
  }
  return list;
}

base::RotarySet turnedAxes(const Trajectory& trajectory) {
  base::RotarySet turned{};
  base::RotaryDeg first = RotaryPosition{}.degrees;
  bool begun =
      false;  // X, Y or Z has moved: where an axis named first stood till then is not known
  for (std::size_t i = 0; i < trajectory.rotary.size(); ++i) {
    const base::RotaryDeg& at = trajectory.rotary[i].degrees;
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (std::isnan(at[axis])) {
        continue;
      }
      turned[axis] = turned[axis] || (std::isnan(first[axis]) ? begun : at[axis] != first[axis]);
      first[axis] = std::isnan(first[axis]) ? at[axis] : first[axis];
    }
    const base::Vec3 mm = trajectory.points[i].positionMm;
    begun = begun || !std::isnan(mm.x) || !std::isnan(mm.y) || !std::isnan(mm.z);
  }
  return turned;
}

}  // namespace rivulet::gcode
