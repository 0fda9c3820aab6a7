// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/close_bar.h"

#include <QPushButton>

namespace rivulet::widgets {

CloseBar::CloseBar(QWidget* parent)
    : NoticeBar(parent),
      m_keep(addButton(QStringLiteral("keep-open"), QStringLiteral("apply"))),
      m_close(addButton(QStringLiteral("stop-and-close"), QStringLiteral("stop"))) {
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
  m_keep->setText(tr("Keep the window open"));
  m_close->setText(tr("Stop and close"));
  setNotice(Status::Attention,
            tr("A run is in progress. To close the window, the run is stopped first; it can be "
               "resumed later."));
}

}  // namespace rivulet::widgets
