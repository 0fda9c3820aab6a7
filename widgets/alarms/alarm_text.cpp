// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/alarms/alarm_text.h"

#include <QCoreApplication>
#include <QDateTime>

#include "widgets/common/error_text.h"

namespace rivulet::widgets {

namespace {

struct AlarmTexts {
  Q_DECLARE_TR_FUNCTIONS(AlarmTexts)

 public:
  static QString filled(const char* pattern, const alarm::Alarm& alarm) {
    QString text = QCoreApplication::translate("AlarmTexts", pattern);
    for (std::size_t i = 0; i < alarm.arguments.size(); ++i) {
      text.replace(QStringLiteral("%%1").arg(i + 1), QString::fromStdString(alarm.arguments[i]));
    }
    return text;
  }

  static QString source(alarm::Source source) {
    switch (source) {
      case alarm::Source::Control:
        return tr("Control");
      case alarm::Source::Connection:
        return tr("Connection");
      case alarm::Source::Run:
        return tr("Run");
      case alarm::Source::Program:
        return tr("Program");
      case alarm::Source::Computer:
        return tr("Computer");
    }
    return {};
  }

  static QString state(alarm::State state) {
    switch (state) {
      case alarm::State::Normal:
        return tr("Normal");
      case alarm::State::Unacknowledged:
        return tr("Active");
      case alarm::State::Acknowledged:
        return tr("Active, acknowledged");
      case alarm::State::ReturnedUnacknowledged:
        return tr("Gone, not acknowledged");
      case alarm::State::Shelved:
        return tr("Shelved");
    }
    return {};
  }

  static QString event(alarm::Event event) {
    switch (event) {
      case alarm::Event::Raised:
        return tr("Came");
      case alarm::Event::Returned:
        return tr("Gone");
      case alarm::Event::Acknowledged:
        return tr("Acknowledged");
      case alarm::Event::Shelved:
        return tr("Shelved");
      case alarm::Event::Unshelved:
        return tr("Taken back");
      case alarm::Event::ShelvingExpired:
        return tr("Shelving expired");
    }
    return {};
  }
};

}  // namespace

QString alarmText(const alarm::Alarm& alarm) {
  return AlarmTexts::filled(alarm::factsOf(alarm.code).text, alarm);
}

QString alarmCause(const alarm::Alarm& alarm) {
  const char* cause = alarm::factsOf(alarm.code).cause;
  return *cause == '\0' ? errorText(alarm.error) : AlarmTexts::filled(cause, alarm);
}

QString alarmRemedy(const alarm::Alarm& alarm) {
  const char* remedy = alarm::factsOf(alarm.code).remedy;
  return *remedy == '\0' ? errorText(alarm.error) : AlarmTexts::filled(remedy, alarm);
}

QString sourceText(alarm::Source source) {
  return AlarmTexts::source(source);
}

QString stateText(alarm::State state) {
  return AlarmTexts::state(state);
}

QString eventText(alarm::Event event) {
  return AlarmTexts::event(event);
}

gcode::Severity severityOf(alarm::Priority priority) {
  switch (priority) {
    case alarm::Priority::High:
      return gcode::Severity::Error;
    case alarm::Priority::Medium:
      return gcode::Severity::Warning;
    case alarm::Priority::Low:
      break;
  }
  return gcode::Severity::Note;
}

QString dateTimeText(base::UtcMs at) {
  return QDateTime::fromMSecsSinceEpoch(at).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

}  // namespace rivulet::widgets
