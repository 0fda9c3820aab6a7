// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which rotary axes a control has and where they stand, and whether the axes that are streamed are
/// those a program moves. @threadsafety runs on the calling thread; for use outside a stream.
#pragma once

#include <array>

#include "base/axes.h"
#include "base/instant.h"
#include "base/result.h"
#include "gcode/trajectory.h"
#include "opcua/link.h"
#include "templates/cells.h"

namespace rivulet::streaming {

/// Where a control has A, B and C among the axes of its channel.
struct ControlAxes {
  /// Index of `VariableKind::ActualPosition`; below 0: the control has no such axis.
  std::array<int, base::kRotaryAxisCount> index{-1, -1, -1};

  [[nodiscard]] base::RotarySet set() const {
    return {index[0] >= 0, index[1] >= 0, index[2] >= 0};
  }
};

/// Asks for the names of the axes behind X, Y and Z. A control that does not say them has none.
[[nodiscard]] base::Result<ControlAxes> readControlAxes(opcua::Link& link, base::Duration deadline);

/// Angles of the wanted axes, 0 for others. @return AxisMissing, or what the read brought
[[nodiscard]] base::Result<base::RotaryDeg> readAngles(opcua::Link& link, const ControlAxes& axes,
                                                       const base::RotarySet& wanted,
                                                       base::Duration deadline);

/// The axes a run streams where nobody chooses: X, Y, Z and those the program turns.
/// @param parameters  method window; with another method they stay as they are
[[nodiscard]] templates::TemplateParameters withTurnedAxes(templates::TemplateParameters parameters,
                                                           const gcode::Trajectory& trajectory);

/// Before a run: every axis that turns is streamed, and the control has it. An axis that is only
/// set before the path need not be streamed if it stands there already, or if the control has none.
/// @param atDeg  where the control's axes stand
/// @return ProgramNotStreamable, AxesNotChosen, AxisMissing
[[nodiscard]] base::Result<void> requireRotaryAxes(const gcode::Trajectory& trajectory,
                                                   const templates::TemplateParameters& parameters,
                                                   const ControlAxes& axes,
                                                   const base::RotaryDeg& atDeg);

/// `gcode::streamPoints` for the chosen axes: the others stay where they stand.
/// @return AxesNotChosen if the program moves one of X, Y, Z that is not chosen
[[nodiscard]] base::Result<gcode::PointList> pointsOnAxes(
    const gcode::Trajectory& trajectory, const templates::TemplateParameters& parameters,
    const base::AxisPosition& start);

}  // namespace rivulet::streaming
