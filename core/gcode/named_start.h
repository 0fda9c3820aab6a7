// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a program begins, as `streamPoints` takes it. @threadsafety pure.
#pragma once

#include "gcode/trajectory.h"

namespace rivulet::gcode {

/// The start, but with the first coordinate that the program names for an axis where the axis
/// stands within 0.005 mm of it: axes at rest tremble, and otherwise a move of less than that would
/// be streamed. @param startMm  mm, workpiece frame
[[nodiscard]] base::Vec3 namedStart(const Trajectory& trajectory, base::Vec3 startMm);

/// Where a point is: axes that it leaves open stay where they are. @param beforeMm  of the point
/// before it, or the named start
[[nodiscard]] base::Vec3 placeOf(const TrajectoryPoint& point, base::Vec3 beforeMm);

}  // namespace rivulet::gcode
