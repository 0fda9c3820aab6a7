// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One machine without a window: connects, and connects again when the machine was gone; loads a
/// job, starts it once somebody has confirmed what was shown, streams, records and resumes it. The
/// rules are those of the window (`permission`, `streaming/start/start_policy`); the streaming
/// thread is the window's, too. Clients only ask: that one is gone changes nothing.
/// @threadsafety one thread; the streaming thread is its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/front/login_failure.h"
#include "opcua/connection.h"
#include "permission/permission.h"
#include "report/machine_store.h"
#include "service/loaded_job.h"
#include "session/session_event.h"
#include "session/session_worker.h"
#include "streaming/run/margins.h"
#include "streaming/start/start_policy.h"

namespace rivulet::service {

struct SessionOptions {
  opcua::ConnectRequest machine;
  std::filesystem::path jobs;   ///< folder of the jobs: no other file is read for a client
  std::filesystem::path state;  ///< folder of releases and audit trail
};

/// Who calls, and what that one may do.
struct Caller {
  std::string name;
  permission::Standing standing;
  bool hasRole = false;  ///< users are set up
};

struct Answer {
  bool accepted = false;
  std::string message;       ///< one sentence; why not, if it is refused
  std::string confirmation;  ///< of a preflight: what a start has to repeat; empty: none
};

/// Refused only because it takes a while: the same call, a second later, has the answer.
[[nodiscard]] bool isNotYet(const Answer& answer);

/// Files of a folder and those below it, as `ServiceSession::loadJob` takes them, one a line: the
/// newest first. Links and hidden files are left out. Of a very large folder, not all.
[[nodiscard]] std::string filesIn(const std::filesystem::path& folder);

/// What clients see. States are those of docs/service.md.
struct Snapshot {
  std::string machine;  ///< address
  std::string model;    ///< product and build of its server; empty: never connected
  bool isConnected = false;
  bool isRunning = false;
  std::string state;         ///< "disconnected", "idle", "loaded", "left", "armed", "running", ...
  std::string waitingFor;    ///< what a run waits for; empty: nothing
  std::string programState;  ///< of OPC 40501-1: "Initializing", "Running", "Interrupted", ...
  std::string itemState;     ///< of OPC 40001-1: "NotAvailable", "NotExecuting", "Executing"
  std::string files;         ///< in the folder of jobs, one a line: see `filesIn`
  std::string program;
  std::string file;
  std::string hash;
  std::string settings;
  std::uint32_t stretches = 0;  ///< of a whole job; 0: the motion alone
  std::uint32_t stretch = 0;    ///< in progress, or the one after the blocks in progress; 0: none
  std::uint32_t pointsDone = 0;
  std::uint32_t points = 0;
  double progressPercent = 0.0;
  double timeLeftS = -1.0;  ///< < 0: not known
  double pointsPerS = 0.0;
  std::uint32_t lateWindows = 0;  ///< of the run in progress, or of the last one
  double leastMarginS = 0.0;      ///< the same
  std::uint32_t runNumber = 0;
  std::vector<double> positionMm;
  double overridePercent = -1.0;  ///< that the control obeys; 0: held; < 0: not known, or none
  double feedFactor = -1.0;       ///< of the override, in force; 0: its source holds; < 0: none
  std::string feedSource;  ///< what becomes of its factors, one sentence; empty: there is none
  bool stands = false;     ///< held, and the axes were seen to stand
  bool canResume = false;  ///< a run was left
  std::string leftRun;     ///< which one; empty: none
  std::string alarm;       ///< why nothing goes on; empty: no alarm
  std::string message;     ///< what happened last
  std::string outcome;     ///< of the last run; empty: none has ended
  std::string report;      ///< its file in the history
};

class ServiceSession {
 public:
  using Clock = std::chrono::steady_clock;

  ServiceSession(SessionOptions options, opcua::Connector connector, report::MachineStore machines);
  ServiceSession(const ServiceSession&) = delete;
  ServiceSession& operator=(const ServiceSession&) = delete;

  /// Takes what the streaming thread has told, and connects again if it is time.
  void turn(Clock::time_point now);
  [[nodiscard]] Snapshot snapshot() const;
  [[nodiscard]] bool isRunning() const { return m_isRunning; }
  /// The last run ended as it was asked to: completed, or stopped with the axes at rest.
  [[nodiscard]] bool isSettled() const { return m_isSettled; }

