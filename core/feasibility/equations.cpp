// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/equations.h"

#include <cmath>

#include "base/contract.h"
#include "feasibility/client_turn.h"

namespace rivulet::feasibility {

namespace {

/// Common to all margins. @param lengthMm  right side, >= 0 @param time > 0
double marginOf(double lengthMm, double feedMmPerS, double timeS, double safetyFactor) {
  RIVULET_ASSERT(feedMmPerS > 0.0);
  RIVULET_ASSERT(timeS > 0.0);
  RIVULET_ASSERT(safetyFactor >= 1.0);
  RIVULET_ASSERT(lengthMm >= 0.0);
  return lengthMm / (feedMmPerS * timeS * safetyFactor);
}

/// Of one turn of the client.
double turnTimeS(base::Duration accessTime, const ClientTurn& turn) {
  return base::toSeconds(accessTime) * turn.charged;
}

}  // namespace

PollTime pollTime(base::Duration accessTime, int cellsPerPoint) {
  RIVULET_ASSERT(accessTime > base::Duration::zero());
  const ClientTurn turn = pointTurn(cellsPerPoint);
  return {accessTime * turn.read, accessTime * (turn.read + turn.content)};
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
                    double pointDistanceMmMin, double safetyFactor, int cellsPerPoint) {
  const double points = pointsPerLoop / 2;
  return realWindowMargin(feedMmPerS, accessTime, pointsPerLoop, points * pointDistanceMmMin,
                          safetyFactor, cellsPerPoint);
}

double realWindowMargin(double feedMmPerS, base::Duration accessTime, int pointsPerLoop,
                        double windowLengthMmMin, double safetyFactor, int cellsPerPoint) {
  RIVULET_ASSERT(pointsPerLoop >= 2);
  const ClientTurn turn = halfLoopTurn(pointsPerLoop, cellsPerPoint);
  return marginOf(windowLengthMmMin, feedMmPerS, turnTimeS(accessTime, turn), safetyFactor);
}

double reachMargin(double feedMmPerS, base::Duration accessTime, int pointsPerWindow,
                   double windowLengthMmMin, double safetyFactor, int cellsPerPoint,
                   int cellsOfFirst) {
  RIVULET_ASSERT(pointsPerWindow >= 1);
  const ClientTurn turn = windowTurn(pointsPerWindow, cellsPerPoint, cellsOfFirst);
  return marginOf(windowLengthMmMin, feedMmPerS, turnTimeS(accessTime, turn), safetyFactor);
}

}  // namespace rivulet::feasibility
