// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A path in levels of detail, so that the cost of a picture of a million points depends on what
/// the screen can show.
///
/// How it works. Level 0 has every point. Each further level is made from the previous one: points
/// are left out as long as they are near the line that replaces them, and the allowed distance (at
/// least) doubles from level to level. Half of a level's tolerance is for its own step, the other
/// half covers all previous steps, so no omitted point is farther than the tolerance from the line
/// drawn in its place. A distance in space is never smaller than in a picture of it, so one set of
/// levels serves every view.
///
/// The points of a level are divided into chunks, each with its box in a view: chunks outside the
/// window are not drawn.
///
/// Made outside the GUI thread, in linear time. @threadsafety immutable once made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vec3.h"
#include "gcode/trajectory.h"

namespace rivulet::overview {

enum class PathProjection : unsigned char { Top, Isometric };
inline constexpr std::size_t kProjectionCount = 2;

/// A place in the plane of a picture: to the right and up, mm.
struct PlanePoint {
  double right = 0.0;
  double up = 0.0;
};
[[nodiscard]] PlanePoint project(base::Vec3 positionMm, PathProjection projection);

struct PlaneBox {
  float left = 0.0F;
  float right = 0.0F;
  float low = 0.0F;
  float high = 0.0F;
};

/// Moves of a chunk: those that end at the points after its first one.
inline constexpr std::size_t kChunkMoves = 128;

struct PathLevel {
  double toleranceMm = 0.0;         ///< no omitted point is farther from the drawn line
  std::vector<std::uint32_t> kept;  ///< indices of the points, ascending; the first and last are in
  /// Per projection the box of each chunk; chunk c has the kept points from c·kChunkMoves to
  /// (c+1)·kChunkMoves, both included.
  std::array<std::vector<PlaneBox>, kProjectionCount> boxes;
};

class PathLevels {
 public:
  PathLevels() = default;
  /// @param isRapid  one per point: the move that ends there; levels keep the points where rapid
  ///                 and cutting moves meet, as long as other points can be left out
  /// @param goOn  called now and then; false: cancel (the levels are then those made so far)
  PathLevels(const std::vector<gcode::StreamPoint>& points, const std::vector<bool>& isRapid,
             const std::function<bool()>& goOn = {});

  /// From fine to coarse; empty if there are no points.
  [[nodiscard]] const std::vector<PathLevel>& levels() const { return m_levels; }
  /// Of the whole path.
  [[nodiscard]] const PlaneBox& box(PathProjection projection) const {
    return m_boxes[static_cast<std::size_t>(projection)];
  }

 private:
  std::vector<PathLevel> m_levels;
  std::array<PlaneBox, kProjectionCount> m_boxes{};
};

}  // namespace rivulet::overview
