// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/arc.h"

namespace rivulet::gcode {

ArcWords readAs(CentreReading reading, ArcWords words) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!words.centre[axis]) {
      continue;
    }
    if (reading == CentreReading::Absolute) {
      words.centreIsAbsolute[axis] = true;
    } else if (reading == CentreReading::StartMinusCentre && !words.centreIsAbsolute[axis]) {
      *words.centre[axis] *= -1.0;
    }
  }
  return words;
}

}  // namespace rivulet::gcode
