// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Common to the methods: the points in order, their slots, and the loops of the flexible program.
/// After the last point a slot gets the last point again: the axes are already there, so the block
/// moves nothing. @threadsafety one object, one thread.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/contract.h"
#include "base/packing.h"
#include "base/units.h"
#include "streaming/methods/method.h"

namespace rivulet::streaming {

class SlotPlan {
 public:
  /// All points are there.
  explicit SlotPlan(MethodSetup setup) : SlotPlan(std::move(setup), nullptr) {
    RIVULET_ASSERT(!m_points.empty());
    append(m_points.size());
  }
  /// None is there so far. @param points  of which some are appended at a time; null: of the setup
  SlotPlan(MethodSetup setup, const std::vector<gcode::StreamPoint>* points)
      : m_setup(std::move(setup)), m_points(points != nullptr ? *points : m_setup.points) {
    const auto count = static_cast<std::size_t>(m_setup.cells.slotCount());
    for (std::size_t slot = 0; slot < count; ++slot) {
      m_cells.push_back(m_setup.cells.slotCells(static_cast<int>(slot)));
    }
    m_writes.reserve(count * (base::kStreamedAxesMax + 1) + 4);
    m_arcMm.reserve(m_points.size());
  }
  SlotPlan(const SlotPlan&) = delete;
  SlotPlan& operator=(const SlotPlan&) = delete;

  /// As many more points.
  void append(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      addWayTo(m_arcMm.size());
    }
  }

  [[nodiscard]] std::size_t pointCount() const { return m_arcMm.size(); }
  [[nodiscard]] std::size_t slotCount() const { return m_cells.size(); }
  [[nodiscard]] const templates::CellMap& cells() const { return m_setup.cells; }
  [[nodiscard]] const RunSettings& settings() const { return m_setup.settings; }
  [[nodiscard]] base::Vec3 pointMm(std::size_t index) const {
    return m_points[std::min(index, pointCount() - 1)].positionMm;
  }
  /// Index of the loop that holds the last point; the stop must be written while it runs.
  [[nodiscard]] std::size_t lastLoop() const { return (pointCount() - 1) / slotCount(); }

  /// Shortest time from point `from` to point `to` (clamped to the last one) at the feed.
  [[nodiscard]] base::Duration travelTime(std::size_t from, std::size_t to) const {
    const std::size_t last = pointCount() - 1;
    const double length = m_arcMm[std::min(to, last)] - m_arcMm[std::min(from, last)];
    return base::fromSeconds(std::max(0.0, length) / m_setup.settings.feedMmPerS);
  }

  /// Shortest time from the tool's position to the first point.
  [[nodiscard]] base::Duration approachTime() const {
    return base::fromSeconds(wayTo(m_setup.startMm, m_setup.startDeg, 0) * slowerThanRun(0) /
                             m_setup.settings.feedMmPerS);
  }

  /// Commanded feed of the move to point `index` (or the last one).
  [[nodiscard]] double feedMmPerMin(std::size_t index) const {
    const double own = m_points[std::min(index, pointCount() - 1)].feedMmPerS;
    return base::mmPerMinFromMmPerS(own > 0.0 ? own : m_setup.settings.feedMmPerS);
  }
  [[nodiscard]] const gcode::StreamPoint& point(std::size_t index) const {
    return m_points[std::min(index, pointCount() - 1)];
  }

