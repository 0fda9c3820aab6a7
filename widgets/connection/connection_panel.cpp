// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/connection_panel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "opcua/node_map.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_state.h"
#include "widgets/connection/described_machine_box.h"

namespace rivulet::widgets {

ConnectionPanel::ConnectionPanel(QWidget* parent)
    : Page(parent),
      m_control(new ControlFields(this)),
      m_login(new LoginFields(this)),
      m_described(new DescribedMachineBox(this)) {
  buildConnection();
  buildMachine();

  inColumn({m_connectionGroup, m_machineGroup, m_described, spring()}, this);

  const auto request = [this] {
    if (m_state == ConnectionState::Connected || m_state == ConnectionState::Connecting) {
      Q_EMIT disconnectRequested();
    } else {
      requestConnection();
    }
  };
  connect(m_connect, &QPushButton::clicked, this, request);
  const auto submit = [this] {
    if (m_endpoint->isEnabled() && !endpoint().isEmpty()) {
      requestConnection();
    }
  };
  connect(m_endpoint, &QLineEdit::returnPressed, this, submit);
  connect(m_login, &LoginFields::submitted, this, submit);
  connect(m_control, &ControlFields::submitted, this, submit);
  connect(m_endpoint, &QLineEdit::textChanged, this, [this] { showConnection(); });
  onLanguage(&ConnectionPanel::showConnection, &ConnectionPanel::showProtection,
             &ConnectionPanel::showMachine);
  restyle();
}

void ConnectionPanel::requestConnection() {
  if (m_control->askForMap()) {
    Q_EMIT connectRequested(endpoint(), m_login->take(), m_control->choice());
  }
}

void ConnectionPanel::buildConnection() {
  m_endpoint->setText(QString::fromUtf8(opcua::kLocalEndpoint));
  m_connectionStatus->setEmphasis(11.0, true);
  auto* connection = new QGridLayout(m_connectionGroup);
  connection->addWidget(label({.text = QT_TR_NOOP("OPC UA endpoint"), .isMuted = true}, m_endpoint),
                        0, 0, 1, 2);
  connection->addWidget(m_endpoint, 1, 0);
  connection->addWidget(m_connect, 1, 1);
  connection->addWidget(m_connectionStatus, 2, 0, 1, 2);
  connection->addWidget(m_protection, 3, 0, 1, 2);
  connection->addWidget(m_virtualBadge, 4, 0, 1, 2);
  connection->addWidget(m_control, 5, 0, 1, 2);
  connection->addWidget(m_login, 6, 0, 1, 2);
  connection->setColumnStretch(0, 1);
}

void ConnectionPanel::buildMachine() {
  auto* machine = new Form(this, m_machineGroup);
  machine->setRowWrapPolicy(QFormLayout::DontWrapRows);
  machine->row({.text = QT_TR_NOOP("Channel"), .isMuted = true}, m_channel);
  machine->row({.text = QT_TR_NOOP("Program"), .isMuted = true}, m_programStatus);
  machine->row({.text = QT_TR_NOOP("Selected"), .isMuted = true}, m_programName);
  machine->row({.text = QT_TR_NOOP("Alarm"), .isMuted = true}, m_alarm);
  machine->row({.text = QT_TR_NOOP("Message"), .isMuted = true}, m_message);
}

void ConnectionPanel::setEndpoint(const QString& endpoint) {
  m_endpoint->setText(endpoint);
}

QString ConnectionPanel::endpoint() const {
  return m_endpoint->text().trimmed();
}

void ConnectionPanel::setConnectionState(ConnectionState state, const QString& detail) {
  m_state = state;
  m_detail = detail;
  restyle();
  showConnection();
  showMachine();
}

void ConnectionPanel::setProtection(std::optional<opcua::Protection> protection,
                                    const std::optional<opcua::ChannelSecurity>& security) {
  m_protectionKind = protection;
  m_security = security;
  showProtection();
}

void ConnectionPanel::setMachineState(const MachineView& machine) {
  m_machine = machine;
  showMachine();
}

void ConnectionPanel::setDisconnectEnabled(bool enabled) {
  m_disconnectEnabled = enabled;
  showConnection();
}

void ConnectionPanel::restyle() {
  const bool connects =
      m_state == ConnectionState::Disconnected || m_state == ConnectionState::Lost;
  m_connect->setIcon(themedIcon(connects ? QStringLiteral("link") : QStringLiteral("unlink"),
                                themeColors(palette()).text));
}

void ConnectionPanel::showConnection() {
  QString text = connectionText(m_state);
  if (!m_detail.isEmpty()) {
    text += QStringLiteral(": ") + m_detail;
  }
  m_connectionStatus->setStatus(connectionStatus(m_state), text);
  const bool connects =
      m_state == ConnectionState::Disconnected || m_state == ConnectionState::Lost;
  m_connect->setText(connects ? tr("Connect") : tr("Disconnect"));
  m_connect->setEnabled(connects ? !endpoint().isEmpty() : m_disconnectEnabled);
  m_endpoint->setEnabled(connects);
  m_control->setEnabled(connects);
  m_login->setEnabled(connects);
}

void ConnectionPanel::showProtection() {
  m_protection->setVisible(m_protectionKind.has_value() && m_security.has_value());
  if (m_protectionKind && m_security) {
    const ProtectionText text = protectionText(*m_protectionKind);
    m_protection->setStatus(
        text.status, QStringLiteral("%1: %2").arg(
                         QString::fromStdString(opcua::securityText(*m_security)), text.sentence));
  }
}

void ConnectionPanel::showMachine() {
  const bool connected = m_state == ConnectionState::Connected;
  m_virtualBadge->setVisible(connected && m_machine.isVirtualMachine);
  m_virtualBadge->setStatus(Status::Simulated, tr("Virtual machine: no real axis moves"));

  m_described->setMachineState(m_machine, connected);
  showChannel();
  const ProgramStatusText program = programStatusText(m_machine.programStatus);
  m_programStatus->setStatus(program.status, program.text);

  const auto text = [](const std::optional<QString>& value) {
    return value && !value->isEmpty() ? *value : noValue();
  };
  m_programName->setText(text(m_machine.programName));
  m_message->setText(text(m_machine.message));

  if (!m_machine.alarmNumber) {
    m_alarm->setStatus(Status::Unknown, noValue());
  } else if (*m_machine.alarmNumber == 0) {
    m_alarm->setStatus(Status::Good, tr("None"));
  } else {
    const QString number = QString::number(*m_machine.alarmNumber);
    m_alarm->setStatus(Status::Fault,
                       m_machine.alarmText.isEmpty()
                           ? number
                           : QStringLiteral("%1: %2").arg(number, m_machine.alarmText));
  }
  const bool isOld = !isFresh(m_machine.stateAgeS);
  for (StatusLabel* label : {m_channel, m_programStatus, m_alarm}) {
    label->setOutdated(isOld && label->text() != noValue());
  }
}

void ConnectionPanel::showChannel() {
  Status channelStatus = Status::Unknown;
  QString channel = noValue();
  if (m_machine.channelStatus) {
    switch (*m_machine.channelStatus) {
      case 0:
        channelStatus = Status::Good;
        channel = tr("Reset");
        break;
      case 1:
        channelStatus = Status::Busy;
        channel = tr("Active");
        break;
      case 2:
        channelStatus = Status::Attention;
        channel = tr("Interrupted");
        break;
      default:
        channel = tr("Unknown (%1)").arg(*m_machine.channelStatus);
    }
  }
  m_channel->setStatus(channelStatus, channel);
}

}  // namespace rivulet::widgets
