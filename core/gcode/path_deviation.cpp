// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/path_deviation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rivulet::gcode {

namespace {

using base::AxisPosition;

/// Shares of a move where a traveller can be; empty: `from` is larger.
struct Reach {
  double from = 1.0;
  double to = 0.0;
  [[nodiscard]] bool isEmpty() const { return from > to; }
  /// What lies further on, too.
  [[nodiscard]] Reach after(double share) const { return {std::max(from, share), to}; }
};

Reach both(Reach a, Reach b) {
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

/// Roots of |begin + s·way|² = most², along one move.
template <class Coordinates>
Reach nearPart(const Coordinates& begin, const Coordinates& way, double most) {
  double squares = 0.0;
  double mixed = 0.0;
  double left = -most * most;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    squares += way[axis] * way[axis];
    mixed += begin[axis] * way[axis];
    left += begin[axis] * begin[axis];
  }
  if (squares == 0.0) {
    return left <= 0.0 ? Reach{0.0, 1.0} : Reach{};
  }
  const double nearest = -mixed / squares;
  double off = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = begin[axis] + nearest * way[axis];
    off += at * at;
  }
  if (off > most * most) {
    return {};
  }
  const double half = std::sqrt((most * most - off) / squares);
  return {std::max(0.0, nearest - half), std::min(1.0, nearest + half)};
}

/// The part of a move that is near a place.
Reach freePart(const AxisPosition& place, const AxisPosition& from, const AxisPosition& to,
               double most) {
  const Reach linear = nearPart(from.mm - place.mm, to.mm - from.mm, most);
  base::RotaryDeg begin{};
  base::RotaryDeg way{};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    begin[axis] = from.deg[axis] - place.deg[axis];
    way[axis] = to.deg[axis] - from.deg[axis];
  }
  return both(linear, nearPart(begin, way, most));
}

/// Cells of the free-space diagram of Alt and Godau (1995), move i of one path against move j of
/// the other, column by column; only those that can be reached are looked at.
class FreeSpace {
 public:
  FreeSpace(std::span<const AxisPosition> a, std::span<const AxisPosition> b, double most)
      : m_a(a), m_b(b), m_most(most) {}

  bool isPassable() {
    if (freePart(m_a.front(), m_b.front(), m_b.front(), m_most).isEmpty() ||
        freePart(m_a.back(), m_b.back(), m_b.back(), m_most).isEmpty()) {
      return false;
    }
    enter();
    for (std::size_t i = 0; i + 1 < m_a.size(); ++i) {
      if (!pass(i)) {
        return false;
      }
    }
    // The last column must have been reached at the end of the other path.
    return m_first + m_left.size() == m_b.size() - 1 && m_left.back().to >= 1.0;
  }

 private:
  /// The first traveller waits at the begin.
  void enter() {
    for (std::size_t j = 0; j + 1 < m_b.size(); ++j) {
      const Reach part = freePart(m_a[0], m_b[j], m_b[j + 1], m_most);
      if (part.isEmpty() || part.from > 0.0) {
        break;
      }
      m_left.push_back(part);
      if (part.to < 1.0) {
        break;
      }
    }
    m_waits = true;
  }

  /// The second traveller waits at its begin.
  Reach waiting(std::size_t i) {
    const Reach part = freePart(m_b[0], m_a[i], m_a[i + 1], m_most);
    m_waits = m_waits && !part.isEmpty() && part.from == 0.0;
    const Reach reach = m_waits ? part : Reach{};
    m_waits = m_waits && part.to >= 1.0;
    return reach;
  }

  /// @return false: nothing of the next column can be reached
  bool pass(std::size_t i) {
    m_right.clear();
    std::size_t first = m_first;
    Reach below = m_first == 0 ? waiting(i) : Reach{};
    for (std::size_t j = m_first; j + 1 < m_b.size(); ++j) {
      const Reach left = j - m_first < m_left.size() ? m_left[j - m_first] : Reach{};
      if (left.isEmpty() && below.isEmpty()) {
        if (j - m_first >= m_left.size()) {
          break;
        }
        keep(first, j, Reach{});
        continue;
      }
      const Reach side = freePart(m_a[i + 1], m_b[j], m_b[j + 1], m_most);
      keep(first, j, below.isEmpty() ? side.after(left.from) : side);
      const Reach above = freePart(m_b[j + 1], m_a[i], m_a[i + 1], m_most);
      below = left.isEmpty() ? above.after(below.from) : above;
    }
    while (!m_right.empty() && m_right.back().isEmpty()) {
      m_right.pop_back();
    }
    m_left.swap(m_right);
    m_first = first;
    return !m_left.empty();
  }

  void keep(std::size_t& first, std::size_t j, Reach reach) {
    if (m_right.empty() && reach.isEmpty()) {
      first = j + 1;
      return;
    }
    m_right.push_back(reach);
  }

  std::span<const AxisPosition> m_a;
  std::span<const AxisPosition> m_b;
  double m_most;
  std::size_t m_first = 0;     ///< move of the second path that `m_left` begins with
  std::vector<Reach> m_left;   ///< where the second traveller can be, the first at a point
  std::vector<Reach> m_right;  ///< the same at the next point
  bool m_waits = false;
};

}  // namespace

std::vector<AxisPosition> placesOf(const Trajectory& trajectory) {
  std::vector<AxisPosition> places(trajectory.points.size());
  const auto known = [](double value) { return std::isnan(value) ? 0.0 : value; };
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      places[i].mm.set(axis, known(trajectory.points[i].positionMm[axis]));
    }
    for (std::size_t axis = 0; !trajectory.rotary.empty() && axis < base::kRotaryAxisCount;
         ++axis) {
      places[i].deg[axis] = known(trajectory.rotary[i].degrees[axis]);
    }
  }
  return places;
}

bool isAlong(std::span<const AxisPosition> a, std::span<const AxisPosition> b, double most) {
  if (a.empty() || b.empty()) {
    return a.empty() && b.empty();
  }
  if (a.size() == 1 || b.size() == 1) {
    // A traveller who stays is near to all that the other one passes: to its points, then.
    const std::span<const AxisPosition> path = a.size() == 1 ? b : a;
    const AxisPosition& place = a.size() == 1 ? a.front() : b.front();
    return std::all_of(path.begin(), path.end(), [&](const AxisPosition& each) {
      return !freePart(place, each, each, most).isEmpty();
    });
  }
  return FreeSpace(a, b, most).isPassable();
}

std::optional<double> pathDeviation(std::span<const AxisPosition> a,
                                    std::span<const AxisPosition> b, double most) {
  // Rounding of doubles is no deviation.
  constexpr double kRounding = 1e-9;
  const auto within = [&](double steps) {
    return isAlong(a, b, steps * kDeviationStep + kRounding);
  };
  double tooFew = -1.0;
  double enough = std::ceil(most / kDeviationStep - kRounding);
  if (!within(enough)) {
    return std::nullopt;
  }
  while (enough - tooFew > 1.0) {
    const double middle = std::floor(0.5 * (tooFew + enough));
    (within(middle) ? enough : tooFew) = middle;
  }
  return enough * kDeviationStep;
}

}  // namespace rivulet::gcode
