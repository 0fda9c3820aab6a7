// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Completes the settings of a run that takes its feeds from the program: may it, and where do the
/// feeds travel: one per window, which then ends where the feed changes, or one per point, which
/// costs a cell more in each. @threadsafety pure.
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "feasibility/access_model.h"
#include "feasibility/verdict.h"
#include "gcode/feeds.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

/// @return FeedUnknown (naming the line) if a move of the program has no known feed;
///         OneFeedOnly if the method has one feed for all moves; BadOverride. Nothing is wrong with
///         one feed for all moves.
[[nodiscard]] base::Result<void> requireFeeds(const gcode::Trajectory& trajectory,
                                              const RunSettings& settings);
/// The same for a program of which `gcode::lineWithoutFeed` is known.
[[nodiscard]] base::Result<void> requireFeeds(std::optional<base::LineNumber> lineWithoutFeed,
                                              const RunSettings& settings);

/// True if a feed in each point makes the run shorter than windows that end where the feed changes:
/// the time of each window is that of its motion and of the stop after it, or that of the client's
/// turn if it is longer. The beginning of a long program decides.
/// @param points  at least 1, with their feeds  @param access  cost of access
[[nodiscard]] bool prefersFeedPerPoint(std::span<const gcode::StreamPoint> points,
                                       const RunSettings& settings,
                                       const feasibility::AccessModel& access);

/// What `planFeeds` chooses by itself.
enum class FeedCells { Best, PerWindow, PerPoint };

/// Sets `RunSettings::feedMmPerS` to the largest feed that is commanded, which the verdict and all
/// scales refer to, and chooses the cells of the feeds. Settings with one feed stay as they are.
/// @param points  of the run, with their feeds
void planFeeds(RunSettings& settings, std::span<const gcode::StreamPoint> points,
               const feasibility::AccessModel& access, FeedCells cells = FeedCells::Best);

/// The largest override at which the limiting condition still holds, and the block that limits it.
struct OverrideLimit {
  double overrideFactor = 1.0;  ///< may exceed what the machine offers
  base::LineNumber line;
  double feedMmPerS = 0.0;  ///< of that block at 100 %
  double stepMm = 0.0;      ///< length of its move, mm; degrees if it only turns
  bool isRapid = false;
};

/// @param points  those that were judged, with their feeds
/// @param overrideOfPoints  at which these feeds are; nothing: that of the settings
/// @return nothing: one feed for all moves, or no condition with a place limits it
[[nodiscard]] std::optional<OverrideLimit> overrideLimit(
    const feasibility::Verdict& verdict, std::span<const gcode::StreamPoint> points,
    const RunSettings& settings, std::optional<double> overrideOfPoints = {});

/// "largest override 62 %, limited by line 214: F 2000, 0.300 mm"
[[nodiscard]] std::string describe(const OverrideLimit& limit);

}  // namespace rivulet::streaming
