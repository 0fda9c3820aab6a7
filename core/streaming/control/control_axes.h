// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The rotary axes of a control and their positions, and a check whether the streamed axes are
/// those that a program moves. @threadsafety runs on the calling thread; for use outside a stream.
#pragma once

#include <array>

#include "base/axes.h"
#include "base/instant.h"
#include "base/result.h"
#include "gcode/feeds.h"
#include "gcode/trajectory.h"
#include "job/plan.h"
#include "opcua/link.h"
#include "templates/cells.h"

namespace rivulet::streaming {

/// The places of A, B and C among the axes of a control's channel.
struct ControlAxes {
  /// Index of `VariableKind::ActualPosition`; below 0: the control has no such axis.
  std::array<int, base::kRotaryAxisCount> index{-1, -1, -1};

  [[nodiscard]] base::RotarySet set() const {
    return {index[0] >= 0, index[1] >= 0, index[2] >= 0};
  }
};

/// Reads the names of the axes after X, Y and Z. A control that does not report them has none.
[[nodiscard]] base::Result<ControlAxes> readControlAxes(opcua::Link& link, base::Duration deadline);

/// Angles of the wanted axes, 0 for others. @return AxisMissing, or the error of the read
[[nodiscard]] base::Result<base::RotaryDeg> readAngles(opcua::Link& link, const ControlAxes& axes,
                                                       const base::RotarySet& wanted,
                                                       base::Duration deadline);

/// The axes that a run streams if none are selected: X, Y, Z and the rotary axes that the program
/// moves.
/// @param parameters  method window; with another method they are not changed
[[nodiscard]] templates::TemplateParameters withTurnedAxes(templates::TemplateParameters parameters,
                                                           const gcode::Trajectory& trajectory);
/// The same of a job: a transformation in it may leave the rotary axes anywhere, so that a single
/// place to which a stretch turns them counts.
[[nodiscard]] templates::TemplateParameters withTurnedAxes(templates::TemplateParameters parameters,
                                                           const job::Plan& plan);

/// Check before a run: every rotary axis that moves is streamed, and the control has it. An axis
/// that is only set before the path need not be streamed if it is there already, or if the control
/// does not have it.
/// @param atDeg  positions of the control's axes
/// @return ProgramNotStreamable, AxesNotChosen, AxisMissing
[[nodiscard]] base::Result<void> requireRotaryAxes(const gcode::Trajectory& trajectory,
                                                   const templates::TemplateParameters& parameters,
                                                   const ControlAxes& axes,
                                                   const base::RotaryDeg& atDeg);

/// `gcode::streamPoints` for the chosen axes: the others do not move.
/// @param feeds  `RunSettings::programFeeds`
/// @return AxesNotChosen if the program moves one of X, Y, Z that is not selected
[[nodiscard]] base::Result<gcode::PointList> pointsOnAxes(
    const gcode::Trajectory& trajectory, const templates::TemplateParameters& parameters,
    const base::AxisPosition& start, const std::optional<gcode::ProgramFeeds>& feeds = {});

}  // namespace rivulet::streaming
