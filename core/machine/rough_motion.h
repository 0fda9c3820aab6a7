// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The geometry of a prepared motion, before anything is said about speed: rough interpolation.
/// @threadsafety pure.
#pragma once

#include "base/axes.h"
#include "machine/config.h"
#include "machine/path_piece.h"
#include "machine/prepared.h"

namespace rivulet::machine {

/// A path shorter than this is no motion; far below the resolution of any control.
inline constexpr double kPathLengthMmMin = 1e-9;
/// A turn smaller than this is none.
inline constexpr double kPathTurnDegMin = 1e-9;

struct RoughMotion {
  PreparedMotion motion{};
  bool moves = false;  ///< false: the block ends where it begins; what follows is not used
  PathPiece path{};
  base::RotaryDeg fromDeg{};
  base::RotaryDeg degPerMm{};  ///< of A, B, C along the path
  double wayMm = 0.0;          ///< of X Y Z alone
  double turnDeg = 0.0;        ///< of the rotary axes
  double feedMmPerS = 0.0;     ///< deg/s in a path of degrees; not more than the main run can take
  bool inDegrees = false;      ///< the path is measured by the turn
};

/// @param from  end of the block before, machine coordinates
[[nodiscard]] RoughMotion roughMotion(const PreparedMotion& motion, const base::AxisPosition& from,
                                      const MachineConfig& config);

}  // namespace rivulet::machine
