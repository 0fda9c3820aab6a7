// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/alarms.h"

#include <QMetaObject>
#include <algorithm>
#include <utility>

#include "report/run_store.h"
#include "widgets/alarms/alarm_text.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using alarm::Transition;

namespace {

constexpr int kAdvanceMs = 1000;
constexpr base::UtcMs kMsPerMinute = 60'000;

}  // namespace

Alarms::Alarms(Messages& messages, const std::filesystem::path& folder, Clock clock)
    : m_messages(messages),
      m_clock(std::move(clock)),
      m_user(report::thisUser().user),
      m_file(folder) {
  connect(&m_messages, &Messages::raised, this, &Alarms::raise);
  connect(&m_messages, &Messages::settled, this, [this](alarm::Code code) {
    m_list.settle(code, m_clock());
    keep();
  });
  m_timer.setInterval(kAdvanceMs);
  connect(&m_timer, &QTimer::timeout, this, &Alarms::advance);
  m_timer.start();
  if (m_file.isKept()) {
    m_writer = std::make_unique<journal::Writer>();
    restore();
  }
}

void Alarms::restore() {
  auto read = m_file.read(&widgets::errorCodeOf);
  if (!read) {
    m_messages.log(gcode::Severity::Warning, Messages::Source::Computer,
                   [error = read.error()] { return widgets::errorText(error); });
    return;
  }
  if (read->dropped > 0) {
    m_messages.log(gcode::Severity::Warning, Messages::Source::Computer,
                   [lines = read->dropped, path = m_file.path().string()] {
                     return tr("%1: %2 damaged lines of the history of alarms were left out.")
                         .arg(QString::fromStdString(path))
                         .arg(lines);
                   });
  }
  for (alarm::Alarm& open : journal::unacknowledged(read->transitions)) {
    m_list.restore(std::move(open));
  }
  std::reverse(read->transitions.begin(), read->transitions.end());
  m_history = std::move(read->transitions);
  m_history.resize(std::min(m_history.size(), kHistoryMax));
}

void Alarms::raise(alarm::Code code, const std::vector<std::string>& arguments,
                   const base::Error& error) {
  m_list.raise(code, arguments, m_clock(), error);
  if (code == alarm::Code::ControlAlarm) {
    // The control shows one alarm at a time: another number takes the place of the last one.
    m_list.settleOthers(code, arguments.empty() ? std::string() : arguments.front(), m_clock());
  }
  keep();
}

void Alarms::advance() {
  m_list.advance(m_clock());
  keep();
}

void Alarms::acknowledge(int number) {
  m_list.acknowledge(number, m_user, m_clock());
  keep();
}

void Alarms::acknowledgeAll() {
  m_list.acknowledgeAll(m_user, m_clock());
  keep();
}

void Alarms::shelve(int number, int minutes) {
  const base::UtcMs now = m_clock();
  m_list.shelve(number, now + minutes * kMsPerMinute, m_user, now);
  keep();
}

void Alarms::unshelve(int number) {
  m_list.unshelve(number, m_user, m_clock());
  keep();
}

void Alarms::keep() {
  const std::vector<Transition> transitions = m_list.takeTransitions();
  for (const Transition& transition : transitions) {
    if (transition.event == alarm::Event::Raised) {
      const alarm::Facts& facts = alarm::factsOf(transition.alarm.code);
      m_messages.log(widgets::severityOf(facts.priority), facts.source, [alarm = transition.alarm] {
        const QString cause = widgets::alarmCause(alarm);
        const QString text = widgets::alarmText(alarm);
        return cause.isEmpty() ? text : text + QLatin1Char(' ') + cause;
      });
    }
    m_history.insert(m_history.begin(), transition);
    m_history.resize(std::min(m_history.size(), kHistoryMax));
    write(transition);
    Q_EMIT happened(transition);
  }
  if (!transitions.empty()) {
    Q_EMIT changed();
  }
}

void Alarms::write(const Transition& transition) {
  if (!m_writer || transition.alarm.code == alarm::Code::AlarmHistoryUnwritten) {
    return;
  }
  m_writer->add([file = m_file, transition] { return file.append(transition); },
                [this, path = m_file.path().string()](const base::Result<void>& written) {
                  // On another thread; the writer ends before this object does.
                  QMetaObject::invokeMethod(
                      this,
                      [this, path, written] {
                        if (written) {
                          m_messages.settle(alarm::Code::AlarmHistoryUnwritten);
                        } else {
                          m_messages.raise(alarm::Code::AlarmHistoryUnwritten, {path},
                                           written.error());
                        }
                      },
                      Qt::QueuedConnection);
                });
}

}  // namespace rivulet::hmi
