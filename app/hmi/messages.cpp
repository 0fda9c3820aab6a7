// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/messages.h"

#include <QMetaObject>
#include <QThread>

namespace rivulet::hmi {

namespace {

using gcode::Severity;

spdlog::level::level_enum levelOf(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return spdlog::level::err;
    case Severity::Warning:
      return spdlog::level::warn;
    case Severity::Note:
      break;
  }
  return spdlog::level::info;
}

Severity severityOf(spdlog::level::level_enum level) {
  return level >= spdlog::level::err    ? Severity::Error
         : level == spdlog::level::warn ? Severity::Warning
                                        : Severity::Note;
}

}  // namespace

Messages::Messages(QObject* parent)
    : QObject(parent), m_listener([this](const log::Line& line) { hear(line); }) {
}

void Messages::log(Severity severity, Source source, const Text& text) {
  Q_EMIT logged({QDateTime::currentDateTime(), severity, source, text});
  m_isLogging = true;
  log::logger().log(levelOf(severity), text().toStdString());
  m_isLogging = false;
}

void Messages::hear(const log::Line& line) {
  if (QThread::currentThread() == thread() && m_isLogging) {
    return;  // `log` has said it already
  }
  // Not at once: the log is locked, and what is drawn may log.
  QMetaObject::invokeMethod(
      this,
      [this, severity = severityOf(line.level), text = QString::fromStdString(line.text)] {
        Q_EMIT logged(
            {QDateTime::currentDateTime(), severity, Source::Computer, [text] { return text; }});
      },
      Qt::QueuedConnection);
}

}  // namespace rivulet::hmi
