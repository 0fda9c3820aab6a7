// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/thinning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "base/axes.h"
#include "base/contract.h"
#include "base/packing.h"

namespace rivulet::gcode {

namespace {

using base::Vec3;

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Corners of the program stay where they are: an arc in steps of a third of its radius still
/// counts as a curve.
constexpr double kCornerDeg = 30.0;
/// Moves that are merged into one, at most: what bounds the work, and what one move leaves out.
constexpr std::size_t kMergedMax = 128;

/// Directions from a place in which a ray passes all the balls round the places after it; at least
/// these, as a box in the plane that stands on the first direction. Exact where the path is plane.
class Wedge {
 public:
  Wedge(Vec3 from, double radius) : m_from(from), m_radius(radius) {}

  [[nodiscard]] bool contains(Vec3 place) const {
    if (!m_hasFrame) {
      return true;
    }
    const Vec3 way = place - m_from;
    const double ahead = base::dot(way, m_ahead);
    return ahead > 0.0 && isIn(base::dot(way, m_side[0]), ahead, 0) &&
           isIn(base::dot(way, m_side[1]), ahead, 1);
  }

  /// @return false: no direction is left
  bool narrow(Vec3 place) {
    const Vec3 way = place - m_from;
    if (!m_hasFrame) {
      const double far = base::norm(way);
      if (!(far > 2.0 * m_radius)) {
        return true;
      }
      m_ahead = (1.0 / far) * way;
      const Vec3 other = std::abs(m_ahead.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0};
      const Vec3 across = base::cross(other, m_ahead);
      m_side[0] = (1.0 / base::norm(across)) * across;
      m_side[1] = base::cross(m_ahead, m_side[0]);
      m_hasFrame = true;
    }
    const double ahead = base::dot(way, m_ahead);
    return ahead <= m_radius || (narrowSide(base::dot(way, m_side[0]), ahead, 0) &&
                                 narrowSide(base::dot(way, m_side[1]), ahead, 1));
  }

 private:
  [[nodiscard]] bool isIn(double side, double ahead, std::size_t which) const {
    return side >= m_least[which] * ahead && side <= m_most[which] * ahead;
  }
  /// The tangents of a circle, as slopes.
  bool narrowSide(double side, double ahead, std::size_t which) {
    const double below = ahead * ahead - m_radius * m_radius;
    const double root = m_radius * std::sqrt(below + side * side);
    m_least[which] = std::max(m_least[which], (side * ahead - root) / below);
    m_most[which] = std::min(m_most[which], (side * ahead + root) / below);
    return m_least[which] <= m_most[which];
  }

