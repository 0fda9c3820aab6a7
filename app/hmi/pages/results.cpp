// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Pages that show what a run left behind: traces, alarms, messages; and the alarm line.

#include "hmi/pages/pages.h"
#include "hmi/past_runs.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/alarms/alarm_page.h"
#include "widgets/common/log_view.h"
#include "widgets/runs/run_texts.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

namespace {

void acknowledge(const Models& models, int number) {
  if (!models.users.refusal(permission::Act::Acknowledge)) {
    models.alarms.acknowledge(number);
  }
}

/// The control's own trace if the recording has it, else what was seen live.
void showRecording(widgets::TracePage* page, const std::shared_ptr<const trace::Recording>& of,
                   const report::FinishedRun& run) {
  const trace::Recording& recording = *of;
  page->clear();
  if (recording.controlTrace && !recording.controlTrace->samples.empty()) {
    std::vector<trace::Pause> pauses = run.report.pauses;
    for (trace::Pause& pause : pauses) {
      // The report counts from the first sample of the trace.
      pause.start += recording.controlTrace->samples.front().at.time_since_epoch();
    }
    page->showControlTrace(std::shared_ptr<const trace::ControlTrace>(of, &*recording.controlTrace),
                           pauses);
  } else if (!recording.samples.empty()) {
    const base::Instant origin = recording.samples.front().at;
    for (const trace::LiveSample& sample : recording.samples) {
      page->append({base::toSeconds(sample.at - origin), sample.positionMm, sample.feedMmPerS});
    }
    for (trace::Pause pause : recording.pauses) {
      pause.start = base::Instant{pause.start - origin};
      page->addPause(pause);
    }
  }
  page->setPastRun(widgets::startText(run.summary),
                   QString::fromStdString(run.summary.programName));
}

}  // namespace

QWidget* makeTracePage(const Models& models, QWidget* parent) {
  auto* page = new widgets::TracePage(parent);
  QObject::connect(&models.runs, &RunController::started, page, &widgets::TracePage::clear);
  QObject::connect(&models.runs, &RunController::sampled, page, &widgets::TracePage::append);
  QObject::connect(&models.runs, &RunController::paused, page, &widgets::TracePage::addPause);
  QObject::connect(&models.runs, &RunController::finished, page,
                   [page](const std::shared_ptr<const streaming::RunReport>& report) {
                     if (report->controlTrace) {
                       page->showControlTrace(report->controlTrace, report->pauses);
                     }
                   });
  QObject::connect(&models.pastRuns, &PastRuns::recordingRead, page,
                   [page](const std::shared_ptr<const trace::Recording>& recording,
                          const std::shared_ptr<const report::FinishedRun>& run) {
                     showRecording(page, recording, *run);
                     showPageOf(page);
                   });
  return page;
}

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
