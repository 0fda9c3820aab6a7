// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/start/start_policy.h"

#include <fmt/format.h>

#include "base/units.h"
#include "opcua/error.h"
#include "opcua/variable.h"
#include "streaming/control/control_alarm.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

namespace {

using Reason = std::optional<Blocked>;

Blocked because(BlockReason reason, std::vector<std::string> arguments = {}) {
  return {reason, std::move(arguments), std::nullopt};
}

/// What a client that is busy or alone cannot do, whatever it is.
Reason linkBlocked(const StartFacts& facts) {
  switch (facts.activity) {
    case Activity::Streaming:
      return because(BlockReason::RunInProgress);
    case Activity::CheckingResume:
      return because(BlockReason::ResumeCheckInProgress);
    case Activity::Calibrating:
      return because(BlockReason::CalibrationInProgress);
    case Activity::Commissioning:
      return because(BlockReason::CommissioningInProgress);
    case Activity::Idle:
      break;
  }
  return facts.isConnected ? std::nullopt : Reason(because(BlockReason::NotConnected));
}

/// What who is there may not do. A job that is not released is named last: the rest of it has to be
/// right before it can be released.
Reason permissionBlocked(const StartFacts& facts) {
  if (!facts.refusal || *facts.refusal == permission::Refusal::NotReleased) {
    return std::nullopt;
  }
  return because(*facts.refusal == permission::Refusal::Locked ? BlockReason::Locked
                                                               : BlockReason::NeedsEngineer);
}

Reason releaseBlocked(const StartFacts& facts) {
  return facts.refusal == permission::Refusal::NotReleased
             ? Reason(because(BlockReason::NotReleased))
             : std::nullopt;
}

Reason channelBlocked(const StartFacts& facts) {
  return facts.channelStatus.value_or(opcua::kChannelReset) == opcua::kChannelReset
             ? std::nullopt
             : Reason(because(BlockReason::ChannelBusy));
}

Reason axesBlocked(const StartFacts& facts) {
  if (!base::any(facts.turnedAxes)) {
    return std::nullopt;
  }
  const std::string axes = base::rotaryNames(facts.turnedAxes);
  if (!base::streamsRotary(facts.method)) {
    return because(BlockReason::RotaryNotStreamed, {axes});
  }
  if (facts.controlAxes && !base::contains(*facts.controlAxes, facts.turnedAxes)) {
    return because(BlockReason::AxesMissing, {axes});
  }
  return std::nullopt;
}

Reason settingsBlocked(const StartFacts& facts) {
  if (facts.settingsError) {
    return Blocked{BlockReason::SettingsInvalid, {}, facts.settingsError};
  }
  if (facts.verdict && !facts.verdict->feasible && !facts.acceptsInfeasible) {
    const double feedMax = base::mmPerMinFromMmPerS(facts.verdict->feedMmPerSMax);
    const feasibility::Equation by = facts.verdict->limiting.equation;
    return because(BlockReason::Infeasible,
                   {by == feasibility::Equation::Machine
                        ? "the motion of this machine"
                        : fmt::format("equation {}", feasibility::equationLabel(by)),
                    fmt::format("{:.0f}", feedMax)});
  }
  if (facts.jobCheck && !facts.jobCheck->isDone) {
    return because(BlockReason::JobNotChecked);
  }
  if (facts.jobCheck && facts.jobCheck->obstacle) {
    return Blocked{BlockReason::BeyondMachine, {}, facts.jobCheck->obstacle};
  }
  if (facts.rehearsed && !facts.acceptsInfeasible) {
    if (!facts.rehearsed->isDone) {
      return because(BlockReason::NotRehearsed);
    }
    if (facts.rehearsed->failures > 0) {
      return because(BlockReason::RehearsalFailed, {std::to_string(facts.rehearsed->failures),
                                                    std::to_string(facts.rehearsed->runs)});
    }
  }
  if (mayRepeat(facts.method) && !facts.acceptsRepeats) {
    return because(BlockReason::MayRepeat, {std::string(base::methodName(facts.method))});
  }
  if (base::needsCommissioning(facts.method) && facts.isCommissioned == false) {
    return because(BlockReason::NotCommissioned);
  }
  return std::nullopt;
}

Reason sourceBlocked(const StartFacts& facts) {
  if (facts.live->obstacle) {
    return Blocked{BlockReason::SourceNotOpen, {}, facts.live->obstacle};
  }
  return base::takesLivePoints(facts.method) ? std::nullopt
                                             : Reason(because(BlockReason::LiveNeedsWindows));
}

/// What is to be run cannot be.
Reason pathBlocked(const StartFacts& facts) {
  if (facts.live) {
    return sourceBlocked(facts);
  }
  if (facts.program == nullptr) {
    return because(BlockReason::NoProgram);
  }
  if (Reason reason = programBlocked(*facts.program)) {
    return reason;
  }
  const gcode::Diagnostic* const open = gcode::openSetting(*facts.program);
  if (open == nullptr || facts.isVirtualMachine) {
    return std::nullopt;
  }
  return Blocked{
      BlockReason::SettingOpen,
      {},
      base::makeError(gcode::GcodeError::Ambiguous, gcode::describe(*open), facts.program->name)};
}

/// All but the state of the channel.
Reason runBlocked(const StartFacts& facts) {
  if (Reason reason = permissionBlocked(facts)) {
    return reason;
  }
  if (Reason reason = linkBlocked(facts)) {
    return reason;
  }
  if (Reason reason = pathBlocked(facts)) {
    return reason;
  }
  if (Reason reason = axesBlocked(facts)) {
    return reason;
  }
  if (Reason reason = settingsBlocked(facts)) {
    return reason;
  }
  if (const int alarm = facts.alarm.value_or(0); alarm != 0) {
    return because(BlockReason::AlarmActive, {std::to_string(alarm)});
  }
  return releaseBlocked(facts);
}

StreamError codeOf(BlockReason reason) {
  switch (reason) {
    case BlockReason::RunInProgress:
    case BlockReason::ResumeCheckInProgress:
    case BlockReason::CalibrationInProgress:
    case BlockReason::CommissioningInProgress:
    case BlockReason::ChannelBusy:
      return StreamError::ChannelBusy;
    case BlockReason::RotaryNotStreamed:
      return StreamError::AxesNotChosen;
    case BlockReason::AxesMissing:
      return StreamError::AxisMissing;
    case BlockReason::NotCommissioned:
      return StreamError::NotCommissioned;
    case BlockReason::AlarmActive:
      return StreamError::ControlAlarm;
    case BlockReason::NothingToResume:
    case BlockReason::MethodCannotResume:
      return StreamError::CannotResume;
    case BlockReason::NotConnected:
    case BlockReason::NoProgram:
    case BlockReason::FileChanged:
    case BlockReason::NoMotion:
    case BlockReason::NeedsTransformation:
    case BlockReason::PathUnknown:
    case BlockReason::SettingOpen:
    case BlockReason::SettingsInvalid:
    case BlockReason::Infeasible:
    case BlockReason::NotRehearsed:
    case BlockReason::RehearsalFailed:
    case BlockReason::JobNotChecked:
    case BlockReason::BeyondMachine:
    case BlockReason::MayRepeat:
    case BlockReason::Locked:
    case BlockReason::NeedsEngineer:
    case BlockReason::NotReleased:
    case BlockReason::LiveNeedsWindows:
    case BlockReason::SourceNotOpen:
      break;
  }
  return StreamError::ProgramNotStreamable;
}

constexpr const char* kMayRepeat =
    "Method {} may execute old points again: if this computer is late for a moment, the tool goes "
    "back through the workpiece. Choose method window.";

std::string sentence(const Blocked& blocked) {
  const auto argument = [&blocked](std::size_t i) {
    return i < blocked.arguments.size() ? blocked.arguments[i] : std::string();
  };
  switch (blocked.reason) {
    case BlockReason::RunInProgress:
      return "A run is in progress. Wait until it has ended.";
    case BlockReason::ResumeCheckInProgress:
      return "The control is being asked where the run was left. Wait for the answer.";
    case BlockReason::CalibrationInProgress:
      return "A calibration is in progress. Wait until it has ended.";
    case BlockReason::CommissioningInProgress:
      return "A test of the control is in progress. Wait until it has ended.";
    case BlockReason::NotConnected:
      return "There is no connection to a control. Connect first.";
    case BlockReason::NoProgram:
      return "No program is loaded. Open one first.";
    case BlockReason::FileChanged:
      return "The file of the program has changed since it was read. Read it again.";
    case BlockReason::NoMotion:
      return std::string(gcode::describe(gcode::Readiness::NoMotion));
    case BlockReason::NeedsTransformation:
      return std::string(gcode::describe(gcode::Readiness::NeedsTransformation));
    case BlockReason::PathUnknown:
      return std::string(gcode::describe(gcode::Readiness::NotUnderstood));
    case BlockReason::RotaryNotStreamed:
      return fmt::format(
          "The program moves {}, but the method moves only X, Y and Z. Choose method window.",
          argument(0));
    case BlockReason::AxesMissing:
      return fmt::format("The program moves {}, but the control does not have all of these axes.",
                         argument(0));
    case BlockReason::Infeasible:
      return fmt::format(
          "Not feasible by {}: the control would repeat points. Reduce the feed to {} mm/min.",
          argument(0), argument(1));
    case BlockReason::NotRehearsed:
      return "The program is being simulated. Wait for the result.";
    case BlockReason::RehearsalFailed:
      return fmt::format(
          "The simulation of this program executed wrong points in {} of {} runs. Reduce the feed.",
          argument(0), argument(1));
    case BlockReason::MayRepeat:
      return fmt::format(kMayRepeat, argument(0));
    case BlockReason::NotCommissioned:
      return "Method credit is experimental and starts only on a control that has passed its "
             "test. Run rivulet-cli commission, or choose method window.";
    case BlockReason::AlarmActive:
      return describeControlAlarm(argument(0));
    case BlockReason::ChannelBusy:
      return "A program is running on the control. Wait until it has ended, or reset the control, "
             "then start again.";
    case BlockReason::NothingToResume:
      return "There is no interrupted run to resume.";
    case BlockReason::MethodCannotResume:
      return "Only methods with numbered windows resume a run. Choose method window.";
    case BlockReason::Locked:
      return "The window is locked. Log in first.";
    case BlockReason::NeedsEngineer:
      return "Only an engineer may do this. Log in as one.";
    case BlockReason::NotReleased:
      return "This program with these settings is not released. An engineer has to release it.";
    case BlockReason::JobNotChecked:
      return "The job is being compared with the machine. Wait for the result.";
    case BlockReason::BeyondMachine:
      return "The machine cannot do this job.";
    case BlockReason::LiveNeedsWindows:
      return "Points of a live source need a machine that waits for them: choose method window or "
             "credit.";
    case BlockReason::SourceNotOpen:
      return "The live source is not open. Open it again.";
    case BlockReason::SettingOpen:
      return "A setting of the control decides where the path goes. Say which it is.";
    case BlockReason::SettingsInvalid:
      break;
  }
  return "No program can be generated from the settings. Correct them first.";
}

}  // namespace