  Vec3 m_from;
  double m_radius;
  Vec3 m_ahead;
  std::array<Vec3, 2> m_side;
  std::array<double, 2> m_least{-kUnbounded, -kUnbounded};
  std::array<double, 2> m_most{kUnbounded, kUnbounded};
  bool m_hasFrame = false;
};

/// Shares of a move.
struct Span {
  double least = 0.0;
  double most = 1.0;
};

/// The part of a move that is not farther than the tolerance from a place; empty: none is.
/// @param way  of the move  @param to  the place, from the begin of the move
Span partNear(Vec3 way, Vec3 to, double tolerance) {
  constexpr Span kEmpty{1.0, 0.0};
  const double squares = base::dot(way, way);
  if (squares == 0.0) {
    return base::norm(to) <= tolerance ? Span{} : kEmpty;
  }
  const double middle = base::dot(to, way) / squares;
  const Vec3 off = to - middle * way;
  const double left = tolerance * tolerance - base::dot(off, off);
  if (left < 0.0) {
    return kEmpty;
  }
  const double half = std::sqrt(left / squares);
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

/// The fewest points. A move may take the place of those between two points if the Fréchet distance
/// of the two is within the tolerance: going along both, never back, one can stay so near. The
/// shortest way over such moves is found from the front.
class Thinner {
 public:
  Thinner(const Trajectory& trajectory, const Tolerance& tolerance)
      : m_trajectory(trajectory),
        m_tolerance(tolerance),
        // Rounding must not make more of it.
        m_near(tolerance.value * (1.0 - 1e-9)),
        m_hasRotary(!trajectory.rotary.empty()),
        m_keep(trajectory.points.size()) {}

  ThinnedTrajectory run() {
    const std::size_t count = m_keep.size();
    if (count > 0) {
      takePlaces();
      markFixed();
      std::size_t from = 0;
      for (std::size_t to = 1; to < count; ++to) {
        if (m_keep[to]) {
          thinBetween(from, to);
          from = to;
        }
      }
    }
    return collect();
  }

 private:
  /// An axis that is not known stands still until the program names it; the point where it does
  /// stays, and so do those beside it.
  void takePlaces() {
    const std::vector<TrajectoryPoint>& points = m_trajectory.points;
    m_mm.resize(points.size());
    m_deg.resize(m_hasRotary ? points.size() : 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const double mm = points[i].positionMm[axis];
        m_mm[i].set(axis, std::isnan(mm) ? 0.0 : mm);
      }
      for (std::size_t axis = 0; m_hasRotary && axis < base::kRotaryAxisCount; ++axis) {
        const double deg = m_trajectory.rotary[i].degrees[axis];
        m_deg[i].set(axis, std::isnan(deg) ? 0.0 : deg);
      }
    }
  }

  /// Ends of stretches within which points may be left out.
  void markFixed() {
    const std::vector<TrajectoryPoint>& points = m_trajectory.points;
    m_keep.front() = m_keep.back() = true;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const TrajectoryPoint& here = points[i];
      const TrajectoryPoint& next = points[i + 1];
      const bool jumps = knowsOther(i);
      if (jumps || here.kind == MoveKind::Rapid || here.kind == MoveKind::Arc ||
          here.kind != next.kind || here.feedMmPerS != next.feedMmPerS) {
        m_keep[i] = true;
      }
      m_keep[i + 1] = m_keep[i + 1] || jumps;
    }
    for (const PathEvent& event : m_trajectory.events) {
      if (event.point > 0 && event.point <= points.size()) {
        m_keep[event.point - 1] = true;
      }
    }
    markCorners();
  }

  /// An axis is named first, or the tool is turned by its direction.
  [[nodiscard]] bool knowsOther(std::size_t i) const {
    bool differs = !m_trajectory.toolDirections.empty() &&
                   m_trajectory.toolDirections[i] != m_trajectory.toolDirections[i + 1];
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      differs = differs || std::isnan(m_trajectory.points[i].positionMm[axis]) !=
                               std::isnan(m_trajectory.points[i + 1].positionMm[axis]);
    }
    for (std::size_t axis = 0; m_hasRotary && axis < base::kRotaryAxisCount; ++axis) {
      differs = differs || std::isnan(m_trajectory.rotary[i].degrees[axis]) !=
                               std::isnan(m_trajectory.rotary[i + 1].degrees[axis]);
    }
    return differs;
  }

  /// Where the direction changes by much, and where a feed in degrees follows one in millimetres.
  void markCorners() {
    const double most = std::cos(kCornerDeg * kRadPerDeg);
    std::optional<std::size_t> last;  // the end of the last move that leads anywhere
    for (std::size_t i = 1; i < m_mm.size(); ++i) {
      const bool isMove = m_mm[i] != m_mm[i - 1] || degBetween(i - 1, i) != Vec3{};
      if (!isMove) {
        continue;
      }
      if (last) {
        const Vec3 before = m_mm[*last] - m_mm[*last - 1];
        const Vec3 then = m_mm[i] - m_mm[i - 1];
        const bool isCorner =
            base::dot(before, then) < most * base::norm(before) * base::norm(then);
        if (isCorner || isInDegrees(*last - 1, *last) != isInDegrees(i - 1, i)) {
          m_keep[i - 1] = true;
        }
      }
      last = i;
    }
  }

