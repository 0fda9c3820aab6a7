// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What happens, said in one place: lines of the log, short answers to what the operator has just
/// done, and alarms that come and go. Texts are made again when the language changes.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "alarm/alarm.h"
#include "gcode/diagnostic.h"
#include "permission/permission.h"
#include "platform/log.h"
#include "widgets/common/log_view.h"

namespace rivulet::hmi {

/// Names and values of what somebody did.
using ActDetails = std::vector<std::pair<std::string, std::string>>;

class Messages final : public QObject {
  Q_OBJECT

 public:
  using Severity = gcode::Severity;
  explicit Messages(QObject* parent = nullptr);

  using Source = alarm::Source;
  /// A text in the present language. It keeps what it speaks of by value.
  using Text = std::function<QString()>;

  /// A line of the log: on the page and, by `log::logger`, in the file.
  void log(Severity severity, Source source, const Text& text);
  /// An answer to what the operator has just done; not in the log.
  void show(Severity severity, const Text& text) { Q_EMIT shown(severity, text); }
  /// Removes the answer.
  void clear() { Q_EMIT cleared(); }
  /// The condition of an alarm holds, or holds no more (`alarm::AlarmList`).
  void raise(alarm::Code code, const std::vector<std::string>& arguments = {},
             const base::Error& error = {}) {
    Q_EMIT raised(code, arguments, error);
  }
  void settle(alarm::Code code) { Q_EMIT settled(code); }
  /// The operator has done something: a line of the audit trail.
  void didAct(permission::Act act, const ActDetails& details = {}) { Q_EMIT did(act, details); }

 Q_SIGNALS:
  /// Also what others have logged, from level `info` on.
  void logged(const rivulet::widgets::LogLine& line);
  void shown(rivulet::gcode::Severity severity, const std::function<QString()>& text);
  void cleared();
  void raised(rivulet::alarm::Code code, const std::vector<std::string>& arguments,
              const rivulet::base::Error& error);
  void settled(rivulet::alarm::Code code);
  void did(rivulet::permission::Act act, const rivulet::hmi::ActDetails& details);

 private:
  /// On any thread.
  void hear(const rivulet::log::Line& line);

  bool m_isLogging = false;
  rivulet::log::Listener m_listener;
};

}  // namespace rivulet::hmi
