// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/connection_panel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

/// The large figures of the position display.
QFont readoutFont(const QFont& base, qreal pointSize) {
  QFont font = base;
  font.setPointSizeF(pointSize);
  font.setBold(true);
  return font;
}

}  // namespace

ConnectionPanel::ConnectionPanel(QWidget* parent)
    : Page(parent),
      m_connectionGroup(new QGroupBox(this)),
      m_endpointLabel(new QLabel(this)),
      m_endpoint(new QLineEdit(this)),
      m_connect(makeTouchButton(this)),
      m_connectionStatus(new StatusLabel(this)),
      m_virtualBadge(new StatusLabel(this)),
      m_positionGroup(new QGroupBox(this)),
      m_feedName(new QLabel(this)),
      m_feedValue(makeValueLabel(this)),
      m_feedUnit(new QLabel(this)),
      m_freshness(new StatusLabel(this)),
      m_machineGroup(new QGroupBox(this)),
      m_channelLabel(new QLabel(this)),
      m_channel(new StatusLabel(this)),
      m_programStatusLabel(new QLabel(this)),
      m_programStatus(new StatusLabel(this)),
      m_programNameLabel(new QLabel(this)),
      m_programName(makeValueLabel(this)),
      m_alarmLabel(new QLabel(this)),
      m_alarm(new StatusLabel(this)),
      m_messageLabel(new QLabel(this)),
      m_message(makeValueLabel(this)) {
  buildConnection();
  buildReadouts();
  buildMachine();

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_connectionGroup);
  layout->addWidget(m_positionGroup);
  layout->addWidget(m_machineGroup);
  layout->addStretch();
  setMinimumWidth(330);

  const auto request = [this] {
    if (m_state == ConnectionState::Connected || m_state == ConnectionState::Connecting) {
      Q_EMIT disconnectRequested();
    } else {
      Q_EMIT connectRequested(endpoint());
    }
  };
  connect(m_connect, &QPushButton::clicked, this, request);
  connect(m_endpoint, &QLineEdit::returnPressed, this, [this] {
    if (m_endpoint->isEnabled() && !endpoint().isEmpty()) {
      Q_EMIT connectRequested(endpoint());
    }
  });
  connect(m_endpoint, &QLineEdit::textChanged, this, [this] { showConnection(); });
  retranslate();
  restyle();
}

void ConnectionPanel::buildConnection() {
  m_endpoint->setMinimumHeight(36);
  m_endpoint->setText(QStringLiteral("opc.tcp://127.0.0.1:4840"));
  m_endpointLabel->setBuddy(m_endpoint);
  m_connectionStatus->setEmphasis(11.0, true);
  m_connectionStatus->setWordWrap(true);
  m_virtualBadge->setWordWrap(true);
  auto* connection = new QGridLayout(m_connectionGroup);
  connection->addWidget(m_endpointLabel, 0, 0, 1, 2);
  connection->addWidget(m_endpoint, 1, 0);
  connection->addWidget(m_connect, 1, 1);
  connection->addWidget(m_connectionStatus, 2, 0, 1, 2);
  connection->addWidget(m_virtualBadge, 3, 0, 1, 2);
  connection->setColumnStretch(0, 1);
}

void ConnectionPanel::buildReadouts() {
  auto* position = new QGridLayout(m_positionGroup);
  position->setHorizontalSpacing(10);
  position->setVerticalSpacing(2);
  position->setColumnStretch(1, 1);
  int row = 0;
  for (std::size_t axis = 0; axis < kReadoutCount; ++axis, ++row) {
    const bool isRotary = axis >= base::kAxisCount;
    const char name =
        isRotary ? base::kRotaryAxisNames[axis - base::kAxisCount] : base::kAxisNames[axis];
    m_axisNames[axis] = new QLabel(QString(QLatin1Char(name)), this);
    m_axisNames[axis]->setFont(readoutFont(font(), 18.0));
    m_axisValues[axis] = makeValueLabel(this);
    m_axisValues[axis]->setFont(readoutFont(font(), 22.0));
    m_axisValues[axis]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_axisUnits[axis] = new QLabel(isRotary ? QStringLiteral("°") : QStringLiteral("mm"), this);
    position->addWidget(m_axisNames[axis], row, 0);
    position->addWidget(m_axisValues[axis], row, 1);
    position->addWidget(m_axisUnits[axis], row, 2);
  }
  m_feedName->setFont(readoutFont(font(), 11.0));
  m_feedValue->setFont(readoutFont(font(), 16.0));
  m_feedValue->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_feedUnit->setText(QStringLiteral("mm/min"));
  position->addWidget(m_feedName, row, 0);
  position->addWidget(m_feedValue, row, 1);
  position->addWidget(m_feedUnit, row, 2);
  position->addWidget(m_freshness, row + 1, 0, 1, 3);
}

