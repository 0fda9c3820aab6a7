// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/exec/position.h"

#include <cmath>

#include "nc/unknown.h"

namespace rivulet::nc {

Position::Position() {
  programmedMm = {kUnknown, kUnknown, kUnknown};
  rotaryDeg.fill(kUnknown);
}

void Position::setFrame(const Frame& other) {
  const base::Vec3 workpieceMm = frame.toWorkpiece(programmedMm);
  frame = other;
  programmedMm = frame.toProgrammed(workpieceMm);
}

void Position::setZero(base::Vec3 otherMm) {
  if (otherMm != zeroMm) {
    const base::Vec3 workpieceMm = frame.toWorkpiece(programmedMm) + (zeroMm - otherMm);
    zeroMm = otherMm;
    programmedMm = frame.toProgrammed(workpieceMm);
  }
}

double Position::lengthMmTo(base::Vec3 targetMm) const {
  const base::Vec3 to = frame.toWorkpiece(targetMm);
  const base::Vec3 way = to - frame.toWorkpiece(programmedMm);
  const double squares = base::dot(way, way);
  if (!std::isnan(squares)) {
    return std::sqrt(squares);
  }
  double knownSquares = 0.0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!std::isnan(way[axis])) {
      knownSquares += way[axis] * way[axis];
    } else if (!std::isnan(to[axis])) {
      return 0.0;
    }
  }
  return std::sqrt(knownSquares);
}

double Position::turnDegTo(const base::RotaryDeg& targetDeg) const {
  base::RotaryDeg fromDeg = rotaryDeg;
  base::RotaryDeg toDeg = targetDeg;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (std::isnan(toDeg[axis])) {
      fromDeg[axis] = toDeg[axis] = 0.0;  // no word has named it: it stays
    }
  }
  const double turn = base::turnDeg(fromDeg, toDeg);
  return std::isnan(turn) ? 0.0 : turn;
}

}  // namespace rivulet::nc
