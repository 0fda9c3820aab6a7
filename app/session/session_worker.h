// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The streaming thread: owns the link and, during a run, driver and method. Requests come in and
/// events go out through bounded rings; nothing but a full ring of events makes this side wait for
/// the GUI.
/// @threadsafety constructor, destructor, `post`, `stopRun`, `leaveRun`, `holdRun`, `overrideRun`,
/// `correct` and `take` belong to the GUI thread.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <semaphore>
#include <thread>

#include "base/spsc_ring.h"
#include "live/source.h"
#include "opcua/connection.h"
#include "report/machine_store.h"
#include "report/run_store.h"
#include "run/factor_feed.h"
#include "run/run_record.h"
#include "session/session_event.h"
#include "streaming/control/control_axes.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/run/job.h"

namespace rivulet::session {

class SessionWorker {
 public:
  /// @param connector  called on the streaming thread
  SessionWorker(opcua::Connector connector, report::MachineStore machines);
  /// Stops a run in progress and waits for its end, closes the connection, ends the thread.
  ~SessionWorker();
  SessionWorker(const SessionWorker&) = delete;
  SessionWorker& operator=(const SessionWorker&) = delete;

  /// @return false if the ring of commands is full
  bool post(SessionCommand command);
  /// Takes effect when the driver next checks its requests, within 20 ms; cancels a calibration
  /// after the request in progress.
  /// @param letsEnd  the program goes on to its end, before its next window; else its axes are
  ///                 held at once, until `holdRun(false)`
  void stopRun(bool letsEnd = true);
  /// The same, and nobody stays to let it go on: it ends when its axes stand, and is left held.
  void leaveRun();
  /// Online correction of the run in progress, mm; a run begins with none.
  void correct(base::Vec3 valueMm);
  /// Makes the axes of the run or job in progress stand at once, by its feed cell, and wait before
  /// its next window; or continue. After a stop as well: a run that is held then ends when it goes
  /// on. To continue while only the source of factors holds is to go on without it, until its next
  /// factor. A start takes it back.
  void holdRun(bool hold);
  /// See `streaming::FeedOrder`; 0: back onto the path.
  void liftTool(double mm);
  /// Path override of the run or job in progress, 0 to 200 %, at once; others are refused. A start
  /// sets 100. `streaming::LiveUpdate::feed` says what has become of it.
  void overrideRun(double percent);
  /// The oldest event not taken yet.
  std::optional<SessionEvent> take();
  /// Live updates that were dropped because nobody took them.
  [[nodiscard]] std::size_t lost() const { return m_lost.load(); }

 private:
  class Sink;
  class JobSink;
  class LiveSink;
  class Requests;

