// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the window tells the operator: one message at a time in the message area, and everything
/// that happened in the log. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QString>

#include "gcode/diagnostic.h"
#include "log/log.h"

namespace rivulet::hmi {

class Messages final : public QObject {
  Q_OBJECT

 public:
  using Severity = gcode::Severity;
  explicit Messages(QObject* parent = nullptr);

  /// In the log only: on the page and, by `log::logger`, in the file.
  void log(Severity severity, const QString& text);
  /// In the message area only: it answers what the operator has just done.
  void show(Severity severity, const QString& text) { Q_EMIT shown(severity, text); }
  /// In both.
  void report(Severity severity, const QString& text) {
    show(severity, text);
    log(severity, text);
  }
  /// Empties the message area.
  void clear() { Q_EMIT cleared(); }

 Q_SIGNALS:
  /// Also what others have logged, from level `info` on.
  void logged(rivulet::gcode::Severity severity, const QString& text);
  void shown(rivulet::gcode::Severity severity, const QString& text);
  void cleared();

 private:
  /// On any thread.
  void hear(const rivulet::log::Line& line);

  bool m_isLogging = false;
  rivulet::log::Listener m_listener;
};

}  // namespace rivulet::hmi
