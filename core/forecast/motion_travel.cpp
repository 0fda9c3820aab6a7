// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/motion_travel.h"

#include <fmt/format.h>

#include <algorithm>

#include "forecast/job_forecast.h"
#include "job/main_program.h"
#include "machine/dry_run.h"

namespace rivulet::forecast {

namespace {

/// The least and the largest place of an axis.
struct Extent {
  const gcode::StreamPoint* least = nullptr;
  const gcode::StreamPoint* most = nullptr;
};

template <class PlaceOf>
Extent extentOf(std::span<const gcode::StreamPoint> points, PlaceOf placeOf) {
  const auto [least, most] = std::minmax_element(
      points.begin(), points.end(),
      [&placeOf](const auto& a, const auto& b) { return placeOf(a) < placeOf(b); });
  return {&*least, &*most};
}

base::Error beyond(const gcode::StreamPoint& point, const machine::BeyondTravel& travel) {
  Hazard hazard;
  hazard.kind = HazardKind::Travel;
  hazard.line = point.line;
  hazard.travel = travel;
  return base::makeError(job::JobError::BeyondMachine, describe(hazard) + " Nothing was moved.");
}

}  // namespace

std::optional<base::Vec3> activeZero(const machine::MachineConfig& machine,
                                     const streaming::EquipmentSeen& equipment) {
  if (!equipment.workOffset || equipment.workOffset->empty()) {
    return std::nullopt;
  }
  std::string text = *equipment.workOffset + "\n";
  const int edge = equipment.edge.value_or(0);
  if (edge > 0) {
    const std::string name = equipment.toolName.value_or("");
    const int tool = equipment.tool.value_or(0);
    if (tool == 0 && name.empty()) {
      return std::nullopt;
    }
    text += (tool > 0 ? fmt::format("T{}", tool) : fmt::format("T=\"{}\"", name)) +
            fmt::format(" M6\nD{}\n", edge);
  }
  const machine::DryRun run = machine::dryRun(machine, text + "M30\n", {machine.start(), {}});
  return run.isComplete && run.findings.empty() ? std::optional(run.zeroMm) : std::nullopt;
}

base::Result<void> requireWithinTravel(std::span<const gcode::StreamPoint> points,
                                       const machine::MachineConfig& machine,
                                       const std::optional<base::Vec3>& zeroMm) {
  if (points.empty()) {
    return {};
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const machine::AxisLimits& limits = machine.axes[axis];
    const Extent extent =
        extentOf(points, [axis](const auto& point) { return point.positionMm[axis]; });
    const double lengthMm = extent.most->positionMm[axis] - extent.least->positionMm[axis];
    const double travelMm = limits.positionMmMax - limits.positionMmMin;
    if (!zeroMm && lengthMm > travelMm) {
      return base::fail(
          job::JobError::BeyondMachine,
          fmt::format("The path is {:.3f} mm long in {}, from line {} to line {}, and the axis can "
                      "travel {:g} mm. Nothing was moved.",
                      lengthMm, base::kAxisNames[axis], extent.least->line.value,
                      extent.most->line.value, travelMm));
    }
    for (const gcode::StreamPoint* const point : {extent.least, extent.most}) {
      const double target = point->positionMm[axis] + (zeroMm ? (*zeroMm)[axis] : 0.0);
      if (zeroMm && (target < limits.positionMmMin || target > limits.positionMmMax)) {
        return base::fail(beyond(
            *point, {base::kAxisNames[axis], target, limits.positionMmMin, limits.positionMmMax}));
      }
    }
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const auto& limits = machine.rotaryAxes[axis];
    if (!limits) {
      continue;
    }
    const Extent extent =
        extentOf(points, [axis](const auto& point) { return point.rotaryDeg[axis]; });
    for (const gcode::StreamPoint* const point : {extent.least, extent.most}) {
      const double target = point->rotaryDeg[axis];
      if (target < limits->positionDegMin || target > limits->positionDegMax) {
        return base::fail(beyond(*point, {base::kRotaryAxisNames[axis], target,
                                          limits->positionDegMin, limits->positionDegMax}));
      }
    }
  }
  return {};
}

}  // namespace rivulet::forecast
