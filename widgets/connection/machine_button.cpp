// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/machine_button.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/common/icons.h"
#include "widgets/connection/connection_state.h"

namespace rivulet::widgets {

namespace {

constexpr int kIconPx = 20;

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
  return newestS && !machine.isSilentAsPlanned(*newestS) ? static_cast<int>(*newestS) : 0;
}

}  // namespace

MachineButton::MachineButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("machine"));
  setCheckable(true);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  show();
}

void MachineButton::setConnectionState(ConnectionState state,
                                       std::optional<opcua::Protection> protection,
                                       const QString& security) {
  m_state = state;
  m_protection = state == ConnectionState::Connected ? protection : std::nullopt;
  m_security = security;
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
  QString tip = tr("Connection and state of the machine");
  if (!m_protection) {
    setText(text);
    setIconSize(QSize(kIconPx, kIconPx));
    setIcon(icon(status, nullptr));
  } else {
    const ProtectionText protection = protectionText(*m_protection);
    setText(text + QLatin1Char('\n') + protection.word);
    setIconSize(QSize(kIconPx, 2 * kIconPx));
    setIcon(icon(status, &protection));
    tip += QStringLiteral("\n%1: %2").arg(m_security, protection.sentence);
  }
  setAccessibleName(text + (m_protection ? QStringLiteral(", ") + protectionText(*m_protection).word
                                         : QString()));
  setToolTip(tip);
}

QIcon MachineButton::icon(Status status, const ProtectionText* protection) const {
  const QColor color = statusColor(status, palette());
  if (protection == nullptr) {
    return themedIcon(statusIconName(status), color);
  }
  const qreal ratio = devicePixelRatioF();
  QPixmap both(QSize(kIconPx, 2 * kIconPx) * ratio);
  both.setDevicePixelRatio(ratio);
  both.fill(Qt::transparent);
  QPainter painter(&both);
  painter.drawPixmap(0, 0, iconPixmap(statusIconName(status), color, kIconPx, ratio));
  painter.drawPixmap(
      0, kIconPx,
      iconPixmap(protection->icon, statusColor(protection->status, palette()), kIconPx, ratio));
  return {both};
}

}  // namespace rivulet::widgets
