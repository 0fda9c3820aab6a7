// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/close_bar.h"

#include <QPushButton>

namespace rivulet::widgets {

CloseBar::CloseBar(QWidget* parent)
    : NoticeBar(parent),
      m_keep(addButton(
          {.text = QT_TR_NOOP("Keep the window open"), .icon = "apply", .id = "keep-open"})),
      m_close(addButton(
          {.text = QT_TR_NOOP("Stop and close"), .icon = "stop", .id = "stop-and-close"})) {
  m_keep->setAutoDefault(true);
  connect(m_keep, &QPushButton::clicked, this, &CloseBar::hide);
  connect(m_close, &QPushButton::clicked, this, [this] {
    m_close->setEnabled(false);
    Q_EMIT stopAndCloseRequested();
  });
  retranslate();
  restyle();
}

void CloseBar::ask() {
  m_close->setEnabled(true);
  show();
  m_keep->setFocus();
}

void CloseBar::retranslate() {
  setNotice(Status::Attention,
            tr("A run is in progress. To close the window, its axes are held first, where they "
               "are; the run can be resumed from there."));
}

}  // namespace rivulet::widgets
