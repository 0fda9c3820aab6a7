// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The HMI's view of the streaming thread: requests in, values out as signals, at most 30 times a
/// second. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>

#include "opcua/connection.h"
#include "report/machine_store.h"
#include "session/session_event.h"

namespace rivulet::session {

class SessionWorker;

/// The connection of the released program.
[[nodiscard]] opcua::Attempt connectByOpcUa(const opcua::ConnectRequest& request);

class StreamSession final : public QObject {
  Q_OBJECT

 public:
  /// @param connector  called on the streaming thread; by default OPC UA
  /// @param machines   what is known about the machines
  explicit StreamSession(opcua::Connector connector = connectByOpcUa,
                         report::MachineStore machines = report::MachineStore(),
                         QObject* parent = nullptr);
  /// Ends a run in progress (with a stop, waiting for its confirmation) and the connection.
  ~StreamSession() override;

  void connectTo(opcua::ConnectRequest request);
  void disconnectFrom();
  /// Starts a run; the time of the start is added. Ignored during a run.
  void start(StartCommand command);
  void stop();
  /// The axes stand at once, and the run ends there: see `SessionWorker::leaveRun`.
  void leave();
  /// Takes live points from this address for the runs to come; `sourceOpened` answers. Ignored
  /// during a run. @param address  see `sources::openSource`; empty: from nowhere any more
  void listen(const QString& address);
  /// Online correction of the run in progress, X Y Z, mm; every run begins with none.
  void correct(base::Vec3 valueMm);
  /// The axes of the run in progress stand at once, where its program has a feed cell; else before
  /// its next window. False: it goes on, also to its end if it has been stopped meanwhile.
  void hold(bool hold);
  /// Path override of the run in progress, 0 to 200 %; every run begins with 100.
  void setOverride(double percent);
  /// Lifts the tool of the run in progress by so much, mm, while its axes are held; 0: lowers it.
  void lift(double mm);
  /// Answered by `resumeFound`. Ignored during a run.
  void askResume(ResumeQuestion question);
  /// Commands a run that was found on the control to end; answered by `runEnded`. Ignored during a
  /// run.
  /// @param holds  see `EndRunCommand`
  /// @return whether the command was taken
  bool endRun(const std::optional<streaming::RunOnControl>& run, bool holds);

  /// Answered by `rightsSeen`. Ignored while anything else is done with the control.
  void examineRights();

  /// Measures the cost of access, on cells that the operator has confirmed. `stop` cancels.
  void calibrate(const streaming::CalibrationPlan& plan);

  /// A test of the control, on cells that nobody else uses. `stop` cancels.
  void commission(CommissionCommand command);

  [[nodiscard]] bool isRunning() const { return m_running; }
  [[nodiscard]] bool isCommissioning() const { return m_commissioning; }
  [[nodiscard]] bool isCalibrating() const { return m_calibrating; }
  [[nodiscard]] bool isAsking() const { return m_asking; }
  [[nodiscard]] bool isEnding() const { return m_ending; }

 Q_SIGNALS:
  void linkChanged(const rivulet::session::LinkChanged& change);
  void machineSeen(const rivulet::session::MachineSeen& seen);
  void updateArrived(const rivulet::streaming::LiveUpdate& update);
  void sourceOpened(const rivulet::session::SourceOpened& opened);
  void livePointsArrived(const rivulet::session::LivePoints& points);
  void jobUpdated(const rivulet::session::JobUpdate& update);
  void noteArrived(const rivulet::trace::Note& note);
  /// Of the run in progress, which goes on.
  void recordingCut(const rivulet::run::RecordingCut& cut);
  void runFinished(const rivulet::session::RunFinished& finished);
  void resumeFound(const rivulet::session::ResumeFound& found);
  void runsSeen(const rivulet::session::RunsSeen& seen);
  void runEnded(const rivulet::session::RunEnded& ended);
  void rightsSeen(const rivulet::session::RightsSeen& seen);
  void calibrationProgressed(const rivulet::streaming::CalibrationProgress& progress);
  void commissioningProgressed(const rivulet::session::CommissioningProgress& progress);
  void commissioningFinished(const rivulet::session::CommissioningFinished& finished);
  void calibrationFinished(const rivulet::session::CalibrationFinished& finished);

 private:
  void drain();
  /// Whether the streaming thread is asked to do something that takes a while.
  [[nodiscard]] bool isBusy() const {
    return m_running || m_asking || m_calibrating || m_ending || m_commissioning;
  }

  std::unique_ptr<SessionWorker> m_worker;
  QTimer m_timer;
  bool m_running = false;
  bool m_asking = false;
  bool m_ending = false;
  bool m_calibrating = false;
  bool m_commissioning = false;
};

}  // namespace rivulet::session
