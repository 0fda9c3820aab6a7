// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Fewer points, or more, on the same path. @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "base/axes.h"
#include "base/budget.h"
#include "base/result.h"
#include "gcode/feeds.h"
#include "gcode/trajectory.h"

namespace rivulet::gcode {

/// How far a path may be moved.
struct Tolerance {
  double value = 0.0;    ///< mm of X, Y and Z, and degrees of rotary axes, > 0
  bool onSteps = false;  ///< the points that stay are moved to whole steps (`base::Packing`)
};

struct ThinnedTrajectory {
  Trajectory trajectory;
  std::size_t leftOut = 0;
};

/// The same path within a tolerance, with the fewest of its points: straight moves take the place
/// of up to 128 others. Both paths can be gone along, never back, within the tolerance of one
/// another (their Fréchet distance), and no move is passed against its direction. Points stay where
/// the kind of motion, the feed or the direction of the tool changes, where an event happens, at
/// arcs kept whole, where an axis is named first, and at corners of 30 degrees or more.
/// `pathDeviation` measures what has come of it.
/// @return the path itself, where nothing can be left out
/// @threadsafety pure; O(points) for ordinary paths, at most 128 times as much for straight ones.
[[nodiscard]] ThinnedTrajectory thin(const Trajectory& trajectory, const Tolerance& tolerance);

/// Puts points on straight moves so that none is longer than `lengthMm`; the path stays what it
/// was. Moves from a place that is not known, and arcs kept whole, stay as they are.
/// @param lengthMm  > 0
/// @param budget  of the new trajectory
/// @return error BudgetError::Exceeded
[[nodiscard]] base::Result<Trajectory> split(const Trajectory& trajectory, double lengthMm,
                                             const base::Budget& budget = {});

/// The same so that none takes longer than the limit. Where nothing has to be divided, nothing is
/// done. @param trajectory  changed in place; on an error it stays as it was
/// @return error BudgetError::Exceeded
[[nodiscard]] base::Result<void> divideLongMoves(Trajectory& trajectory, const MoveRules& limit,
                                                 const base::Budget& budget = {});

/// Equal parts of a straight move, a whole number >= 1, so that none is longer than `most`.
/// @param way  in mm, degrees or s  @param most  in the same unit, > 0
[[nodiscard]] double partsOf(double way, double most);

/// Where a part of a straight move ends. @param share  of the move until there, 0 to 1
[[nodiscard]] base::AxisPosition onMove(const base::AxisPosition& from,
                                        const base::AxisPosition& to, double share);

}  // namespace rivulet::gcode
