// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/operating_point.h"

#include <algorithm>

namespace rivulet::report {

feasibility::OperatingPoint operatingPointOf(const streaming::RunSettings& settings) {
  const templates::TemplateParameters& parameters = settings.parameters;
  return {parameters.method,
          parameters.pointsPerLoop,
          settings.deltaMm,
          settings.feedMmPerS,
          templates::cellsPerPoint(parameters),
          parameters.feedPerPoint,
          templates::cellsOfFirstPoint(parameters)};
}

gcode::ProgramFeeds programFeedsOf(const machine::MachineConfig& machine, double overrideFactor,
                                   double rapidMmPerS) {
  const double rapid = rapidMmPerS > 0.0 ? rapidMmPerS : machine.rapidMmPerS;
  return {overrideFactor, rapid, std::max(rapid, machine.feedMmPerSMax())};
}

}  // namespace rivulet::report
