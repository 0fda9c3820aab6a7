// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/machine_model.h"

#include <chrono>

#include "opcua/control_map.h"
#include "trust/user_certificate.h"
#include "widgets/common/error_text.h"
#include "widgets/connection/trust_sheet.h"

namespace rivulet::hmi {

using gcode::Severity;
using Source = Messages::Source;

namespace {

/// Values of a control that executes the flexible program.
constexpr int kProgramRunning = 3;
/// How often what is shown is asked for its age.
constexpr int kAgeIntervalMs = 250;
/// Reads that were rare are taken for frequent again after this time without a gap.
constexpr double kRareLastsS = 3.0;

}  // namespace

void MachineModel::ReadTimes::take(double nowS, bool duringRun) {
  if (!duringRun) {
    m_rareAtS.reset();
  } else if (m_atS && nowS - *m_atS > widgets::kFreshS) {
    m_rareAtS = nowS;
  }
  m_atS = nowS;
}

std::optional<double> MachineModel::ReadTimes::ageS(double nowS) const {
  return m_atS ? std::optional(nowS - *m_atS) : std::nullopt;
}

bool MachineModel::ReadTimes::isRare(double nowS) const {
  return m_rareAtS && nowS - *m_rareAtS < kRareLastsS;
}

MachineModel::MachineModel(session::StreamSession& session, report::MachineStore store,
                           Messages& messages, Clock clock)
    : m_session(session),
      m_store(std::move(store)),
      m_messages(messages),
      m_clock(std::move(clock)) {
  m_ageTimer.setInterval(kAgeIntervalMs);
  connect(&m_ageTimer, &QTimer::timeout, this, &MachineModel::showAges);
  m_ageTimer.start();
  connect(&m_session, &session::StreamSession::linkChanged, this, &MachineModel::takeLink);
  connect(&m_session, &session::StreamSession::machineSeen, this, &MachineModel::takeSeen);
  connect(&m_session, &session::StreamSession::rightsSeen, this, &MachineModel::rightsSeen);
  connect(&m_session, &session::StreamSession::calibrationFinished, this,
          &MachineModel::takeCalibration);
}

double MachineModel::steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void MachineModel::showAges() {
  m_ageTimer.start();  // it shows them where nothing is read that would
  const double nowS = m_clock();
  m_view.positionAgeS = m_positionRead.ageS(nowS);
  m_view.isPositionRare = m_positionRead.isRare(nowS);
  m_view.feedAgeS = m_feedRead.ageS(nowS);
  m_view.isFeedRare = m_feedRead.isRare(nowS);
  m_view.equipmentAgeS = m_equipmentAtS ? std::optional(nowS - *m_equipmentAtS) : std::nullopt;
  m_view.describedAgeS = m_describedAtS ? std::optional(nowS - *m_describedAtS) : std::nullopt;
  m_view.stateAgeS = m_stateAtS ? std::optional(nowS - *m_stateAtS) : std::nullopt;
  if (m_view.executed) {
    m_view.executed->ageS = nowS - m_executedAtS;
  }
  Q_EMIT viewChanged();
}

widgets::ConnectionState MachineModel::connectionState() const {
  switch (m_link.state) {
    case session::LinkState::Disconnected:
      return widgets::ConnectionState::Disconnected;
    case session::LinkState::Connecting:
      return widgets::ConnectionState::Connecting;
    case session::LinkState::Connected:
      return widgets::ConnectionState::Connected;
    case session::LinkState::Lost:
      return widgets::ConnectionState::Lost;
  }
  return widgets::ConnectionState::Disconnected;
}

void MachineModel::setEndpoint(const QString& endpoint) {
  m_control = rememberedControl(endpoint);
  showEndpoint(endpoint);
}

widgets::ControlChoice MachineModel::rememberedControl(const QString& endpoint) const {
  return m_logins != nullptr ? m_logins->controlOf(endpoint) : widgets::ControlChoice();
}

void MachineModel::showEndpoint(const QString& endpoint) {
  m_endpoint = endpoint;
  if (m_logins != nullptr) {
    m_logins->show(endpoint);
  }
  Q_EMIT endpointChanged();
}

void MachineModel::connectTo(const QString& endpoint) {
  widgets::Login login;
  if (m_logins != nullptr) {
    login.name = m_logins->nameOf(endpoint);
  }
  connectAs(endpoint, login, rememberedControl(endpoint));
}

bool MachineModel::readMap(const QString& file) {
  if (file.isEmpty()) {
    return true;
  }
  auto map = opcua::readControlMap(file.toStdString());
  if (!map) {
    refuse(map.error());
    return false;
  }
  QStringList missing;
  for (const opcua::MapGap& gap : opcua::gapsOf(*map)) {
    missing.append(QString::fromUtf8(gap.key.data(), static_cast<qsizetype>(gap.key.size())));
  }
  if (!missing.isEmpty()) {
    m_messages.log(Severity::Warning, Source::Connection, [file, missing] {
      return tr("The map %1 does not name: %2. What needs it does not work.")
          .arg(file, missing.join(QStringLiteral(", ")));
    });
  }
  m_request.map = std::make_shared<const opcua::ControlMap>(std::move(*map));
  return true;
}

bool MachineModel::readCertificate(const widgets::LoginName& name) {
  if (name.certificateFile.isEmpty()) {
    return true;
  }
  auto certificate =
      trust::readUserFiles(name.certificateFile.toStdString(), name.keyFile.toStdString());
  if (!certificate) {
    refuse(certificate.error());
    return false;
  }
  m_request.userCertificate = std::move(*certificate);
  return true;
}

void MachineModel::refuse(const base::Error& error) {
  session::LinkChanged change;
  change.state = session::LinkState::Disconnected;
  change.error = error;
  takeLink(change);
}

void MachineModel::connectAs(const QString& endpoint, const widgets::Login& login,
                             const widgets::ControlChoice& control) {
  m_control = control;
  showEndpoint(endpoint);
  m_messages.didAct(permission::Act::Connect, {{"machine", endpoint.toStdString()}});
  m_request = {};
  m_request.endpoint = endpoint.trimmed().toStdString();
  m_request.user = login.name.user.toStdString();
  m_request.password = login.password.toStdString();
  m_request.link = control.link;
  m_login = login;
  if (!readMap(control.mapFile) || !readCertificate(login.name)) {
    return;
  }
  if (login.name.user.isEmpty() || !login.password.isEmpty() || m_logins == nullptr) {
    m_session.connectTo(m_request);
    return;
  }
  m_logins->findPassword(
      endpoint, login.name.user, [this, asked = m_request](const QString& password) {
        if (asked.endpoint != m_request.endpoint || asked.user != m_request.user) {
          return;  // somebody wants another machine meanwhile
        }
        if (password.isEmpty()) {
          m_logins->ask(widgets::LoginView::Reason::NeedsPassword, m_login.name);
          return;
        }
        m_request.password = password.toStdString();
        m_session.connectTo(m_request);
      });
}

std::optional<opcua::Protection> MachineModel::protection() const {
  if (!isConnected() || !m_link.security) {
    return std::nullopt;
  }
  return opcua::protectionOf(*m_link.security, m_endpoint.trimmed().toStdString());
}

void MachineModel::acceptCertificate() {
  if (question() == nullptr) {
    return;
  }
  m_request.fingerprint = question()->shown.fingerprint;
  m_messages.didAct(permission::Act::Trust,
                    {{"machine", m_request.endpoint}, {"certificate", m_request.fingerprint}});
  connectAgain();
}

void MachineModel::allow(const opcua::SecurityChoice& choice) {
  if (question() == nullptr) {
    return;
  }
  m_request.security = choice;
  m_messages.didAct(permission::Act::Trust, {{"machine", m_request.endpoint},
                                             {"allowed", opcua::securityChoiceText(choice)}});
  connectAgain();
}

void MachineModel::connectAgain() {
  m_link.question.reset();
  m_session.connectTo(m_request);
  Q_EMIT linkChanged();
}

void MachineModel::dropQuestion() {
  m_request = {};
  m_login = {};
  m_link.question.reset();
  Q_EMIT linkChanged();
}

void MachineModel::disconnectFrom() {
  m_messages.didAct(permission::Act::Disconnect, {{"machine", m_endpoint.toStdString()}});
  m_session.disconnectFrom();
}

std::optional<base::Vec3> MachineModel::positionNowMm() const {
  return m_view.positionFreshness() == widgets::Freshness::Live ? m_view.positionMm : std::nullopt;
}

void MachineModel::takeLink(const session::LinkChanged& change) {
  m_link = change;
  m_view.isVirtualMachine = change.isVirtualMachine;
  m_view.isGone = !isConnected();
  if (!isConnected()) {
    // What the control does now is not known. Where the tool was is kept, with its age.
    m_view.channelStatus.reset();
    m_view.programStatus.reset();
    m_view.alarmNumber.reset();
    m_view.programName.reset();
    m_view.message.reset();
    m_view.executed.reset();
    m_view.toGo.reset();
    m_view.feedSetMmPerS.reset();
    m_view.overrideFactor.reset();
    m_stateAtS.reset();
    m_view.described.reset();
    m_describedAtS.reset();
  }
  if (m_logins != nullptr && isConnected()) {
    m_logins->remember(m_endpoint, m_login, m_control);
  } else if (m_logins != nullptr && question() != nullptr &&
             question()->kind == opcua::TrustQuestion::Kind::Login) {
    using Reason = widgets::LoginView::Reason;
    m_logins->ask(m_login.name.isAnonymous() ? Reason::NeedsUser : Reason::Refused, m_login.name);
  }
  if (isConnected()) {
    m_request = {};  // with its password
    m_login = {};
  }
  showAges();
  sayLink();
  Q_EMIT linkChanged();
}

void MachineModel::sayLink() {
  const std::string endpoint = m_endpoint.toStdString();
  switch (m_link.state) {
    case session::LinkState::Connected:
      m_messages.settle(alarm::Code::NotConnected);
      m_messages.settle(alarm::Code::ConnectionLost);
      m_messages.clear();
      loadCalibration();
      m_messages.log(Severity::Note, Source::Connection,
                     [endpoint = m_endpoint, isVirtual = m_link.isVirtualMachine] {
                       return (isVirtual ? tr("Connected to the virtual machine at %1.")
                                         : tr("Connected to the control at %1."))
                           .arg(endpoint);
                     });
      return;
    case session::LinkState::Connecting:
      m_messages.settle(alarm::Code::NotConnected);
      return;
    case session::LinkState::Lost:
      m_messages.raise(alarm::Code::ConnectionLost, {endpoint}, m_link.error);
      m_messages.settle(alarm::Code::ControlAlarm);
      return;
    case session::LinkState::Disconnected:
      m_messages.settle(alarm::Code::ConnectionLost);
      m_messages.settle(alarm::Code::ControlAlarm);
      // What is asked on a sheet of its own is no alarm.
      if (m_link.error.code && (question() == nullptr || !widgets::isOnSheet(*question()))) {
        m_messages.raise(alarm::Code::NotConnected, {endpoint}, m_link.error);
      }
      return;
  }
}

void MachineModel::takeSeen(const session::MachineSeen& seen) {
  const widgets::MachineView before = m_view;
  const double nowS = m_clock();
  const bool wasSilent = !widgets::isFresh(m_positionRead.ageS(nowS)) || !m_stateAtS ||
                         !widgets::isFresh(nowS - *m_stateAtS);
  m_view.channelStatus = seen.channelStatus;
  // What was still on its way when a test began tells of the time before.
  m_mayMove = m_session.isCommissioning() ? m_mayMove : seen.channelStatus != opcua::kChannelReset;
  m_view.programStatus = seen.programStatus;
  m_view.alarmNumber = seen.alarm;
  if (seen.alarm.value_or(0) != 0) {
    m_messages.raise(alarm::Code::ControlAlarm, {std::to_string(*seen.alarm)});
  } else if (seen.alarm) {
    m_messages.settle(alarm::Code::ControlAlarm);
  }
  const auto shown = [](const std::optional<std::string>& text) {
    return text ? std::optional(QString::fromStdString(*text)) : std::nullopt;
  };
  m_view.programName = shown(seen.programName);
  m_view.message = shown(seen.message);
  m_view.rotaryAxes = seen.rotaryAxes;
  m_view.toGo.reset();
  if (seen.toGoMm) {
    m_view.toGo = widgets::MachineView::ToGo{*seen.toGoMm, seen.toGoDeg};
  }
  if (seen.equipment) {
    m_view.equipment = seen.equipment;
    m_equipmentAtS = nowS;
  }
  if (seen.described) {
    m_view.described = seen.described;
    m_describedAtS = nowS;
  }
  // What could not be read stays as it was, and gets old.
  if (seen.channelStatus && seen.programStatus && seen.alarm) {
    m_stateAtS = nowS;
  }
  const bool isRotaryKnown = seen.rotaryDeg || !base::any(seen.rotaryAxes);
  if (seen.positionMm && isRotaryKnown) {
    m_view.positionMm = seen.positionMm;
    m_view.rotaryDeg = seen.rotaryDeg;
    m_positionRead.take(nowS, false);
  }
  if (seen.feedMmPerS) {
    m_view.feedMmPerS = seen.feedMmPerS;
    m_feedRead.take(nowS, false);
  }
  const bool isNews = wasSilent || m_view != before;  // ages apart, which come now
  showAges();
  Q_EMIT this->seen(isNews);
}

void MachineModel::showRunning(const QString& programName) {
  m_view.channelStatus = opcua::kChannelActive;
  m_mayMove = true;
  m_view.programStatus = kProgramRunning;
  m_view.programName = programName;
  m_stateAtS = m_clock();
  showAges();
}

void MachineModel::showExecuted(std::size_t number, const base::Vec3& positionMm,
                                double feedSetMmPerS, std::optional<double> overrideFactor) {
  m_view.feedSetMmPerS = feedSetMmPerS;
  m_view.overrideFactor = overrideFactor;
  m_stateAtS = m_executedAtS = m_clock();
  if (number > 0) {
    m_view.executed = widgets::MachineView::Executed{number, positionMm, 0.0};
  }
  showAges();
}

void MachineModel::forgetExecuted() {
  m_view.executed.reset();
  m_view.toGo.reset();
  m_view.feedSetMmPerS.reset();
  m_view.overrideFactor.reset();
  showAges();
}

void MachineModel::showSample(const trace::LiveSample& sample,
                              const std::optional<widgets::MachineView::ToGo>& toGo) {
  const double nowS = m_clock();
  if (sample.positionMm) {
    m_view.positionMm = sample.positionMm;
    m_view.toGo = toGo;
    m_positionRead.take(nowS, true);
  }
  if (sample.rotaryDeg) {
    m_view.rotaryDeg = sample.rotaryDeg;
  }
  if (sample.feedMmPerS) {
    m_view.feedMmPerS = sample.feedMmPerS;
    m_feedRead.take(nowS, true);
  }
  showAges();
}

void MachineModel::showEquipment(const streaming::EquipmentSeen& equipment) {
  m_view.equipment = equipment;
  m_equipmentAtS = m_clock();
  showAges();
}

void MachineModel::takeCalibration(const session::CalibrationFinished& finished) {
  if (!finished.record) {
    const bool isCancelled = finished.error.code == streaming::CalibrationError::Cancelled;
    const auto text = [error = finished.error] { return widgets::errorText(error); };
    if (isCancelled) {
      m_messages.show(Severity::Note, text);
      m_messages.log(Severity::Note, Source::Control, text);
    } else {
      m_messages.raise(alarm::Code::CalibrationFailed, {m_endpoint.toStdString()}, finished.error);
    }
    Q_EMIT calibrationEnded();
    return;
  }
  m_calibration = finished.record;
  m_isOutdated = false;
  Q_EMIT calibrationEnded();
  m_messages.settle(alarm::Code::CalibrationFailed);
  if (const auto saved = m_store.save(*finished.record); !saved) {
    m_messages.raise(alarm::Code::CalibrationNotSaved, {m_endpoint.toStdString()}, saved.error());
  } else {
    m_messages.settle(alarm::Code::CalibrationNotSaved);
    const auto path = m_store.pathOf(finished.record->endpoint, finished.record->server);
    m_messages.log(Severity::Note, Source::Control, [path = QString::fromStdString(path.string())] {
      return tr("Calibrated. Saved %1.").arg(path);
    });
  }
  Q_EMIT calibrationChanged();
}

void MachineModel::loadCalibration() {
  m_calibration.reset();
  m_isOutdated = false;
  auto found = m_store.calibration(m_endpoint.trimmed().toStdString(), m_link.server);
  if (!found) {
    m_messages.log(Severity::Warning, Source::Control,
                   [error = found.error()] { return widgets::errorText(error); });
  } else if (*found) {
    m_isOutdated = (*found)->isOutdated(m_link.server);
    m_calibration = std::make_shared<const streaming::CalibrationRecord>(std::move(**found));
    if (m_isOutdated) {
      m_messages.log(Severity::Warning, Source::Control, [] {
        return tr("The calibration belongs to another version of the server and is not used.");
      });
    }
  }
  Q_EMIT calibrationChanged();
}

}  // namespace rivulet::hmi
