// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A place on the path that has not been evaluated yet: what the look-ahead hands to the
/// interpolation in each cycle. Machine coordinates. @threadsafety plain values.
#pragma once

#include <cstddef>
#include <optional>

#include "base/axes.h"
#include "base/vec3.h"
#include "machine/path_piece.h"

namespace rivulet::machine {

struct PathPlace {
  PathPiece path{};
  double mm = 0.0;  ///< path length from the start of the piece
  base::RotaryDeg startDeg{};
  base::RotaryDeg degPerMm{};  ///< of A, B, C along the piece
  /// At the end of a block: the programmed end point, without the rounding of the path.
  std::optional<base::Vec3> exactMm{};
  std::optional<base::RotaryDeg> exactDeg{};

  [[nodiscard]] base::Vec3 positionMm() const { return exactMm ? *exactMm : path.at(mm); }
  [[nodiscard]] base::RotaryDeg positionDeg() const {
    if (exactDeg) {
      return *exactDeg;
    }
    base::RotaryDeg angles = startDeg;
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      angles[axis] += mm * degPerMm[axis];
    }
    return angles;
  }
};

}  // namespace rivulet::machine
