// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/trajectory.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "gcode/feeds.h"
#include "gcode/named_start.h"

namespace rivulet::gcode {

namespace {

/// Axes at rest tremble: an axis this near to a place stands there.
constexpr double kTremblingMm = 0.005;

}  // namespace

base::Vec3 namedStart(const Trajectory& trajectory, base::Vec3 startMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const auto named = std::find_if(
        trajectory.points.begin(), trajectory.points.end(),
        [axis](const TrajectoryPoint& point) { return !std::isnan(point.positionMm[axis]); });
    if (named != trajectory.points.end() &&
        std::abs(named->positionMm[axis] - startMm[axis]) <= kTremblingMm) {
      startMm.set(axis, named->positionMm[axis]);
    }
  }
  return startMm;
}

base::Vec3 placeOf(const TrajectoryPoint& point, base::Vec3 beforeMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!std::isnan(point.positionMm[axis])) {
      beforeMm.set(axis, point.positionMm[axis]);
    }
  }
  return beforeMm;
}

PointList streamPoints(const Trajectory& trajectory, base::Vec3 startMm,
                       const base::RotaryDeg& startDeg, const ProgramFeeds* feeds,
                       std::vector<std::uint32_t>* indices) {
  RIVULET_ASSERT(base::isFinite(startMm));
  startMm = namedStart(trajectory, startMm);
  PointList list;
  list.points.reserve(trajectory.points.size());
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const TrajectoryPoint& point = trajectory.points[i];
    const base::Vec3 positionMm =
        placeOf(point, list.points.empty() ? startMm : list.points.back().positionMm);
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
    if (indices != nullptr) {
      indices->push_back(static_cast<std::uint32_t>(i));
    }
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
