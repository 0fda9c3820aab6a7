// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Who may do what, and the releases that say which jobs an operator may start. Without users
/// everybody may do everything. Stop is always permitted. @threadsafety pure.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/utc.h"

namespace rivulet::permission {

enum class Role {
  Operator,  ///< starts what is released
  Engineer,  ///< everything
};

/// What somebody does with the window. Each one is a line of the audit trail.
enum class Act {
  Stop,
  Hold,
  Continue,
  Override,  ///< path override of a run
  Start,
  Resume,
  Watch,    ///< a run that another window or client streams
  Correct,  ///< online correction
  OpenProgram,
  ChangeSettings,
  Connect,
  Disconnect,
  Trust,  ///< a server, its certificate, or a connection without encryption
  Calibrate,
  Release,
  TakeBackRelease,
  Acknowledge,
  Shelve,
  SetUpUsers,
  LogIn,
  LogInFailed,
  Lock,
  ProgramStart,  ///< of Rivulet
  ProgramEnd,
};

/// "start", "change-settings", ...
[[nodiscard]] std::string_view actName(Act act);
[[nodiscard]] std::optional<Act> actOfName(std::string_view name);
[[nodiscard]] std::string_view roleName(Role role);
[[nodiscard]] std::optional<Role> roleOfName(std::string_view name);

/// Who is at the window.
struct Standing {
  Role role = Role::Engineer;
  bool isLocked = false;
};

enum class Refusal {
  Locked,         ///< only Stop works
  NeedsEngineer,  ///< the act is not an operator's
  NotReleased,    ///< an operator starts only what is released
};

/// @param isReleased  of the job that Start or Resume would run
/// @param mayRepeat   its method may execute old points again: an engineer's alone, released or not
/// @return nothing if it is permitted
[[nodiscard]] std::optional<Refusal> refusal(const Standing& standing, Act act,
                                             bool isReleased = true, bool mayRepeat = false);

/// The highest path override that somebody may set, percent. The highest of all is that of the
/// machine's own switch.
[[nodiscard]] constexpr double overridePercentMax(Role role) {
  return role == Role::Engineer ? 120.0 : 100.0;
}

/// What exactly is released. A job that differs in anything is another one.
struct Job {
  std::string programHash;
  std::string settings;     ///< every setting of the run as text
  std::string calibration;  ///< which one the verdict rests on; empty: none

  friend bool operator==(const Job&, const Job&) = default;
};

struct Release {
  Job job;
  std::string programName;
  std::string by;
  base::UtcMs at = 0;
  bool isTakenBack = false;
};

/// The release of a job that holds; null: none. The last word on a job counts.
/// @param releases  in the order in which they were made
[[nodiscard]] const Release* releaseOf(std::span<const Release> releases, const Job& job);
/// The last release of a program that holds, with whatever settings; null: none.
[[nodiscard]] const Release* lastReleaseOf(std::span<const Release> releases,
                                           std::string_view programHash);

}  // namespace rivulet::permission
