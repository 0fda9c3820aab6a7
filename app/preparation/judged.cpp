// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "preparation/judged.h"

#include <fmt/format.h>

#include <utility>

#include "report/operating_point.h"
#include "streaming/control/access_policy.h"

namespace rivulet::preparation {

namespace {

/// A single point has no distances.
constexpr std::size_t kPointsMin = 2;

}  // namespace

std::optional<feasibility::ProgramDistances> distancesOf(const overview::ProgramView& view,
                                                         int pointsPerLoop, bool isTimed) {
  if (view.points.points.size() < kPointsMin) {
    return std::nullopt;
  }
  if (view.distancesFor == pointsPerLoop) {
    return isTimed ? view.timedDistances : view.distances;
  }
  return pointsPerLoop >= 2 ? feasibility::programDistances(view.points.points, pointsPerLoop,
                                                            isTimed ? view.fastestMmPerS : 0.0)
                            : std::optional<feasibility::ProgramDistances>();
}

streaming::RunSettings runSettings(
    const streaming::StreamSettings& wanted, const templates::TemplateParameters& parameters,
    const overview::ProgramView* view, const gcode::ProgramFeeds& machineFeeds,
    std::shared_ptr<const streaming::CalibrationRecord> calibration) {
  const streaming::AccessPlan plan = streaming::accessPlan(wanted.access, wanted.parameters.method);
  streaming::RunSettings settings;
  settings.parameters = parameters;
  settings.deltaMm = wanted.deltaMm;
  settings.feedMmPerS = wanted.feedMmPerS;
  if (wanted.usesProgramFeeds() && view != nullptr) {
    settings.programFeeds = machineFeeds;
    settings.programFeeds->overrideFactor = wanted.overrideFactor;
    if (view->fastestMmPerS > 0.0) {
      settings.feedMmPerS = wanted.overrideFactor * view->fastestMmPerS;
    }
  }
  settings.tolerance = view != nullptr && view->isJob() ? 0.0 : wanted.tolerance;
  settings.factor = wanted.factor;
  settings.transfer =
      wanted.transferByHand ? streaming::TransferWay::ByHand : streaming::TransferWay::Link;
  settings.access = plan.choice;
  settings.grouping = plan.grouping;
  if (calibration) {
    const streaming::Calibration* measured = &calibration->calibration;
    settings.calibration =
        std::shared_ptr<const streaming::Calibration>(std::move(calibration), measured);
  }
  return settings;
}

streaming::StreamSettings settingsOfRun(const streaming::RunSettings& run,
                                        streaming::StreamSettings settings) {
  settings.parameters = run.parameters;
  settings.factor = run.factor;
  settings.tolerance = run.tolerance;
  settings.programFeeds = run.programFeeds.has_value();
  if (run.programFeeds) {
    settings.overrideFactor = run.programFeeds->overrideFactor;
  } else {
    settings.feedMmPerS = run.feedMmPerS;
  }
  return settings;
}

Judged judge(const overview::ProgramView* view, const streaming::RunSettings& settings,
             const feasibility::AccessModel& access, std::optional<base::Error> problem) {
  return judgeWith(view != nullptr
                       ? distancesOf(*view, report::operatingPointOf(settings).pointsPerLoop,
                                     settings.programFeeds.has_value())
                       : std::nullopt,
                   view, settings, access, std::move(problem));
}

Judged judgeWith(const std::optional<feasibility::ProgramDistances>& distances,
                 const overview::ProgramView* view, const streaming::RunSettings& settings,
                 const feasibility::AccessModel& access, std::optional<base::Error> problem) {
  Judged found;
  const feasibility::OperatingPoint point = report::operatingPointOf(settings);
  if (auto flexible = templates::makeProgram(settings.parameters)) {
    found.flexible = std::make_shared<const templates::FlexibleProgram>(std::move(*flexible));
  } else {
    found.settingsError = flexible.error();
  }
  if (problem) {
    found.settingsError = std::move(problem);
  }
  if (view == nullptr) {
    return found;
  }
  found.distances = distances;
  if (!found.settingsError) {
    if (const auto known = streaming::requireFeeds(view->lineWithoutFeed, settings); !known) {
      found.settingsError = known.error();
      if (known.error().code == streaming::StreamError::FeedUnknown) {
        found.settingsError->context = fmt::format("Line {}", view->lineWithoutFeed->value);
      }
    }
  }
  // Of a path that is not known nothing can be said.
  if (!found.settingsError && found.distances && view->program->isStreamable()) {
    auto verdict = feasibility::judge(point, *found.distances, access);
    if (verdict) {
      found.verdict = *verdict;
      found.overrideLimit = streaming::overrideLimit(*verdict, view->points.points, settings, 1.0);
    } else {
      found.settingsError = verdict.error();
    }
  }
  return found;
}

}  // namespace rivulet::preparation