  /// The last `count` writes are moved before all others.
  void lastToFront(std::size_t count) {
    RIVULET_ASSERT(count <= m_writes.size());
    std::rotate(m_writes.begin(), m_writes.end() - static_cast<std::ptrdiff_t>(count),
                m_writes.end());
  }
  void clearWrites() { m_writes.clear(); }
  void addCell(int cell, double value) { m_writes.push_back({opcua::rParameter(cell), value}); }
  /// Point `index` (or the last one) into its slot.
  void addPoint(std::size_t index) { addPointAt(index % slotCount(), index); }
  void addPointAt(std::size_t slot, std::size_t index) {
    const std::vector<int>& cells = m_cells[slot];
    std::size_t next = 0;
    forEachCoordinate(index, [&](double value) { addCell(cells[next++], value); });
    if (m_setup.cells.feedPerPoint) {
      addCell(cells[next], feedMmPerMin(index));
    }
  }
  /// Point `index` (or the last one), packed, in a window that begins with point `first`.
  void addPackedAt(std::size_t slot, std::size_t index, std::size_t first) {
    const std::vector<int>& cells = m_cells[slot];
    const base::Packing packing(m_setup.cells.axisCount());
    base::Packing::Number number(packing);
    forEachPair(first, index, [&](double place, double value) { number.add(place, value); });
    addCell(cells[0], number.value());
    if (m_setup.cells.feedPerPoint) {
      addCell(cells[1], feedMmPerMin(index));
    }
  }
  /// What the control moves to for point `index` of a window that begins with point `first`; then
  /// the feed, if each point has its own.
  template <class Take>
  void forEachTaken(std::size_t first, std::size_t index, const Take& take) const {
    forEachPair(first, index, [&](double place, double value) {
      const bool isPacked = m_setup.cells.packed && index != first;
      take(isPacked ? base::Packing::unpacked(place, value) : value);
    });
    if (m_setup.cells.feedPerPoint) {
      take(feedMmPerMin(index));
    }
  }
  /// The coordinates of point `index` (or the last one) that are streamed, in the order of cells.
  template <class Take>
  void forEachCoordinate(std::size_t index, const Take& take) const {
    const gcode::StreamPoint& at = point(index);
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (m_setup.cells.axes[axis]) {
        take(at.positionMm[axis]);
      }
    }
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (m_setup.cells.rotaryAxes[axis]) {
        take(at.rotaryDeg[axis]);
      }
    }
  }
  [[nodiscard]] std::span<const opcua::Assignment> writes() const { return m_writes; }

  /// Feed, cleared stop cell and the first N points.
  void addFirstLoop() {
    addCell(m_setup.cells.feed, base::mmPerMinFromMmPerS(m_setup.settings.feedMmPerS));
    for (std::size_t index = 0; index < slotCount(); ++index) {
      addPoint(index);
    }
  }

 private:
  template <class Take>
  void forEachPair(std::size_t first, std::size_t index, const Take& take) const {
    std::array<double, base::kStreamedAxesMax> places{};
    std::size_t next = 0;
    forEachCoordinate(first, [&](double value) { places[next++] = value; });
    next = 0;
    forEachCoordinate(index, [&](double value) { take(places[next++], value); });
  }

  void addWayTo(std::size_t index) {
    const double before = m_arcMm.empty() ? 0.0 : m_arcMm.back();
    m_arcMm.push_back(index == 0 ? 0.0
                                 : before + wayTo(m_points[index - 1].positionMm,
                                                  m_points[index - 1].rotaryDeg, index) *
                                                slowerThanRun(index));
  }

  [[nodiscard]] double wayTo(base::Vec3 fromMm, const base::RotaryDeg& fromDeg,
                             std::size_t point) const {
    return base::wayAlongFeed(base::distance(fromMm, m_points[point].positionMm),
                              base::turnDeg(fromDeg, m_points[point].rotaryDeg));
  }

  /// Feed of the run over that of the move to a point.
  [[nodiscard]] double slowerThanRun(std::size_t point) const {
    const double own = m_points[point].feedMmPerS;
    return own > 0.0 ? m_setup.settings.feedMmPerS / own : 1.0;
  }

  MethodSetup m_setup;
  const std::vector<gcode::StreamPoint>& m_points;
  std::vector<std::vector<int>> m_cells;
  /// Path length up to each point, see `base::wayAlongFeed`; moves with their own feed as long as
  /// the feed of the run would go in their time.
  std::vector<double> m_arcMm;
  std::vector<opcua::Assignment> m_writes;
};

}  // namespace rivulet::streaming
