// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A signal over time that is drawn in the width of a window, however long the run: while values
/// are appended, the smallest and largest of every 16, 256, 4096, ... are kept, and a drawing asks
/// for two points per column of pixels. @threadsafety one object, one thread.
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
  /// @param at  not before the value appended last
  void append(base::Instant at, double value);
  void clear();

  [[nodiscard]] std::size_t size() const { return m_points.size(); }
  [[nodiscard]] bool empty() const { return m_points.empty(); }
  [[nodiscard]] const SeriesPoint& operator[](std::size_t index) const { return m_points[index]; }

  /// What to draw between two instants. The span is split into `columns` columns of equal width;
  /// the first ones include their left border, the last one also `to`. Of each column that holds
  /// values the first smallest and the first largest one are returned (one if they are the same),
  /// and its first NaN if it has one, all in time order. In front and behind, the nearest point
  /// outside on either side is added, so that the line enters and leaves the window where it
  /// should: at most 3 * columns + 2 points, 2 * columns + 2 without gaps.
  /// O(columns * log(size)). @param from <= to  @param columns > 0
  [[nodiscard]] std::vector<SeriesPoint> visible(base::Instant from, base::Instant to,
                                                 std::size_t columns) const;

  /// Smallest and largest value between two instants, both included; nothing if there is none.
  /// O(log(size)).
  [[nodiscard]] std::optional<ValueRange> range(base::Instant from, base::Instant to) const;

 private:
  /// Of a stretch of points: which is the first smallest, the first largest, the first gap.
  struct Extremes {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::size_t min = kNone;
    std::size_t max = kNone;
    std::size_t gap = kNone;
  };

  /// Takes in a stretch that lies behind everything taken in so far.
  void merge(Extremes& into, const Extremes& later) const;
  [[nodiscard]] Extremes at(std::size_t index) const;
  /// Of the points [begin, end).
  [[nodiscard]] Extremes extremes(std::size_t begin, std::size_t end) const;
  /// Index of the first point at `instant` or later (with `after`: later), from `begin` on.
  [[nodiscard]] std::size_t find(base::Instant instant, bool after, std::size_t begin = 0) const;

  Series<SeriesPoint> m_points;
  std::vector<Series<Extremes, 1024>> m_levels;  ///< level k: one entry per 16^(k+1) points
};

}  // namespace rivulet::trace
