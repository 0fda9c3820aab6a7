// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the settings make of a program, before anything is started. @threadsafety pure.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "feasibility/verdict.h"
#include "gcode/feeds.h"
#include "overview/program_view.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/run/run.h"
#include "streaming/setup/calibration_record.h"
#include "streaming/start/stream_settings.h"
#include "templates/flexible_program.h"

namespace rivulet::preparation {

/// @param parameters  of the method, with the axes that the program turns
/// @param view  null: no program is loaded  @param machineFeeds  limits of the machine, at 100 %
/// @param calibration  what access costs; null: not measured
[[nodiscard]] streaming::RunSettings runSettings(
    const streaming::StreamSettings& settings, const templates::TemplateParameters& parameters,
    const overview::ProgramView* view, const gcode::ProgramFeeds& machineFeeds,
    std::shared_ptr<const streaming::CalibrationRecord> calibration);

/// The settings that a run was started with, as far as they decide what it does; the others stay as
/// they are.
[[nodiscard]] streaming::StreamSettings settingsOfRun(const streaming::RunSettings& run,
                                                      streaming::StreamSettings settings);

struct Judged {
  /// What the control would run; null: see `settingsError`.
  std::shared_ptr<const templates::FlexibleProgram> flexible;
  std::optional<base::Error> settingsError;  ///< why no flexible program or verdict can be had
  std::optional<feasibility::ProgramDistances> distances;
  std::optional<feasibility::Verdict> verdict;
  /// With the feeds of the program: the largest override, and the block that limits it.
  std::optional<streaming::OverrideLimit> overrideLimit;
};

/// @param view  null: only the settings are judged  @param problem  with them that is known already
[[nodiscard]] Judged judge(const overview::ProgramView* view,
                           const streaming::RunSettings& settings,
                           const feasibility::AccessModel& access,
                           std::optional<base::Error> problem = {});

/// What the verdict takes of a path: O(points), unless the view has them.
/// @param isTimed  the points have feeds of their own
/// @return nothing: no verdict can be had with so few points
[[nodiscard]] std::optional<feasibility::ProgramDistances> distancesOf(
    const overview::ProgramView& view, int pointsPerLoop, bool isTimed);
/// The same as `judge`, with the distances of the view.
[[nodiscard]] Judged judgeWith(const std::optional<feasibility::ProgramDistances>& distances,
                               const overview::ProgramView* view,
                               const streaming::RunSettings& settings,
                               const feasibility::AccessModel& access,
                               std::optional<base::Error> problem);

}  // namespace rivulet::preparation
