// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/feed_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/contract.h"
#include "base/units.h"
#include "streaming/methods/pause_placement.h"
#include "templates/flexible_program.h"

namespace rivulet::streaming {

namespace {

/// Enough to tell which cells make the run shorter.
constexpr std::size_t kPointsJudgedMax = 100'000;

/// Time of the move to point i; 0: it has no feed of its own. @param i > 0
double ownMoveS(std::span<const gcode::StreamPoint> points, std::size_t i) {
  return points[i].feedMmPerS > 0.0 ? moveS(points[i - 1], points[i], 0.0) : 0.0;
}

/// Time of a run, as far as the cells of the feeds change it.
double runS(std::span<const gcode::StreamPoint> points, const RunSettings& settings,
            const feasibility::AccessModel& access, bool feedPerPoint) {
  RunSettings with = settings;
  with.parameters.feedPerPoint = feedPerPoint;
  const templates::TemplateParameters& parameters = with.parameters;
  const feasibility::TurnSize turn{parameters.method, parameters.pointsPerLoop,
                                   templates::cellsPerPoint(parameters),
                                   templates::cellsOfFirstPoint(parameters)};
  const double turnS = base::toSeconds(access.timePerNode(turn)) * turnOf(turn).charged;
  const bool stops = !base::goesOn(parameters.method);
  const double stopS = stops ? base::toSeconds(settings.nominalPause) : 0.0;
  WindowCut cut = windowCut(with);
  cut.place = cut.place && stops;  // without pauses there is nothing to place
  std::vector<std::size_t> begins =
      cutWindows(points, static_cast<std::size_t>(parameters.pointsPerLoop), cut).begins;
  begins.push_back(points.size());
  double seconds = 0.0;
  for (std::size_t window = 0; window + 1 < begins.size(); ++window) {
    double motionS = 0.0;
    for (std::size_t i = std::max<std::size_t>(begins[window], 1); i < begins[window + 1]; ++i) {
      motionS += ownMoveS(points, i);
    }
    seconds += std::max(motionS + stopS, turnS);
  }
  return seconds;
}

}  // namespace

base::Result<void> requireFeeds(const gcode::Trajectory& trajectory, const RunSettings& settings) {
  return requireFeeds(settings.programFeeds ? gcode::lineWithoutFeed(trajectory) : std::nullopt,
                      settings);
}

base::Result<void> requireFeeds(std::optional<base::LineNumber> lineWithoutFeed,
                                const RunSettings& settings) {
  if (!settings.programFeeds) {
    return {};
  }
  const gcode::ProgramFeeds& feeds = *settings.programFeeds;
  if (base::isPublished(settings.parameters.method)) {
    return base::fail(
        StreamError::OneFeedOnly,
        fmt::format("Method {} has one feed for all moves, as published. Give a fixed feed, or "
                    "choose method window.",
                    base::methodName(settings.parameters.method)));
  }
  if (!(feeds.overrideFactor >= gcode::kOverrideMin) ||
      !(feeds.overrideFactor <= gcode::kOverrideMax) || !(feeds.rapidMmPerS > 0.0) ||
      !(feeds.feedMmPerSMax > 0.0)) {
    return base::fail(StreamError::BadOverride,
                      fmt::format("An override of {:.4g} %: choose {:.0f} to {:.0f} %.",
                                  100.0 * feeds.overrideFactor, 100.0 * gcode::kOverrideMin,
                                  100.0 * gcode::kOverrideMax));
  }
  if (lineWithoutFeed) {
    return base::fail(
        StreamError::FeedUnknown,
        fmt::format("The feed of line {} is not known: F is missing, or it is in mm per revolution "
                    "(G95) without a spindle speed, or as inverse time (G93) for a move of unknown "
                    "length. Give a fixed feed.",
                    lineWithoutFeed->value));
  }
  return {};
}

bool prefersFeedPerPoint(std::span<const gcode::StreamPoint> points, const RunSettings& settings,
                         const feasibility::AccessModel& access) {
  RIVULET_ASSERT(!points.empty());
  templates::TemplateParameters perPoint = settings.parameters;
  perPoint.feedPerPoint = true;
  if (!base::fillsWindows(perPoint.method) || !templates::requireProgram(perPoint)) {
    return false;
  }
  const auto judged = points.first(std::min(points.size(), kPointsJudgedMax));
  return runS(judged, settings, access, true) < runS(judged, settings, access, false);
}

void planFeeds(RunSettings& settings, std::span<const gcode::StreamPoint> points,
               const feasibility::AccessModel& access, FeedCells cells) {
  settings.parameters.feedPerPoint = false;
  if (!settings.programFeeds || points.empty()) {
    return;
  }
  const auto fastest =
      std::max_element(points.begin(), points.end(),
                       [](const auto& a, const auto& b) { return a.feedMmPerS < b.feedMmPerS; });
  if (fastest->feedMmPerS > 0.0) {
    settings.feedMmPerS = fastest->feedMmPerS;
  }
  settings.parameters.feedPerPoint =
      cells == FeedCells::PerPoint ||
      (cells == FeedCells::Best && prefersFeedPerPoint(points, settings, access));
}

std::optional<OverrideLimit> overrideLimit(const feasibility::Verdict& verdict,
                                           std::span<const gcode::StreamPoint> points,
                                           const RunSettings& settings,
                                           std::optional<double> overrideOfPoints) {
  const std::optional<feasibility::Place>& place = verdict.limiting.place;
  if (!settings.programFeeds || !place || points.size() < 2) {
    return std::nullopt;
  }
  const std::size_t first = place->point.value + 1;
  const std::size_t last = std::min(points.size() - 1, first + place->steps - 1);
  std::size_t shortest = std::min(first, last);
  for (std::size_t i = shortest; i <= last; ++i) {
    shortest = ownMoveS(points, i) < ownMoveS(points, shortest) ? i : shortest;
  }
  const gcode::StreamPoint& at = points[shortest];
  const double overrideFactor = settings.programFeeds->overrideFactor;
  return OverrideLimit{overrideFactor * verdict.limiting.margin, at.line,
                       at.feedMmPerS / overrideOfPoints.value_or(overrideFactor),
                       ownMoveS(points, shortest) * at.feedMmPerS,
                       at.kind == gcode::MoveKind::Rapid};
}

std::string describe(const OverrideLimit& limit) {
  return fmt::format("largest override {:.0f} %, limited by line {}: {}{:.0f}, {:.3f} mm",
                     100.0 * limit.overrideFactor, limit.line.value,
                     limit.isRapid ? "rapid " : "F ", base::mmPerMinFromMmPerS(limit.feedMmPerS),
                     limit.stepMm);
}

}  // namespace rivulet::streaming
