// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/stream_session.h"

#include <QDateTime>

#include "qtopcua/open_link.h"
#include "session/session_worker.h"
#include "trust/connect.h"

namespace rivulet::session {

namespace {

/// How often the window takes events from the streaming thread: while that is busy, and while it
/// only watches the machine.
constexpr int kDrainMs = 50;
constexpr int kIdleDrainMs = 100;

}  // namespace

opcua::Attempt connectByOpcUa(const opcua::ConnectRequest& request) {
  return trust::connect(request, trust::trustFolder(), [&](const opcua::ConnectOptions& asked) {
    return qtopcua::openLink(request.link, asked);
  });
}

StreamSession::StreamSession(opcua::Connector connector, report::MachineStore machines,
                             QObject* parent)
    : QObject(parent),
      m_worker(std::make_unique<SessionWorker>(std::move(connector), std::move(machines))) {
  m_timer.setInterval(kIdleDrainMs);
  connect(&m_timer, &QTimer::timeout, this, &StreamSession::drain);
  m_timer.start();
}

StreamSession::~StreamSession() = default;

void StreamSession::connectTo(opcua::ConnectRequest request) {
  m_worker->post(ConnectCommand{std::move(request)});
}

void StreamSession::disconnectFrom() {
  m_worker->post(DisconnectCommand{});
}

void StreamSession::start(StartCommand command) {
  if (isBusy()) {
    return;
  }
  command.startedAtUtc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  m_running = m_worker->post(std::move(command));
}

void StreamSession::listen(const QString& address) {
  if (!m_running) {
    m_worker->post(ListenCommand{address.toStdString()});
  }
}

void StreamSession::calibrate(const streaming::CalibrationPlan& plan) {
  if (m_running || m_calibrating || m_commissioning) {
    return;
  }
  m_calibrating = m_worker->post(
      CalibrateCommand{plan, QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
}

void StreamSession::commission(CommissionCommand command) {
  if (isBusy()) {
    return;
  }
  command.startedAtUtc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  m_commissioning = m_worker->post(std::move(command));
}

void StreamSession::correct(base::Vec3 valueMm) {
  if (m_running) {
    m_worker->correct(valueMm);
  }
}

void StreamSession::stop() {
  m_worker->stopRun();
}

void StreamSession::leave() {
  m_worker->leaveRun();
}

void StreamSession::hold(bool hold) {
  m_worker->holdRun(hold);
}

void StreamSession::lift(double mm) {
  m_worker->liftTool(mm);
}

void StreamSession::setOverride(double percent) {
  m_worker->overrideRun(percent);
}

void StreamSession::askResume(ResumeQuestion question) {
  if (!m_running && !m_asking) {
    m_asking = m_worker->post(std::move(question));
  }
}

bool StreamSession::endRun(const std::optional<streaming::RunOnControl>& run, bool holds) {
  if (m_running || m_ending || m_commissioning) {
    return false;
  }
  m_ending = m_worker->post(EndRunCommand{run, holds});
  return m_ending;
}

void StreamSession::examineRights() {
  if (!isBusy()) {
    m_worker->post(RightsCommand{});
  }
}

void StreamSession::drain() {
  if (const int intervalMs = isBusy() ? kDrainMs : kIdleDrainMs; intervalMs != m_timer.interval()) {
    m_timer.setInterval(intervalMs);
  }
  while (const std::optional<SessionEvent> event = m_worker->take()) {
    if (const auto* change = std::get_if<LinkChanged>(&*event)) {
      Q_EMIT linkChanged(*change);
    } else if (const auto* seen = std::get_if<MachineSeen>(&*event)) {
      Q_EMIT machineSeen(*seen);
    } else if (const auto* update = std::get_if<streaming::LiveUpdate>(&*event)) {
      Q_EMIT updateArrived(*update);
    } else if (const auto* opened = std::get_if<SourceOpened>(&*event)) {
      Q_EMIT sourceOpened(*opened);
    } else if (const auto* live = std::get_if<LivePoints>(&*event)) {
      Q_EMIT livePointsArrived(*live);
    } else if (const auto* job = std::get_if<JobUpdate>(&*event)) {
      Q_EMIT jobUpdated(*job);
    } else if (const auto* note = std::get_if<trace::Note>(&*event)) {
      Q_EMIT noteArrived(*note);
    } else if (const auto* cut = std::get_if<run::RecordingCut>(&*event)) {
      Q_EMIT recordingCut(*cut);
    } else if (const auto* finished = std::get_if<RunFinished>(&*event)) {
      m_running = false;
      Q_EMIT runFinished(*finished);
    } else if (const auto* found = std::get_if<ResumeFound>(&*event)) {
      m_asking = false;
      Q_EMIT resumeFound(*found);
    } else if (const auto* runs = std::get_if<RunsSeen>(&*event)) {
      Q_EMIT runsSeen(*runs);
    } else if (const auto* ended = std::get_if<RunEnded>(&*event)) {
      m_ending = false;
      Q_EMIT runEnded(*ended);
    } else if (const auto* rights = std::get_if<RightsSeen>(&*event)) {
      Q_EMIT rightsSeen(*rights);
    } else if (const auto* progress = std::get_if<streaming::CalibrationProgress>(&*event)) {
      Q_EMIT calibrationProgressed(*progress);
    } else if (const auto* tested = std::get_if<CommissioningProgress>(&*event)) {
      Q_EMIT commissioningProgressed(*tested);
    } else if (const auto* commissioned = std::get_if<CommissioningFinished>(&*event)) {
      m_commissioning = false;
      Q_EMIT commissioningFinished(*commissioned);
    } else if (const auto* calibrated = std::get_if<CalibrationFinished>(&*event)) {
      m_calibrating = false;
      Q_EMIT calibrationFinished(*calibrated);
    }
  }
}

}  // namespace rivulet::session
