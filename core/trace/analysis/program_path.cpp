// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/program_path.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "base/contract.h"

namespace rivulet::trace {

namespace {

base::Vec3 least(base::Vec3 a, base::Vec3 b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
base::Vec3 greatest(base::Vec3 a, base::Vec3 b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace

ProgramPath::ProgramPath(std::vector<gcode::StreamPoint> points, base::Vec3 startMm)
    : m_points(std::move(points)), m_startMm(startMm) {
  RIVULET_ASSERT(!m_points.empty());
  m_lengths.reserve(m_points.size() + 1);
  m_lengths.push_back(0.0);
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    m_lengths.push_back(m_lengths.back() + base::distance(begin(i), m_points[i].positionMm));
  }
  m_bySpace.resize(m_points.size());
  std::iota(m_bySpace.begin(), m_bySpace.end(), 0U);
  std::size_t size = kLeaf;
  while (size < m_points.size()) {
    size *= 2;
  }
  m_boxes.resize(2 * size / kLeaf);
  sort(1, 0, size);
  m_ends.reserve(m_bySpace.size());
  for (const std::uint32_t segment : m_bySpace) {
    m_ends.push_back({begin(segment), m_points[segment].positionMm});
  }
}

void ProgramPath::sort(std::size_t node, std::size_t first, std::size_t size) {
  const auto segments = [this](std::size_t from, std::size_t upto) {
    return std::span(m_bySpace).subspan(from, std::min(upto, m_bySpace.size()) - from);
  };
  Box& box = m_boxes[node];
  for (const std::uint32_t segment : segments(first, first + size)) {
    const base::Vec3 from = begin(segment);
    const base::Vec3 to = m_points[segment].positionMm;
    box.min = least(box.min, least(from, to));
    box.max = greatest(box.max, greatest(from, to));
  }
  if (size == kLeaf) {
    return;
  }
  const std::size_t half = first + size / 2;
  if (half < m_bySpace.size()) {
    const base::Vec3 extent = box.max - box.min;
    const std::size_t axis = extent.x >= std::max(extent.y, extent.z) ? 0
                             : extent.y >= extent.z                   ? 1
                                                                      : 2;
    const auto twiceTheMiddle = [this, axis](std::uint32_t segment) {
      return begin(segment)[axis] + m_points[segment].positionMm[axis];
    };
    const std::span<std::uint32_t> all = segments(first, first + size);
    std::ranges::nth_element(all, all.begin() + static_cast<std::ptrdiff_t>(size / 2), {},
                             twiceTheMiddle);
    sort(2 * node + 1, half, size / 2);
  }
  sort(2 * node, first, size / 2);
}

std::size_t ProgramPath::segmentAt(double lengthMm) const {
  const auto found = std::lower_bound(m_lengths.begin() + 1, m_lengths.end(), lengthMm);
  return std::min(static_cast<std::size_t>(found - m_lengths.begin() - 1), m_points.size() - 1);
}

std::size_t ProgramPath::lastOf(std::size_t first, double fromMm, double toMm) const {
  constexpr std::size_t kShort = 8;
  std::size_t segment = first;
  while (segment + 1 < m_points.size() && segment < first + kShort &&
         m_lengths[segment + 1] < toMm) {
    ++segment;
  }
  return segment < first + kShort && toMm >= fromMm ? segment : segmentAt(toMm);
}

base::Vec3 ProgramPath::at(double lengthMm) const {
  const std::size_t segment = segmentAt(lengthMm);
  const double length = m_lengths[segment + 1] - m_lengths[segment];
  const double share =
      length > 0.0 ? std::clamp((lengthMm - m_lengths[segment]) / length, 0.0, 1.0) : 1.0;
  const base::Vec3 from = begin(segment);
  return from + share * (m_points[segment].positionMm - from);
}

base::Vec3 ProgramPath::direction(std::size_t segment) const {
  const base::Vec3 along = m_points[segment].positionMm - begin(segment);
  const double length = base::norm(along);
  return length > 0.0 ? (1.0 / length) * along : base::Vec3{};
}

bool ProgramPath::isBlockEnd(std::size_t segment) const {
  const gcode::StreamPoint& point = m_points[segment];
  const bool isChord =
      point.kind == gcode::MoveKind::ArcPiece || point.kind == gcode::MoveKind::SplinePiece;
  return !isChord || segment + 1 == m_points.size() || m_points[segment + 1].line != point.line ||
         m_points[segment + 1].kind != point.kind;
}

ProgramPath::Foot ProgramPath::footOn(const Ends& ends, base::Vec3 position) {
  const base::Vec3 along = ends.to - ends.from;
  const double squares = base::dot(along, along);
  const double share =
      squares > 0.0 ? std::clamp(base::dot(position - ends.from, along) / squares, 0.0, 1.0) : 1.0;
  return {share, base::distance(position, ends.from + share * along)};
}

PathPlace ProgramPath::placeAt(std::size_t segment, const Foot& foot) const {
  return {m_lengths[segment] + foot.share * (m_lengths[segment + 1] - m_lengths[segment]),
          foot.distanceMm, segment};
}

PathPlace ProgramPath::placeOn(std::size_t segment, base::Vec3 position) const {
  return placeAt(segment, footOn({begin(segment), m_points[segment].positionMm}, position));
}

void ProgramPath::collect(std::size_t node, std::size_t first, std::size_t size,
                          Search& search) const {
  const Box& box = m_boxes[node];
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (search.position[axis] < box.min[axis] - search.radiusMm ||
        search.position[axis] > box.max[axis] + search.radiusMm) {
      return;
    }
  }
  if (search.found.size() > search.most) {
    return;
  }
  if (size > kLeaf) {
    collect(2 * node, first, size / 2, search);
    collect(2 * node + 1, first + size / 2, size / 2, search);
    return;
  }
  for (std::size_t i = first; i < std::min(first + kLeaf, m_bySpace.size()); ++i) {
    const Foot foot = footOn(m_ends[i], search.position);
    if (foot.distanceMm <= search.radiusMm) {
      search.found.push_back(placeAt(m_bySpace[i], foot));
    }
  }
}

std::vector<PathPlace> ProgramPath::minima(std::vector<PathPlace> found) const {
  std::ranges::sort(found, {}, &PathPlace::segment);
  std::size_t kept = 0;
  std::size_t segmentBefore = 0;  // whether it was kept or not
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool hasBefore = i > 0 && segmentBefore + 1 == found[i].segment;
    const bool hasAfter = i + 1 < found.size() && found[i].segment + 1 == found[i + 1].segment;
    // A vertex belongs to both of its segments.
    const bool isAtBegin = found[i].lengthMm <= m_lengths[found[i].segment];
    const bool isAtEnd = found[i].lengthMm >= m_lengths[found[i].segment + 1];
    const bool isOfBefore = isAtBegin && hasBefore;
    // Rounding must not give it to none of them.
    const bool isBehind = hasAfter && found[i + 1].lengthMm > m_lengths[found[i + 1].segment];
    const bool isOfAfter = isAtEnd && isBehind && found[i + 1].distanceMm < found[i].distanceMm;
    segmentBefore = found[i].segment;
    if (!isOfBefore && !isOfAfter) {
      found[kept++] = found[i];
    }
  }
  found.resize(kept);
  return found;
}

std::vector<PathPlace> ProgramPath::near(base::Vec3 position, double radiusMm) const {
  return *nearIfFew(position, radiusMm, m_points.size());
}

std::optional<std::vector<PathPlace>> ProgramPath::nearIfFew(base::Vec3 position, double radiusMm,
                                                             std::size_t segmentsMax) const {
  Search search{position, radiusMm, segmentsMax, {}};
  collect(1, 0, m_boxes.size() / 2 * kLeaf, search);
  if (search.found.size() > segmentsMax) {
    return std::nullopt;
  }
  return minima(std::move(search.found));
}

std::vector<PathPlace> ProgramPath::nearWithin(base::Vec3 position, double radiusMm, double fromMm,
                                               double toMm) const {
  Search search{position, radiusMm, m_points.size(), {}};
  const std::size_t first = segmentAt(fromMm);
  const std::size_t last = lastOf(first, fromMm, toMm);
  for (std::size_t segment = first; segment <= last; ++segment) {
    const PathPlace place = placeOn(segment, position);
    if (place.distanceMm <= radiusMm) {
      search.found.push_back(place);
    }
  }
  return minima(std::move(search.found));
}

PathPlace ProgramPath::nearest(base::Vec3 position, double fromMm, double toMm) const {
  PathPlace best;
  best.distanceMm = std::numeric_limits<double>::infinity();
  const std::size_t first = segmentAt(fromMm);
  const std::size_t last = lastOf(first, fromMm, toMm);
  for (std::size_t segment = first; segment <= last; ++segment) {
    const PathPlace place = placeOn(segment, position);
    if (place.distanceMm < best.distanceMm) {
      best = place;
    }
  }
  return best;
}

}  // namespace rivulet::trace
