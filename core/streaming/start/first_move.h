// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The first move of a run, which nobody has programmed: it goes straight from where the tool
/// happens to stand. After a stop that is in the cut. @threadsafety pure.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/vec3.h"
#include "gcode/trajectory.h"

namespace rivulet::streaming {

/// Whether the straight way to the first point passes the space in which the program cuts: the box
/// around its moves with feed, from where they plunge downwards, without the tool's own size. A way
/// straight up is clear. Frame: workpiece, mm.
/// @param toolMm   where the tool stands  @param firstMm  the first point
/// @param program  all points of the program, also if the run begins behind the first
/// @return Z above which no move with feed begins; nothing: the way is clear
[[nodiscard]] std::optional<double> cutOnTheWay(const base::Vec3& toolMm, const base::Vec3& firstMm,
                                                std::span<const gcode::StreamPoint> program);

/// The sentence. @param heightMm  as `cutOnTheWay` returns it
[[nodiscard]] std::string describeCutOnTheWay(double heightMm);

}  // namespace rivulet::streaming
