// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "base/contract.h"
#include "feasibility/verdict.h"

namespace rivulet::feasibility {

namespace {

/// Two sums of the same steps may differ by rounding; this does not distinguish two places.
constexpr double kSameLength = 1e-12;

bool isShorter(double lengthMm, double thanMm) {
  return lengthMm < thanMm * (1.0 - kSameLength);
}

/// First window of `width` consecutive steps whose sum is smallest.
///
/// A running sum that adds the new step and subtracts the old one drifts: after a long path at 100
/// mm per step, sums of 0.001 mm steps have lost their digits. So nothing is subtracted. The steps
/// are cut into blocks of `width`; any window is the end of one block and the beginning of the
/// next, and both parts are partial sums of at most `width` positive numbers.
std::size_t shortestWindow(std::span<const double> stepsMm, std::size_t width) {
  std::size_t best = 0;
  double bestMm = std::numeric_limits<double>::infinity();
  std::vector<double> tailsMm(width);  // of the block the window starts in: from i to its end
  for (std::size_t block = 0; block + width <= stepsMm.size(); block += width) {
    double tailMm = 0.0;
    for (std::size_t i = width; i-- > 0;) {
      tailMm += stepsMm[block + i];
      tailsMm[i] = tailMm;
    }
    double headMm = 0.0;  // of the next block: up to the end of the window
    for (std::size_t i = 0; i < width && block + i + width <= stepsMm.size(); ++i) {
      if (isShorter(tailsMm[i] + headMm, bestMm)) {
        bestMm = tailsMm[i] + headMm;
        best = block + i;
      }
      if (block + width + i < stepsMm.size()) {
        headMm += stepsMm[block + width + i];
      }
    }
  }
  return best;
}

}  // namespace

ProgramDistances programDistances(const std::vector<gcode::StreamPoint>& points, int pointsPerLoop,
                                  double referenceMmPerS) {
  RIVULET_ASSERT(points.size() >= 2);
  RIVULET_ASSERT(pointsPerLoop >= 2);
  std::vector<double> stepsMm;
  stepsMm.reserve(points.size() - 1);
  for (std::size_t i = 1; i < points.size(); ++i) {
    // If only rotary axes turn, the feed is in degrees: the time is the same as for as many mm.
    const double way =
        base::wayAlongFeed(base::distance(points[i - 1].positionMm, points[i].positionMm),
                           base::turnDeg(points[i - 1].rotaryDeg, points[i].rotaryDeg));
    const bool isScaled = referenceMmPerS > 0.0 && points[i].feedMmPerS > 0.0;
    stepsMm.push_back(isScaled ? way * referenceMmPerS / points[i].feedMmPerS : way);
  }
  const auto place = [&](std::size_t first, std::size_t steps) {
    return Place{
        {static_cast<std::uint32_t>(first)}, points[first].line, points[first + steps].line, steps};
  };

  ProgramDistances distances;
  std::size_t closest = 0;
  for (std::size_t i = 1; i < stepsMm.size(); ++i) {
    if (isShorter(stepsMm[i], stepsMm[closest])) {
      closest = i;
    }
  }
  distances.pointDistanceMmMin = stepsMm[closest];
  distances.pointDistancePlace = place(closest, 1);

  distances.windowSteps = pointsPerLoop / 2;
  const std::size_t width =
      std::min(static_cast<std::size_t>(distances.windowSteps), stepsMm.size());
  const std::size_t first = shortestWindow(stepsMm, width);
  for (std::size_t i = first; i < first + width; ++i) {
    distances.windowLengthMmMin += stepsMm[i];
  }
  distances.windowPlace = place(first, width);
  return distances;
}

}  // namespace rivulet::feasibility
