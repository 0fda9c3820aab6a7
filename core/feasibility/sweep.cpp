// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/sweep.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "feasibility/equations.h"
#include "feasibility/margins.h"

namespace rivulet::feasibility {

namespace {

/// Where the limits are computed: evenly spaced, both ends included; whole numbers from 2 over N.
std::vector<double> abscissas(SweepAxis axis, const SweepRange& range) {
  RIVULET_ASSERT(range.steps >= 2);
  RIVULET_ASSERT(range.max > range.min);
  RIVULET_ASSERT(range.min >= 0.0);
  std::vector<double> values;
  for (int step = 0; step < range.steps; ++step) {
    double value = range.min + (range.max - range.min) * step / (range.steps - 1);
    if (axis == SweepAxis::PointsPerLoop) {
      value = std::max(2.0, std::round(value));
    }
    if (values.empty() || value > values.back()) {
      values.push_back(value);
    }
  }
  return values;
}

}  // namespace

std::vector<Border> sweepBorders(const OperatingPoint& operatingPoint,
                                 const ProgramDistances& distances, SweepAxis axis,
                                 const SweepRange& range, const AccessModel& access,
                                 const SafetyFactors& safety) {
  const std::vector<double> values = abscissas(axis, range);
  const PollTime poll =
      pollTime(access.timePerNode(operatingPoint.turn()), operatingPoint.cellsPerPoint);
  const SafetyFactors asPublished{1.0, 1.0, 1.0};
  std::vector<Border> borders;
  for (const MethodEquation& entry : equationsOf(operatingPoint.method, distances)) {
    for (const bool withSafety : {true, false}) {
      Border border{entry.equation, withSafety, {}};
      border.points.reserve(values.size());
      for (const double value : values) {
        OperatingPoint at = operatingPoint;
        ProgramDistances with = distances;
        // At 1 mm/s the margin, which is the factor left for the feed, is the limit in mm/s.
        at.feedMmPerS = 1.0;
        switch (axis) {
          case SweepAxis::PointDistance:
            with.pointDistanceMmMin = value;
            break;
          case SweepAxis::PointsPerLoop:
            at.pointsPerLoop = static_cast<int>(value);
            break;
          case SweepAxis::Delta:
            at.deltaMm = value;
            break;
        }
        const double feedMmPerS =
            marginOf(entry.equation, at, with, withSafety ? poll.max : poll.min, access,
                     withSafety ? safety : asPublished);
        border.points.push_back({value, feedMmPerS});
      }
      borders.push_back(std::move(border));
    }
  }
  return borders;
}

}  // namespace rivulet::feasibility
