// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/equations.h"

#include <cmath>

#include "base/contract.h"
#include "feasibility/symbols.h"

namespace rivulet::feasibility {

namespace {

/// What all margins share. @param lengthMm right side, >= 0 @param time > 0
double marginOf(double lengthMm, double feedMmPerS, double timeS, double safetyFactor) {
  RIVULET_ASSERT(feedMmPerS > 0.0);
  RIVULET_ASSERT(timeS > 0.0);
  RIVULET_ASSERT(safetyFactor >= 1.0);
  RIVULET_ASSERT(lengthMm >= 0.0);
  return lengthMm / (feedMmPerS * timeS * safetyFactor);
}

/// One read of the signal and its answer, and three writes per point: 3⌊N/2⌋+1 accesses.
double windowTimeS(base::Duration accessTime, int pointsPerLoop) {
  RIVULET_ASSERT(pointsPerLoop >= 2);
  const double points = pointsPerLoop / 2;
  return base::toSeconds(accessTime) * (kWriteNodesPerPoint * points + 1.0);
}

}  // namespace

PollTime pollTime(base::Duration accessTime) {
  RIVULET_ASSERT(accessTime > base::Duration::zero());
  const auto times = [&](double nodes) { return accessTime * static_cast<int>(nodes); };
  return {times(kReadNodesPerPoll), times(kReadNodesPerPoll + kWriteNodesPerPoint)};
}

double pointDistanceMargin(double feedMmPerS, base::Duration pollTime, double pointDistanceMmMin,
                           double safetyFactor) {
  return marginOf(pointDistanceMmMin, feedMmPerS, base::toSeconds(pollTime), safetyFactor);
}

double deltaMargin(double feedMmPerS, base::Duration pollTime, double deltaMm,
                   double safetyFactor) {
  return marginOf(2.0 * deltaMm, feedMmPerS, base::toSeconds(pollTime), safetyFactor);
}

double windowMargin(double feedMmPerS, base::Duration accessTime, int pointsPerLoop,
                    double pointDistanceMmMin, double safetyFactor) {
  const double points = pointsPerLoop / 2;
  return marginOf(points * pointDistanceMmMin, feedMmPerS, windowTimeS(accessTime, pointsPerLoop),
                  safetyFactor);
}

double realWindowMargin(double feedMmPerS, base::Duration accessTime, int pointsPerLoop,
                        double windowLengthMmMin, double safetyFactor) {
  return marginOf(windowLengthMmMin, feedMmPerS, windowTimeS(accessTime, pointsPerLoop),
                  safetyFactor);
}

double reachMargin(double feedMmPerS, base::Duration accessTime, int pointsPerWindow,
                   double windowLengthMmMin, double safetyFactor) {
  RIVULET_ASSERT(pointsPerWindow >= 1);
  const double nodes = kWriteNodesPerPoint * pointsPerWindow + kWindowNodes;
  return marginOf(windowLengthMmMin, feedMmPerS, base::toSeconds(accessTime) * nodes, safetyFactor);
}

}  // namespace rivulet::feasibility
