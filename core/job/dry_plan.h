// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A job to look at its motion: everything that refers to the workpiece takes place at a height
/// above it, and neither the spindle turns nor does coolant flow. @threadsafety pure.
#pragma once

#include "base/result.h"
#include "job/plan.h"

namespace rivulet::job {

/// The same job, `raiseMm` higher along Z, without S, M3 to M5, M7 to M9 and the like. Tools are
/// changed, and motion in machine coordinates stays as it is.
/// @param raiseMm  greater than 0, at most `kRaiseMmMax`
/// @return error NotDry if a block cannot be raised for certain, or turns the spindle itself: it is
///         named with its line
[[nodiscard]] base::Result<Plan> dryPlan(Plan plan, double raiseMm);

inline constexpr double kRaiseMmMax = 1000.0;

}  // namespace rivulet::job
