// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Events of the streaming thread for the GUI, and requests of the GUI. @threadsafety plain values.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/vec3.h"
#include "gcode/program.h"
#include "job/plan.h"
#include "live/setup.h"
#include "opcua/connection.h"
#include "opcua/machinery.h"
#include "opcua/rights.h"
#include "report/run_store.h"
#include "run/resume.h"
#include "run/run_record.h"
#include "session/hazards.h"
#include "streaming/control/machine_facts.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/equipment_watch.h"
#include "streaming/run/job_times.h"
#include "streaming/run/run.h"
#include "streaming/setup/calibration_record.h"
#include "trace/analysis/tool_use.h"
#include "trace/recording.h"

namespace rivulet::session {

enum class LinkState { Disconnected, Connecting, Connected, Lost };

struct LinkChanged {
  LinkState state = LinkState::Disconnected;
  base::Error error;  ///< why, for Disconnected and Lost; code clear otherwise
  bool isVirtualMachine = false;
  opcua::ServerIdentity server{};  ///< for Connected
  /// For Connected, how it is protected; nothing in virtual time.
  std::optional<opcua::ChannelSecurity> security{};
  /// For Disconnected, what a person can decide; null: nothing.
  std::shared_ptr<const opcua::TrustQuestion> question{};
};

/// The control as read between runs. Nothing: it could not be read.
struct MachineSeen {
  std::optional<int> channelStatus;
  std::optional<int> programStatus;
  std::optional<int> alarm;
  std::optional<std::string> programName;
  std::optional<std::string> message;
  std::optional<base::Vec3> positionMm;
  std::optional<double> feedMmPerS;
  base::RotarySet rotaryAxes{};  ///< those the control has
  std::optional<base::RotaryDeg> rotaryDeg;
  /// Distance to go of each axis; nothing: the control does not report it.
  std::optional<base::Vec3> toGoMm;
  base::RotaryDeg toGoDeg{};                          ///< with `toGoMm`
  std::optional<streaming::EquipmentSeen> equipment;  ///< nothing: not read this time
  /// What the server describes; null: not read this time.
  std::shared_ptr<const std::vector<opcua::DescribedMachine>> described;
};

/// Where a whole job is, beside its counters.
struct JobUpdate {
  int stretch = 0;  ///< that is streamed, or comes after the blocks in progress; one more: the last
  bool isNative = false;            ///< the control executes its own blocks
  base::LineNumber line;            ///< of the block in progress; 0: not known
  std::string block;                ///< as the source has it
  bool waitsForCycleStart = false;  ///< at M0 or M1
  std::string program = {};         ///< main program of the job on the control
};

struct RunFinished {
  std::shared_ptr<const streaming::RunReport> report;
  std::string recordingPath;  ///< empty: none could be written completely
  base::Error notRecorded{};  ///< why
  base::Error notKept{};      ///< why the history does not have the run; code clear: it has it
  std::optional<streaming::JobTimes> jobTimes{};  ///< of a whole job
  std::vector<trace::ToolUse> tools{};            ///< of a whole job
  std::optional<report::SavedRun> left{};         ///< as it is kept; nothing: it is not
  std::optional<run::RecordingCut> cut{};         ///< what `notRecorded` says of a part of it
};

/// The answer to a `ResumeQuestion`.
struct ResumeFound {
  std::optional<streaming::Resume> resume;     ///< of the motion alone
  std::shared_ptr<const run::JobRestart> job;  ///< null and no `resume`: see `error`
  base::Error error;
};

/// What there is of runs that this window does not stream. Told while nothing else is done with the
/// control.
struct RunsSeen {
  std::optional<report::FoundRun> onControl;  ///< nothing: no program of Rivulet is active
  bool isClientKnown = false;                 ///< `hasClient` of that run is certain
  /// Points executed after each number of windows of it; null: not known.
  std::shared_ptr<const std::vector<std::size_t>> pointsAfter;
  /// Without one on the control: the newest run of this computer that was left there.
  std::optional<report::SavedRun> left;
  bool isJob = false;  ///< the run that is kept here is a whole job
  /// Of that run on the control: what its program executes if it is told to end. Nothing: not
  /// known.
  std::optional<streaming::MotionAhead> ahead{};
};

/// Which rights the user of the connection has.
struct RightsSeen {
  std::optional<opcua::RightsReport> report;  ///< nothing: see `error`
  base::Error error;
};

/// The end of a run that this window did not start, on its request.
struct RunEnded {
  std::optional<base::Duration> confirmedAfter;  ///< nothing: see `error`
  base::Error error;
  bool isHeld = false;   ///< not ended: its axes stand since then, until it is let go
  bool byReset = false;  ///< it was no run, and the control was reset for it
};

struct CalibrationFinished {
  std::shared_ptr<const streaming::CalibrationRecord> record;  ///< null: see `error`
  base::Error error;
};

/// Tests of the control.
enum class TestKind { Credit, FeedCell, Jobs };

/// What a test of the control is waiting for.
struct CommissioningProgress {
  TestKind kind = TestKind::Credit;
  streaming::CommissioningStep step = streaming::CommissioningStep::CycleStart;
};
struct CommissioningFinished {
  TestKind kind = TestKind::Credit;
  base::Error error{};  ///< also if the test could not be stored
  // The one of its kind; none: see `error`.
  std::optional<streaming::CreditTest> credit{};
  std::optional<streaming::FeedTest> feed{};
  std::optional<streaming::JobTest> jobs{};
};

/// The live source that was asked for. Told again after each run, when it is there for the next.
struct SourceOpened {
  std::string address;
  std::string name;   ///< with the port that was taken; empty: see `error`
  base::Error error;  ///< why it is not open; code clear: it is
};

/// Points of a live source that have been taken into windows, in their order and without a gap.
struct LivePoints {
  std::size_t first = 0;  ///< index of the first of them in the run
  std::shared_ptr<const std::vector<gcode::StreamPoint>> points;
};

using SessionEvent =
    std::variant<std::monostate, LinkChanged, MachineSeen, streaming::LiveUpdate, JobUpdate,
                 SourceOpened, LivePoints, trace::Note, run::RecordingCut, RunFinished,
                 streaming::CalibrationProgress, CalibrationFinished, CommissioningProgress,
                 CommissioningFinished, ResumeFound, RunsSeen, RunEnded, RightsSeen>;

struct ConnectCommand {
  opcua::ConnectRequest request;
};
struct DisconnectCommand {};
/// Where was this run left? The control is asked; nothing moves.
struct ResumeQuestion {
  std::shared_ptr<const gcode::Program> program;
  streaming::RunSettings settings;  ///< of the interrupted run
  streaming::Checkpoint checkpoint;
  /// Of a whole job: what was run, and its machine, whose tools and offsets are re-established;
  /// null: it is not known.
  std::shared_ptr<const job::Plan> plan{};
  std::shared_ptr<const machine::MachineConfig> machine{};
  int fromStretch = 0;  ///< > 0: the job is to begin with it, wherever it was left
  std::optional<report::SavedJob> job{};  ///< what was kept of it
};
/// Listens for points from now on, in place of the source before. @param address  empty: no longer
struct ListenCommand {
  std::string address;
};
/// Where the program of a run came from: enough to load it again.
struct ProgramSource {
  std::string file;            ///< absolute path
  gcode::LoadOptions reading;  ///< see `report::SavedRun`
};
struct StartCommand {
  std::shared_ptr<const gcode::Program> program;
  /// The points come from the source that is open; `program` has only name and hash.
  std::optional<live::Setup> live{};
  /// Set for a whole job, which `program` belongs to; null: only the motion is streamed.
  std::shared_ptr<const job::Plan> plan;
  /// Of a whole job: which of the streamed points each stretch begins with, and how many there are.
  std::vector<std::uint32_t> stretchStarts;
  std::size_t points = 0;
  ProgramSource source;
  streaming::RunSettings settings;
  std::string startedAtUtc;
  double dryRunMm = 0.0;  ///< > 0: `plan` is a dry run
  /// A job that goes on: `plan` is that of its restart. Null: from the beginning.
  std::shared_ptr<const run::JobRestart> restart{};
  /// The run that this one drives back along its path: see `run::RunFacts`.
  std::optional<report::SavedRun> drivenBack{};
  /// A run that is resumed: asked once more right before it starts. If the answer differs, the run
  /// does not start.
  std::optional<ResumeQuestion> resumes;
};

struct CalibrateCommand {
  streaming::CalibrationPlan plan;
  std::string startedAtUtc;
};

/// Commands the program of a run that was found on the control to end.
struct EndRunCommand {
  /// Nothing: a program that is no run; stopped by `streaming::stopByReset`.
  std::optional<streaming::RunOnControl> run;
  bool holds = false;  ///< its axes, at once: `streaming::stopRun`; else it goes on to its end
};

/// Asks for the rights of the user; changes nothing on the control.
struct RightsCommand {};

/// A test of the control, on cells that nobody else uses.
struct CommissionCommand {
  TestKind kind = TestKind::Credit;
  int firstCell = 0;
  streaming::TransferWay transfer = streaming::TransferWay::Link;
  std::optional<streaming::AirMove> move{};  ///< of the tests of the feed cell and of whole jobs
  std::vector<std::string> blocks{};         ///< to be tried by the test of whole jobs
  std::string startedAtUtc{};
};

using SessionCommand =
    std::variant<std::monostate, ConnectCommand, DisconnectCommand, StartCommand, CalibrateCommand,
                 CommissionCommand, ResumeQuestion, EndRunCommand, RightsCommand, ListenCommand>;

}  // namespace rivulet::session
