// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/emulation.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "emulator/paper/cascade.h"

namespace rivulet::emulator::paper {

namespace {

/// Farther from the set point than this, or faster, an axis has run away.
constexpr double kErrorMmMax = 1e3;
constexpr double kSpeedMmPerSMax = 1e4;
/// Steps between two looks for that: runs need not be slowed down by looking at each.
constexpr std::size_t kStepsBetweenChecks = 128;

bool ranAway(double errorMm, double speedMmPerS) {
  // So written that it is true of what is not a number.
  return !(std::abs(errorMm) < kErrorMmMax && std::abs(speedMmPerS) < kSpeedMmPerSMax);
}

/// @return share of the course that the axis stayed with its set points
template <class Model>
double runAxis(Model model, const Course& course, std::size_t axis, Emulation& emulation) {
  const std::vector<double>& reference = course.referenceMm[axis];
  std::vector<double>& mm = emulation.mm[axis];
  std::vector<double>& mmPerS = emulation.mmPerS[axis];
  const double start = reference.front();
  const std::size_t steps = course.points.back().step + 1;
  double beforeMm = 0.0;
  double beforeMmPerS = 0.0;
  std::size_t point = 0;
  // Step k takes the axis from time k to time k + 1 (in steps) and serves the points between.
  for (std::size_t k = 0; k < steps;) {
    const std::size_t until = std::min(k + kStepsBetweenChecks, steps);
    double referenceMm = 0.0;
    for (; k < until; ++k) {
      referenceMm = reference[std::min(k, reference.size() - 1)] - start;
      model.step(referenceMm);
      for (; point < course.points.size() && course.points[point].step == k; ++point) {
        const double share = course.points[point].share;
        mm[point] = start + beforeMm + share * (model.positionMm() - beforeMm);
        mmPerS[point] = beforeMmPerS + share * (model.speedMmPerS() - beforeMmPerS);
      }
      beforeMm = model.positionMm();
      beforeMmPerS = model.speedMmPerS();
    }
    if (ranAway(beforeMm - referenceMm, beforeMmPerS)) {
      return static_cast<double>(k - 1) / static_cast<double>(steps);
    }
  }
  return 1.0;
}

double meanSquare(const std::vector<double>& ours, const std::vector<double>& observed,
                  std::size_t first) {
  double sum = 0.0;
  for (std::size_t i = first; i < observed.size(); ++i) {
    const double error = observed[i] - ours[i];
    sum += error * error;
  }
  return first < observed.size() ? sum / static_cast<double>(observed.size() - first) : 0.0;
}

}  // namespace

Emulation emulate(const Course& course, const Parameters& values, const PlantSettings& plant) {
  RIVULET_ASSERT(course.stepS == plant.stepS);
  RIVULET_ASSERT(!course.points.empty());
  Emulation emulation;
  for (std::size_t axis : {kAxisX, kAxisY}) {
    emulation.mm[axis].assign(course.points.size(), 0.0);
    emulation.mmPerS[axis].assign(course.points.size(), 0.0);
  }
  emulation.stableShare =
      runAxis(Cascade<4>(oscillatorsOfX(values), values, plant), course, kAxisX, emulation);
  if (!emulation.diverged()) {
    emulation.stableShare =
        runAxis(Cascade<2>(oscillatorsOfY(values), values, plant), course, kAxisY, emulation);
  }
  return emulation;
}

double Misfit::objective(double lambda) const {
  if (stableShare < 1.0) {
    return kDivergedObjective * (2.0 - stableShare);
  }
  return positionMm2() + lambda * speedMm2PerS2();
}

Misfit misfitOf(const Course& course, const Emulation& emulation) {
  Misfit misfit;
  misfit.stableShare = emulation.stableShare;
  for (std::size_t axis : {kAxisX, kAxisY}) {
    misfit.mm2[axis] = meanSquare(emulation.mm[axis], course.observedMm[axis], course.firstScored);
    misfit.mm2PerS2[axis] =
        meanSquare(emulation.mmPerS[axis], course.observedMmPerS[axis], course.firstScored);
  }
  return misfit;
}

}  // namespace rivulet::emulator::paper
