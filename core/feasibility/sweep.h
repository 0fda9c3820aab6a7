// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The feasibility region as curves: the feed at which each condition just holds, over d_min, N
/// or δ. @threadsafety pure.
#pragma once

#include <vector>

#include "feasibility/verdict.h"

namespace rivulet::feasibility {

struct BorderPoint {
  double abscissa = 0.0;    ///< d_min in mm, N, or δ in mm
  double feedMmPerS = 0.0;  ///< the limit: feasible below
};

/// One limit curve of the region.
struct Border {
  Equation equation = Equation::PointDistance;
  bool withSafety = true;  ///< false: the inequality as published (and the shorter poll time)
  std::vector<BorderPoint> points;
};

enum class SweepAxis { PointDistance, PointsPerLoop, Delta };

struct SweepRange {
  double min = 0.0;
  double max = 1.0;
  int steps = 64;  ///< >= 2; over N the steps are whole numbers
};

/// Limit curves of the conditions of the method of `operatingPoint`, with and without safety
/// factor. The quantities not swept are those of `operatingPoint` and `distances`.
[[nodiscard]] std::vector<Border> sweepBorders(const OperatingPoint& operatingPoint,
                                               const ProgramDistances& distances, SweepAxis axis,
                                               const SweepRange& range,
                                               const AccessModel& access = {},
                                               const SafetyFactors& safety = {});

}  // namespace rivulet::feasibility
