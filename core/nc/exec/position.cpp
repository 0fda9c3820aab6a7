// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/exec/position.h"

#include <cmath>
#include <limits>

namespace rivulet::nc {

Position::Position() {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  programmedMm = {kUnknown, kUnknown, kUnknown};
  rotaryDeg.fill(kUnknown);
}

void Position::setFrame(const Frame& other) {
  const base::Vec3 workpieceMm = frame.toWorkpiece(programmedMm);
  frame = other;
  programmedMm = frame.toProgrammed(workpieceMm);
}

double Position::lengthMmTo(base::Vec3 targetMm) const {
  double squares = 0.0;
  const base::Vec3 from = frame.toWorkpiece(programmedMm);
  const base::Vec3 to = frame.toWorkpiece(targetMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double step = to[axis] - from[axis];
    if (!std::isnan(step)) {
      squares += step * step;
    } else if (!std::isnan(to[axis])) {
      return 0.0;
    }
  }
  return std::sqrt(squares);
}

}  // namespace rivulet::nc
