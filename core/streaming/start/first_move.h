// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The first move of a run, which nobody has programmed: it goes straight from where the tool
/// happens to stand. After a stop that is in the cut. @threadsafety pure.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>

#include "base/vec3.h"
#include "gcode/program.h"
#include "gcode/trajectory.h"

namespace rivulet::streaming {

/// The space in which a program cuts: the box around its moves with feed, from where they plunge
/// downwards, without the tool's own size. mm, in one frame.
struct CutBox {
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();
  base::Vec3 lowestMm{kNowhere, kNowhere, kNowhere};
  base::Vec3 highestMm{-kNowhere, -kNowhere, -kNowhere};

  [[nodiscard]] bool isEmpty() const { return !(lowestMm.x <= highestMm.x); }
  /// An axis that is not known (NaN) widens nothing.
  void add(const base::Vec3& placeMm);
};
/// @param program  all points of the program, also if the run begins behind the first
[[nodiscard]] CutBox cutOf(std::span<const gcode::StreamPoint> program);

/// Where the first move of a program goes. @return NaN: an axis that it leaves where it is
[[nodiscard]] base::Vec3 firstPlace(const gcode::Trajectory& trajectory, const base::Vec3& toolMm);

struct CutOnTheWay {
  double heightMm = 0.0;          ///< Z above which no move with feed begins
  bool isClearFromAbove = false;  ///< the straight way from that height is clear
};
/// Whether the straight way to the first point passes within the cut. A way straight up is clear.
/// @param toolMm  where the tool stands, in the frame of the box
/// @param firstMm  the first point; NaN: an axis that stays where it is
/// @return nothing: the way is clear
[[nodiscard]] std::optional<CutOnTheWay> cutOnTheWay(const base::Vec3& toolMm,
                                                     const base::Vec3& firstMm, const CutBox& cut);

/// The sentence.
[[nodiscard]] std::string describe(const CutOnTheWay& cut);

/// A program of one move, straight up: a run of its own. @param toMm  Z in the frame of the run
[[nodiscard]] gcode::Program raiseProgram(double toMm);

}  // namespace rivulet::streaming
