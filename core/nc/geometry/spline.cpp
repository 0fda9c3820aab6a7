// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/geometry/spline.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::nc {

namespace {

using base::Vec3;

class Flattener {
 public:
  Flattener(const Spline& spline, double toleranceMm, std::vector<Vec3>& points)
      : m_spline(spline), m_toleranceMm(toleranceMm), m_points(points) {}

  double span(double from, Vec3 start, double to, Vec3 end, int depth) {
    const double middle = 0.5 * (from + to);
    const Vec3 centre = splinePoint(m_spline, middle);
    const Vec3 before = splinePoint(m_spline, 0.5 * (from + middle));
    const Vec3 behind = splinePoint(m_spline, 0.5 * (middle + to));
    // The chords are tested at fewer places than they have: half the tolerance makes up for it.
    const double offMm = std::max({base::distanceToSegment(centre, start, end),
                                   base::distanceToSegment(before, start, end),
                                   base::distanceToSegment(behind, start, end)});
    constexpr int kDepthMin = 2;
    constexpr int kDepthMax = 20;
    if (depth >= kDepthMax || (depth >= kDepthMin && offMm <= 0.5 * m_toleranceMm)) {
      m_points.push_back(end);
      return base::distance(start, end);
    }
    return span(from, start, middle, centre, depth + 1) + span(middle, centre, to, end, depth + 1);
  }

 private:
  const Spline& m_spline;
  double m_toleranceMm;
  std::vector<Vec3>& m_points;
};

/// The point with `value` along the axes that the other one does not know.
Vec3 withKnown(Vec3 point, Vec3 unknownMm, double value) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (std::isnan(unknownMm[axis])) {
      point.set(axis, value);
    }
  }
  return point;
}

}  // namespace

std::vector<double> clampedKnots(std::size_t points, int degree) {
  const auto order = static_cast<std::size_t>(degree) + 1;
  RIVULET_ASSERT(points >= order);
  std::vector<double> knots(points + order);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots[i] = i < order ? 0.0 : static_cast<double>(std::min(i - order + 1, points - order + 1));
  }
  return knots;
}

bool isClamped(const Spline& spline) {
  const auto order = static_cast<std::size_t>(spline.degree) + 1;
  const std::vector<double>& knots = spline.knots;
  const std::size_t points = spline.controlMm.size();
  return spline.degree >= 1 && points >= order && knots.size() == points + order &&
         std::all_of(knots.begin(), knots.end(), [](double knot) { return std::isfinite(knot); }) &&
         std::is_sorted(knots.begin(), knots.end()) && knots.front() == knots[order - 1] &&
         knots[points] == knots.back() && knots.front() < knots.back();
}

Vec3 splinePoint(const Spline& spline, double parameter) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  const std::size_t last = spline.controlMm.size() - 1;
  std::size_t span = degree;
  while (span < last && parameter >= spline.knots[span + 1]) {
    ++span;
  }
  // De Boor, on points multiplied by their weights.
  std::vector<Vec3> points(degree + 1);
  std::vector<double> weights(degree + 1);
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t from = span - degree + i;
    weights[i] = spline.weights[from];
    points[i] = weights[i] * spline.controlMm[from];
  }
  for (std::size_t round = 1; round <= degree; ++round) {
    for (std::size_t i = degree; i >= round; --i) {
      const double left = spline.knots[span - degree + i];
      const double right = spline.knots[span + 1 + i - round];
      const double share = right > left ? (parameter - left) / (right - left) : 0.0;
      points[i] = (1.0 - share) * points[i - 1] + share * points[i];
      weights[i] = (1.0 - share) * weights[i - 1] + share * weights[i];
    }
  }
  return (1.0 / weights[degree]) * points[degree];
}

double flattenSpline(const Spline& spline, double chordToleranceMm, std::vector<Vec3>& points) {
  RIVULET_ASSERT(chordToleranceMm > 0.0);
  const Vec3 unknownMm = spline.controlMm.front();
  if (!base::isFinite(unknownMm)) {
    Spline flat = spline;
    for (Vec3& point : flat.controlMm) {
      point = withKnown(point, unknownMm, 0.0);
    }
    const std::size_t first = points.size();
    const double lengthMm = flattenSpline(flat, chordToleranceMm, points);
    for (std::size_t i = first; i < points.size(); ++i) {
      points[i] = withKnown(points[i], unknownMm, std::nan(""));
    }
    return lengthMm;
  }
  const auto degree = static_cast<std::size_t>(spline.degree);
  RIVULET_ASSERT(spline.degree >= 1 && spline.controlMm.size() > degree);
  RIVULET_ASSERT(spline.weights.size() == spline.controlMm.size());
  RIVULET_ASSERT(spline.knots.size() == spline.controlMm.size() + degree + 1);
  Flattener flattener(spline, chordToleranceMm, points);
  double lengthMm = 0.0;
  Vec3 start = spline.controlMm.front();
  for (std::size_t i = degree; i < spline.controlMm.size(); ++i) {
    const double from = spline.knots[i];
    const double to = spline.knots[i + 1];
    if (!(to > from)) {
      continue;
    }
    const bool isLast = i + 1 == spline.controlMm.size();
    const Vec3 end = isLast ? spline.controlMm.back() : splinePoint(spline, to);
    lengthMm += flattener.span(from, start, to, end, 0);
    start = end;
  }
  return lengthMm;
}

}  // namespace rivulet::nc