  [[nodiscard]] Vec3 degBetween(std::size_t from, std::size_t to) const {
    return m_hasRotary ? m_deg[to] - m_deg[from] : Vec3{};
  }
  [[nodiscard]] bool isInDegrees(std::size_t from, std::size_t to) const {
    return base::distance(m_mm[from], m_mm[to]) * base::kDegPerMmMax <
           base::norm(degBetween(from, to));
  }

  /// All points that one move more leads to, until the last one is among them.
  void thinBetween(std::size_t first, std::size_t last) {
    const std::size_t count = last - first + 1;
    m_before.assign(count, kNowhere);
    m_reached.assign(1, 0);
    m_known = 1;
    while (m_before[count - 1] == kNowhere) {
      m_next.clear();
      // From the farthest, which leaves the least to do for the others.
      std::sort(m_reached.begin(), m_reached.end(), std::greater<>());
      for (const std::size_t i : m_reached) {
        reachFrom(first, i, std::min(count, i + 1 + kMergedMax));
      }
      m_reached.swap(m_next);
    }
    for (std::size_t at = count - 1; at > 0; at = m_before[at]) {
      m_keep[first + at] = true;
    }
  }

  void reachFrom(std::size_t first, std::size_t i, std::size_t end) {
    while (m_known < m_before.size() && m_before[m_known] != kNowhere) {
      ++m_known;
    }
    if (end <= m_known) {
      return;
    }
    Wedge linear(ends(m_mm[first + i]), m_tolerance.value);
    Wedge rotary(m_hasRotary ? ends(m_deg[first + i]) : Vec3{}, m_tolerance.value);
    for (std::size_t j = i + 1; j < end; ++j) {
      const Vec3 mm = m_mm[first + j];
      const Vec3 deg = m_hasRotary ? m_deg[first + j] : Vec3{};
      if (m_before[j] == kNowhere &&
          (j == i + 1 || (linear.contains(ends(mm)) && rotary.contains(ends(deg)) &&
                          isNear(first + i, first + j)))) {
        m_before[j] = i;
        m_next.push_back(j);
      }
      if (!linear.narrow(mm) || !rotary.narrow(deg)) {
        return;
      }
    }
  }

  /// Where a move begins or ends.
  [[nodiscard]] Vec3 ends(Vec3 place) const {
    for (std::size_t axis = 0; m_tolerance.onSteps && axis < base::kAxisCount; ++axis) {
      place.set(axis, base::Packing::rounded(place[axis]));
    }
    return place;
  }

  /// One move for all between the two: no farther than the tolerance, in order, and none of them is
  /// passed against its direction.
  [[nodiscard]] bool isNear(std::size_t from, std::size_t to) const {
    const Vec3 beginMm = ends(m_mm[from]);
    const Vec3 wayMm = ends(m_mm[to]) - beginMm;
    const Vec3 beginDeg = m_hasRotary ? ends(m_deg[from]) : Vec3{};
    const Vec3 wayDeg = m_hasRotary ? ends(m_deg[to]) - beginDeg : Vec3{};
    if ((wayMm == Vec3{} && wayDeg == Vec3{}) || isInDegrees(from, to) != isInDegrees(to - 1, to)) {
      return false;
    }
    double reached = 0.0;
    for (std::size_t i = from; i <= to; ++i) {
      Span part = partNear(wayMm, m_mm[i] - beginMm, m_near);
      if (m_hasRotary) {
        const Span turned = partNear(wayDeg, m_deg[i] - beginDeg, m_near);
        part = {std::max(part.least, turned.least), std::min(part.most, turned.most)};
      }
      reached = std::max(reached, i == to ? 1.0 : part.least);
      const bool isBegin = i == from;
      if (part.least > part.most || reached > part.most || (isBegin && part.least > 0.0) ||
          (!isBegin && base::dot(m_mm[i] - m_mm[i - 1], wayMm) < 0.0)) {
        return false;
      }
    }
    return true;
  }

