// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A whole job from start to end: the control executes its native blocks, and each stretch between
/// them is a run of its own (`runJob`), on the same link and in the same program of the control.
/// @threadsafety runs on the calling thread; the sinks are called on that thread.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "streaming/run/driver.h"
#include "streaming/run/job.h"
#include "streaming/run/job_times.h"
#include "streaming/run/run.h"
#include "trace/analysis/tool_use.h"
#include "trace/control_trace.h"

namespace rivulet::streaming {

/// Told how far the job is, in addition to what a run tells.
class WholeJobSink : public RunSink {
 public:
  /// The control executes native blocks. @param next  number of the stretch after them; one more
  ///        than there are: the last ones
  virtual void nativeBlocks(int next) = 0;
  /// The control has come to another of them.
  virtual void nativeBlock(const job::NativeBlock& /*block*/) {}
  /// A stretch is about to begin. @param startMm  where the tool is, as the control says
  virtual void stretchBegins(const job::Stretch& stretch, base::Vec3 startMm) = 0;
  /// The program waits for cycle start, at M0 or M1; told once. @return true: the control is
  ///        commanded to go on; false: somebody presses it at the control
  [[nodiscard]] virtual bool waitsForCycleStart() = 0;
};

struct StretchReport {
  int number = 0;
  base::Vec3 startMm;  ///< where the tool was
  std::vector<gcode::StreamPoint> points;
  RunReport run;
};

/// How far a job came.
struct JobPlace {
  int stretch = 0;           ///< begun last; 0: none
  std::size_t executed = 0;  ///< points of it
  std::size_t total = 0;     ///< points it has
  int native = 0;         ///< number of the native block that was due last, from 1; 0: none since
  base::LineNumber line;  ///< of the last point or of that block; 0: nothing was executed
  std::string file;       ///< the called file that line is in; empty: the program itself
};
/// "in stretch 2, after 5 of 12 points, at line 30"; "at the block in line 31, after stretch 2"
[[nodiscard]] std::string describe(const JobPlace& place);

struct WholeJobReport {
  Outcome outcome = Outcome::Failed;
  base::Error error;                     ///< why, for Failed
  int runNumber = 0;                     ///< of the job; stretch k has this + k
  std::vector<StretchReport> stretches;  ///< those that were begun
  /// The beginning of the trace of the whole job, as much as RunTrace keeps; null if there was
  /// none. What is judged, and the tools, are of the whole trace.
  std::shared_ptr<const trace::ControlTrace> controlTrace;
  std::vector<trace::ToolUse> tools;  ///< by the trace; empty also if a part of it is missing
  JobTimes times;
  /// One for each part of the plan, as the client saw them: a native block that is shorter than the
  /// client's interval of 20 ms counts to its neighbour.
  std::vector<JobTimes> partTimes;
  JobPlace reached;
  /// The streamed points by the control's trace. Not judged if programs on the control move, too.
  trace::Integrity integrity;
  /// Standstills in the stretches: by the control's trace if they are judged, else by the client.
  std::vector<trace::Pause> pauses;
  AccessStatistics access;
  std::vector<FeedEvent> feed;         ///< what was ordered by the feed cell
  std::optional<FactorReport> factor;  ///< see `RunReport`
  std::vector<trace::Pause> holds{};   ///< standstills that an order made, if they are judged
  bool leftHeld = false;               ///< see `RunReport`
};

struct WholeJobOptions {
  std::optional<Resume> resume{};  ///< of the first stretch of the plan; nothing: all of it
  /// Keeps the job before its first block, then the stretch in progress; null: nothing is kept.
  CheckpointKeeper* keeper = nullptr;
  trace::RecordingWriter* writer = nullptr;  ///< of the whole job; null: nothing is recorded
  trace::RunStart start{};  ///< tool version, endpoint and time; the rest is completed
  /// How long each part of the plan takes; empty: not known.
  std::vector<base::Duration> expected{};
};

/// What a control does that executes native blocks and has lost its client.
/// @param due  number of the native block in progress, from 1; 0: the first after `stretch`
/// @param stretch  that was executed last; 0: none
/// @param expected  see `WholeJobOptions`
[[nodiscard]] std::string describeUnattended(const job::Plan& plan, int due, int stretch,
                                             const std::vector<base::Duration>& expected = {});

/// Runs a job. Nothing moves before every check has passed. A stop ends it at the next window or
/// native block; a hold waits there. With an origin in the settings the cells are claimed first.
/// @param programs  of the plan: the parameters of the loop are those of the run
/// @param settings  method window or credit; the access is tested before the start
[[nodiscard]] WholeJobReport runWholeJob(opcua::Link& link, opcua::Control& control,
                                         const job::Plan& plan, const job::JobPrograms& programs,
                                         const RunSettings& settings, RunOrders& orders,
                                         WholeJobSink& sink, const WholeJobOptions& options = {});
/// The same with the programs of the settings, where nobody else needs them.
[[nodiscard]] WholeJobReport runWholeJob(opcua::Link& link, opcua::Control& control,
                                         const job::Plan& plan, const RunSettings& settings,
                                         RunOrders& orders, WholeJobSink& sink,
                                         const WholeJobOptions& options = {});

/// The points of one stretch, as a program of their own.
[[nodiscard]] gcode::Program programOf(const job::Plan& plan, const job::Stretch& stretch);

}  // namespace rivulet::streaming