  void work();
  void connect(const ConnectCommand& command);
  void disconnect();
  void start(const StartCommand& command);
  /// What a run has left behind.
  struct Done {
    streaming::RunReport report;
    std::vector<gcode::StreamPoint> points{};       ///< its path
    std::optional<streaming::JobTimes> jobTimes{};  ///< of a whole job
    std::vector<trace::ToolUse> tools{};            ///< of a whole job
  };
  [[nodiscard]] Done runMotion(const StartCommand& command,
                               const templates::FlexibleProgram& flexible,
                               const streaming::RunSettings& settings, Requests& requests,
                               run::RunRecord& record);
  [[nodiscard]] Done runWholeJob(const StartCommand& command,
                                 const streaming::RunSettings& settings, Requests& requests,
                                 run::RunRecord& record);
  [[nodiscard]] Done runLive(const StartCommand& command,
                             const templates::FlexibleProgram& flexible,
                             const streaming::RunSettings& settings, Requests& requests,
                             run::RunRecord& record);
  void listen(const std::string& address);
  [[nodiscard]] run::RunFacts factsOf(const StartCommand& command);
  void answer(const ResumeQuestion& question);
  [[nodiscard]] base::Result<run::JobRestart> askJob(const ResumeQuestion& question,
                                                     streaming::ActiveProgram active);
  /// The way of a run of points, before it starts.
  [[nodiscard]] base::Result<void> checkTravel(const StartCommand& command);
  [[nodiscard]] base::Result<void> askAgain(const StartCommand& command);
  /// Checks that are possible only now, right before a start. The template is proved once per kind.
  [[nodiscard]] base::Result<void> checkBefore(const StartCommand& command,
                                               const templates::FlexibleProgram& flexible,
                                               streaming::RunSink& sink);
  void calibrate(const CalibrateCommand& command);
  void commission(const CommissionCommand& command);
  /// According to the file of the machine.
  [[nodiscard]] bool hasPassedCreditTest(const streaming::RunSettings& settings) const;
  /// Reads the control between other work; notices that the connection is lost.
  void watch();
  /// @return what the control says now, without what it describes; the error of the link
  [[nodiscard]] base::Result<MachineSeen> readControl();
  /// Tells it, and looks for runs. @return the error of the link, if it has one
  [[nodiscard]] base::Result<void> lookAtControl();
  using Described = std::shared_ptr<const std::vector<opcua::DescribedMachine>>;
  /// @return null: it is not time yet, or it could not be read; ConnectionLost
  [[nodiscard]] base::Result<Described> readDescription();
  /// @param isBusy  a program is active
  /// @param tool  where it is; nothing: not known
  [[nodiscard]] base::Result<void> lookForRuns(bool isBusy,
                                               const std::optional<base::AxisPosition>& tool);
  /// What is known here about a run on the control.
  void takeFound(const std::optional<streaming::RunOnControl>& found);
  /// See `RunsSeen`.
  [[nodiscard]] std::optional<streaming::MotionAhead> ahead(
      const std::optional<base::AxisPosition>& tool) const;
  void endRun(const EndRunCommand& command);
  void examineRights();
  /// Live values may be lost when the GUI does not keep up; everything else waits for room.
  void tell(SessionEvent event);
  bool tellIfRoom(SessionEvent event);

  base::SpscRing<SessionCommand, 16> m_commands;
  /// Too large for the stack of a thread, on which the worker may stand.
  using Events = base::SpscRing<SessionEvent, 4096>;
  std::unique_ptr<Events> m_events = std::make_unique<Events>();
  std::counting_semaphore<> m_commandCount{0};
  std::atomic<bool> m_quit{false};
  std::atomic<bool> m_stopRun{false};
  std::atomic<bool> m_letsEnd{true};
  std::atomic<bool> m_leaves{false};
  /// What is wanted of the feed of the run in progress.
  struct FeedWanted {
    std::atomic<bool> holds{false};
    std::atomic<bool> goesOn{false};  ///< without the source that holds
    std::atomic<double> percent{templates::FeedCell::kProgrammed};
    std::atomic<double> liftMm{0.0};
  };
  FeedWanted m_feed;
  std::atomic<std::size_t> m_lost{0};
  std::mutex m_correctionMutex;  // held for a copy
  base::Vec3 m_correctionMm;
  opcua::Connector m_connector;
  report::MachineStore m_machines;
  report::RunStore m_runs;
  report::RunStore m_jobs{report::RunStore::folderOfJobs()};
  opcua::Connection m_connection;         // streaming thread only
  streaming::ControlAxes m_axes;          // of the control at the other end
  streaming::EquipmentWatch m_equipment;  // of the control at the other end
  base::Instant m_nextEquipment{};
  base::Instant m_nextDescription{};
  streaming::RunWatch m_watch;                   // of the control at the other end
  RunsSeen m_seen;                               // as told last
  std::vector<gcode::StreamPoint> m_seenPoints;  // of its run on the control; empty: not known
  bool m_looksForLeft = false;                   // the store may have changed
  std::string m_proven;             // text of the template proved last; streaming thread only
  opcua::ConnectRequest m_request;  // that `m_connection` was made for
  std::unique_ptr<live::Source> m_source;     // of live points; streaming thread only; null: none
  std::unique_ptr<run::FactorFeed> m_factor;  // of the run in progress; streaming thread only
  opcua::ServerIdentity m_server;
  std::thread m_thread;
};

static_assert(sizeof(SessionWorker) < 256 * 1024);

}  // namespace rivulet::session
