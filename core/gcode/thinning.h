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

struct ThinnedTrajectory {
  Trajectory trajectory;
  std::size_t leftOut = 0;
  /// Largest distance of a point left out from the path that remains, mm: measured, <= tolerance.
  /// The path between two points is straight, so no place on it is further away.
  double errorMmMax = 0.0;
};

/// Leaves out points whose absence moves the path by no more than the tolerance. Points stay where
/// the kind of motion, the feed, a rotary axis or the direction of the tool changes, where an event
/// happens, at arcs kept whole, and where a coordinate is not known.
/// @param toleranceMm  > 0
/// @threadsafety pure; O(n log n) for ordinary paths.
[[nodiscard]] ThinnedTrajectory thin(const Trajectory& trajectory, double toleranceMm);

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
[[nodiscard]] base::Result<void> divideLongMoves(Trajectory& trajectory, const MoveLimit& limit,
                                                 const base::Budget& budget = {});

/// Equal parts of a straight move, a whole number >= 1, so that none is longer than `most`.
/// @param way  in mm, degrees or s  @param most  in the same unit, > 0
[[nodiscard]] double partsOf(double way, double most);

/// Where a part of a straight move ends. @param share  of the move until there, 0 to 1
[[nodiscard]] base::AxisPosition onMove(const base::AxisPosition& from,
                                        const base::AxisPosition& to, double share);

}  // namespace rivulet::gcode
