// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Points whose coordinates share a cell, see `base::Packing`. @threadsafety pure.
#pragma once

#include "base/axes.h"
#include "base/packing.h"
#include "gcode/trajectory.h"

namespace rivulet::gcode {

/// Both points can be in one window.
[[nodiscard]] inline bool sharesCell(const base::Packing& packing, const StreamPoint& first,
                                     const StreamPoint& point) {
  bool fits = true;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    fits = fits && packing.fits(first.positionMm[axis], point.positionMm[axis]);
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    fits = fits && packing.fits(first.rotaryDeg[axis], point.rotaryDeg[axis]);
  }
  return fits;
}

[[nodiscard]] inline base::AxisPosition onSteps(base::AxisPosition place) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    place.mm.set(axis, base::Packing::rounded(place.mm[axis]));
  }
  for (double& deg : place.deg) {
    deg = base::Packing::rounded(deg);
  }
  return place;
}

/// Onto whole steps; what stands where it stood stays there.
inline void roundToSteps(StreamPoint& point, const base::AxisPosition& stood) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double mm = point.positionMm[axis];
    point.positionMm.set(axis, mm == stood.mm[axis] ? mm : base::Packing::rounded(mm));
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const double deg = point.rotaryDeg[axis];
    point.rotaryDeg[axis] = deg == stood.deg[axis] ? deg : base::Packing::rounded(deg);
  }
}

}  // namespace rivulet::gcode
