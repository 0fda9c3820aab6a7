// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One entry point to all margins, for `verdict` and `sweep`: the equations of a method, and their
/// margins at an operating point. @threadsafety pure.
#pragma once

#include <vector>

#include "feasibility/verdict.h"

namespace rivulet::feasibility {

/// An equation, and whether it counts for the verdict.
struct MethodEquation {
  Equation equation;
  bool decides;
};

/// @param distances windowSteps = 0: no program is loaded
[[nodiscard]] std::vector<MethodEquation> equationsOf(base::MethodKind method,
                                                      const ProgramDistances& distances);

/// Smallest path length of `steps` steps that the distances guarantee. Exact for the number of
/// steps for which they were computed; for others a lower bound from whole windows and single
/// steps, so that a change of N never looks better than it is.
[[nodiscard]] double windowLengthMmBound(const ProgramDistances& distances, int steps);

/// @param operatingPoint feed and, for (2), δ positive; N >= 2
/// @param pollTime for (1) and (2)
[[nodiscard]] double marginOf(Equation equation, const OperatingPoint& operatingPoint,
                              const ProgramDistances& distances, base::Duration pollTime,
                              const AccessModel& access, const SafetyFactors& safety);

}  // namespace rivulet::feasibility
