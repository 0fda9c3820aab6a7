// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which move of a path a position belongs to. @threadsafety pure.
#pragma once

#include <cstddef>
#include <span>

#include "gcode/trajectory.h"

namespace rivulet::gcode {

struct NearestMove {
  std::size_t point = 0;    ///< index of the point at which the move ends
  double distanceMm = 0.0;  ///< from the position to the move
};

/// Of moves that are equally near, the first. What comes before the first point of the path is not
/// known: its move is that point alone. O(`end` - `begin`).
/// @param begin, end  indices of the points at which the moves end, [begin, end), not empty
/// @param positionMm  workpiece frame, finite
[[nodiscard]] NearestMove nearestMove(std::span<const StreamPoint> points, std::size_t begin,
                                      std::size_t end, base::Vec3 positionMm);

}  // namespace rivulet::gcode
