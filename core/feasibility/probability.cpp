// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/probability.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "feasibility/prediction/methods.h"

namespace rivulet::feasibility {

Prediction predict(const std::vector<gcode::StreamPoint>& points,
                   const OperatingPoint& operatingPoint, const StreamModel& model,
                   base::Vec3 startMm) {
  RIVULET_ASSERT(!points.empty());
  RIVULET_ASSERT(operatingPoint.feedMmPerS > 0.0);
  switch (base::methodTraits(operatingPoint.method).portion) {
    case base::Portion::Point:
      return predictPosition(points, operatingPoint, model, startMm);
    case base::Portion::HalfLoop:
      return predictSignal(points, operatingPoint, model, startMm);
    case base::Portion::Window:
      break;
  }
  return predictWindows(points, operatingPoint, model, startMm);
}

Prediction predict(const std::vector<gcode::StreamPoint>& points,
                   const OperatingPoint& operatingPoint, const StreamModel& model) {
  RIVULET_ASSERT(!points.empty());
  // A little above, so that the first point is not taken for passed before the run.
  const double aboveMm = 1.0 + 2.0 * operatingPoint.deltaMm;
  return predict(points, operatingPoint, model,
                 points.front().positionMm + base::Vec3{0.0, 0.0, aboveMm});
}

double largestFeedMmPerS(const std::function<bool(double)>& isTooFast, double feedMmPerSMin,
                         double feedMmPerSMax) {
  RIVULET_ASSERT(feedMmPerSMin > 0.0);
  RIVULET_ASSERT(feedMmPerSMax > feedMmPerSMin);
  constexpr double kStride = 1.5;
  constexpr double kAccuracy = 1.01;
  if (isTooFast(feedMmPerSMin)) {
    return 0.0;
  }
  // From below: the first feed that is too fast is the limit, whatever comes above it.
  double fine = feedMmPerSMin;
  double fast = 0.0;
  while (fast == 0.0) {
    const double next = std::min(fine * kStride, feedMmPerSMax);
    if (isTooFast(next)) {
      fast = next;
    } else if (next >= feedMmPerSMax) {
      return feedMmPerSMax;
    } else {
      fine = next;
    }
  }
  while (fast / fine > kAccuracy) {
    const double middle = std::sqrt(fine * fast);
    (isTooFast(middle) ? fast : fine) = middle;
  }
  return fine;
}

double feedMmPerSAt(double probability, const std::vector<gcode::StreamPoint>& points,
                    const OperatingPoint& operatingPoint, const StreamModel& model,
                    double feedMmPerSMin, double feedMmPerSMax) {
  const auto isTooFast = [&](double feedMmPerS) {
    OperatingPoint at = operatingPoint;
    at.feedMmPerS = feedMmPerS;
    return predict(points, at, model).failureProbability > probability;
  };
  return largestFeedMmPerS(isTooFast, feedMmPerSMin, feedMmPerSMax);
}

}  // namespace rivulet::feasibility
