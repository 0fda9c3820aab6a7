// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One streaming job from start to end: check the control, transfer and select the flexible
/// program, wait for cycle start, check that the control runs exactly that program, stream, confirm
/// the end, fetch the control's trace and let the oracle judge. Nothing moves before every check
/// has passed, and nothing is retried by itself.
/// @threadsafety runs on the calling thread; the sink is called on that thread.
#pragma once

#include <memory>
#include <string>

#include "gcode/program.h"
#include "streaming/control_axes.h"
#include "streaming/driver.h"
#include "streaming/run.h"

namespace rivulet::streaming {

/// State of the control before a start; obstacles are errors with text in `base::Error::message`.
struct Preflight {
  base::Vec3 toolMm;          ///< position of the tool
  base::RotaryDeg toolDeg{};  ///< the rotary axes that the control has; 0 for others
  ControlAxes axes;           ///< their places in the channel
  double approachMm = 0.0;    ///< straight distance from there to the first point
  gcode::PointList points;    ///< the points to be streamed
};

/// Checks the control without changing anything.
/// @return VariableMissing, ChannelBusy, ProgramNotStreamable, AxesNotChosen, AxisMissing, or a
/// link error
[[nodiscard]] base::Result<Preflight> preflight(opcua::Link& link, const gcode::Program& program,
                                                const RunSettings& settings);

/// Where a job writes its recording; may be null.
struct JobRecorder {
  trace::RecordingWriter* writer = nullptr;
  trace::RunStart start;  ///< tool version, endpoint and time; the rest is completed
};

/// Runs the whole job. Always returns a report; its error says why the job failed.
[[nodiscard]] RunReport runJob(opcua::Link& link, opcua::Control& control,
                               const gcode::Program& program, const RunSettings& settings,
                               RunOrders& orders, RunSink& sink, JobRecorder recorder = {});

}  // namespace rivulet::streaming
