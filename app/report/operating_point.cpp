// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/operating_point.h"

namespace rivulet::report {

feasibility::OperatingPoint operatingPointOf(const streaming::RunSettings& settings) {
  const templates::TemplateParameters& parameters = settings.parameters;
  return {parameters.method, parameters.pointsPerLoop, settings.deltaMm, settings.feedMmPerS,
          templates::cellsPerPoint(parameters)};
}

}  // namespace rivulet::report
