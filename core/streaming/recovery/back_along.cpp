// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/recovery/back_along.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "base/contract.h"
#include "streaming/control/control_axes.h"

namespace rivulet::streaming {

namespace {

using base::AxisPosition;
using base::Result;

/// Each of its moves is compared with all others.
constexpr std::size_t kMovesMax = 3000;
/// Two places nearer than this are told apart by nobody, see `pointAhead`.
constexpr double kSameMm = 0.05;
/// A tool this near to a place stands there.
constexpr double kStandsMm = 1e-3;
/// A path that comes back after more than this has passed a place twice.
constexpr double kAwayMm = 0.06;
/// Two moves of which the second goes back on the first: the cosine of what is left of the turn.
constexpr double kBackCosine = 0.996;  // 5 degrees

AxisPosition between(const AxisPosition& a, const AxisPosition& b, double share) {
  AxisPosition place{a.mm + share * (b.mm - a.mm), a.deg};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    place.deg[axis] += share * (b.deg[axis] - a.deg[axis]);
  }
  return place;
}

/// The axes as a space in which a degree counts as a millimetre, as in `pointAhead`.
using Way = std::array<double, base::kAxisCount + base::kRotaryAxisCount>;

Way wayOf(const AxisPosition& from, const AxisPosition& to) {
  const base::Vec3 mm = to.mm - from.mm;
  return {
      mm.x, mm.y, mm.z, to.deg[0] - from.deg[0], to.deg[1] - from.deg[1], to.deg[2] - from.deg[2]};
}

double dot(const Way& a, const Way& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

double length(const AxisPosition& from, const AxisPosition& to) {
  const Way way = wayOf(from, to);
  return std::sqrt(dot(way, way));
}

/// Smallest distance of a place from a straight move.
double distance(const AxisPosition& place, const AxisPosition& from, const AxisPosition& to) {
  const Way way = wayOf(from, to);
  const double square = dot(way, way);
  const double share =
      square > 0.0 ? std::clamp(dot(wayOf(from, place), way) / square, 0.0, 1.0) : 0.0;
  return length(place, between(from, to, share));
}

/// Smallest distance of two straight moves: where the lines are nearest, or at an end of one.
double distance(const AxisPosition& a, const AxisPosition& b, const AxisPosition& c,
                const AxisPosition& d) {
  double least =
      std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
  const Way u = wayOf(a, b);
  const Way v = wayOf(c, d);
  const Way w = wayOf(c, a);
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double det = uu * vv - uv * uv;
  if (det > 1e-12 * uu * vv) {
    const double s = (uv * dot(v, w) - vv * dot(u, w)) / det;
    const double t = (uu * dot(v, w) - uv * dot(u, w)) / det;
    if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
      least = std::min(least, length(between(a, b, s), between(c, d, t)));
    }
  }
  return least;
}

/// What the way back must not cross: between this point of the list and the one before it, the
/// machine does something.
struct Barrier {
  std::size_t point = 0;
  std::string what;
};

/// The last one before the move to point `next` has been finished.
Barrier barrierBefore(const gcode::Trajectory& trajectory,
                      const std::vector<std::uint32_t>& indices,
                      std::span<const gcode::StreamPoint> points, std::size_t next) {
  // Nobody has programmed the way to the first point.
  Barrier barrier{1, fmt::format("the path begins in line {}", points.front().line.value)};
  for (const gcode::PathEvent& event : trajectory.events) {
    const auto point = static_cast<std::size_t>(
        std::lower_bound(indices.begin(), indices.end(), event.point) - indices.begin());
    if (point > next || event.kind == gcode::PathEvent::Kind::Dwell) {
      continue;
    }
    if (point >= barrier.point) {
      barrier = {point, fmt::format("the machine changes its tool or another function in line {}",
                                    event.line.value)};
    }
  }
  for (std::size_t i = next + 1; i-- > barrier.point - 1;) {
    if (points[i].kind == gcode::MoveKind::Rapid) {
      return {i + 1, fmt::format("a rapid ends in line {}", points[i].line.value)};
    }
  }
  return barrier;
}

/// Nothing: no place of the path is passed twice. @param path  one place more than moves
std::optional<std::size_t> movePassedTwice(const std::vector<AxisPosition>& path) {
  std::vector<double> reachedMm{0.0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    reachedMm.push_back(reachedMm.back() + length(path[i - 1], path[i]));
  }
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (std::size_t j = i + 1; j < path.size(); ++j) {
      if (j == i + 1) {
        const Way in = wayOf(path[i - 1], path[i]);
        const Way out = wayOf(path[i], path[j]);
        if (dot(in, out) < -kBackCosine * std::sqrt(dot(in, in) * dot(out, out))) {
          return i;
        }
      } else if (reachedMm[j - 1] - reachedMm[i] > kAwayMm &&
                 distance(path[i - 1], path[i], path[j - 1], path[j]) <= kSameMm) {
        return i;
      }
    }
  }
  return std::nullopt;
}

