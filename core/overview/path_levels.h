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
/// The points of a level are divided into chunks, each with its box: chunks outside the picture are
/// not drawn.
///
/// Made outside the GUI thread, in linear time. @threadsafety immutable once made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vec3.h"
#include "gcode/trajectory.h"
#include "overview/projection.h"

namespace rivulet::overview {

/// Moves of a chunk: those that end at the points after its first one.
inline constexpr std::size_t kChunkMoves = 128;

struct PathLevel {
  double toleranceMm = 0.0;         ///< no omitted point is farther from the drawn line
  std::vector<std::uint32_t> kept;  ///< indices of the points, ascending; the first and last are in
  /// Of each chunk; chunk c has the kept points from c·kChunkMoves to (c+1)·kChunkMoves, both
  /// included.
  std::vector<SpaceBox> boxes;
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
  [[nodiscard]] const SpaceBox& box() const { return m_box; }

 private:
  std::vector<PathLevel> m_levels;
  SpaceBox m_box;
};

}  // namespace rivulet::overview
