// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the window tells the operator: one message at a time in the message area, and everything
/// that happened in the log. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QString>

#include "gcode/diagnostic.h"

namespace rivulet::hmi {

class Messages final : public QObject {
  Q_OBJECT

 public:
  using Severity = gcode::Severity;
  using QObject::QObject;

  /// In the log only.
  void log(Severity severity, const QString& text) { Q_EMIT logged(severity, text); }
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
  void logged(rivulet::gcode::Severity severity, const QString& text);
  void shown(rivulet::gcode::Severity severity, const QString& text);
  void cleared();
};

}  // namespace rivulet::hmi
