// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Pages that show what a run left behind: alarms, messages; and the alarm line.

#include "hmi/pages/pages.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/alarms/alarm_page.h"
#include "widgets/common/log_view.h"

namespace rivulet::hmi {

namespace {

void acknowledge(const Models& models, int number) {
  if (!models.users.refusal(permission::Act::Acknowledge)) {
    models.alarms.acknowledge(number);
  }
}

}  // namespace

QWidget* makeAlarmPage(const Models& models, QWidget* parent) {
  auto* page = new widgets::AlarmPage(parent);
  Alarms* alarms = &models.alarms;
  const auto show = [page, alarms] {
    page->setAlarms(alarms->list().alarms());
    page->setHistory(alarms->history());
  };
  show();
  QObject::connect(alarms, &Alarms::changed, page, show);
  QObject::connect(alarms, &Alarms::listRequested, page, &widgets::AlarmPage::showAlarms);
  QObject::connect(page, &widgets::AlarmPage::acknowledgeRequested, page,
                   [models](int number) { acknowledge(models, number); });
  QObject::connect(page, &widgets::AlarmPage::acknowledgeAllRequested, page, [models] {
    if (!models.users.refusal(permission::Act::Acknowledge)) {
      models.alarms.acknowledgeAll();
    }
  });
  QObject::connect(page, &widgets::AlarmPage::shelveRequested, page,
                   [models](int number, int minutes) {
                     if (!models.users.refusal(permission::Act::Shelve)) {
                       models.alarms.shelve(number, minutes);
                     }
                   });
  QObject::connect(page, &widgets::AlarmPage::unshelveRequested, page, [models](int number) {
    if (!models.users.refusal(permission::Act::Shelve)) {
      models.alarms.unshelve(number);
    }
  });
  return page;
}

QWidget* makeLogPage(const Models& models, QWidget* parent) {
  auto* page = new widgets::LogView(parent);
  QObject::connect(&models.messages, &Messages::logged, page, &widgets::LogView::append);
  QObject::connect(page, &widgets::LogView::saveRequested, page,
                   [page, models](const QString& path) { saveText(models, path, page->toText()); });
  return page;
}

QWidget* makeAlarmLine(const Models& models, QWidget* parent) {
  auto* line = new widgets::AlarmLine(parent);
  Alarms* alarms = &models.alarms;
  const auto show = [line, alarms] {
    const alarm::Alarm* first = alarms->list().mostImportant();
    line->setAlarm(first == nullptr ? std::nullopt : std::optional(*first),
                   alarms->list().shownCount());
  };
  show();
  QObject::connect(alarms, &Alarms::changed, line, show);
  QObject::connect(&models.messages, &Messages::shown, line, &widgets::AlarmLine::showNote);
  QObject::connect(&models.messages, &Messages::cleared, line, &widgets::AlarmLine::clearNote);
  QObject::connect(line, &widgets::AlarmLine::acknowledgeRequested, line,
                   [models](int number) { acknowledge(models, number); });
  QObject::connect(line, &widgets::AlarmLine::listRequested, alarms, &Alarms::listRequested);
  return line;
}

}  // namespace rivulet::hmi
