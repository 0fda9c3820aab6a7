// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The main job without an operator: waits until Start is possible, presses it, and leaves a
/// picture of every page and the run's report in a folder. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "hmi/main_window.h"

namespace rivulet::hmi {

class Demo final : public QObject {
  Q_OBJECT

 public:
  /// @param folder  made if it is missing
  Demo(MainWindow& window, QString folder);

 private:
  void tryStart();
  void takeLivePicture();
  void finish(const std::shared_ptr<const streaming::RunReport>& report);
  void leave(const std::shared_ptr<const streaming::RunReport>& report);
  void fail(const QString& sentence);
  bool savePicture(const QString& name);

  MainWindow& m_window;
  QString m_folder;
  QTimer m_timer;
  int m_attempts = 0;
  bool m_started = false;
};

}  // namespace rivulet::hmi
