// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the set points of recorded runs say of the limits that their planner keeps.
///
/// A planner that keeps a limit reaches it again and again, and stays there: the largest
/// acceleration of an axis is then found in many places, with the same value. A value that was
/// found once or twice, or passed at the top of a circle, is a coincidence of path and feed, and
/// says no more than that the limit is not below it.
/// @threadsafety pure functions.
#pragma once

#include <span>
#include <vector>

#include "emulator/training_run.h"

namespace rivulet::emulator {

/// The largest magnitude of a quantity.
struct SeenLimit {
  double value = 0.0;  ///< median over the places that have it to 1 %
  int places = 0;      ///< stretches of one sign in which it was reached and held
};

/// Whether it was reached so often that it is the planner's limit.
[[nodiscard]] bool isReached(const SeenLimit& seen);

/// One axis in all runs, units of mm and s.
struct AxisLimits {
  char axis = 'X';
  double speedMmPerS = 0.0;  ///< largest; limits of speed are seldom reached, so it is no limit
  SeenLimit accelerationMmPerS2;
  SeenLimit jerkMmPerS3;
  /// Else accelerations change within so few set points that the jerk is larger than it looks.
  bool showsJerk = false;
};

/// From differences of the set points. Axes that do not move are left out.
/// @param runs  with the set points of the machine's own planner, checked (`checkRun`)
[[nodiscard]] std::vector<AxisLimits> limitsSeen(std::span<const TrainingRun> runs);

}  // namespace rivulet::emulator