  /// @param file  in the folder of jobs  @param settings  "name=value;…"; empty: the default, or
  /// for an operator those that were released
  Answer loadJob(const Caller& caller, const std::string& file, const std::string& settings);
  /// What Start would do now. Nothing moves.
  Answer preflight(const Caller& caller);
  /// The same of a whole job that is to begin with one of its stretches; the answer is that of a
  /// later call. @param stretch  a number from 1 on
  Answer preflightStretch(const Caller& caller, const std::string& stretch);
  /// What the last of the two has shown.
  Answer start(const Caller& caller, const std::string& confirmation);
  /// The axes stand at once, where the program has a feed cell, else before the next window; or
  /// they go on.
  Answer hold(const Caller& caller, bool hold);
  /// @param percent  a number, up to that of the caller's role
  Answer setOverride(const Caller& caller, const std::string& percent);
  Answer stop(const Caller& caller);
  /// Asks the control where the run was left; the answer is that of a later call.
  Answer preflightResume(const Caller& caller);
  Answer resumeRun(const Caller& caller, const std::string& confirmation);
  /// The run that was left is not kept any longer.
  Answer forgetRun(const Caller& caller);
  /// Ends a program that waits on the control for a run that nobody goes on with.
  Answer endRun(const Caller& caller);
  /// For the audit trail.
  void noteLogin(const Caller& caller);
  void noteFailedLogin(const machine::LoginFailure& failure);
  /// The service ends: a run in progress stops at the next window.
  void endForGood();

 private:
  struct Resumable;
  /// A preflight that was shown and can be confirmed.
  struct Shown {
    std::string confirmation;
    base::Vec3 toolMm;
    /// Of a job that is to begin with one of its stretches; null: at its beginning.
    std::shared_ptr<const run::JobRestart> restart{};
  };

  void take(const session::SessionEvent& event);
  void takeLink(const session::LinkChanged& link);
  void takeUpdate(const streaming::LiveUpdate& update);
  void takeRuns(const session::RunsSeen& runs);
  void takeFinished(const session::RunFinished& finished);
  void takeResume(const session::ResumeFound& found);
  /// @param restart  of a job that goes on or begins in the middle; null: it does not
  [[nodiscard]] streaming::StartFacts facts(const Caller& caller, permission::Act act,
                                            const run::JobRestart* restart = nullptr) const;
  [[nodiscard]] bool isReleased() const;
  /// What the act is refused for; nothing: it is permitted.
  [[nodiscard]] std::optional<Answer> refused(const Caller& caller, permission::Act act) const;
  [[nodiscard]] base::Result<LoadedJob> load(const Caller& caller, const std::string& file,
                                             const std::string& settings) const;
  void lookForFiles(Clock::time_point now);
  [[nodiscard]] base::Result<std::filesystem::path> pathOf(const std::string& file) const;
  [[nodiscard]] base::Result<void> requireNoWayOut(const std::filesystem::path& program) const;
  [[nodiscard]] const report::SavedRun* leftRun() const;
  /// Asks the control; the answer is that of a later call.
  Answer ask(session::ResumeQuestion question);
  /// The run that was left and could no longer be resumed; empty: there is none.
  [[nodiscard]] std::string replacedText() const;
  [[nodiscard]] std::string describeStart() const;
  [[nodiscard]] std::string describeResume(const report::SavedRun& run) const;
  [[nodiscard]] std::string describeBeginning(const run::JobRestart& restart) const;
  [[nodiscard]] std::string newConfirmation(const std::string& text);
  /// Since somebody was shown what a start would do; also if its place is not known.
  [[nodiscard]] bool hasToolMoved(const Shown& shown) const;
  [[nodiscard]] std::optional<base::Vec3> toolMm() const;  ///< nothing: not known
  Answer begin(const Caller& caller, permission::Act act, session::StartCommand command);
  void record(const Caller& caller, permission::Act act,
              std::vector<std::pair<std::string, std::string>> details);
  [[nodiscard]] std::string stateName() const;
  [[nodiscard]] double timeLeftS() const;

  SessionOptions m_options;
  report::MachineStore m_machines;
  report::RunHistory m_history;
  session::SessionWorker m_worker;
  session::LinkChanged m_link;
  std::optional<MachineFacts> m_machine;  ///< nothing: never connected
  std::optional<session::MachineSeen> m_seen;
  std::optional<LoadedJob> m_job;
  std::optional<Shown> m_shown;
  session::RunsSeen m_runs;
  std::optional<session::ResumeQuestion> m_question;  ///< asked last
  std::optional<session::ResumeFound> m_found;        ///< its answer
  std::optional<Shown> m_shownResume;
  streaming::LiveUpdate m_update;
  std::optional<session::JobUpdate> m_whole;
  struct Pace {
    std::vector<double> lengthsMm;  ///< from the first point to each, of the run in progress
    std::optional<std::pair<base::Instant, std::size_t>> from;  ///< first motion, points then
    std::size_t firstPoint = 0;
  };
  Pace m_pace;
  streaming::Margins m_margins;
  std::shared_ptr<const streaming::RunReport> m_report;
  std::string m_reportFile;
  std::string m_alarm;
  std::string m_message;
  struct Look {
    Clock::time_point nextConnect{};
    Clock::time_point nextFiles{};
    std::string files{};  ///< see `Snapshot`
  };
  Look m_look;
  std::uint64_t m_shownCount = 0;
  bool m_isRunning = false;
  bool m_isHeld = false;
  bool m_isAsking = false;
  bool m_isEnding = false;
  bool m_isConnecting = false;
  bool m_isSettled = true;
  bool m_endsForGood = false;
};

}  // namespace rivulet::service
