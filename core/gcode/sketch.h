// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A path in few points, for a small picture. @threadsafety pure.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gcode/trajectory.h"

namespace rivulet::gcode {

struct SketchPoint {
  base::Vec3 positionMm;
  bool isRapid = false;  ///< of the move that ends here

  friend bool operator==(const SketchPoint&, const SketchPoint&) = default;
};

/// Leaves out points that are too close to the last one kept to be seen, and then, if there are
/// still too many, all but evenly spaced ones. First and last point stay. O(points).
/// @param pointsMax  >= 2
[[nodiscard]] std::vector<SketchPoint> sketchOf(std::span<const StreamPoint> points,
                                                std::size_t pointsMax);

}  // namespace rivulet::gcode