  ThinnedTrajectory collect() {
    ThinnedTrajectory thinned;
    Trajectory& out = thinned.trajectory;
    std::size_t event = 0;
    std::size_t arc = 0;
    for (std::size_t i = 0; i < m_keep.size(); ++i) {
      if (!m_keep[i]) {
        ++thinned.leftOut;
        continue;
      }
      for (; event < m_trajectory.events.size() && m_trajectory.events[event].point <= i; ++event) {
        out.events.push_back(m_trajectory.events[event]);
        out.events.back().point = out.points.size();
      }
      for (; arc < m_trajectory.arcs.size() && m_trajectory.arcs[arc].point <= i; ++arc) {
        out.arcs.push_back(m_trajectory.arcs[arc]);
        out.arcs.back().point = out.points.size();
      }
      out.points.push_back(m_trajectory.points[i]);
      if (m_hasRotary) {
        out.rotary.push_back(m_trajectory.rotary[i]);
      }
      if (!m_trajectory.toolDirections.empty()) {
        out.toolDirections.push_back(m_trajectory.toolDirections[i]);
      }
    }
    for (; event < m_trajectory.events.size(); ++event) {
      out.events.push_back(m_trajectory.events[event]);
      out.events.back().point = out.points.size();
    }
    out.toolNames = m_trajectory.toolNames;
    return thinned;
  }

  const Trajectory& m_trajectory;
  Tolerance m_tolerance;
  double m_near;
  bool m_hasRotary;
  std::vector<char> m_keep;
  std::vector<Vec3> m_mm;
  std::vector<Vec3> m_deg;
  // Of a stretch: the point before each, those of the same number of moves and of one more, and
  // how many of the first ones are known.
  std::vector<std::size_t> m_before;
  std::vector<std::size_t> m_reached;
  std::vector<std::size_t> m_next;
  std::size_t m_known = 0;
};

struct Way {
  double mm = 0.0;
  double deg = 0.0;
};

/// Of the move to point `i`. Nothing: an axis that moves is not known to stand anywhere before, or
/// the move is an arc kept whole.
std::optional<Way> wayTo(const Trajectory& trajectory, std::size_t i) {
  if (i == 0 || trajectory.points[i].kind == MoveKind::Arc) {
    return std::nullopt;
  }
  // An axis that the program has not named so far stays where it stands.
  bool isKnown = true;
  const auto moved = [&isKnown](double from, double to) {
    isKnown = isKnown && std::isnan(from) == std::isnan(to);
    return std::isnan(to) ? 0.0 : to - from;
  };
  const Vec3& from = trajectory.points[i - 1].positionMm;
  const Vec3& to = trajectory.points[i].positionMm;
  Way way{base::norm({moved(from.x, to.x), moved(from.y, to.y), moved(from.z, to.z)})};
  if (!trajectory.rotary.empty()) {
    const base::RotaryDeg& fromDeg = trajectory.rotary[i - 1].degrees;
    const base::RotaryDeg& toDeg = trajectory.rotary[i].degrees;
    way.deg = base::norm(
        {moved(fromDeg[0], toDeg[0]), moved(fromDeg[1], toDeg[1]), moved(fromDeg[2], toDeg[2])});
  }
  return isKnown ? std::optional(way) : std::nullopt;
}

base::AxisPosition placeOf(const Trajectory& trajectory, std::size_t i) {
  return {trajectory.points[i].positionMm,
          trajectory.rotary.empty() ? base::RotaryDeg{} : trajectory.rotary[i].degrees};
}

}  // namespace

double partsOf(double way, double most) {
  // A way that is a whole number of parts but for rounding needs no part more.
  return way > most ? std::ceil(way / most - 1e-9) : 1.0;
}

base::AxisPosition onMove(const base::AxisPosition& from, const base::AxisPosition& to,
                          double share) {
  base::AxisPosition place{from.mm + share * (to.mm - from.mm), from.deg};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    place.deg[axis] += share * (to.deg[axis] - from.deg[axis]);
  }
  return place;
}

ThinnedTrajectory thin(const Trajectory& trajectory, const Tolerance& tolerance) {
  RIVULET_ASSERT(tolerance.value > 0.0);
  return Thinner(trajectory, tolerance).run();
}

