// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/pause_placement.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <utility>

#include "base/contract.h"
#include "gcode/packed_points.h"
#include "streaming/methods/method.h"

namespace rivulet::streaming {

namespace {

/// A corner of just this angle must not depend on the last digit.
constexpr double kRounding = 1e-9;
/// A move counts as straight up along Z if its sideways motion is no more than this.
constexpr double kAsideMm = 1e-6;

bool turns(base::Vec3 before, base::Vec3 at, base::Vec3 after) {
  const base::Vec3 in = at - before;
  const base::Vec3 out = after - at;
  const double cosine = std::cos(kCornerDegrees * std::numbers::pi / 180.0);
  return base::dot(in, out) <= (cosine + kRounding) * base::norm(in) * base::norm(out);
}

bool retracts(const gcode::StreamPoint& before, const gcode::StreamPoint& at) {
  // Where a rotary axis is turned, up along Z need not be along the tool.
  const base::RotaryDeg upright{};
  const base::Vec3 way = at.positionMm - before.positionMm;
  return way.z > 0.0 && std::hypot(way.x, way.y) <= kAsideMm && before.rotaryDeg == upright &&
         at.rotaryDeg == upright;
}

/// Point i has another feed than its predecessor. @param i > 0
bool changesFeed(std::span<const gcode::StreamPoint> points, std::size_t i) {
  return points[i].feedMmPerS != points[i - 1].feedMmPerS;
}

/// How many points a window may have that ends somewhere.
class WindowSize {
 public:
  WindowSize(std::span<const gcode::StreamPoint> points, std::size_t most, const WindowCut& cut)
      : m_most(most), m_secondsMax(cut.secondsMax) {
    RIVULET_ASSERT(!points.empty() && most >= 1);
    if (cut.packedAxes > 0) {
      findReach(points, base::Packing(cut.packedAxes));
    }
    if (!(m_secondsMax > 0.0)) {
      return;
    }
    RIVULET_ASSERT(cut.feedMmPerS > 0.0);
    m_reachedS.assign(points.size() + 1, 0.0);
    for (std::size_t i = 1; i < points.size(); ++i) {
      m_reachedS[i + 1] = m_reachedS[i] + moveS(points[i - 1], points[i], cut.feedMmPerS);
    }
  }
  /// Of the points from `begin` to before `end`. One move alone cannot be divided.
  [[nodiscard]] bool fits(std::size_t begin, std::size_t end) const {
    return end - begin <= m_most && (m_reach.empty() || end <= m_reach[begin]) &&
           (m_reachedS.empty() || end - begin <= 1 ||
            m_reachedS[end] - m_reachedS[begin] <= m_secondsMax);
  }

 private:
  void findReach(std::span<const gcode::StreamPoint> points, const base::Packing& packing) {
    m_reach.reserve(points.size());
    for (std::size_t begin = 0; begin < points.size(); ++begin) {
      const std::size_t last = std::min(points.size(), begin + m_most);
      std::size_t end = begin + 1;
      while (end < last && gcode::sharesCell(packing, points[begin], points[end])) {
        ++end;
      }
      m_reach.push_back(end);
    }
  }

