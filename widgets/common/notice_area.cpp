// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/notice_area.h"

#include <QEvent>
#include <QVBoxLayout>

namespace rivulet::widgets {

NoticeArea::NoticeArea(QWidget* parent) : QScrollArea(parent) {
  auto* content = new QWidget;
  m_rows = new QVBoxLayout(content);
  m_rows->setContentsMargins(0, 0, 0, 0);
  m_rows->setSpacing(0);
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);
}

void NoticeArea::add(QWidget* notice) {
  m_rows->addWidget(notice);
}

QSize NoticeArea::sizeHint() const {
  return {0, widget()->minimumHeight()};
}

bool NoticeArea::eventFilter(QObject* object, QEvent* event) {
  const bool result = QScrollArea::eventFilter(object, event);
  if (object == widget() &&
      (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)) {
    const int height = m_rows->hasHeightForWidth() ? m_rows->heightForWidth(widget()->width())
                                                   : m_rows->sizeHint().height();
    if (height != widget()->minimumHeight()) {
      widget()->setMinimumHeight(height);  // a squeezed layout would cut the text without a word
      updateGeometry();
    }
  }
  return result;
}

}  // namespace rivulet::widgets
