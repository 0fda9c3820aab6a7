// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/envelope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/contract.h"

namespace rivulet::trace {
namespace {

using base::Duration;
using base::Instant;

constexpr std::size_t kLowest = 64;  // points of an entry of the lowest level
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

Envelope::Envelope(PackedPoints points) : m_points(std::move(points)) {
  RIVULET_ASSERT(m_points.size() < kNone);
  PackedReader<PackedValues> values(m_points.values());
  for (std::size_t i = 0; i < values.size(); ++i) {
    count(i, values[i]);
  }
}

void Envelope::append(Instant instant, double value) {
  RIVULET_ASSERT(m_points.empty() || m_points.timeAt(m_points.size() - 1) <= instant);
  RIVULET_ASSERT(m_points.size() < kNone);
  count(m_points.size(), value);
  m_points.append({instant, value});
}

void Envelope::count(std::size_t index, double value) {
  merge(m_open, of(index, value));
  if ((index + 1) % kLowest != 0) {
    return;
  }
  // A level gets an entry when the last of its points arrives, built from the level below.
  Extremes entry = std::exchange(m_open, {});
  for (std::size_t level = 0;; ++level) {
    if (level == m_levels.size()) {
      m_levels.emplace_back();
    }
    std::vector<Extremes>& entries = m_levels[level];
    entries.push_back(entry);
    if (entries.size() % kFanOut != 0) {
      return;
    }
    entry = {};
    for (std::size_t i = entries.size() - kFanOut; i < entries.size(); ++i) {
      merge(entry, entries[i]);
    }
  }
}

void Envelope::clear() {
  m_points.clear();
  m_open = {};
  m_levels.clear();
}

std::size_t Envelope::memoryBytes() const {
  std::size_t bytes = m_points.memoryBytes();
  for (const std::vector<Extremes>& level : m_levels) {
    bytes += level.capacity() * sizeof(Extremes);
  }
  return bytes;
}

void Envelope::merge(Extremes& into, const Extremes& later) {
  // Strictly smaller and larger: of equal values the first one stays.
  if (later.minAt != kNone && (into.minAt == kNone || later.min < into.min)) {
    into.min = later.min;
    into.minAt = later.minAt;
  }
  if (later.maxAt != kNone && (into.maxAt == kNone || later.max > into.max)) {
    into.max = later.max;
    into.maxAt = later.maxAt;
  }
  if (into.gapAt == kNone) {
    into.gapAt = later.gapAt;
  }
}

Envelope::Extremes Envelope::of(std::size_t index, double value) {
  const auto at = static_cast<std::uint32_t>(index);
  return std::isnan(value) ? Extremes{0.0, 0.0, kNone, kNone, at}
                           : Extremes{value, value, at, at, kNone};
}

Envelope::Extremes Envelope::extremes(std::size_t begin, std::size_t end) const {
  Extremes result;
  while (begin < end) {
    // The largest entry that starts here and does not extend beyond the end. Entries that start at
    // a multiple of their length and end within the points are always complete.
    std::size_t length = 1;
    std::size_t levels = 0;
    for (std::size_t next = kLowest; begin % next == 0 && begin + next <= end; next *= kFanOut) {
      length = next;
      ++levels;
    }
    merge(result,
          levels == 0 ? of(begin, m_points.valueAt(begin)) : m_levels[levels - 1][begin / length]);
    begin += length;
  }
  return result;
}

std::size_t Envelope::find(Instant instant, bool after, std::size_t begin) const {
  std::size_t end = m_points.size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const Instant at = m_points.timeAt(middle);
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
    std::array<std::uint32_t, 3> indices{found.minAt, found.maxAt, found.gapAt};
    std::sort(indices.begin(), indices.end());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] != kNone && (i == 0 || indices[i] != indices[i - 1])) {
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
  if (found.minAt == kNone) {
    return std::nullopt;
  }
  return ValueRange{found.min, found.max};
}

}  // namespace rivulet::trace