  std::size_t m_most;
  double m_secondsMax;
  std::vector<std::size_t> m_reach;  ///< end of the longest window that begins there; empty: any
  std::vector<double> m_reachedS;    ///< after so many points; empty: time does not matter
};

}  // namespace

double moveS(const gcode::StreamPoint& from, const gcode::StreamPoint& to, double feedMmPerS) {
  return base::wayAlongFeed(base::distance(from.positionMm, to.positionMm),
                            base::turnDeg(from.rotaryDeg, to.rotaryDeg)) /
         (to.feedMmPerS > 0.0 ? to.feedMmPerS : feedMmPerS);
}

std::vector<bool> harmlessPauses(std::span<const gcode::StreamPoint> points) {
  std::vector<bool> harmless(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isLast = i + 1 == points.size();
    harmless[i] = isLast || points[i].kind == gcode::MoveKind::Rapid ||
                  (i > 0 && (retracts(points[i - 1], points[i]) ||
                             turns(points[i - 1].positionMm, points[i].positionMm,
                                   points[i + 1].positionMm)));
  }
  return harmless;
}

namespace {

PausePlacement placed(std::span<const gcode::StreamPoint> points, const WindowSize& size,
                      bool feedPerPoint) {
  const std::vector<bool> harmless = harmlessPauses(points);
  RIVULET_ASSERT(points.size() < std::numeric_limits<std::uint32_t>::max());
  // The best way to cut the points before `at`, after the last of them.
  struct Cut {
    std::uint32_t at = 0;
    std::uint32_t inCut = 0;
    std::uint32_t windows = 0;
    [[nodiscard]] auto cost() const { return std::pair(inCut, windows); }
  };
  Cut cut;
  std::vector<std::uint32_t> begins(points.size() + 1);  // of the last window of that way
  // Candidates for the beginning of the next window: the cheapest comes first, then only more
  // expensive ones, for the time when the first is too far back.
  std::deque<Cut> candidates{cut};
  for (std::size_t end = 1; end <= points.size(); ++end) {
    while (!size.fits(candidates.front().at, end)) {
      candidates.pop_front();
    }
    const Cut& from = candidates.front();
    cut = {static_cast<std::uint32_t>(end), from.inCut + (harmless[end - 1] ? 0U : 1U),
           from.windows + 1};
    begins[end] = from.at;
    const bool mustEnd = !feedPerPoint && end < points.size() && changesFeed(points, end);
    while (!candidates.empty() && (mustEnd || candidates.back().cost() > cut.cost())) {
      candidates.pop_back();
    }
    candidates.push_back(cut);
  }
  PausePlacement placement;
  placement.inCut = cut.inCut;
  for (std::size_t end = points.size(); end > 0; end = begins[end]) {
    placement.begins.push_back(begins[end]);
  }
  std::reverse(placement.begins.begin(), placement.begins.end());
  return placement;
}

PausePlacement even(std::span<const gcode::StreamPoint> points, const WindowSize& size,
                    bool feedPerPoint) {
  const std::vector<bool> harmless = harmlessPauses(points);
  PausePlacement placement;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool mustEnd = i > 0 && !feedPerPoint && changesFeed(points, i);
    if (i == 0 || mustEnd || !size.fits(begin, i + 1)) {
      begin = i;
      placement.begins.push_back(begin);
      placement.inCut += begin > 0 && !harmless[begin - 1] ? 1U : 0U;
    }
  }
  return placement;
}

}  // namespace

PausePlacement placePauses(std::span<const gcode::StreamPoint> points, std::size_t pointsPerWindow,
                           bool feedPerPoint) {
  return placed(points, WindowSize(points, pointsPerWindow, {}), feedPerPoint);
}

PausePlacement evenPauses(std::span<const gcode::StreamPoint> points, std::size_t pointsPerWindow,
                          bool feedPerPoint) {
  return even(points, WindowSize(points, pointsPerWindow, {}), feedPerPoint);
}

PausePlacement cutWindows(std::span<const gcode::StreamPoint> points, std::size_t pointsPerWindow,
                          WindowCut cut) {
  const WindowSize size(points, pointsPerWindow, cut);
  return cut.place ? placed(points, size, cut.feedPerPoint) : even(points, size, cut.feedPerPoint);
}

std::vector<PlannedPause> plannedPauses(std::span<const gcode::StreamPoint> points,
                                        base::MethodKind method, std::size_t pointsPerLoop,
                                        WindowCut cut) {
  RIVULET_ASSERT(!points.empty() && pointsPerLoop >= 1);
  const std::vector<bool> harmless = harmlessPauses(points);
  std::vector<PlannedPause> pauses;
  for (const std::size_t next : methodType(method).pausesBefore(points, pointsPerLoop, cut)) {
    if (next > 0 && next < points.size()) {
      pauses.push_back({static_cast<std::uint32_t>(next - 1), !harmless[next - 1]});
    }
  }
  return pauses;
}

std::size_t pausesInCut(std::span<const PlannedPause> pauses) {
  return static_cast<std::size_t>(std::count_if(
      pauses.begin(), pauses.end(), [](const PlannedPause& pause) { return pause.inCut; }));
}

}  // namespace rivulet::streaming
