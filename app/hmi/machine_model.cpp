// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/machine_model.h"

#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using gcode::Severity;

namespace {

/// Values of a control that executes the flexible program.
constexpr int kChannelActive = 1;
constexpr int kProgramRunning = 3;

}  // namespace

MachineModel::MachineModel(session::StreamSession& session, report::MachineStore store,
                           Messages& messages)
    : m_session(session), m_store(std::move(store)), m_messages(messages) {
  connect(&m_session, &session::StreamSession::linkChanged, this, &MachineModel::takeLink);
  connect(&m_session, &session::StreamSession::machineSeen, this, &MachineModel::takeSeen);
  connect(&m_session, &session::StreamSession::calibrationFinished, this,
          &MachineModel::takeCalibration);
}

void MachineModel::setEndpoint(const QString& endpoint) {
  m_endpoint = endpoint;
  Q_EMIT endpointChanged();
}

void MachineModel::connectTo(const QString& endpoint) {
  setEndpoint(endpoint);
  m_session.connectTo(endpoint);
}

std::optional<base::Vec3> MachineModel::positionNowMm() const {
  return m_view.isStale ? std::nullopt : m_view.positionMm;
}

void MachineModel::takeLink(const session::LinkChanged& change) {
  m_link = change;
  m_view.isVirtualMachine = change.isVirtualMachine;
  if (!isConnected()) {
    m_view.isStale = m_view.positionMm.has_value();
  }
  Q_EMIT viewChanged();
  if (isConnected()) {
    m_messages.clear();
    loadCalibration();
    m_messages.log(Severity::Note,
                   change.isVirtualMachine
                       ? tr("Connected to the virtual machine at %1.").arg(m_endpoint)
                       : tr("Connected to the control at %1.").arg(m_endpoint));
  } else if (change.error.code) {
    m_messages.report(Severity::Error, widgets::errorText(change.error));
  }
  Q_EMIT linkChanged();
}

void MachineModel::takeSeen(const session::MachineSeen& seen) {
  m_view.channelStatus = seen.channelStatus;
  m_view.programStatus = seen.programStatus;
  m_view.alarmNumber = seen.alarm;
  m_view.programName = QString::fromStdString(seen.programName);
  m_view.message = QString::fromStdString(seen.message);
  m_view.positionMm = seen.positionMm;
  m_view.feedMmPerS = seen.feedMmPerS;
  m_view.rotaryAxes = seen.rotaryAxes;
  m_view.rotaryDeg = seen.rotaryDeg;
  m_view.isStale = false;
  Q_EMIT viewChanged();
  Q_EMIT this->seen();
}

void MachineModel::showRunning(const QString& programName) {
  m_view.channelStatus = kChannelActive;
  m_view.programStatus = kProgramRunning;
  m_view.programName = programName;
  Q_EMIT viewChanged();
}

void MachineModel::showSample(const trace::LiveSample& sample) {
  if (sample.positionMm) {
    m_view.positionMm = sample.positionMm;
  }
  if (sample.rotaryDeg) {
    m_view.rotaryDeg = sample.rotaryDeg;
  }
  if (sample.feedMmPerS) {
    m_view.feedMmPerS = sample.feedMmPerS;
  }
  m_view.isStale = false;
  Q_EMIT viewChanged();
}

void MachineModel::takeCalibration(const session::CalibrationFinished& finished) {
  if (!finished.record) {
    const bool isCancelled = finished.error.code == streaming::CalibrationError::Cancelled;
    m_messages.report(isCancelled ? Severity::Note : Severity::Error,
                      widgets::errorText(finished.error));
    Q_EMIT calibrationEnded();
    return;
  }
  m_calibration = finished.record;
  m_isOutdated = false;
  Q_EMIT calibrationEnded();
  if (const auto saved = m_store.save(*finished.record); !saved) {
    m_messages.show(Severity::Error, widgets::errorText(saved.error()));
  } else {
    const auto path = m_store.pathOf(finished.record->endpoint, finished.record->server);
    m_messages.log(Severity::Note,
                   tr("Calibrated. Saved %1.").arg(QString::fromStdString(path.string())));
  }
  Q_EMIT calibrationChanged();
}

void MachineModel::loadCalibration() {
  m_calibration.reset();
  m_isOutdated = false;
  auto found = m_store.calibration(m_endpoint.trimmed().toStdString(), m_link.server);
  if (!found) {
    m_messages.log(Severity::Warning, widgets::errorText(found.error()));
  } else if (*found) {
    m_isOutdated = (*found)->isOutdated(m_link.server);
    m_calibration = std::make_shared<const streaming::CalibrationRecord>(std::move(**found));
    if (m_isOutdated) {
      m_messages.log(
          Severity::Warning,
          tr("The calibration belongs to another version of the server and is not used."));
    }
  }
  Q_EMIT calibrationChanged();
}

}  // namespace rivulet::hmi
