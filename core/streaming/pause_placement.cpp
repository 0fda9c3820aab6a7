// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/pause_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/contract.h"

namespace rivulet::streaming {

namespace {

bool turns(base::Vec3 before, base::Vec3 at, base::Vec3 after) {
  const base::Vec3 in = at - before;
  const base::Vec3 out = after - at;
  const double cosine = std::cos(kCornerDegrees * std::numbers::pi / 180.0);
  return base::dot(in, out) <= cosine * base::norm(in) * base::norm(out);
}

}  // namespace

std::vector<bool> harmlessPauses(std::span<const gcode::StreamPoint> points) {
  std::vector<bool> harmless(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isLast = i + 1 == points.size();
    harmless[i] =
        isLast || points[i].kind == gcode::MoveKind::Rapid ||
        points[i + 1].kind == gcode::MoveKind::Rapid ||
        (i > 0 && turns(points[i - 1].positionMm, points[i].positionMm, points[i + 1].positionMm));
  }
  return harmless;
}

PausePlacement placePauses(std::span<const gcode::StreamPoint> points,
                           std::size_t pointsPerWindow) {
  RIVULET_ASSERT(!points.empty() && pointsPerWindow >= 1);
  const std::vector<bool> harmless = harmlessPauses(points);
  struct Best {
    std::size_t inCut = 0;
    std::size_t windows = 0;
    std::size_t begin = 0;  ///< of the last window
  };
  // best[n]: of the first n points, cut behind the last of them.
  std::vector<Best> best(points.size() + 1);
  for (std::size_t end = 1; end <= points.size(); ++end) {
    Best chosen{std::numeric_limits<std::size_t>::max(), 0, 0};
    const std::size_t first = end > pointsPerWindow ? end - pointsPerWindow : 0;
    for (std::size_t begin = first; begin < end; ++begin) {
      const Best& before = best[begin];
      if (std::pair(before.inCut, before.windows) < std::pair(chosen.inCut, chosen.windows)) {
        chosen = {before.inCut, before.windows, begin};
      }
    }
    best[end] = {chosen.inCut + (harmless[end - 1] ? 0U : 1U), chosen.windows + 1, chosen.begin};
  }
  PausePlacement placement;
  placement.inCut = best.back().inCut;
  for (std::size_t end = points.size(); end > 0; end = best[end].begin) {
    placement.begins.push_back(best[end].begin);
  }
  std::reverse(placement.begins.begin(), placement.begins.end());
  return placement;
}

PausePlacement evenPauses(std::span<const gcode::StreamPoint> points, std::size_t pointsPerWindow) {
  RIVULET_ASSERT(!points.empty() && pointsPerWindow >= 1);
  const std::vector<bool> harmless = harmlessPauses(points);
  PausePlacement placement;
  for (std::size_t begin = 0; begin < points.size(); begin += pointsPerWindow) {
    placement.begins.push_back(begin);
    placement.inCut += begin > 0 && !harmless[begin - 1] ? 1U : 0U;
  }
  return placement;
}

PausePlacement cutWindows(std::span<const gcode::StreamPoint> points, std::size_t pointsPerWindow,
                          bool place) {
  return place ? placePauses(points, pointsPerWindow) : evenPauses(points, pointsPerWindow);
}

}  // namespace rivulet::streaming
