// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/envelope.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contract.h"

namespace rivulet::trace {
namespace {

using base::Duration;
using base::Instant;

constexpr std::size_t kFanOut = 16;

/// Instants beyond 70 years are clamped to that, so that spans cannot overflow.
Instant clamped(Instant at) {
  constexpr Duration kFar{std::int64_t{1} << 61};
  return std::clamp(at, Instant{-kFar}, Instant{kFar});
}

/// Left border of a column, without the overflow of span * column.
Instant columnStart(Instant from, Duration span, std::size_t column, std::size_t columns) {
  const auto c = static_cast<std::int64_t>(column);
  const auto n = static_cast<std::int64_t>(columns);
  return from + Duration{span.count() / n * c + span.count() % n * c / n};
}

}  // namespace

void Envelope::append(Instant instant, double value) {
  RIVULET_ASSERT(m_points.empty() || m_points[m_points.size() - 1].at <= instant);
  m_points.append({instant, value});
  // A level gets an entry when the last of its points arrives, built from the level below.
  std::size_t stretch = 1;
  for (std::size_t level = 0; m_points.size() % (stretch * kFanOut) == 0; ++level) {
    Extremes entry;
    const std::size_t first = m_points.size() / stretch - kFanOut;
    for (std::size_t i = first; i < first + kFanOut; ++i) {
      merge(entry, level == 0 ? at(i) : m_levels[level - 1][i]);
    }
    if (level == m_levels.size()) {
      m_levels.emplace_back();
    }
    m_levels[level].append(entry);
    stretch *= kFanOut;
  }
}

void Envelope::clear() {
  m_points.clear();
  m_levels.clear();
}

void Envelope::merge(Extremes& into, const Extremes& later) const {
  // Strictly smaller and larger: of equal values the first one stays.
  if (later.min != Extremes::kNone &&
      (into.min == Extremes::kNone || m_points[later.min].value < m_points[into.min].value)) {
    into.min = later.min;
  }
  if (later.max != Extremes::kNone &&
      (into.max == Extremes::kNone || m_points[later.max].value > m_points[into.max].value)) {
    into.max = later.max;
  }
  if (into.gap == Extremes::kNone) {
    into.gap = later.gap;
  }
}

Envelope::Extremes Envelope::at(std::size_t index) const {
  if (std::isnan(m_points[index].value)) {
    return {Extremes::kNone, Extremes::kNone, index};
  }
  return {index, index, Extremes::kNone};
}

Envelope::Extremes Envelope::extremes(std::size_t begin, std::size_t end) const {
  Extremes result;
  while (begin < end) {
    // The largest entry that starts here and does not extend beyond the end. Entries that start at
    // a multiple of their length and end within the points are always complete.
    std::size_t length = 1;
    std::size_t levels = 0;
    while (begin % (length * kFanOut) == 0 && begin + length * kFanOut <= end) {
      length *= kFanOut;
      ++levels;
    }
    merge(result, levels == 0 ? at(begin) : m_levels[levels - 1][begin / length]);
    begin += length;
  }
  return result;
}

std::size_t Envelope::find(Instant instant, bool after, std::size_t begin) const {
  std::size_t end = m_points.size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const Instant at = m_points[middle].at;
    if (at < instant || (after && at == instant)) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

std::vector<SeriesPoint> Envelope::visible(Instant from, Instant to, std::size_t columns) const {
  RIVULET_ASSERT(from <= to);
  RIVULET_ASSERT(columns > 0);
  from = clamped(from);
  to = clamped(to);
  std::vector<SeriesPoint> points;
  std::size_t begin = find(from, false);
  const std::size_t last = find(to, true, begin);
  points.reserve(std::min(2 * columns, last - begin) + 2);
  if (begin > 0) {
    points.push_back(m_points[begin - 1]);
  }
  for (std::size_t column = 0; column < columns && begin < last; ++column) {
    const std::size_t end =
        column + 1 == columns
            ? last
            : std::min(last, find(columnStart(from, to - from, column + 1, columns), false, begin));
    const Extremes found = extremes(begin, end);
    std::array<std::size_t, 3> indices{found.min, found.max, found.gap};
    std::sort(indices.begin(), indices.end());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] != Extremes::kNone && (i == 0 || indices[i] != indices[i - 1])) {
        points.push_back(m_points[indices[i]]);
      }
    }
    begin = end;
  }
  if (last < m_points.size()) {
    points.push_back(m_points[last]);
  }
  return points;
}

std::optional<ValueRange> Envelope::range(Instant from, Instant to) const {
  RIVULET_ASSERT(from <= to);
  const std::size_t begin = find(from, false);
  const Extremes found = extremes(begin, find(to, true, begin));
  if (found.min == Extremes::kNone) {
    return std::nullopt;
  }
  return ValueRange{m_points[found.min].value, m_points[found.max].value};
}

}  // namespace rivulet::trace
