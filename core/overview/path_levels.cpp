// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overview/path_levels.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::overview {

namespace {

using Points = std::vector<gcode::StreamPoint>;
using Kept = std::vector<std::uint32_t>;

constexpr double kFinestToleranceMm = 0.0005;  // below, zooming in shows the points themselves
constexpr std::size_t kCoarseEnough = 2000;    // points of the last level
constexpr std::size_t kRunMax = 16;            // moves that one move may replace in one step
constexpr double kShrinksEnough = 0.8;         // a level that keeps more is not worth its memory

/// Leaves points out that stay within `toleranceMm` of the line that replaces them.
Kept simplified(const Points& points, const Kept& kept, double toleranceMm,
                const std::vector<bool>* isRapid) {
  Kept result{kept.front()};
  std::size_t from = 0;
  const auto at = [&](std::size_t i) { return points[kept[i]].positionMm; };
  const auto fits = [&](std::size_t to) {
    for (std::size_t i = from + 1; i < to; ++i) {
      if (base::distanceToSegment(at(i), at(from), at(to)) > toleranceMm) {
        return false;
      }
    }
    return true;
  };
  // At such a point the kind of move changes: a level without it would colour one as the other.
  const auto mustStay = [&](std::size_t i) {
    return isRapid != nullptr && (*isRapid)[kept[i]] != (*isRapid)[kept[i] + 1];
  };
  while (from + 1 < kept.size()) {
    std::size_t to = from + 1;
    while (to + 1 < kept.size() && to + 1 - from <= kRunMax && !mustStay(to) && fits(to + 1)) {
      ++to;
    }
    result.push_back(kept[to]);
    from = to;
  }
  return result;
}

SpaceBox boxOf(const base::Vec3& positionMm) {
  SpaceBox box;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    box.low[axis] = box.high[axis] = static_cast<float>(positionMm[axis]);
  }
  return box;
}

void widen(SpaceBox& box, const SpaceBox& by) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    box.low[axis] = std::min(box.low[axis], by.low[axis]);
    box.high[axis] = std::max(box.high[axis], by.high[axis]);
  }
}

void makeBoxes(PathLevel& level, const Points& points) {
  const std::size_t moves = level.kept.size() - 1;
  const auto box = [&](std::size_t i) { return boxOf(points[level.kept[i]].positionMm); };
  for (std::size_t first = 0; first == 0 || first < moves; first += kChunkMoves) {
    SpaceBox chunk = box(first);
    for (std::size_t i = first + 1; i <= std::min(first + kChunkMoves, moves); ++i) {
      widen(chunk, box(i));
    }
    level.boxes.push_back(chunk);
  }
}

}  // namespace

PathLevels::PathLevels(const Points& points, const std::vector<bool>& isRapid,
                       const std::function<bool()>& goOn) {
  RIVULET_ASSERT(points.size() == isRapid.size());
  if (points.empty()) {
    return;
  }
  PathLevel finest;
  finest.kept.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    finest.kept[i] = static_cast<std::uint32_t>(i);
  }
  makeBoxes(finest, points);
  m_box = finest.boxes.front();
  for (const SpaceBox& box : finest.boxes) {
    widen(m_box, box);
  }
  m_levels.push_back(std::move(finest));

  // No point is farther from another than this.
  double sizeMm = 0.0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    sizeMm += m_box.high[axis] - m_box.low[axis];
  }
  bool keepsKinds = true;
  for (double toleranceMm = kFinestToleranceMm; m_levels.back().kept.size() > kCoarseEnough;
       toleranceMm *= 2.0) {
    if (goOn && !goOn()) {
      return;
    }
    const Kept& before = m_levels.back().kept;
    PathLevel level;
    level.toleranceMm = toleranceMm;
    level.kept = simplified(points, before, 0.5 * toleranceMm, keepsKinds ? &isRapid : nullptr);
    if (static_cast<double>(level.kept.size()) <
        kShrinksEnough * static_cast<double>(before.size())) {
      level.kept.shrink_to_fit();
      makeBoxes(level, points);
      m_levels.push_back(std::move(level));
    } else if (toleranceMm > 2.0 * sizeMm) {
      if (!keepsKinds) {
        return;
      }
      keepsKinds = false;  // nothing but changes of kind is left: let them go
    }
  }
}

}  // namespace rivulet::overview
