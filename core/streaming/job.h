// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One streaming job from arm to done: look at the control, transfer and select the flexible
/// program, wait for cycle start, check that the control runs exactly that program, stream,
/// confirm the end, fetch the control's trace and let the oracle judge. Nothing moves before
/// every check has passed, and nothing is retried by itself.
/// @threadsafety runs on the calling thread; the sink is called on that thread.
#pragma once

#include <memory>
#include <string>

#include "gcode/program.h"
#include "streaming/control_axes.h"
#include "streaming/driver.h"
#include "streaming/run.h"

namespace rivulet::streaming {

/// What is in the way of a start, or good to know before it. Text in `base::Error::message`.
struct Preflight {
  base::Vec3 toolMm;          ///< where the tool stands
  base::RotaryDeg toolDeg{};  ///< the rotary axes the control has; 0 for others
  ControlAxes axes;           ///< where it has them
  double approachMm = 0.0;    ///< straight way from there to the first point
  gcode::PointList points;    ///< what would be streamed
};

/// Looks at the control without changing anything.
/// @return VariableMissing, ChannelBusy, ProgramNotStreamable, AxesNotChosen, AxisMissing, or a
/// link error
[[nodiscard]] base::Result<Preflight> preflight(opcua::Link& link, const gcode::Program& program,
                                                const RunSettings& settings);

/// Where a job writes its recording; may be null.
struct JobRecorder {
  trace::RecordingWriter* writer = nullptr;
  trace::RunStart start;  ///< tool version, endpoint and time; the rest is filled in
};

/// Runs the whole job. Always returns a report; why it failed is in its error.
[[nodiscard]] RunReport runJob(opcua::Link& link, opcua::Control& control,
                               const gcode::Program& program, const RunSettings& settings,
                               RunOrders& orders, RunSink& sink, JobRecorder recorder = {});

}  // namespace rivulet::streaming
