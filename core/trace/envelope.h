// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A signal over time that can be drawn in the width of a window, however long the run is. While
/// values are appended, the smallest and largest of every 64, 1024, 16384, ... are kept; a drawing
/// uses two points per column of pixels. Memory: that of `PackedPoints` and 0.6 bytes per value.
/// @threadsafety one object, one thread; several may read what nobody appends to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/instant.h"
#include "trace/packed_points.h"
#include "trace/value_range.h"

namespace rivulet::trace {

class Envelope {
 public:
  Envelope() = default;
  /// Of samples that are there. O(points). @param points  in time order
  explicit Envelope(PackedPoints points);

  /// Adds one value; NaN starts a gap that lasts until the next value. Amortised O(1).
  /// @param at  not before the last appended value
  void append(base::Instant at, double value);
  void clear();

  [[nodiscard]] std::size_t size() const { return m_points.size(); }
  [[nodiscard]] bool empty() const { return m_points.empty(); }
  [[nodiscard]] SeriesPoint operator[](std::size_t index) const { return m_points[index]; }
  [[nodiscard]] base::Instant timeAt(std::size_t index) const { return m_points.timeAt(index); }
  [[nodiscard]] double valueAt(std::size_t index) const { return m_points.valueAt(index); }
  /// Index of the first point at `instant` or later; `size()`: there is none. O(log(size)).
  [[nodiscard]] std::size_t firstAt(base::Instant instant) const { return find(instant, false); }
  /// Of points and levels.
  [[nodiscard]] std::size_t memoryBytes() const;

  /// What to draw between two instants. The span is split into `columns` columns of equal width;
  /// the first ones include their left border, the last one also `to`. Each column that holds
  /// values returns its first smallest and its first largest value (one if they are the same) and
  /// its first NaN, if any, all in time order. The nearest point outside is added on either side,
  /// so that the line enters and leaves the window at the right place: at most 3 * columns + 2
  /// points, 2 * columns + 2 without gaps. O(columns * log(size)).
  /// @param from <= to  @param columns > 0
  [[nodiscard]] std::vector<SeriesPoint> visible(base::Instant from, base::Instant to,
                                                 std::size_t columns) const;

  /// Smallest and largest value between two instants, both included; nothing if there is none.
  /// O(log(size)).
  [[nodiscard]] std::optional<ValueRange> range(base::Instant from, base::Instant to) const;

 private:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// Of a range of points: the first smallest, the first largest and the first gap.
  struct Extremes {
    double min = 0.0;
    double max = 0.0;
    std::uint32_t minAt = kNone;
    std::uint32_t maxAt = kNone;
    std::uint32_t gapAt = kNone;
  };

  /// Keeps the extremes of one more point.
  void count(std::size_t index, double value);
  /// Adds a range of points that follows all those added so far.
  static void merge(Extremes& into, const Extremes& later);
  [[nodiscard]] static Extremes of(std::size_t index, double value);
  /// Extremes of the points [begin, end).
  [[nodiscard]] Extremes extremes(std::size_t begin, std::size_t end) const;
  /// Index of the first point at `instant` or later (with `after`: later), from `begin` on.
  [[nodiscard]] std::size_t find(base::Instant instant, bool after, std::size_t begin = 0) const;

  PackedPoints m_points;
  Extremes m_open;  ///< of the points that are in no entry of the lowest level yet
  std::vector<std::vector<Extremes>> m_levels;  ///< level k: one entry per 64 * 16^k points
};

}  // namespace rivulet::trace
