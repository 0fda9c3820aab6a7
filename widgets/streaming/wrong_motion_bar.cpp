// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/wrong_motion_bar.h"

#include <QPushButton>

namespace rivulet::widgets {

WrongMotionBar::WrongMotionBar(QWidget* parent)
    : NoticeBar(parent),
      m_stop(addButton(QStringLiteral("wrong-stop"), QStringLiteral("stop"))),
      m_acknowledge(addButton(QStringLiteral("wrong-acknowledge"), QStringLiteral("apply"))) {
  connect(m_stop, &QPushButton::clicked, this, &WrongMotionBar::stopRequested);
  connect(m_acknowledge, &QPushButton::clicked, this, &WrongMotionBar::acknowledged);
  retranslate();
  restyle();
}

void WrongMotionBar::setWrong(const QString& sentence, bool isRunning) {
  m_sentence = sentence;
  m_isRunning = isRunning;
  setVisible(!sentence.isEmpty());
  retranslate();
}

void WrongMotionBar::retranslate() {
  m_stop->setText(tr("Stop the run"));
  m_stop->setVisible(m_isRunning);
  m_acknowledge->setText(tr("Acknowledge"));
  m_acknowledge->setVisible(!m_isRunning);
  setNotice(Status::Fault, m_sentence);
}

}  // namespace rivulet::widgets
