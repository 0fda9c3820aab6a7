// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/path_watch.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::streaming {

namespace {

/// A control rounds corners by this much.
constexpr double kRoundingMm = 0.5;
/// Lag of the axes behind their set point, at a low gain of the position controller.
constexpr double kLagS = 0.06;
/// Axes that lag cut a right-angled corner by 1/e of the way they lag behind.
constexpr double kCutShare = 0.37;
/// A tool that stands trembles, and overshoots when it stops.
constexpr double kBackMm = 0.2;
/// The tool can be on either of two pieces that are equally near: of a way there and back.
constexpr double kNearerMm = 1e-3;

/// The place on a segment that is nearest to a point.
base::Vec3 nearestOn(base::Vec3 from, base::Vec3 to, base::Vec3 point) {
  const base::Vec3 along = to - from;
  const double squares = base::dot(along, along);
  const double share =
      squares > 0.0 ? std::clamp(base::dot(point - from, along) / squares, 0.0, 1.0) : 0.0;
  return from + share * along;
}

}  // namespace

PathWatch::PathWatch(std::span<const gcode::StreamPoint> points, base::Vec3 startMm,
                     PathSlack slack)
    : m_startMm(startMm), m_slack(slack), m_alongMm{0.0} {
  extend(points);
}

void PathWatch::extend(std::span<const gcode::StreamPoint> points) {
  RIVULET_ASSERT(points.size() >= m_points.size());
  m_points = points;
  if (m_alongMm.capacity() <= points.size()) {
    m_alongMm.reserve(std::max(points.size() + 1, 2 * m_alongMm.capacity()));
  }
  for (std::size_t place = m_alongMm.size(); place <= m_points.size(); ++place) {
    m_alongMm.push_back(m_alongMm.back() + base::distance(placeMm(place - 1), placeMm(place)));
  }
}

base::Vec3 PathWatch::placeMm(std::size_t place) const {
  return place == 0 ? m_startMm : m_points[place - 1].positionMm;
}

double PathWatch::feedMmPerS(std::size_t place) const {
  const double feed = place == 0 ? 0.0 : m_points[place - 1].feedMmPerS;
  return feed > 0.0 ? feed : m_slack.feedMmPerS;
}

double PathWatch::sideMm(std::size_t place) const {
  // The tool may still come from the faster move before.
  const double feed = std::max(feedMmPerS(place), feedMmPerS(place - 1));
  return kRoundingMm + kCutShare * kLagS * feed + std::sqrt(3.0) * m_slack.correctionMm;
}

double PathWatch::follow(base::Vec3 positionMm, double fromMm, std::size_t to) {
  const auto next = std::lower_bound(m_alongMm.begin() + 1, m_alongMm.end(), fromMm);
  std::size_t place = std::min(static_cast<std::size_t>(next - m_alongMm.begin()), to);
  const double lengthMm = m_alongMm[place] - m_alongMm[place - 1];
  const double share =
      lengthMm > 0.0 ? std::clamp((fromMm - m_alongMm[place - 1]) / lengthMm, 0.0, 1.0) : 1.0;
  base::Vec3 from = placeMm(place - 1) + share * (placeMm(place) - placeMm(place - 1));
  double leastMm = base::distance(positionMm, from);
  bool isOnPath = false;
  for (; place <= to; ++place) {
    const base::Vec3 end = placeMm(place);
    const base::Vec3 nearest = nearestOn(from, end, positionMm);
    const double offMm = base::distance(positionMm, nearest);
    if (isOnPath && offMm > leastMm - kNearerMm) {
      break;  // the first piece that the tool can be on: farther ones say nothing
    }
    leastMm = std::min(leastMm, offMm);
    if (offMm <= sideMm(place)) {
      isOnPath = true;
      m_reachedMm = std::max(m_reachedMm, m_alongMm[place] - base::distance(nearest, end));
    }
    from = end;
  }
  return isOnPath ? 0.0 : leastMm;
}

std::optional<double> PathWatch::add(base::Vec3 positionMm, std::size_t passed, std::size_t sent) {
  const std::size_t last = m_points.size();
  if (last == 0) {
    return std::nullopt;
  }
  passed = std::min(passed, last);
  const std::size_t to = std::min(std::max(sent, passed + 1), last);
  const double passedMm =
      m_alongMm[passed] - m_slack.passedMm - kRoundingMm - kLagS * feedMmPerS(passed);
  const double offMm = follow(positionMm, std::max({0.0, passedMm, m_reachedMm - kBackMm}), to);
  const bool wasOff = m_wasOff;
  m_wasOff = offMm > 0.0;
  return m_wasOff && wasOff ? std::optional(offMm) : std::nullopt;
}

}  // namespace rivulet::streaming
