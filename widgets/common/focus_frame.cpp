// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/focus_frame.h"

#include <QApplication>
#include <QFocusEvent>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

class Frame final : public QWidget {
 public:
  explicit Frame(QWidget* target) : QWidget(target) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    const qreal inset = FocusFrame::kWidthPx / 2.0;
    painter.setPen(QPen(themeColors(palette()).accent, FocusFrame::kWidthPx, Qt::SolidLine,
                        Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset));
  }
};

bool showsFor(const QWidget& widget, Qt::FocusReason reason) {
  switch (reason) {
    case Qt::TabFocusReason:
    case Qt::BacktabFocusReason:
    case Qt::ShortcutFocusReason:
      return true;
    default:
      return widget.testAttribute(Qt::WA_InputMethodEnabled);
  }
}

}  // namespace

FocusFrame::FocusFrame(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

FocusFrame::~FocusFrame() {
  hide();
}

const QWidget* FocusFrame::target() const {
  return m_frame ? m_frame->parentWidget() : nullptr;
}

bool FocusFrame::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::FocusIn: {
      auto* widget = qobject_cast<QWidget*>(watched);
      if (widget == nullptr || widget->isWindow() || qobject_cast<QMenuBar*>(widget) != nullptr) {
        break;
      }
      const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
      if (reason == Qt::ActiveWindowFocusReason || reason == Qt::PopupFocusReason) {
        break;  // the focus was here before
      }
      if (showsFor(*widget, reason)) {
        surround(widget);
      } else {
        hide();
      }
      break;
    }
    case QEvent::FocusOut: {
      const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
      if (watched == target() && reason != Qt::ActiveWindowFocusReason &&
          reason != Qt::PopupFocusReason) {
        hide();
      }
      break;
    }
    case QEvent::Resize:
      if (m_frame && watched == m_frame->parent()) {
        m_frame->setGeometry(m_frame->parentWidget()->rect());
      }
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void FocusFrame::surround(QWidget* target) {
  hide();
  m_frame = new Frame(target);
  m_frame->setGeometry(target->rect());
  m_frame->raise();
  m_frame->show();
}

void FocusFrame::hide() {
  if (m_frame) {
    m_frame->hide();
    m_frame->deleteLater();
    m_frame.clear();
  }
}

}  // namespace rivulet::widgets
