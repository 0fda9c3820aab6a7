// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The programmed path as a line over its length, with a quick search for what
/// is near a place.
/// @threadsafety immutable after construction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/vec3.h"
#include "gcode/trajectory.h"

namespace rivulet::trace {

/// A place on the path.
struct PathPlace {
  double lengthMm = 0.0;    ///< from the start of the path
  double distanceMm = 0.0;  ///< of the position asked for
  std::size_t segment = 0;  ///< ends at point `segment` of the list
};

/// Segment i leads to point i of the list; segment 0 comes from the start.
class ProgramPath {
 public:
  /// @param points  not empty, finite  @param startMm  where the tool stood
  /// before the first
  ProgramPath(std::vector<gcode::StreamPoint> points, base::Vec3 startMm);

  [[nodiscard]] const std::vector<gcode::StreamPoint>& points() const { return m_points; }
  [[nodiscard]] double lengthMm() const { return m_lengths.back(); }
  /// Of the path up to the end of a segment.
  [[nodiscard]] double lengthTo(std::size_t segment) const { return m_lengths[segment + 1]; }
  [[nodiscard]] base::Vec3 at(double lengthMm) const;
  [[nodiscard]] std::size_t segmentAt(double lengthMm) const;
  /// Unit vector; zero if the segment has no length.
  [[nodiscard]] base::Vec3 direction(std::size_t segment) const;
  /// False for the chords within an arc or spline: their ends are no programmed
  /// points.
  [[nodiscard]] bool isBlockEnd(std::size_t segment) const;

  /// The nearest place of each run of segments that lies within `radiusMm`, in
  /// the order of the path: several if the path passes there more than once.
  /// O(log(points) + found).
  [[nodiscard]] std::vector<PathPlace> near(base::Vec3 position, double radiusMm) const;
  /// The same. @return nothing if more than so many segments are within the
  /// radius
  [[nodiscard]] std::optional<std::vector<PathPlace>> nearIfFew(base::Vec3 position,
                                                                double radiusMm,
                                                                std::size_t segmentsMax) const;
  /// The same of a part of the path. O(segments of it).
  [[nodiscard]] std::vector<PathPlace> nearWithin(base::Vec3 position, double radiusMm,
                                                  double fromMm, double toMm) const;
  /// The nearest place of a part of the path.
  [[nodiscard]] PathPlace nearest(base::Vec3 position, double fromMm, double toMm) const;

 private:
  /// Segments that are looked at one by one.
  static constexpr std::size_t kLeaf = 4;
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  struct Box {
    base::Vec3 min{kFar, kFar, kFar};
    base::Vec3 max{-kFar, -kFar, -kFar};
  };
  [[nodiscard]] base::Vec3 begin(std::size_t segment) const {
    return segment == 0 ? m_startMm : m_points[segment - 1].positionMm;
  }
  /// The place on a segment that is nearest to a position.
  struct Foot {
    double share = 0.0;  ///< of the length of the segment
    double distanceMm = 0.0;
  };
  struct Ends {
    base::Vec3 from;
    base::Vec3 to;
  };
  [[nodiscard]] static Foot footOn(const Ends& ends, base::Vec3 position);
  [[nodiscard]] PathPlace placeAt(std::size_t segment, const Foot& foot) const;
  [[nodiscard]] PathPlace placeOn(std::size_t segment, base::Vec3 position) const;
  /// The last segment of a part of the path that begins in another one. Most
  /// parts are short.
  [[nodiscard]] std::size_t lastOf(std::size_t first, double fromMm, double toMm) const;
  /// Divides the segments below a node in space, so that turns of a spiral or
  /// lines of a raster that pass by far away are not looked at. @param first of
  /// `m_bySpace`  @param size  its places
  void sort(std::size_t node, std::size_t first, std::size_t size);
  /// What is within a distance of a place.
  struct Search {
    base::Vec3 position;
    double radiusMm = 0.0;
    std::size_t most = 0;          ///< it ends when it has found more
    std::vector<PathPlace> found;  ///< one for each segment
  };
  void collect(std::size_t node, std::size_t first, std::size_t size, Search& search) const;
  /// Of neighbouring segments, the local minima of the distance. @param found
  /// in any order
  [[nodiscard]] std::vector<PathPlace> minima(std::vector<PathPlace> found) const;

  std::vector<gcode::StreamPoint> m_points;
  base::Vec3 m_startMm;
  std::vector<double> m_lengths;         ///< at the vertices: the start and every point
  std::vector<std::uint32_t> m_bySpace;  ///< segments, in the order of the tree's leaves
  std::vector<Ends> m_ends;              ///< of them, in the same order: beside each other
  std::vector<Box> m_boxes;  ///< binary tree from 1; the children of n are 2n and 2n + 1
};

}  // namespace rivulet::trace
