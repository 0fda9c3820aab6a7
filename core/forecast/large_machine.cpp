// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/large_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "forecast/job_forecast.h"
#include "nc/cycles/milling.h"

namespace rivulet::forecast {

namespace {

/// A path that ends at a limit may be rounded beyond it.
constexpr double kMarginMm = 1.0;
/// A block that is refused hides those after it.
constexpr int kLooksMax = 20;
/// Of radius compensation, and of the milling cycles.
constexpr std::array kToolTooLarge{10751, nc::kToolTooLarge};

bool isToolTooLarge(int alarm) {
  return std::find(kToolTooLarge.begin(), kToolTooLarge.end(), alarm) != kToolTooLarge.end();
}

/// @return false if nothing was to do
bool widen(machine::AxisLimits& limits, double targetMm) {
  const double minMm = std::min(limits.positionMmMin, std::floor(targetMm - kMarginMm));
  const double maxMm = std::max(limits.positionMmMax, std::ceil(targetMm + kMarginMm));
  const bool changes = minMm < limits.positionMmMin || maxMm > limits.positionMmMax;
  limits.positionMmMin = minMm;
  limits.positionMmMax = maxMm;
  return changes;
}

bool takePointedTools(machine::MachineConfig& config) {
  bool changes = false;
  for (machine::Tool& tool : config.tools->tools) {
    for (machine::ToolEdge& edge : tool.edges) {
      changes = changes || edge.radiusMm > 0.0;
      edge.radiusMm = 0.0;
    }
  }
  return changes;
}

}  // namespace

std::vector<std::string> enlarge(machine::MachineConfig& config, const job::Plan& plan) {
  const auto before = config.axes;
  std::vector<std::string> notes;
  bool changes = true;
  for (int look = 0; look < kLooksMax && changes; ++look) {
    changes = false;
    for (const Hazard& hazard : hazardsOf(plan, config, {config.start()})) {
      if (hazard.kind == HazardKind::Travel && !hazard.travel->isRotary()) {
        const auto axis = static_cast<std::size_t>(hazard.travel->axis - 'X');
        changes = widen(config.axes[axis], hazard.travel->target) || changes;
      } else if (hazard.kind == HazardKind::Refused && isToolTooLarge(hazard.alarm) &&
                 takePointedTools(config)) {
        changes = true;
        notes.push_back(fmt::format(
            "The tools of the machine are too large for the contour at line {}: all have radius 0.",
            hazard.line.value));
      }
    }
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const machine::AxisLimits& had = before[axis];
    const machine::AxisLimits& has = config.axes[axis];
    if (had.positionMmMin != has.positionMmMin || had.positionMmMax != has.positionMmMax) {
      notes.push_back(fmt::format(
          "The job needs more travel than the machine has: {} goes from {:g} to {:g} mm "
          "instead of {:g} to {:g} mm. Name your machine (--preset) to check its travel.",
          base::kAxisNames[axis], has.positionMmMin, has.positionMmMax, had.positionMmMin,
          had.positionMmMax));
    }
  }
  return notes;
}

}  // namespace rivulet::forecast
