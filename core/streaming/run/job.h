// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One streaming job from start to end: check the control, transfer and select the flexible
/// program, wait for cycle start, check that the control runs exactly that program, stream, confirm
/// the end, fetch the control's trace and let the oracle judge. Nothing moves before every check
/// has passed, and nothing is retried by itself.
/// @threadsafety runs on the calling thread; the sink is called on that thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "gcode/program.h"
#include "live/point_supplier.h"
#include "streaming/control/control_axes.h"
#include "streaming/run/driver.h"
#include "streaming/run/run.h"
#include "templates/flexible_program.h"

namespace rivulet::streaming {

/// State of the control before a start; obstacles are errors with text in `base::Error::message`.
struct Preflight {
  base::Vec3 toolMm;             ///< position of the tool
  base::RotaryDeg toolDeg{};     ///< the rotary axes that the control has; 0 for others
  ControlAxes axes;              ///< their places in the channel
  double approachMm = 0.0;       ///< straight distance from there to the first point
  gcode::PointList points;       ///< the points to be streamed
  std::size_t pointCount = 0;    ///< of the whole program, those executed already included
  std::uint64_t pointsHash = 0;  ///< `hashOfPoints` of them
};

/// Checks the control without changing anything.
/// @return VariableMissing, ChannelBusy, ProgramNotStreamable, AxesNotChosen, AxisMissing, or a
/// link error
[[nodiscard]] base::Result<Preflight> preflight(opcua::Link& link, const gcode::Program& program,
                                                const RunSettings& settings);

/// Keeps what is needed to resume a run in a place that outlives this program and a loss of power.
/// @threadsafety called on the thread of the job
class CheckpointKeeper {
 public:
  virtual ~CheckpointKeeper() = default;
  /// Called before the program on the control is started, and again when the control obeys the run,
  /// before the first window. When it returns, the checkpoint is stored safely. A failure is noted;
  /// the run goes on.
  /// @param settings  of the run, with its number
  /// @param points    of the whole program, in the first call; empty in the second
  virtual base::Result<void> keep(const Checkpoint& checkpoint, const RunSettings& settings,
                                  std::span<const gcode::StreamPoint> points) = 0;
};

/// Who is given the recording, the checkpoint and the trace of a job; each may be null.
struct JobRecorder {
  trace::RecordingWriter* writer = nullptr;
  trace::RunStart start;  ///< tool version, endpoint and time; the rest is completed
  CheckpointKeeper* keeper = nullptr;
  /// Takes the trace while the run lasts if the control keeps none of this run alone; null: nobody.
  TraceTaker* trace = nullptr;
  /// The feed cell of the program that the run is a part of; null: the run has its own.
  FeedControl* feed = nullptr;
};

/// Runs the whole job. Always returns a report; its error says why the job failed.
/// @param flexible  the program on the control: its parameters are those of the run
[[nodiscard]] RunReport runJob(opcua::Link& link, opcua::Control& control,
                               const gcode::Program& program,
                               const templates::FlexibleProgram& flexible,
                               const RunSettings& settings, RunOrders& orders, RunSink& sink,
                               JobRecorder recorder = {});
/// The same with the flexible program of the settings, where nobody else needs it.
[[nodiscard]] RunReport runJob(opcua::Link& link, opcua::Control& control,
                               const gcode::Program& program, const RunSettings& settings,
                               RunOrders& orders, RunSink& sink, JobRecorder recorder = {});

/// The same for points that may arrive while the machine moves. The run cannot be resumed.
/// @param name  of the run, in reports  @param settings  `feedMmPerS` is that of points without one
///        of their own  @param flexible  method window or credit
[[nodiscard]] RunReport runLive(opcua::Link& link, opcua::Control& control, std::string name,
                                live::PointSupplier& supplier,
                                const templates::FlexibleProgram& flexible,
                                const RunSettings& settings, RunOrders& orders, RunSink& sink,
                                JobRecorder recorder = {});

}  // namespace rivulet::streaming
