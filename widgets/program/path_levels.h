// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A path in levels of detail, so that a picture of a million points costs what the screen can
/// show.
///
/// How it works. Level 0 has every point. Each further level is made from the one before: points
/// are left out as long as they stay near the line that replaces them, and the distance allowed
/// doubles (at least) from level to level. Half of a level's tolerance goes to its own step, the
/// other half covers all steps before, so no point left out is farther than the tolerance from
/// the line drawn in its place. In space a distance is never smaller than in a picture of it,
/// therefore one set of levels serves every view.
///
/// The points of a level are cut into chunks with the box each fills in a view: what lies outside
/// the window is left out chunk by chunk.
///
/// Made away from the GUI thread, in linear time. @threadsafety immutable once made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vec3.h"
#include "gcode/trajectory.h"

namespace rivulet::widgets {

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

/// Moves of a chunk: those that end at the points behind its first one.
inline constexpr std::size_t kChunkMoves = 128;

struct PathLevel {
  double toleranceMm = 0.0;         ///< no point left out is farther from the line drawn
  std::vector<std::uint32_t> kept;  ///< indices of the points, ascending; the first and last are in
  /// Per projection the box of each chunk; chunk c has the kept points from c·kChunkMoves to
  /// (c+1)·kChunkMoves, both included.
  std::array<std::vector<PlaneBox>, kProjectionCount> boxes;
};

class PathLevels {
 public:
  PathLevels() = default;
  /// @param isRapid  one per point: the move that ends there; levels keep the points where rapid
  ///                 and cutting moves meet as long as that leaves anything out
  /// @param goOn     asked now and then; false: give up (the levels are then those made so far)
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

}  // namespace rivulet::widgets
