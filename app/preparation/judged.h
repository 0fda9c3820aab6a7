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
#include "streaming/calibration_record.h"
#include "streaming/feed_plan.h"
#include "streaming/run.h"
#include "widgets/program/program_view.h"
#include "widgets/streaming/stream_settings.h"

namespace rivulet::preparation {

/// @param parameters  of the method, with the axes that the program turns
/// @param view  null: no program is loaded  @param machineFeeds  limits of the machine, at 100 %
/// @param calibration  what access costs; null: not measured
[[nodiscard]] streaming::RunSettings runSettings(
    const widgets::StreamSettings& settings, const templates::TemplateParameters& parameters,
    const widgets::ProgramView* view, const gcode::ProgramFeeds& machineFeeds,
    std::shared_ptr<const streaming::CalibrationRecord> calibration);

/// The settings that a run was started with, as far as they decide what it does; the others stay as
/// they are.
[[nodiscard]] widgets::StreamSettings settingsOfRun(const streaming::RunSettings& run,
                                                    widgets::StreamSettings settings);

struct Judged {
  std::optional<templates::CellMap> cells;
  std::string templateText;                  ///< empty: see `settingsError`
  std::optional<base::Error> settingsError;  ///< why no flexible program or verdict can be had
  std::optional<feasibility::ProgramDistances> distances;
  std::optional<feasibility::Verdict> verdict;
  /// With the feeds of the program: the largest override, and the block that limits it.
  std::optional<streaming::OverrideLimit> overrideLimit;
};

/// @param view  null: only the settings are judged  @param problem  with them that is known already
[[nodiscard]] Judged judge(const widgets::ProgramView* view, const streaming::RunSettings& settings,
                           const feasibility::AccessModel& access,
                           std::optional<base::Error> problem = {});

}  // namespace rivulet::preparation
