// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/wrong_motion_bar.h"

#include <QPushButton>

namespace rivulet::widgets {

WrongMotionBar::WrongMotionBar(QWidget* parent)
    : NoticeBar(parent),
      m_stop(addButton({.text = QT_TR_NOOP("Stop the run"), .icon = "stop", .id = "wrong-stop"})),
      m_acknowledge(addButton(
          {.text = QT_TR_NOOP("Acknowledge"), .icon = "apply", .id = "wrong-acknowledge"})) {
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
  m_stop->setVisible(m_isRunning);
  m_acknowledge->setVisible(!m_isRunning);
  setNotice(Status::Fault, m_sentence);
}

}  // namespace rivulet::widgets
