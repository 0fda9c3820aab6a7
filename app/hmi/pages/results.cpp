// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Pages that show what a run left behind: alarms, messages; and the alarm line.

#include "hmi/alarms.h"
#include "hmi/messages.h"
#include "hmi/pages/pages.h"
#include "hmi/users.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/alarms/alarm_page.h"
#include "widgets/common/log_view.h"

namespace rivulet::hmi {

namespace {

void acknowledge(Alarms* alarms, Users* users, int number) {
  if (!users->refusal(permission::Act::Acknowledge)) {
    alarms->acknowledge(number);
  }
}

}  // namespace

QWidget* makeAlarmPage(Alarms* alarms, Users* users, QWidget* parent) {
  auto* page = new widgets::AlarmPage(parent);
  const auto show = [page, alarms] {
    page->setAlarms(alarms->list().alarms());
    page->setHistory(alarms->history());
  };
  show();
  QObject::connect(alarms, &Alarms::changed, page, show);
  QObject::connect(alarms, &Alarms::listRequested, page, &widgets::AlarmPage::showAlarms);
  QObject::connect(page, &widgets::AlarmPage::acknowledgeRequested, page,
                   [alarms, users](int number) { acknowledge(alarms, users, number); });
  QObject::connect(page, &widgets::AlarmPage::acknowledgeAllRequested, page, [alarms, users] {
    if (!users->refusal(permission::Act::Acknowledge)) {
      alarms->acknowledgeAll();
    }
  });
  QObject::connect(page, &widgets::AlarmPage::shelveRequested, page,
                   [alarms, users](int number, int minutes) {
                     if (!users->refusal(permission::Act::Shelve)) {
                       alarms->shelve(number, minutes);
                     }
                   });
  QObject::connect(page, &widgets::AlarmPage::unshelveRequested, page, [alarms, users](int number) {
    if (!users->refusal(permission::Act::Shelve)) {
      alarms->unshelve(number);
    }
  });
  return page;
}

QWidget* makeLogPage(Messages* messages, QWidget* parent) {
  auto* page = new widgets::LogView(parent);
  QObject::connect(messages, &Messages::logged, page, &widgets::LogView::append);
  QObject::connect(
      page, &widgets::LogView::saveRequested, page,
      [page, messages](const QString& path) { saveText(messages, path, page->toText()); });
  return page;
}

QWidget* makeAlarmLine(Messages* messages, Alarms* alarms, Users* users, QWidget* parent) {
  auto* line = new widgets::AlarmLine(parent);
  const auto show = [line, alarms] {
    const alarm::Alarm* first = alarms->list().mostImportant();
    line->setAlarm(first == nullptr ? std::nullopt : std::optional(*first),
                   alarms->list().shownCount());
  };
  show();
  QObject::connect(alarms, &Alarms::changed, line, show);
  QObject::connect(messages, &Messages::shown, line, &widgets::AlarmLine::showNote);
  QObject::connect(messages, &Messages::cleared, line, &widgets::AlarmLine::clearNote);
  QObject::connect(line, &widgets::AlarmLine::acknowledgeRequested, line,
                   [alarms, users](int number) { acknowledge(alarms, users, number); });
  QObject::connect(line, &widgets::AlarmLine::listRequested, alarms, &Alarms::listRequested);
  return line;
}

}  // namespace rivulet::hmi
