// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/facts.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::gcode {

std::string_view fileUnitsName(FileUnits units) {
  switch (units) {
    case FileUnits::Unspecified:
      return "unspecified";
    case FileUnits::Millimetres:
      return "mm";
    case FileUnits::Inches:
      return "in";
    case FileUnits::Mixed:
      return "mixed";
  }
  base::contractViolated("every unit has a name", __FILE__, __LINE__);
}

std::optional<FileUnits> saidUnitsOfName(std::string_view name) {
  for (const FileUnits units : {FileUnits::Millimetres, FileUnits::Inches}) {
    if (fileUnitsName(units) == name) {
      return units;
    }
  }
  return std::nullopt;
}

std::string_view centreReadingName(CentreReading reading) {
  switch (reading) {
    case CentreReading::AsProgrammed:
      return "as-programmed";
    case CentreReading::Absolute:
      return "absolute";
    case CentreReading::StartMinusCentre:
      return "start-minus-centre";
  }
  base::contractViolated("every reading has a name", __FILE__, __LINE__);
}

std::optional<CentreReading> centreReadingOfName(std::string_view name) {
  const auto found =
      std::find_if(kCentreReadings.begin(), kCentreReadings.end(),
                   [name](CentreReading reading) { return centreReadingName(reading) == name; });
  return found == kCentreReadings.end() ? std::nullopt : std::optional(*found);
}

}  // namespace rivulet::gcode
