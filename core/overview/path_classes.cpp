// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overview/path_classes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/contract.h"
#include "feasibility/equations.h"

namespace rivulet::overview {

namespace {

/// For each step the smallest sum of `width` neighbouring steps it belongs to. One pass: the
/// windows that may still be smallest are kept in ascending order.
std::vector<double> shortestWindowOf(const std::vector<double>& stepsMm, std::size_t width) {
  const std::size_t count = stepsMm.size();
  width = std::clamp<std::size_t>(width, 1, std::max<std::size_t>(count, 1));
  std::vector<double> windowMm(count >= width ? count - width + 1 : 0);
  for (std::size_t i = 0; i < windowMm.size(); ++i) {
    // Summed again each time: a running sum loses the short steps after long ones. N is small.
    for (std::size_t k = 0; k < width; ++k) {
      windowMm[i] += stepsMm[i + k];
    }
  }
  std::vector<double> shortest(count);
  std::vector<std::size_t> candidates;  // windows, their sums ascending; the front one is smallest
  std::size_t front = 0;
  for (std::size_t step = 0; step < count; ++step) {
    if (step < windowMm.size()) {
      while (candidates.size() > front && windowMm[candidates.back()] >= windowMm[step]) {
        candidates.pop_back();
      }
      candidates.push_back(step);
    }
    while (candidates[front] + width <= step) {
      ++front;
    }
    shortest[step] = windowMm[candidates[front]];
  }
  return shortest;
}

void separateGaps(PathClasses& classes, const ProgramView& view) {
  if (view.gaps.empty() || classes.ofPoint.empty()) {
    return;
  }
  classes.hasGaps = true;
  for (const ProgramView::Gap& gap : view.gaps) {
    classes.ofPoint[gap.point] = static_cast<std::uint8_t>(classes.count);
  }
  ++classes.count;
}

/// A move that represents several shows the class of the last, or the highest of all.
std::vector<std::uint8_t> coarser(const PathLevel& level, const PathLevel& fine,
                                  const std::vector<std::uint8_t>& fineClasses, bool highest) {
  std::vector<std::uint8_t> classes;
  classes.reserve(level.kept.size());
  std::size_t at = 0;
  for (const std::uint32_t point : level.kept) {
    std::uint8_t shown = 0;
    for (; at < fine.kept.size() && fine.kept[at] <= point; ++at) {
      shown = highest ? std::max(shown, fineClasses[at]) : fineClasses[at];
    }
    classes.push_back(shown);
  }
  return classes;
}

}  // namespace

std::shared_ptr<const DrawnClasses> drawnClasses(PathClasses classes, const ProgramView& view) {
  RIVULET_ASSERT(classes.ofPoint.size() == view.points.points.size());
  auto drawn = std::make_shared<DrawnClasses>();
  separateGaps(classes, view);
  drawn->present.assign(classes.count, false);
  for (const std::uint8_t one : classes.ofPoint) {
    drawn->present[one] = true;
  }
  drawn->ofLevel.push_back(std::move(classes.ofPoint));
  const std::vector<PathLevel>& levels = view.levels.levels();
  for (std::size_t level = 1; level < levels.size(); ++level) {
    drawn->ofLevel.push_back(
        coarser(levels[level], levels[level - 1], drawn->ofLevel.back(), classes.highestWins));
  }
  classes.ofPoint.clear();
  drawn->classes = std::move(classes);
  return drawn;
}

PathClasses classesByKind(const ProgramView& view) {
  PathClasses classes;
  classes.colouring = PathColouring::Kind;
  classes.count = 4;
  const std::vector<gcode::StreamPoint>& points = view.points.points;
  classes.ofPoint.reserve(points.size());
  for (const gcode::StreamPoint& point : points) {
    KindClass shown = KindClass::Line;
    switch (point.kind) {
      case gcode::MoveKind::Rapid:
        shown = KindClass::Rapid;
        break;
      case gcode::MoveKind::Feed:
        break;
      case gcode::MoveKind::Arc:
      case gcode::MoveKind::ArcPiece:
        shown = KindClass::Arc;
        break;
      case gcode::MoveKind::SplinePiece:
        shown = KindClass::Spline;
        break;
    }
    classes.ofPoint.push_back(static_cast<std::uint8_t>(shown));
  }
  return classes;
}

PathClasses classesByFeed(const ProgramView& view) {
  PathClasses classes;
  classes.colouring = PathColouring::Feed;
  const std::vector<gcode::StreamPoint>& points = view.points.points;
  std::vector<float> feeds;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float feed = view.programmedMmPerS(i);
    if (points[i].kind != gcode::MoveKind::Rapid && (feeds.empty() || feeds.back() != feed)) {
      feeds.push_back(feed);
    }
  }
  std::sort(feeds.begin(), feeds.end());
  feeds.erase(std::unique(feeds.begin(), feeds.end()), feeds.end());
  classes.eachFeedItsOwn = feeds.size() <= kFeedClassesMax;
  if (classes.eachFeedItsOwn) {
    classes.borders.assign(feeds.begin(), feeds.end());
    classes.count = feeds.size() + 1;
  } else {
    // A feed of 0 means no feed: it belongs to the lowest class.
    const double lowest = *std::upper_bound(feeds.begin(), feeds.end(), 0.0F);
    const double ratio = feeds.back() / lowest;
    for (std::size_t i = 0; i <= kFeedClassesMax; ++i) {
      classes.borders.push_back(
          lowest * std::pow(ratio, static_cast<double>(i) / static_cast<double>(kFeedClassesMax)));
    }
    classes.count = kFeedClassesMax + 1;
  }
  classes.ofPoint.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t shown = 0;
    if (points[i].kind != gcode::MoveKind::Rapid) {
      const auto above = std::upper_bound(classes.borders.begin(), classes.borders.end(),
                                          static_cast<double>(view.programmedMmPerS(i)));
      shown = std::clamp<std::size_t>(static_cast<std::size_t>(above - classes.borders.begin()), 1,
                                      classes.count - 1);
    }
    classes.ofPoint.push_back(static_cast<std::uint8_t>(shown));
  }
  return classes;
}

