// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Moves of other dialects as lines of a SINUMERIK: workpiece frame, mm, after G90 G94 G710 DIAMOF.
/// @threadsafety pure.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/vec3.h"
#include "nc/exec/position.h"
#include "nc/exec/sink.h"
#include "nc/geometry/arc.h"
#include "nc/modal/frame.h"

namespace rivulet::job {

/// A straight move. Axes that do not move, and those that are not known, are left out.
/// @param feedMmPerS  nothing: a rapid @return empty if nothing moves
[[nodiscard]] std::string lineText(base::Vec3 fromMm, base::Vec3 toMm,
                                   std::optional<double> feedMmPerS);

/// A straight move in which axes move by an increment from where the control has them.
/// @param frame  of the program @param incrementsMm  of those axes
/// @return nothing if the frame turns or scales the axes
[[nodiscard]] std::optional<std::string> incrementText(
    const nc::Frame& frame, base::Vec3 fromMm, base::Vec3 toMm,
    const std::array<std::optional<double>, base::kAxisCount>& incrementsMm,
    std::optional<double> feedMmPerS);

/// An arc or helix. @return nothing if it lies in another plane than X Y, or the frame turns it
[[nodiscard]] std::optional<std::string> arcText(const nc::Position& from, const nc::Arc& arc,
                                                 const nc::Move& move);

/// An arc whose start only the control knows, in its plane X Y.
struct ArcWithoutStart {
  bool isClockwise = false;
  base::Vec3 endMm;  ///< workpiece frame; NaN: the axis is not named, or counts as below
  std::array<std::optional<double>, base::kAxisCount> incrementsMm;
  std::array<std::optional<double>, 2> centreMm;  ///< from the start
  std::optional<double> radiusMm;
  double feedMmPerS = 0.0;  ///< 0: the one in force
};
/// @param frame  of the program @return nothing if the frame turns or scales the axes
[[nodiscard]] std::optional<std::string> arcText(const nc::Frame& frame,
                                                 const ArcWithoutStart& arc);

}  // namespace rivulet::job
