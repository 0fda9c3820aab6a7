// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/verdict.h"

#include <fmt/format.h>

#include <cmath>

#include "base/contract.h"
#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "feasibility/equations.h"
#include "feasibility/margins.h"

namespace rivulet::feasibility {

namespace {

/// The inequalities are strict. Exactly at the limit, rounding may put the margin slightly above 1:
/// that is still the limit.
constexpr double kRounding = 1e-12;

bool holds(double margin) {
  return margin > 1.0 + kRounding;
}

std::optional<Place> placeOf(Equation equation, const ProgramDistances& distances) {
  if (distances.windowSteps == 0 || equation == Equation::Delta) {
    return std::nullopt;
  }
  return equation == Equation::RealWindow || equation == Equation::Reach
             ? distances.windowPlace
             : distances.pointDistancePlace;
}

}  // namespace

const Place& tightestPlace(const ProgramDistances& distances, base::MethodKind method) {
  return base::usesDelta(method) ? distances.pointDistancePlace : distances.windowPlace;
}

std::error_code make_error_code(FeasibilityError code) {
  static const base::NamedCategory category("feasibility");
  return {static_cast<int>(code), category};
}

std::string_view equationLabel(Equation equation) {
  switch (equation) {
    case Equation::PointDistance:
      return "(1)";
    case Equation::Delta:
      return "(2)";
    case Equation::Window:
      return "(3)";
    case Equation::Reach:
      return "reach";
    case Equation::Machine:
      return "machine";
    case Equation::RealWindow:
      break;
  }
  return "(3) with d_min^N";
}

std::vector<MethodEquation> equationsOf(base::MethodKind method,
                                        const ProgramDistances& distances) {
  if (base::usesDelta(method)) {
    return {{Equation::PointDistance, true}, {Equation::Delta, true}};
  }
  if (base::hasWindows(method)) {
    return {{Equation::Reach, true}};
  }
  if (distances.windowSteps > 0) {
    return {{Equation::RealWindow, true}, {Equation::Window, false}};
  }
  return {{Equation::Window, true}};
}

double windowLengthMmBound(const ProgramDistances& distances, int steps) {
  RIVULET_ASSERT(steps >= 1);
  RIVULET_ASSERT(distances.windowSteps >= 1);
  const int windows = steps / distances.windowSteps;
  const int single = steps % distances.windowSteps;
  return windows * distances.windowLengthMmMin + single * distances.pointDistanceMmMin;
}

double marginOf(Equation equation, const OperatingPoint& operatingPoint,
                const ProgramDistances& distances, base::Duration pollTime,
                const AccessModel& access, const SafetyFactors& safety) {
  const base::Duration accessTime = access.timePerNode(operatingPoint.turn());
  switch (equation) {
    case Equation::PointDistance:
      return pointDistanceMargin(operatingPoint.feedMmPerS, pollTime, distances.pointDistanceMmMin,
                                 safety.pointDistance);
    case Equation::Delta:
      return deltaMargin(operatingPoint.feedMmPerS, pollTime, operatingPoint.deltaMm, safety.delta);
    case Equation::Window:
      return windowMargin(operatingPoint.feedMmPerS, accessTime, operatingPoint.pointsPerLoop,
                          distances.pointDistanceMmMin, safety.window,
                          operatingPoint.cellsPerPoint);
    case Equation::Reach:
      return reachMargin(operatingPoint.feedMmPerS, accessTime, operatingPoint.pointsPerLoop,
                         distances.windowSteps > 0
                             ? windowLengthMmBound(distances, operatingPoint.pointsPerLoop)
                             : operatingPoint.pointsPerLoop * distances.pointDistanceMmMin,
                         safety.window, operatingPoint.cellsPerPoint, operatingPoint.cellsOfFirst);
    case Equation::Machine:
      RIVULET_ASSERT(false);  // has none of its own
      break;
    case Equation::RealWindow:
      break;
  }
  return realWindowMargin(operatingPoint.feedMmPerS, accessTime, operatingPoint.pointsPerLoop,
                          windowLengthMmBound(distances, operatingPoint.pointsPerLoop / 2),
                          safety.window, operatingPoint.cellsPerPoint);
}

base::Result<Verdict> judge(const OperatingPoint& operatingPoint, const ProgramDistances& distances,
                            const AccessModel& access, const SafetyFactors& safety) {
  const bool position = base::usesDelta(operatingPoint.method);
  if (base::sendsBlocks(operatingPoint.method)) {
    return base::fail(
        FeasibilityError::NothingKnown,
        fmt::format("No source says what it costs to store a program on a control, so no "
                    "prediction is possible for method {}. Its axes wait if the client is late.",
                    base::methodName(operatingPoint.method)));
  }
  // Written so that a value which is not a number is refused as well.
  const double feedMmPerMin = base::mmPerMinFromMmPerS(operatingPoint.feedMmPerS);
  if (!base::isFeedMmPerMin(feedMmPerMin)) {
    return base::fail(FeasibilityError::FeedNotPositive,
                      fmt::format("The feed is {:g} mm/min: choose one from {:g} to {:.0f}.",
                                  feedMmPerMin, base::kFeedMmPerMinLeast, base::kFeedMmPerMinMost));
  }
  if (position && (!(operatingPoint.deltaMm > 0.0) || !std::isfinite(operatingPoint.deltaMm))) {
    return base::fail(FeasibilityError::DeltaNotPositive,
                      fmt::format("The distance δ is {} mm: choose one greater than 0.",
                                  base::formatFixed(operatingPoint.deltaMm, 3)));
  }
  if (operatingPoint.pointsPerLoop < 2) {
    return base::fail(
        FeasibilityError::TooFewPointsPerLoop,
        fmt::format("N is {}: choose at least 2 points per loop.", operatingPoint.pointsPerLoop));
  }

  Verdict verdict;
  verdict.accessTime = access.timePerNode(operatingPoint.turn());
  verdict.accessMeasured = access.measured.has_value();
  const base::Duration poll = pollTime(verdict.accessTime, operatingPoint.cellsPerPoint).max;
  bool first = true;
  for (const MethodEquation& entry : equationsOf(operatingPoint.method, distances)) {
    const Condition condition{
        entry.equation, marginOf(entry.equation, operatingPoint, distances, poll, access, safety),
        entry.decides, placeOf(entry.equation, distances)};
    verdict.conditions.push_back(condition);
    if (condition.decides && (first || condition.margin < verdict.limiting.margin)) {
      verdict.limiting = condition;
      first = false;
    }
  }
  const bool inTime = holds(verdict.limiting.margin);
  const bool window = base::hasWindows(operatingPoint.method);
  verdict.feasible = inTime || window;
  verdict.waits = window && !inTime;
  // Every left side is proportional to the feed, so the margin is the factor left for it.
  verdict.feedMmPerSMax = operatingPoint.feedMmPerS * verdict.limiting.margin;
  if (position) {
    // The margin of (2) is proportional to δ: the limit is where it is 1.
    verdict.deltaMmMin = operatingPoint.deltaMm /
                         marginOf(Equation::Delta, operatingPoint, distances, poll, access, safety);
  }
  return verdict;
}

}  // namespace rivulet::feasibility