std::vector<float> localMargins(const ProgramView& view, const feasibility::OperatingPoint& point,
                                const feasibility::AccessModel& access, bool ownFeeds) {
  const std::vector<gcode::StreamPoint>& points = view.points.points;
  const feasibility::SafetyFactors safety;
  std::vector<float> margins(points.size(), std::numeric_limits<float>::infinity());
  if (points.size() < 2 || !(point.feedMmPerS > 0.0) || point.pointsPerLoop < 2) {
    return margins;
  }
  std::vector<double> stepsMm;
  stepsMm.reserve(points.size() - 1);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double stepMm = base::distance(points[i - 1].positionMm, points[i].positionMm);
    const bool hasOwn = ownFeeds && points[i].feedMmPerS > 0.0;
    stepsMm.push_back(hasOwn ? stepMm * view.fastestMmPerS / points[i].feedMmPerS : stepMm);
  }
  // Both margins are proportional to the length: one evaluation is enough for all.
  double perMm = 0.0;
  const base::Duration accessTime = access.timePerNode(point.turn());
  switch (base::methodTraits(point.method).portion) {
    case base::Portion::Point:
      perMm = feasibility::pointDistanceMargin(
          point.feedMmPerS, feasibility::pollTime(accessTime, point.cellsPerPoint).max, 1.0,
          safety.pointDistance);
      break;
    case base::Portion::HalfLoop:
      perMm = feasibility::realWindowMargin(point.feedMmPerS, accessTime, point.pointsPerLoop, 1.0,
                                            safety.window, point.cellsPerPoint);
      stepsMm = shortestWindowOf(stepsMm, static_cast<std::size_t>(point.pointsPerLoop / 2));
      break;
    case base::Portion::Window:
      perMm = feasibility::reachMargin(point.feedMmPerS, accessTime, point.pointsPerLoop, 1.0,
                                       safety.window, point.cellsPerPoint, point.cellsOfFirst);
      stepsMm = shortestWindowOf(stepsMm, static_cast<std::size_t>(point.pointsPerLoop));
      break;
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    margins[i] = static_cast<float>(stepsMm[i - 1] * perMm);
  }
  return margins;
}

