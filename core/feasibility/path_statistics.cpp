// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/path_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/contract.h"

namespace rivulet::feasibility {

namespace {

/// Classes in a factor of ten, and their greatest number: a path from a nanometre to a kilometre
/// has twelve powers of ten.
constexpr double kClassesPerDecade = 5.0;
constexpr std::size_t kClassesMax = 64;
constexpr std::size_t kAngleClasses = 12;  // of 15 degrees

/// Borders of equal ratio from the smallest to the largest, as near to the wanted number of
/// classes per decade as whole classes allow.
DistanceHistogram histogramOf(const std::vector<double>& sortedMm) {
  DistanceHistogram histogram;
  const double smallest = sortedMm.front();
  const double largest = sortedMm.back();
  const double decades = std::log10(largest / smallest);
  const std::size_t classes =
      largest > smallest ? std::clamp(static_cast<std::size_t>(std::lround(
                                          std::ceil(std::min(decades, 100.0) * kClassesPerDecade))),
                                      std::size_t{1}, kClassesMax)
                         : 1;
  histogram.bordersMm.resize(classes + 1);
  histogram.bordersMm.front() = smallest;
  histogram.bordersMm.back() = largest;
  for (std::size_t i = 1; i < classes; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(classes);
    histogram.bordersMm[i] =
        std::clamp(smallest * std::pow(largest / smallest, share), smallest, largest);
  }
  // The distances are sorted: a class is the range between two borders.
  histogram.counts.resize(classes);
  auto from = sortedMm.begin();
  for (std::size_t i = 0; i < classes; ++i) {
    const auto to = i + 1 == classes
                        ? sortedMm.end()
                        : std::lower_bound(from, sortedMm.end(), histogram.bordersMm[i + 1]);
    histogram.counts[i] = static_cast<std::size_t>(to - from);
    from = to;
  }
  return histogram;
}

/// Angle between two directions, 0 to 180 degrees; exact for small angles, unlike an arc cosine.
double degreesBetween(base::Vec3 a, base::Vec3 b) {
  return std::atan2(base::norm(base::cross(a, b)), base::dot(a, b)) * 180.0 / std::numbers::pi;
}

}  // namespace

bool hasDistances(const gcode::PointList& list) {
  const std::vector<gcode::StreamPoint>& points = list.points;
  return std::adjacent_find(points.begin(), points.end(),
                            [](const gcode::StreamPoint& a, const gcode::StreamPoint& b) {
                              return a.positionMm != b.positionMm;
                            }) != points.end();
}

PathStatistics pathStatistics(const gcode::PointList& list) {
  const std::vector<gcode::StreamPoint>& points = list.points;
  RIVULET_ASSERT(hasDistances(list));
  PathStatistics statistics;
  statistics.points = points.size();
  statistics.duplicates = list.merged;
  statistics.angles.counts.resize(kAngleClasses);
  std::vector<double> distancesMm;
  distancesMm.reserve(points.size() - 1);
  base::Vec3 before{};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const base::Vec3 step = points[i].positionMm - points[i - 1].positionMm;
    if (step == base::Vec3{}) {
      continue;  // only rotary axes turn
    }
    if (!distancesMm.empty()) {
      const double degrees = degreesBetween(before, step);
      const auto angleClass =
          static_cast<std::size_t>(degrees * static_cast<double>(kAngleClasses) / 180.0);
      ++statistics.angles.counts[std::min(angleClass, kAngleClasses - 1)];
      if (degrees > statistics.angles.degreesMax) {
        statistics.angles.degreesMax = degrees;
        statistics.angles.line = points[i - 1].line;
      }
    }
    distancesMm.push_back(base::norm(step));
    before = step;
  }
  std::sort(distancesMm.begin(), distancesMm.end());
  const std::size_t half = distancesMm.size() / 2;
  statistics.distanceMmMin = distancesMm.front();
  statistics.distanceMmMax = distancesMm.back();
  statistics.distanceMmMedian = distancesMm.size() % 2 == 1
                                    ? distancesMm[half]
                                    : 0.5 * (distancesMm[half - 1] + distancesMm[half]);
  statistics.distances = histogramOf(distancesMm);
  return statistics;
}

}  // namespace rivulet::feasibility
