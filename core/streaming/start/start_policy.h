// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What may be started now, and why not: the rules for command line and HMI. The rules see facts
/// only; nothing here asks the control. A run looks at the control again before anything moves
/// (`preflight`). @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/axes.h"
#include "base/error.h"
#include "base/method_kind.h"
#include "feasibility/verdict.h"
#include "gcode/program.h"
#include "permission/permission.h"

namespace rivulet::streaming {

/// What this client is doing with the control.
enum class Activity {
  Idle,
  Streaming,
  CheckingResume,  ///< the control is asked where a run was left
  Calibrating,
  Commissioning,  ///< the test of method credit
};

/// Why something may not be started. The arguments are those of `Blocked::arguments`.
enum class BlockReason {
  RunInProgress,
  ResumeCheckInProgress,
  CalibrationInProgress,
  CommissioningInProgress,
  NotConnected,
  NoProgram,
  FileChanged,          ///< the file is no longer what was read
  NoMotion,             ///< the program moves no axis
  NeedsTransformation,  ///< the path is known, but only with a transformation of the control
  PathUnknown,          ///< the program has findings of severity error
  SettingOpen,          ///< a setting of the control decides where the path goes; `Blocked::cause`
  RotaryNotStreamed,    ///< the program turns rotary axes, the method moves X, Y, Z; axes
  AxesMissing,          ///< the program turns axes the control lacks; axes
  SettingsInvalid,      ///< see `Blocked::cause`
  Infeasible,           ///< the control would repeat points; equation, largest feed in mm/min
  NotRehearsed,         ///< the simulation of this program with these settings is in progress
  RehearsalFailed,      ///< that simulation executed wrong points; runs that failed, all runs
  MayRepeat,            ///< the method may execute old points again; its name
  NotCommissioned,      ///< the method needs a test that this control has not passed
  AlarmActive,          ///< number of the alarm
  ChannelBusy,          ///< a program runs on the control
  NothingToResume,      ///< no run was left
  Locked,               ///< the window is locked: only Stop works
  NeedsEngineer,        ///< who is there may not do this
  NotReleased,          ///< an operator starts only what an engineer has released
  MethodCannotResume,   ///< only methods with numbered windows go on where a run was left
  JobNotChecked,        ///< the comparison of the whole job with the machine is in progress
  BeyondMachine,        ///< the machine cannot do the job; see `Blocked::cause`
  LiveNeedsWindows,     ///< a live source needs a machine that waits for its points
  SourceNotOpen,        ///< the live source cannot be opened; see `Blocked::cause`
};

struct Blocked {
  BlockReason reason = BlockReason::NotConnected;
  std::vector<std::string> arguments;
  /// SettingOpen, SettingsInvalid, BeyondMachine and SourceNotOpen only
  std::optional<base::Error> cause;
};

/// A simulation of the program that is to be started, with the settings it is to be started with.
struct Rehearsed {
  bool isDone = false;  ///< false: in progress
  std::size_t runs = 0;
  std::size_t failures = 0;
};

/// A whole job compared with the machine that is to run it: travel, spindle and tools.
struct JobCheck {
  bool isDone = false;  ///< false: in progress
  /// Why the job must not start, in the language of whoever asks; nothing: it may.
  std::optional<base::Error> obstacle;
};

/// A source whose points arrive during the run.
struct LiveFacts {
  std::optional<base::Error> obstacle;  ///< why it is not open; nothing: it is
};

/// What is known when somebody wants to start something. What is not known blocks nothing: the run
/// finds out.
struct StartFacts {
  Activity activity = Activity::Idle;
  bool isConnected = false;
  const gcode::Program* program = nullptr;  ///< null: none is loaded
  std::optional<LiveFacts> live;            ///< in place of `program`; nothing: there is none
  bool isVirtualMachine = false;  ///< one of Rivulet's, which are metric and read whole units
  bool hasFileChanged = false;    ///< since the program was read from it
  base::RotarySet turnedAxes{};   ///< rotary axes the program turns
  base::MethodKind method = base::kDefaultMethod;
  std::optional<base::Error> settingsError;     ///< no program can be made of the settings
  std::optional<feasibility::Verdict> verdict;  ///< nothing: there is none to be had
  std::optional<Rehearsed> rehearsed;           ///< nothing: it cannot be simulated
  std::optional<JobCheck> jobCheck;  ///< nothing: no whole job, or the machine is not known
  bool acceptsInfeasible = false;    ///< wrong motion does no harm, or the user answers for it
  /// The user has confirmed that old points may be executed again: see `mayRepeat`.
  bool acceptsRepeats = false;
  std::optional<bool> isCommissioned;          ///< the control has passed the test of the method
  std::optional<int> channelStatus;            ///< 0: reset
  std::optional<int> alarm;                    ///< 0: none
  std::optional<base::RotarySet> controlAxes;  ///< rotary axes the control has
  std::optional<permission::Refusal> refusal;  ///< why who is there may not do it
  bool hasRunToResume = false;                 ///< a run was left that can be resumed
};

/// The first reason in the order in which an operator would remove them; nothing: it may start.
[[nodiscard]] std::optional<Blocked> startBlocked(const StartFacts& facts);
/// The same for a run that was left. A program that still waits on the control does not block: it
/// is ended first.
[[nodiscard]] std::optional<Blocked> resumeBlocked(const StartFacts& facts);
/// The same for a calibration, which needs no program.
[[nodiscard]] std::optional<Blocked> calibrationBlocked(const StartFacts& facts);

/// A late client makes the control execute old points again, and nothing recognises it before the
/// tool has moved: methods of [P1], which have no numbered windows.
[[nodiscard]] bool mayRepeat(base::MethodKind method);

/// Why no method streams this program; nothing if one does.
[[nodiscard]] std::optional<Blocked> programBlocked(const gcode::Program& program);

/// The reason as an error in English, for command line and log.
[[nodiscard]] base::Error blockedError(const Blocked& blocked);

}  // namespace rivulet::streaming