PathClasses classesByMargin(const ProgramView& view, const feasibility::OperatingPoint& point,
                            const feasibility::AccessModel& access, bool ownFeeds) {
  PathClasses classes;
  classes.colouring = PathColouring::Margin;
  classes.count = kMarginClasses;
  classes.highestWins = true;
  classes.borders = {kMarginAmple, kMarginFair, kMarginNone};
  classes.ofPoint.reserve(view.points.points.size());
  for (const float margin : localMargins(view, point, access, ownFeeds)) {
    const bool keeps = static_cast<double>(margin) > kMarginNone;
    classes.ofPoint.push_back(margin >= static_cast<float>(kMarginAmple)  ? 0
                              : margin >= static_cast<float>(kMarginFair) ? 1
                              : keeps                                     ? 2
                                                                          : 3);
  }
  return classes;
}

PathClasses classesByPauses(const ProgramView& view, const PauseMap* pauses) {
  const auto& points = view.points.points;
  PathClasses classes;
  classes.colouring = PathColouring::Pauses;
  classes.count = kPauseClasses + 1;
  classes.highestWins = true;
  classes.ofPoint.assign(points.size(), 0);
  if (pauses == nullptr || pauses->count() == 0) {
    return classes;
  }
  std::vector<std::uint32_t> stops;
  stops.reserve(pauses->count());
  std::merge(pauses->inCut.begin(), pauses->inCut.end(), pauses->offCut.begin(),
             pauses->offCut.end(), std::back_inserter(stops));
  std::vector<double> waysMm(stops.size());  // to each pause from the one before
  double longestMm = 0.0;
  double shortestMm = std::numeric_limits<double>::infinity();
  std::size_t point = 1;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    for (; point <= stops[i] && point < points.size(); ++point) {
      waysMm[i] += base::distance(points[point - 1].positionMm, points[point].positionMm);
    }
    if (waysMm[i] > 0.0) {
      longestMm = std::max(longestMm, waysMm[i]);
      shortestMm = std::min(shortestMm, waysMm[i]);
    }
  }
  if (!(longestMm > 0.0)) {
    return classes;
  }
  const double ratio = std::pow(shortestMm / longestMm, 1.0 / kPauseClasses);
  for (std::size_t i = 0; i <= kPauseClasses; ++i) {
    classes.borders.push_back(longestMm * std::pow(ratio, static_cast<double>(i)));
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const double depth =
        ratio < 1.0 && waysMm[i] > 0.0 ? std::log(waysMm[i] / longestMm) / std::log(ratio) : 0.0;
    const auto one = static_cast<std::uint8_t>(
        1 + std::min(static_cast<std::size_t>(std::max(0.0, depth)), kPauseClasses - 1));
    const std::size_t end = std::min<std::size_t>(stops[i] + 1, points.size());
    std::fill(classes.ofPoint.begin() + static_cast<std::ptrdiff_t>(begin),
              classes.ofPoint.begin() + static_cast<std::ptrdiff_t>(end), one);
    begin = end;
  }
  return classes;
}

PathClasses classesByTime(const std::vector<float>& atS) {
  PathClasses classes;
  classes.colouring = PathColouring::Time;
  classes.count = kTimeClasses;
  const double total = atS.empty() ? 0.0 : atS.back();
  for (std::size_t i = 0; i <= kTimeClasses; ++i) {
    classes.borders.push_back(total * static_cast<double>(i) / static_cast<double>(kTimeClasses));
  }
  classes.ofPoint.reserve(atS.size());
  for (const float at : atS) {
    const double share = total > 0.0 ? at / total : 0.0;
    classes.ofPoint.push_back(static_cast<std::uint8_t>(
        std::min(static_cast<std::size_t>(share * kTimeClasses), kTimeClasses - 1)));
  }
  return classes;
}

}  // namespace rivulet::overview