void ConnectionPanel::buildMachine() {
  m_programName->setWordWrap(true);
  m_message->setWordWrap(true);
  m_alarm->setWordWrap(true);
  auto* machine = new QFormLayout(m_machineGroup);
  machine->setLabelAlignment(Qt::AlignLeft);
  machine->setHorizontalSpacing(16);
  machine->addRow(m_channelLabel, m_channel);
  machine->addRow(m_programStatusLabel, m_programStatus);
  machine->addRow(m_programNameLabel, m_programName);
  machine->addRow(m_alarmLabel, m_alarm);
  machine->addRow(m_messageLabel, m_message);
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

void ConnectionPanel::setMachineState(const MachineView& machine) {
  m_machine = machine;
  showMachine();
}

void ConnectionPanel::setDisconnectEnabled(bool enabled) {
  m_disconnectEnabled = enabled;
  showConnection();
}

void ConnectionPanel::retranslate() {
  m_connectionGroup->setTitle(tr("Connection"));
  m_endpointLabel->setText(tr("OPC UA endpoint"));
  m_positionGroup->setTitle(tr("Actual position"));
  m_feedName->setText(tr("Feed"));
  m_machineGroup->setTitle(tr("Machine"));
  m_channelLabel->setText(tr("Channel"));
  m_programStatusLabel->setText(tr("Program"));
  m_programNameLabel->setText(tr("Selected"));
  m_alarmLabel->setText(tr("Alarm"));
  m_messageLabel->setText(tr("Message"));
  showConnection();
  showMachine();
}

void ConnectionPanel::restyle() {
  const bool connects =
      m_state == ConnectionState::Disconnected || m_state == ConnectionState::Lost;
  m_connect->setIcon(themedIcon(connects ? QStringLiteral("link") : QStringLiteral("unlink"),
                                themeColors(palette()).text));
  for (QLabel* label : {m_channelLabel, m_programStatusLabel, m_programNameLabel, m_alarmLabel,
                        m_messageLabel, m_endpointLabel, m_feedUnit}) {
    setMuted(label, palette());
  }
  for (QLabel* unit : m_axisUnits) {
    setMuted(unit, palette());
  }
}

void ConnectionPanel::showConnection() {
  Status status = Status::Unknown;
  QString text;
  switch (m_state) {
    case ConnectionState::Disconnected:
      text = tr("Disconnected");
      break;
    case ConnectionState::Connecting:
      status = Status::Busy;
      text = tr("Connecting …");
      break;
    case ConnectionState::Connected:
      status = Status::Good;
      text = tr("Connected");
      break;
    case ConnectionState::Lost:
      status = Status::Fault;
      text = tr("Connection lost");
      break;
  }
  if (!m_detail.isEmpty()) {
    text += QStringLiteral(": ") + m_detail;
  }
  m_connectionStatus->setStatus(status, text);
  const bool connects =
      m_state == ConnectionState::Disconnected || m_state == ConnectionState::Lost;
  m_connect->setText(connects ? tr("Connect") : tr("Disconnect"));
  m_connect->setEnabled(connects ? !endpoint().isEmpty() : m_disconnectEnabled);
  m_endpoint->setEnabled(connects);
}

void ConnectionPanel::showMachine() {
  const bool connected = m_state == ConnectionState::Connected;
  m_virtualBadge->setVisible(connected && m_machine.isVirtualMachine);
  m_virtualBadge->setStatus(Status::Simulated, tr("Virtual machine: no real axis moves"));

  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_axisValues[axis]->setText(numberText(m_machine.positionMm
                                               ? (*m_machine.positionMm)[axis]
                                               : std::numeric_limits<double>::quiet_NaN(),
                                           3));
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const std::size_t readout = base::kAxisCount + axis;
    m_axisValues[readout]->setText(numberText(m_machine.rotaryDeg
                                                  ? (*m_machine.rotaryDeg)[axis]
                                                  : std::numeric_limits<double>::quiet_NaN(),
                                              3));
    for (QLabel* label : {m_axisNames[readout], m_axisValues[readout], m_axisUnits[readout]}) {
      label->setVisible(m_machine.rotaryAxes[axis]);
    }
  }
  m_feedValue->setText(m_machine.feedMmPerS
                           ? numberText(base::mmPerMinFromMmPerS(*m_machine.feedMmPerS), 0)
                           : noValue());

  showFreshness(connected);
  showChannel();
  showProgramStatus();

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
}

void ConnectionPanel::showFreshness(bool connected) {
  const bool hasValues = m_machine.positionMm || m_machine.feedMmPerS;
  if (!connected) {
    m_freshness->setStatus(hasValues ? Status::Attention : Status::Unknown,
                           hasValues ? tr("Old values: not connected") : tr("No data"));
  } else if (m_machine.isStale) {
    m_freshness->setStatus(
        Status::Attention,
        m_machine.ageS ? tr("Stale: %1 old").arg(secondsText(*m_machine.ageS)) : tr("Stale"));
  } else {
    m_freshness->setStatus(hasValues ? Status::Good : Status::Unknown,
                           hasValues ? tr("Live") : tr("No data"));
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

void ConnectionPanel::showProgramStatus() {
  Status programStatus = Status::Unknown;
  QString program = noValue();
  if (m_machine.programStatus) {
    switch (*m_machine.programStatus) {
      case 1:
        programStatus = Status::Attention;
        program = tr("Interrupted");
        break;
      case 2:
        programStatus = Status::Good;
        program = tr("Stopped");
        break;
      case 3:
        programStatus = Status::Busy;
        program = tr("Running");
        break;
      case 4:
        programStatus = Status::Busy;
        program = tr("Waiting");
        break;
      case 5:
        programStatus = Status::Good;
        program = tr("Ended");
        break;
      default:
        program = tr("Unknown (%1)").arg(*m_machine.programStatus);
    }
  }
  m_programStatus->setStatus(programStatus, program);
}

}  // namespace rivulet::widgets