Reason programBlocked(const gcode::Program& program) {
  switch (program.readiness()) {
    case gcode::Readiness::NotUnderstood:
      return because(BlockReason::PathUnknown);
    case gcode::Readiness::NoMotion:
      return because(BlockReason::NoMotion);
    case gcode::Readiness::NeedsTransformation:
      return because(BlockReason::NeedsTransformation);
    case gcode::Readiness::Streamable:
      break;
  }
  return std::nullopt;
}

bool mayRepeat(base::MethodKind method) {
  return base::isPublished(method);
}

Reason startBlocked(const StartFacts& facts) {
  if (Reason reason = runBlocked(facts)) {
    return reason;
  }
  if (facts.hasFileChanged) {
    return because(BlockReason::FileChanged);
  }
  return channelBlocked(facts);
}

Reason resumeBlocked(const StartFacts& facts) {
  if (!facts.hasRunToResume) {
    return because(BlockReason::NothingToResume);
  }
  if (!base::hasWindows(facts.method)) {
    return because(BlockReason::MethodCannotResume);
  }
  return runBlocked(facts);
}

Reason calibrationBlocked(const StartFacts& facts) {
  if (Reason reason = permissionBlocked(facts)) {
    return reason;
  }
  if (Reason reason = linkBlocked(facts)) {
    return reason;
  }
  return channelBlocked(facts);
}

base::Error blockedError(const Blocked& blocked) {
  return blocked.cause ? *blocked.cause
                       : base::makeError(codeOf(blocked.reason), sentence(blocked));
}

}  // namespace rivulet::streaming
