// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the path of a program stands. @threadsafety plain values.
#pragma once

#include "base/axes.h"
#include "base/vec3.h"
#include "nc/modal/frame.h"

namespace rivulet::nc {

/// NaN: no motion has said it yet.
struct Position {
  Position();

  base::Vec3 programmedMm;
  base::RotaryDeg rotaryDeg{};
  Frame frame;
  /// Of the workpiece frame, in machine coordinates: work offset and length of the tool. Zero where
  /// only the control knows them.
  base::Vec3 zeroMm;
  base::Vec3 direction;  ///< of the end of the last move, programmed coordinates; zero: none

  /// A place in programmed coordinates.
  [[nodiscard]] base::Vec3 toMachine(base::Vec3 placeMm) const {
    const base::Vec3 workpieceMm = frame.toWorkpiece(placeMm);
    return zeroMm == base::Vec3{} ? workpieceMm : workpieceMm + zeroMm;  // to the last bit
  }
  /// The machine does not move; the same place gets other coordinates.
  void setFrame(const Frame& other);
  void setZero(base::Vec3 otherMm);
  /// In the workpiece, of a straight move from here; 0 if it comes from a place that is not known.
  [[nodiscard]] double lengthMmTo(base::Vec3 targetMm) const;
  /// How far the rotary axes turn from here, deg; 0 if one comes from a place that is not known.
  [[nodiscard]] double turnDegTo(const base::RotaryDeg& targetDeg) const;
};

}  // namespace rivulet::nc
