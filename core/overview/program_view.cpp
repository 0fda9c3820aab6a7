// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overview/program_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "base/axes.h"
#include "base/contract.h"
#include "base/text.h"
#include "overview/path_classes.h"

namespace rivulet::overview {

namespace {

constexpr std::size_t kSmallestShown = 200;

/// The smallest ones of any number of values.
class Smallest {
 public:
  void take(double value) {
    if (m_values.size() < kSmallestShown) {
      m_values.push_back(value);
      std::push_heap(m_values.begin(), m_values.end());
    } else if (value < m_values.front()) {
      std::pop_heap(m_values.begin(), m_values.end());
      m_values.back() = value;
      std::push_heap(m_values.begin(), m_values.end());
    }
  }
  [[nodiscard]] std::vector<double> ascending() && {
    std::sort_heap(m_values.begin(), m_values.end());
    return std::move(m_values);
  }

 private:
  std::vector<double> m_values;  ///< a heap, the largest in front
};

void takeDistances(ProgramView& view) {
  const std::vector<gcode::StreamPoint>& points = view.points.points;
  Smallest distances;
  Smallest timed;
  auto gap = view.gaps.begin();
  for (std::size_t i = 1; i < points.size(); ++i) {
    base::Vec3 fromMm = points[i - 1].positionMm;
    if (gap != view.gaps.end() && gap->point == i) {
      fromMm = gap->isKnown() ? gap->fromMm : points[i].positionMm;
      ++gap;
    }
    const double distance = base::distance(fromMm, points[i].positionMm);
    if (distance > 0.0) {  // else only rotary axes turn
      distances.take(distance);
      const double feedMmPerS = points[i].feedMmPerS;
      timed.take(feedMmPerS > 0.0 ? distance * view.fastestMmPerS / feedMmPerS : distance);
    }
    switch (points[i].kind) {
      case gcode::MoveKind::Rapid:
        view.lengths.rapidMm += distance;
        break;
      case gcode::MoveKind::Feed:
        view.lengths.lineMm += distance;
        break;
      case gcode::MoveKind::ArcPiece:
      case gcode::MoveKind::Arc:
        view.lengths.arcMm += distance;
        break;
      case gcode::MoveKind::SplinePiece:
        view.lengths.splineMm += distance;
        break;
    }
  }
  view.smallestDistancesMm = std::move(distances).ascending();
  view.smallestTimedMm = std::move(timed).ascending();
}

/// The number of X, Y or Z in a native block, mm; NaN: there is none.
double namedMm(const job::NativeBlock& native, std::size_t axis) {
  const std::string_view text = std::string_view(native.text).substr(0, native.text.find(';'));
  for (std::size_t at = text.find(base::kAxisNames[axis]); at != std::string_view::npos;
       at = text.find(base::kAxisNames[axis], at + 1)) {
    std::size_t begin = at + 1;
    begin += begin < text.size() && text[begin] == '=' ? 1 : 0;
    const std::size_t end = std::min(text.find_first_not_of("+-.0123456789", begin), text.size());
    const auto number = base::parseNumber(text.substr(begin, end - begin));
    const bool isWord = at == 0 || text[at - 1] == ' ' || text[at - 1] == '\t' ||
                        (text[at - 1] >= '0' && text[at - 1] <= '9') || text[at - 1] == '.';
    if (isWord && number) {
      return *number * native.before.lengthFactor;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Follows what native blocks name, for the picture alone: the run begins each stretch where the
/// control says.
class NamedPlace {
 public:
  void take(const job::NativeBlock& native) {
    using job::NativeReason;
    const bool forgets = job::rowOf(native.reason).after == job::PositionAfter::ControlOnly;
    const bool counts = native.reason != NativeReason::Retract && native.frame.empty();
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (native.places[axis] || native.increments[axis] ||
          (forgets && native.reason != NativeReason::Cycle &&
           native.reason != NativeReason::Retract)) {
        placeMm.set(axis, native.places[axis] && counts ? namedMm(native, axis)
                                                        : std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
  base::Vec3 placeMm{std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::quiet_NaN()};
};

/// The path of a job with coordinates that are only named by native blocks. Nothing: it has all.
std::optional<gcode::Trajectory> withNamedPlaces(const job::Plan& plan,
                                                 std::vector<base::Vec3>& startsMm) {
  std::optional<gcode::Trajectory> filled;
  NamedPlace named;
  for (const job::Part& part : plan.parts) {
    if (const auto* native = std::get_if<job::NativeBlock>(&part)) {
      named.take(*native);
      continue;
    }
    const auto& stretch = std::get<job::Stretch>(part);
    if (stretch.number == 0) {
      continue;
    }
    base::Vec3 startMm = stretch.startMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (std::isnan(startMm[axis])) {
        startMm.set(axis, named.placeMm[axis]);
      }
    }
    startsMm.push_back(startMm);
    for (std::size_t i = stretch.firstPoint; i < stretch.firstPoint + stretch.pointCount; ++i) {
      const base::Vec3& programmedMm = plan.program.trajectory.points[i].positionMm;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (std::isnan(programmedMm[axis]) && !std::isnan(startMm[axis])) {
          if (!filled) {
            filled = plan.program.trajectory;
          }
          filled->points[i].positionMm.set(axis, startMm[axis]);
        }
      }
      if (base::isFinite(programmedMm)) {
        break;  // and so are all after it
      }
    }
    named.placeMm =
        plan.program.trajectory.points[stretch.firstPoint + stretch.pointCount - 1].positionMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (std::isnan(named.placeMm[axis])) {
        named.placeMm.set(axis, startMm[axis]);
      }
    }
  }
  return filled;
}

/// Where the path of a job is interrupted, and with which tool it goes on.
void takeStretches(ProgramView& view, const std::vector<base::Vec3>& startsMm) {
  constexpr double kSamePlaceMm = 1e-6;
  const std::vector<gcode::StreamPoint>& points = view.points.points;
  std::string tool;
  for (const job::Part& part : view.plan->parts) {
    if (const auto* native = std::get_if<job::NativeBlock>(&part)) {
      if (std::string selected = toolOf(*native); !selected.empty()) {
        tool = std::move(selected);
      }
      continue;
    }
    const auto& stretch = std::get<job::Stretch>(part);
    if (stretch.number == 0) {
      continue;
    }
    // A point that repeats the one before it is not streamed: the next one stands for it.
    const auto first =
        std::lower_bound(view.trajectoryIndices.begin(), view.trajectoryIndices.end(),
                         static_cast<std::uint32_t>(stretch.firstPoint));
    const auto point = static_cast<std::uint32_t>(std::min<std::ptrdiff_t>(
        first - view.trajectoryIndices.begin(), static_cast<std::ptrdiff_t>(points.size()) - 1));
    view.stretchStarts.push_back(point);
    base::Vec3 startMm = startsMm[view.stretchStarts.size() - 1];
    if (std::isfinite(startMm.x) && std::isfinite(startMm.y) && std::isnan(startMm.z)) {
      startMm.z = points[point].positionMm.z;  // seen from above it is known
    }
    const bool isThere = point > 0 && base::isFinite(startMm) &&
                         base::distance(points[point - 1].positionMm, startMm) <= kSamePlaceMm;
    if (point > 0 && !isThere && (view.gaps.empty() || view.gaps.back().point != point)) {
      view.gaps.push_back({point, startMm});
    }
    if (!tool.empty()) {
      const bool hasOwn = view.trajectoryIndices[point] < stretch.firstPoint + stretch.pointCount;
      view.toolChanges.push_back(
          {hasOwn || point == 0 ? point : point - 1, std::exchange(tool, {})});
    }
  }
}

void orderByLine(ProgramView& view) {
  const std::vector<gcode::StreamPoint>& points = view.points.points;
  const auto earlier = [](const gcode::StreamPoint& a, const gcode::StreamPoint& b) {
    return a.line < b.line;
  };
  if (std::is_sorted(points.begin(), points.end(), earlier)) {
    return;
  }
  view.byLine.resize(points.size());
  std::iota(view.byLine.begin(), view.byLine.end(), 0U);
  std::stable_sort(view.byLine.begin(), view.byLine.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return earlier(points[a], points[b]); });
}

std::optional<std::pair<double, double>> cuttingFeeds(const ProgramView& view) {
  std::optional<std::pair<double, double>> range;
  for (std::size_t i = 0; i < view.points.points.size(); ++i) {
    const double feed = view.programmedMmPerS(i);
    if (feed > 0.0 && view.points.points[i].kind != gcode::MoveKind::Rapid) {
      range = range ? std::pair(std::min(range->first, feed), std::max(range->second, feed))
                    : std::pair(feed, feed);
    }
  }
  return range;
}

}  // namespace

std::vector<std::uint32_t> ProgramView::pointsOfLine(base::LineNumber line) const {
  std::vector<std::uint32_t> found;
  const std::vector<gcode::StreamPoint>& list = points.points;
  const auto indexAt = [&](std::size_t i) {
    return byLine.empty() ? static_cast<std::uint32_t>(i) : byLine[i];
  };
  std::size_t low = 0;
  std::size_t high = list.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (list[indexAt(middle)].line < line) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  for (; low < list.size() && list[indexAt(low)].line == line; ++low) {
    found.push_back(indexAt(low));
  }
  return found;
}

std::shared_ptr<const ProgramView> makeProgramView(std::shared_ptr<const gcode::Program> program,
                                                   base::Vec3 startMm, int pointsPerLoop,
                                                   const std::function<bool(double)>& progress,
                                                   const std::optional<gcode::ProgramFeeds>& feeds,
                                                   std::shared_ptr<const job::Plan> plan) {
  RIVULET_ASSERT(program != nullptr);
  const auto goesOn = [&](double share) { return !progress || progress(share); };
  auto view = std::make_shared<ProgramView>();
  view->program = std::move(program);
  view->startMm = startMm;
  view->feeds = feeds;
  if (plan) {
    view->plan = std::move(plan);
    view->outline = JobOutline(view->plan);
  }
  std::vector<base::Vec3> startsMm;
  const std::optional<gcode::Trajectory> filled =
      view->isJob() ? withNamedPlaces(*view->plan, startsMm) : std::nullopt;
  const gcode::Trajectory& path = filled ? *filled : view->program->trajectory;
  view->trajectoryIndices.reserve(path.points.size());
  view->points =
      gcode::streamPoints(path, startMm, {}, feeds ? &*feeds : nullptr, &view->trajectoryIndices);
  for (const gcode::StreamPoint& point : view->points.points) {
    view->fastestMmPerS = std::max(view->fastestMmPerS, point.feedMmPerS);
  }
  view->cuttingMmPerS = cuttingFeeds(*view);
  view->lineWithoutFeed = gcode::lineWithoutFeed(view->program->trajectory);
  view->turnedAxes = gcode::turnedAxes(view->program->trajectory);
  view->dependsOnStart = std::any_of(
      path.points.begin(), path.points.end(),
      [](const gcode::TrajectoryPoint& point) { return !base::isFinite(point.positionMm); });
  if (!goesOn(0.1)) {
    return nullptr;
  }
  if (view->isJob() && !view->points.points.empty()) {
    takeStretches(*view, startsMm);
  }
  view->text = TextIndex(view->program->text);
  takeDistances(*view);
  orderByLine(*view);
  if (!goesOn(0.3)) {
    return nullptr;
  }
  if (view->points.points.size() >= 2) {
    if (feasibility::hasDistances(view->points)) {
      view->statistics = feasibility::pathStatistics(view->points);
    }
    view->distancesFor = pointsPerLoop;
    view->distances = feasibility::programDistances(view->points.points, pointsPerLoop);
    view->timedDistances =
        feasibility::programDistances(view->points.points, pointsPerLoop, view->fastestMmPerS);
  }
  if (!goesOn(0.5)) {
    return nullptr;
  }
  std::vector<bool> isRapid(view->points.points.size());
  std::transform(
      view->points.points.begin(), view->points.points.end(), isRapid.begin(),
      [](const gcode::StreamPoint& point) { return point.kind == gcode::MoveKind::Rapid; });
  bool goOn = true;
  view->levels = PathLevels(view->points.points, isRapid, [&] { return goOn = goesOn(0.6); });
  if (!goOn || !goesOn(1.0)) {
    return nullptr;
  }
  view->kinds = drawnClasses(classesByKind(*view), *view);
  return view;
}

}  // namespace rivulet::overview
