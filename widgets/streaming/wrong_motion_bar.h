// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run has executed wrong points: says so, offers to stop it, and stays after the run until
/// somebody has acknowledged it. Hidden otherwise. @threadsafety GUI thread.
#pragma once

#include "widgets/common/notice_bar.h"

namespace rivulet::widgets {

class WrongMotionBar final : public NoticeBar {
  Q_OBJECT

 public:
  explicit WrongMotionBar(QWidget* parent = nullptr);

  /// @param sentence  what is wrong; empty: nothing  @param isRunning  the run is in progress
  void setWrong(const QString& sentence, bool isRunning);

 Q_SIGNALS:
  void stopRequested();
  void acknowledged();

 protected:
  void retranslate() override;

 private:
  QString m_sentence;
  bool m_isRunning = false;
  QPushButton* m_stop;
  QPushButton* m_acknowledge;
};

}  // namespace rivulet::widgets