namespace {

base::Result<Trajectory> divided(const Trajectory& trajectory,
                                 const std::function<double(std::size_t)>& partsOfMove,
                                 const base::Budget& budget) {
  double count = 0.0;
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    count += partsOfMove(i);
  }
  const std::size_t each = sizeof(TrajectoryPoint) +
                           (trajectory.rotary.empty() ? 0 : sizeof(RotaryPosition)) +
                           (trajectory.toolDirections.empty() ? 0 : sizeof(Vec3));
  if (auto fits = budget.require(count * static_cast<double>(each),
                                 fmt::format("A path of {:.0f} points", count));
      !fits) {
    return base::fail(fits.error());
  }
  Trajectory out;
  out.points.reserve(static_cast<std::size_t>(count));
  out.toolNames = trajectory.toolNames;
  std::size_t event = 0;
  std::size_t arc = 0;
  const auto appendEvents = [&](std::size_t before) {
    for (; event < trajectory.events.size() && trajectory.events[event].point <= before; ++event) {
      out.events.push_back(trajectory.events[event]);
      out.events.back().point = out.points.size();
    }
  };
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    appendEvents(i);
    const TrajectoryPoint& point = trajectory.points[i];
    const auto parts = static_cast<std::size_t>(partsOfMove(i));
    for (std::size_t part = 1; part <= parts; ++part) {
      TrajectoryPoint piece = point;
      const double share = static_cast<double>(part) / static_cast<double>(parts);
      const base::AxisPosition place =
          part < parts ? onMove(placeOf(trajectory, i - 1), placeOf(trajectory, i), share)
                       : placeOf(trajectory, i);
      piece.positionMm = place.mm;
      out.points.push_back(piece);
      if (!trajectory.rotary.empty()) {
        out.rotary.push_back({place.deg});
      }
      if (!trajectory.toolDirections.empty()) {
        Vec3 direction = trajectory.toolDirections[i];
        if (part < parts) {
          const Vec3 from = trajectory.toolDirections[i - 1];
          const Vec3 mixed = from + share * (direction - from);
          direction = base::norm(mixed) > 0.0 ? (1.0 / base::norm(mixed)) * mixed : direction;
        }
        out.toolDirections.push_back(direction);
      }
    }
    for (; arc < trajectory.arcs.size() && trajectory.arcs[arc].point <= i; ++arc) {
      out.arcs.push_back(trajectory.arcs[arc]);
      out.arcs.back().point = out.points.size() - 1;
    }
  }
  appendEvents(trajectory.points.size());
  return out;
}

}  // namespace

base::Result<Trajectory> split(const Trajectory& trajectory, double lengthMm,
                               const base::Budget& budget) {
  RIVULET_ASSERT(lengthMm > 0.0);
  return divided(
      trajectory,
      [&](std::size_t i) {
        const std::optional<Way> way = wayTo(trajectory, i);
        return way ? partsOf(way->mm, lengthMm) : 1.0;
      },
      budget);
}

base::Result<void> divideLongMoves(Trajectory& trajectory, const MoveRules& limit,
                                   const base::Budget& budget) {
  const auto partsOfMove = [&](std::size_t i) {
    const double feed =
        limit.feeds ? commandedMmPerS(trajectory.points[i], *limit.feeds) : limit.feedMmPerS;
    const std::optional<Way> way = wayTo(trajectory, i);
    // A move without a known feed does not start.
    return way && feed > 0.0
               ? partsOf(base::wayAlongFeed(way->mm, way->deg), feed * limit.secondsMax)
               : 1.0;
  };
  const auto isDivided = [&] {
    for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
      if (partsOfMove(i) > 1.0) {
        return true;
      }
    }
    return false;
  };
  if (!(limit.secondsMax > 0.0) || !isDivided()) {
    return {};
  }
  auto parts = divided(trajectory, partsOfMove, budget);
  if (!parts) {
    return base::fail(parts.error());
  }
  trajectory = *std::move(parts);
  return {};
}

}  // namespace rivulet::gcode
