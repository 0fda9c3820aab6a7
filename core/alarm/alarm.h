// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Alarms as ISA-18.2 has them: what they are, their priority and source, and their sentences as
/// data. An alarm needs a response of the operator; what only informs is a message of the log.
/// @threadsafety plain values.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/utc.h"

namespace rivulet::alarm {

using base::UtcMs;

enum class Code {
  ControlAlarm,           ///< number of the alarm
  ConnectionLost,         ///< endpoint; error
  NotConnected,           ///< endpoint; error
  WrongMotion,            ///< program, repeated points, skipped points
  MovesWrong,             ///< program, point; while the run is in progress
  RunFailed,              ///< program; error
  RunIncomplete,          ///< program, executed points, points
  NotJudged,              ///< program
  NotRecorded,            ///< folder
  RecordingCut,           ///< program, seconds recorded, folder; error; the run is in progress
  FileChanged,            ///< file of the program
  FileGone,               ///< file of the program
  CalibrationFailed,      ///< endpoint; error
  CalibrationNotSaved,    ///< endpoint; error
  AlarmHistoryUnwritten,  ///< file; error
  AuditUnwritten,         ///< file; error
  AuditChanged,           ///< file, line at which the chain breaks
};

/// How soon the operator has to respond.
enum class Priority { Low, Medium, High };

/// What the alarm speaks of.
enum class Source { Control, Connection, Run, Program, Computer };

/// The states of ISA-18.2 that occur here. Nothing is suppressed by design or out of service.
enum class State {
  Normal,
  Unacknowledged,          ///< active
  Acknowledged,            ///< active
  ReturnedUnacknowledged,  ///< its cause is gone, nobody has acknowledged it
  Shelved,                 ///< put aside by somebody until a time
};

/// What is true of every alarm of a code. Sentences are English patterns with "%1" for the first
/// argument: the source of their translation, context "AlarmTexts".
struct Facts {
  Code code;
  const char* name;  ///< for files, e.g. "connection-lost"; never changes
  Priority priority;
  Source source;
  const char* text;    ///< what has happened
  const char* cause;   ///< empty: the error of the alarm says it
  const char* remedy;  ///< what to do; empty: the error of the alarm says it
};

/// In the order of `Code`.
[[nodiscard]] std::span<const Facts> allFacts();
[[nodiscard]] const Facts& factsOf(Code code);
[[nodiscard]] std::optional<Code> codeOfName(std::string_view name);

[[nodiscard]] std::string_view sourceName(Source source);
[[nodiscard]] std::string_view stateName(State state);
[[nodiscard]] std::optional<State> stateOfName(std::string_view name);

/// Somebody's decision to put an alarm aside.
struct Shelving {
  UtcMs until = 0;
  std::string by;
};

struct Alarm {
  int number = 0;  ///< identifies the alarm in a list, from 1
  Code code = Code::ControlAlarm;
  std::vector<std::string> arguments;  ///< the first one tells alarms of one code apart
  base::Error error;                   ///< why, if there is one; code clear otherwise
  UtcMs raisedAt = 0;                  ///< the last time it became active
  int count = 1;                       ///< how often it became active since it was normal
  bool isActive = true;
  bool isAcknowledged = false;
  std::optional<Shelving> shelving;

  [[nodiscard]] State state() const;
  [[nodiscard]] std::string subject() const { return arguments.empty() ? "" : arguments.front(); }
};

/// English sentences with the arguments in place, for files and logs.
[[nodiscard]] std::string describe(const Alarm& alarm);

}  // namespace rivulet::alarm
