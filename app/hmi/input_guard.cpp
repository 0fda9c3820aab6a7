// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/input_guard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>

namespace rivulet::hmi {

namespace {

bool isSetting(const QObject* object) {
  return qobject_cast<const QAbstractSpinBox*>(object) != nullptr ||
         qobject_cast<const QComboBox*>(object) != nullptr ||
         qobject_cast<const QSlider*>(object) != nullptr ||
         qobject_cast<const QTabBar*>(object) != nullptr;
}

}  // namespace

InputGuard::InputGuard(std::function<void()> stop, std::function<void()> touched, QObject* parent)
    : QObject(parent), m_stop(std::move(stop)), m_touched(std::move(touched)) {
  qApp->installEventFilter(this);
}

InputGuard::~InputGuard() {
  qApp->removeEventFilter(this);
}

bool InputGuard::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
      m_touched();
      break;
    case QEvent::Wheel:
      m_touched();
      if (isSetting(watched)) {
        event->ignore();  // so that the area around it scrolls
        return true;
      }
      break;
    case QEvent::Polish:
      // Otherwise the wheel would at least move the focus.
      if (auto* widget = qobject_cast<QWidget*>(watched);
          isSetting(watched) && widget->focusPolicy() == Qt::WheelFocus) {
        widget->setFocusPolicy(Qt::StrongFocus);
      }
      break;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      m_touched();
      // Before any window, menu or dialog can take the key; they still get it.
      if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        m_stop();
      }
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace rivulet::hmi
