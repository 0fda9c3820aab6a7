// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/hold_button.h"

#include <QPainter>
#include <algorithm>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kRepaintMs = 30;
constexpr int kBarHeightPx = 6;

}  // namespace

HoldButton::HoldButton(QWidget* parent) : QPushButton(parent) {
  setMinimumHeight(kTouchHeightPx);
  setIconSize(QSize(20, 20));
  m_timer.setInterval(kRepaintMs);
  connect(&m_timer, &QTimer::timeout, this, &HoldButton::advance);
  // The base class also reports a finger that slides off, a lost focus and a disabled button as
  // released.
  connect(this, &QPushButton::pressed, this, &HoldButton::begin);
  connect(this, &QPushButton::released, this, &HoldButton::cancel);
}

void HoldButton::setNeedsHold(bool needsHold) {
  if (needsHold != m_needsHold) {
    m_needsHold = needsHold;
    cancel();  // a press that began under the other meaning does not count
  }
}

void HoldButton::begin() {
  if (m_needsHold) {
    m_since.start();
    m_timer.start();
    update();
  }
}

void HoldButton::cancel() {
  m_timer.stop();
  update();
}

void HoldButton::advance() {
  update();
  if (m_since.elapsed() >= kHoldMs) {
    cancel();
    Q_EMIT held();
  }
}

void HoldButton::hideEvent(QHideEvent* event) {
  cancel();
  QPushButton::hideEvent(event);
}

void HoldButton::paintEvent(QPaintEvent* event) {
  QPushButton::paintEvent(event);
  if (!m_timer.isActive()) {
    return;
  }
  const double share = std::min(1.0, static_cast<double>(m_since.elapsed()) / kHoldMs);
  QPainter painter(this);
  const QRect bar(4, height() - kBarHeightPx - 3, static_cast<int>((width() - 8) * share),
                  kBarHeightPx);
  painter.fillRect(bar, palette().color(QPalette::ButtonText));
}

}  // namespace rivulet::widgets
