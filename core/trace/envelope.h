// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A signal over time that can be drawn in the width of a window, however long the run is. While
/// values are appended, the smallest and largest of every 16, 256, 4096, ... are kept; a drawing
/// uses two points per column of pixels. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/instant.h"
#include "trace/series.h"

namespace rivulet::trace {

struct SeriesPoint {
  base::Instant at{};
  double value = 0.0;  ///< NaN: the signal has a gap here, the line is interrupted

  friend bool operator==(const SeriesPoint&, const SeriesPoint&) = default;
};

struct ValueRange {
  double min = 0.0;
  double max = 0.0;
};

class Envelope {
 public:
  /// Adds one value; NaN starts a gap that lasts until the next value. Amortised O(1).
  /// @param at  not before the last appended value
  void append(base::Instant at, double value);
  void clear();

  [[nodiscard]] std::size_t size() const { return m_points.size(); }
  [[nodiscard]] bool empty() const { return m_points.empty(); }
  [[nodiscard]] const SeriesPoint& operator[](std::size_t index) const { return m_points[index]; }

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
  /// Of a range of points: indices of the first smallest, the first largest and the first gap.
  struct Extremes {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::size_t min = kNone;
    std::size_t max = kNone;
    std::size_t gap = kNone;
  };

  /// Adds a range of points that follows all those added so far.
  void merge(Extremes& into, const Extremes& later) const;
  [[nodiscard]] Extremes at(std::size_t index) const;
  /// Extremes of the points [begin, end).
  [[nodiscard]] Extremes extremes(std::size_t begin, std::size_t end) const;
  /// Index of the first point at `instant` or later (with `after`: later), from `begin` on.
  [[nodiscard]] std::size_t find(base::Instant instant, bool after, std::size_t begin = 0) const;

  Series<SeriesPoint> m_points;
  std::vector<Series<Extremes, 1024>> m_levels;  ///< level k: one entry per 16^(k+1) points
};

}  // namespace rivulet::trace
