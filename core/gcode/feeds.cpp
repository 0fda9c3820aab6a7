// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/feeds.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::gcode {

double commandedMmPerS(const TrajectoryPoint& point, const ProgramFeeds& feeds) {
  RIVULET_ASSERT(feeds.overrideFactor > 0.0);
  RIVULET_ASSERT(feeds.rapidMmPerS > 0.0 && feeds.feedMmPerSMax > 0.0);
  const bool isRapid = point.kind == MoveKind::Rapid;
  const double programmed = isRapid ? feeds.rapidMmPerS : point.feedMmPerS;
  const double limit = isRapid ? feeds.rapidMmPerS : feeds.feedMmPerSMax;
  return std::min({feeds.overrideFactor * programmed, limit, feeds.feedMmPerSMax});
}

std::optional<base::LineNumber> lineWithoutFeed(const Trajectory& trajectory) {
  const auto found = std::find_if(
      trajectory.points.begin(), trajectory.points.end(), [](const TrajectoryPoint& point) {
        return point.kind != MoveKind::Rapid && !(point.feedMmPerS > 0.0);
      });
  return found == trajectory.points.end() ? std::nullopt : std::optional(found->line);
}

}  // namespace rivulet::gcode
