// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/machine_button.h"

#include <QEvent>
#include <algorithm>

#include "widgets/common/icons.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_state.h"

namespace rivulet::widgets {

namespace {

/// The newest of what was read, whole seconds. Never anything: 0, there is nothing to be old.
int silenceS(const MachineView& machine) {
  std::optional<double> newestS;
  for (const auto& ageS : {machine.positionAgeS, machine.feedAgeS, machine.stateAgeS}) {
    if (ageS) {
      newestS = std::min(newestS.value_or(*ageS), *ageS);
    }
  }
  if (machine.executed && newestS) {
    newestS = std::min(*newestS, machine.executed->ageS);
  }
  return static_cast<int>(newestS.value_or(0.0));
}

}  // namespace

MachineButton::MachineButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("machine"));
  setCheckable(true);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setIconSize(QSize(20, 20));
  show();
}

void MachineButton::setConnectionState(ConnectionState state) {
  m_state = state;
  show();
}

void MachineButton::setMachineState(const MachineView& machine) {
  const int silentS = silenceS(machine);
  if (silentS != m_silentS || machine.isVirtualMachine != m_isVirtual) {
    m_silentS = silentS;
    m_isVirtual = machine.isVirtualMachine;
    show();
  }
}

void MachineButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
    show();
  }
  QToolButton::changeEvent(event);
}

void MachineButton::show() {
  Status status = connectionStatus(m_state);
  QString text = connectionText(m_state);
  if (m_state == ConnectionState::Connected) {
    if (m_isVirtual) {
      status = Status::Simulated;
      text = tr("Virtual machine");
    }
    if (m_silentS >= 1) {
      status = Status::Attention;
      text = tr("%1, silent for %2 s").arg(text).arg(m_silentS);
    }
  }
  setText(text);
  setIcon(themedIcon(statusIconName(status), statusColor(status, palette())));
  setToolTip(tr("Connection and state of the machine"));
}

}  // namespace rivulet::widgets
