// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How far one path is from another, found without knowing how the one was made of the other.
///
/// It is the Fréchet distance: two travellers go along one path each, from its begin to its end, as
/// fast as they like and never back; of all ways to do so, the one counts in which they are nearest
/// at their farthest. So it sees what a distance of points does not: a spike that is passed the
/// other way, a slot that is cut off, a loop that is left out where the path crosses itself.
/// @threadsafety pure.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/axes.h"
#include "gcode/trajectory.h"

namespace rivulet::gcode {

/// Where the axes are at each point; an axis stands at 0 until it is named.
[[nodiscard]] std::vector<base::AxisPosition> placesOf(const Trajectory& trajectory);

/// Whether the Fréchet distance is within `most`: mm of X, Y and Z, degrees of the rotary axes,
/// each of them. @param a, b  finite; the moves between them are straight O(moves) where the paths
/// are not near themselves, else the number of pairs that are that near.
[[nodiscard]] bool isAlong(std::span<const base::AxisPosition> a,
                           std::span<const base::AxisPosition> b, double most);

/// The Fréchet distance, rounded up to `kDeviationStep`. @param most  where the search ends
/// @return nothing: it is larger than that
[[nodiscard]] std::optional<double> pathDeviation(std::span<const base::AxisPosition> a,
                                                  std::span<const base::AxisPosition> b,
                                                  double most);
inline constexpr double kDeviationStep = 1e-4;  ///< mm and degrees

}  // namespace rivulet::gcode
