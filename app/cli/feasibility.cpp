// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "gcode/program.h"
#include "report/calibration_json.h"
#include "report/report_json.h"
#include "streaming/pause_placement.h"

namespace rivulet::cli {

namespace {

/// Where the tool is taken to stand for programs that leave coordinates open.
constexpr base::Vec3 kOriginMm{0.0, 0.0, 0.0};

void print(const feasibility::Verdict& verdict) {
  fmt::print("{}\n", !verdict.feasible ? "NOT feasible"
                     : verdict.waits   ? "feasible, but the machine will wait for the client"
                                       : "feasible");
  for (const feasibility::Condition& condition : verdict.conditions) {
    fmt::print("  {:<18} margin {:.3f}  {}{}", feasibility::equationLabel(condition.equation),
               condition.margin, condition.margin > 1.0 ? "holds" : "does not hold",
               condition.decides ? "" : " (for information)");
    if (condition.place) {
      fmt::print("  lines {} to {}", condition.place->firstLine.value,
                 condition.place->lastLine.value);
    }
    fmt::print("\n");
  }
  const bool reach = verdict.limiting.equation == feasibility::Equation::Reach;
  fmt::print("  limiting: {}; largest feed{} {:.0f} mm/min\n",
             feasibility::equationLabel(verdict.limiting.equation), reach ? " without waiting" : "",
             base::mmPerMinFromMmPerS(verdict.feedMmPerSMax));
}

}  // namespace

Exit feasibility(const FeasibilityOptions& options) {
  feasibility::OperatingPoint point;
  point.method = options.point.parameters().method;
  point.pointsPerLoop = options.point.pointsPerLoop;
  point.deltaMm = options.point.deltaMm;
  point.feedMmPerS = base::mmPerSFromMmPerMin(options.point.feedMmPerMin);
  feasibility::AccessModel access;
  access.accessTime = base::fromMilliseconds(options.accessTimeMs);
  CalibrationChoice calibrated;
  if (!options.calibration.empty()) {
    auto record = report::readCalibration(options.calibration);
    if (!record) {
      return reportError(record.error(), options.json);
    }
    calibrated.record = std::move(*record);
  } else if (!options.endpoint.empty()) {
    auto connection = connectTo(options.endpoint);
    if (!connection) {
      return reportError(connection.error(), options.json);
    }
    auto choice = calibrationOf(*connection);
    if (!choice) {
      return reportError(choice.error(), options.json);
    }
    calibrated = std::move(*choice);
  }
  opcua::Grouping form = opcua::Grouping::List;
  if (const streaming::CalibrationRecord* record = calibrated.usable()) {
    form = formOf(point.method, record->calibration);
    access = report::accessModel(record->calibration, form);
  }
  feasibility::SafetyFactors safety;
  safety.delta = options.deltaSafety;

  feasibility::ProgramDistances distances;
  std::optional<std::size_t> pauses;
  std::optional<streaming::PausePlacement> placement;
  nlohmann::ordered_json json;
  if (!options.program.empty()) {
    auto program = gcode::loadProgram(options.program, options.loading.loadOptions());
    if (!program) {
      return reportError(program.error(), options.json);
    }
    program->trajectory = options.resampling.resampled(std::move(program->trajectory));
    const gcode::PointList list = gcode::streamPoints(program->trajectory, kOriginMm);
    if (list.points.size() < 2) {
      return reportError(
          base::makeError(gcode::GcodeError::NoMotion,
                          "The program has fewer than two points. Choose another.", program->name),
          options.json);
    }
    distances = feasibility::programDistances(list.points, point.pointsPerLoop);
    json["program"] = program->name;
    json["points"] = list.points.size();
    json["distances"] = report::distancesJson(distances);
    if (point.method == base::MethodKind::Window) {
      const auto perWindow = static_cast<std::size_t>(std::max(point.pointsPerLoop, 1));
      placement = streaming::placePauses(list.points, perWindow);
      const streaming::PausePlacement even = streaming::evenPauses(list.points, perWindow);
      pauses = placement->pauses();
      json["planned_pauses"] = *pauses;
      json["planned_pauses_in_cut"] = placement->inCut;
      json["even_pauses"] = even.pauses();
      json["even_pauses_in_cut"] = even.inCut;
    }
  } else {
    distances.pointDistanceMmMin = options.pointDistanceMm.value_or(0.0);
    json["d_min_mm"] = distances.pointDistanceMmMin;
  }
  const auto verdict = feasibility::judge(point, distances, access, safety);
  if (!verdict) {
    return reportError(verdict.error(), options.json);
  }
  if (options.json) {
    json.update(report::verdictJson(*verdict));
    json["method"] = options.point.method;
    json["points_per_loop"] = point.pointsPerLoop;
    json["delta_mm"] = point.deltaMm;
    json["feed_mm_per_min"] = options.point.feedMmPerMin;
    json["access_time"] = accessSourceJson(calibrated, form, *verdict);
    printJson(json);
  } else {
    if (distances.windowSteps > 0) {
      fmt::print(
          "d_min {:.4f} mm (lines {} to {}), d_min^N {:.4f} mm over {} steps (lines {} to "
          "{})\n",
          distances.pointDistanceMmMin, distances.pointDistancePlace.firstLine.value,
          distances.pointDistancePlace.lastLine.value, distances.windowLengthMmMin,
          distances.windowSteps, distances.windowPlace.firstLine.value,
          distances.windowPlace.lastLine.value);
    }
    print(*verdict);
    fmt::print("{}\n", accessSourceText(calibrated, form, *verdict));
    if (pauses) {
      fmt::print(
          "  {} planned pauses, one between windows, {} of them in the cut (no way to cut the "
          "windows has fewer)\n",
          *pauses, placement ? placement->inCut : 0);
    }
  }
  return verdict->feasible ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