/// @param placeOf  of each point  @param within  these moves  @param mostMm  length of the way
BackWay walkBack(const std::function<AxisPosition(std::size_t)>& placeOf, const AxisPosition& tool,
                 const BackPart& within, double mostMm) {
  BackWay way;
  way.part = within;
  AxisPosition from = tool;
  for (std::size_t i = within.next; i >= within.first; --i) {
    const AxisPosition to = placeOf(i - 1);
    const double moveMm = base::distance(from.mm, to.mm);
    const double leftMm = mostMm - way.lengthMm;
    way.part.first = i;
    if (moveMm >= leftMm) {
      way.places.push_back(between(from, to, leftMm / moveMm));
      way.lengthMm += leftMm;
      break;
    }
    if (length(from, to) > kStandsMm) {
      way.places.push_back(to);
      way.lengthMm += moveMm;
    }
    if (way.places.size() > kMovesMax) {
      break;
    }
    from = to;
  }
  return way;
}

tl::unexpected<base::Error> no(std::string why) {
  return base::fail(StreamError::CannotResume, std::move(why));
}

}  // namespace

Result<BackWay> backAlong(const gcode::Program& program, const RunSettings& settings,
                          const Checkpoint& last, std::size_t next, AxisPosition tool,
                          const BackWish& wish) {
  RIVULET_ASSERT(!wish.mm || *wish.mm > 0.0);
  const Result<gcode::PointList> list =
      pointsOnAxes(program.trajectory, settings.parameters, {last.startMm, last.startDeg},
                   settings.programFeeds);
  if (!list) {
    return base::fail(list.error());
  }
  const std::vector<gcode::StreamPoint>& points = list->points;
  std::vector<std::uint32_t> indices;
  (void)gcode::streamPoints(program.trajectory, last.startMm, last.startDeg, nullptr, &indices);
  if (next == 0 || next >= points.size()) {
    return no("There is no way back: the run has executed nothing, or all of it.");
  }
  if (settings.parameters.correctionLimitMm > 0.0) {
    return no("The run has an online correction: there is no way back along its path.");
  }
  // Axes that are not streamed may be anywhere.
  const auto streamed = [&](AxisPosition place) {
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      place.deg[axis] = settings.parameters.rotaryAxes[axis] ? place.deg[axis] : 0.0;
    }
    return place;
  };
  const auto placeOf = [&](std::size_t i) {
    return streamed({points[i].positionMm, points[i].rotaryDeg});
  };
  tool = streamed(tool);
  if (distance(tool, placeOf(next - 1), placeOf(next)) > kSameMm) {
    return no(
        fmt::format("The tool is not on the path of the run, between the points of lines {} and "
                    "{}: move it there first.",
                    points[next - 1].line.value, points[next].line.value));
  }
  const Barrier barrier = barrierBefore(program.trajectory, indices, points, next);
  if (barrier.point > next) {
    return no(fmt::format("There is no way back from here: {}.", barrier.what));
  }
  if (!wish.mm && points[barrier.point - 1].kind != gcode::MoveKind::Rapid) {
    return no(fmt::format("There is no rapid to go back to: {}. Give a length.", barrier.what));
  }
  const BackWay way = walkBack(placeOf, tool, {barrier.point, next}, wish.mm.value_or(HUGE_VAL));
  if (way.places.size() > kMovesMax) {
    return no(fmt::format("The way back has more than {} moves: choose a shorter one.", kMovesMax));
  }
  constexpr double kRoundingMm = 1e-6;
  if (wish.mm && way.lengthMm < *wish.mm - kRoundingMm) {
    return no(fmt::format("Only {:.3f} mm can be driven back: {}.", way.lengthMm, barrier.what));
  }
  if (way.places.empty()) {
    return no(fmt::format("The tool stands there already: {}.", barrier.what));
  }
  std::vector<AxisPosition> path;
  for (std::size_t i = way.part.first - 1; i <= next; ++i) {
    path.push_back(placeOf(i));
  }
  if (const auto twice = movePassedTwice(path)) {
    return no(
        fmt::format("The way back passes a place twice, on the move of line {}: afterwards "
                    "nobody could tell where the run goes on. Choose a shorter way.",
                    points[way.part.first + *twice - 1].line.value));
  }
  return way;
}

gcode::Program backProgram(const BackWay& way, const base::RotarySet& rotaryAxes) {
  std::string text = "G90 G710 G1\n";
  for (const AxisPosition& place : way.places) {
    text += fmt::format("X{:.6f} Y{:.6f} Z{:.6f}", place.mm.x, place.mm.y, place.mm.z);
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (rotaryAxes[axis]) {
        text += fmt::format(" {}{:.6f}", base::kRotaryAxisNames[axis], place.deg[axis]);
      }
    }
    text += '\n';
  }
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  auto program = gcode::interpretProgram("BACK", text + "M30\n", options);
  RIVULET_ASSERT(program.has_value());
  return std::move(*program);
}

}  // namespace rivulet::streaming
