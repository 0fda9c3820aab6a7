// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/nearest_move.h"

#include <limits>

#include "base/contract.h"

namespace rivulet::gcode {

NearestMove nearestMove(std::span<const StreamPoint> points, std::size_t begin, std::size_t end,
                        base::Vec3 positionMm) {
  RIVULET_ASSERT(begin < end && end <= points.size());
  NearestMove nearest{begin, std::numeric_limits<double>::infinity()};
  for (std::size_t point = begin; point < end; ++point) {
    const base::Vec3 to = points[point].positionMm;
    const base::Vec3 from = point > 0 ? points[point - 1].positionMm : to;
    const double distanceMm = base::distanceToSegment(positionMm, from, to);
    if (distanceMm < nearest.distanceMm) {
      nearest = {point, distanceMm};
    }
  }
  return nearest;
}

}  // namespace rivulet::gcode
