// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/thinning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "base/axes.h"
#include "base/contract.h"

namespace rivulet::gcode {

namespace {

using base::Vec3;

bool equal(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

class Thinner {
 public:
  Thinner(const Trajectory& trajectory, double toleranceMm)
      : m_trajectory(trajectory), m_toleranceMm(toleranceMm), m_keep(trajectory.points.size()) {}

  ThinnedTrajectory run() {
    const std::size_t count = m_keep.size();
    if (count > 0) {
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
  /// Ends of stretches within which points may be left out.
  void markFixed() {
    const std::vector<TrajectoryPoint>& points = m_trajectory.points;
    m_keep.front() = m_keep.back() = true;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const TrajectoryPoint& here = points[i];
      const TrajectoryPoint& next = points[i + 1];
      const bool known = base::isFinite(here.positionMm) && base::isFinite(next.positionMm);
      if (!known || here.kind == MoveKind::Rapid || here.kind == MoveKind::Arc ||
          here.kind != next.kind || here.feedMmPerS != next.feedMmPerS || turns(i)) {
        m_keep[i] = true;
      }
    }
    for (const PathEvent& event : m_trajectory.events) {
      if (event.point > 0 && event.point <= points.size()) {
        m_keep[event.point - 1] = true;
      }
    }
  }

  [[nodiscard]] bool turns(std::size_t i) const {
    if (!m_trajectory.rotary.empty()) {
      const auto& here = m_trajectory.rotary[i].degrees;
      const auto& next = m_trajectory.rotary[i + 1].degrees;
      if (!std::equal(here.begin(), here.end(), next.begin(), equal)) {
        return true;
      }
    }
    return !m_trajectory.toolDirections.empty() &&
           m_trajectory.toolDirections[i] != m_trajectory.toolDirections[i + 1];
  }

  /// Keeps the point furthest from the chord, and looks at both sides of it, as long as it is
  /// beyond the tolerance.
  void thinBetween(std::size_t first, std::size_t last) {
    m_stack.assign(1, {first, last});
    while (!m_stack.empty()) {
      const auto [from, to] = m_stack.back();
      m_stack.pop_back();
      double furthestMm = 0.0;
      std::size_t furthest = from;
      for (std::size_t i = from + 1; i < to; ++i) {
        const double offMm = base::distanceToSegment(position(i), position(from), position(to));
        if (offMm > furthestMm) {
          furthestMm = offMm;
          furthest = i;
        }
      }
      if (furthestMm > m_toleranceMm) {
        m_keep[furthest] = true;
        m_stack.emplace_back(from, furthest);
        m_stack.emplace_back(furthest, to);
      } else {
        m_errorMm = std::max(m_errorMm, furthestMm);
      }
    }
  }

  [[nodiscard]] Vec3 position(std::size_t i) const { return m_trajectory.points[i].positionMm; }

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
      if (!m_trajectory.rotary.empty()) {
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
    thinned.errorMmMax = m_errorMm;
    return thinned;
  }

  const Trajectory& m_trajectory;
  double m_toleranceMm;
  std::vector<char> m_keep;
  std::vector<std::pair<std::size_t, std::size_t>> m_stack;
  double m_errorMm = 0.0;
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

ThinnedTrajectory thin(const Trajectory& trajectory, double toleranceMm) {
  RIVULET_ASSERT(toleranceMm > 0.0);
  return Thinner(trajectory, toleranceMm).run();
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

base::Result<void> divideLongMoves(Trajectory& trajectory, const MoveLimit& limit,
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
