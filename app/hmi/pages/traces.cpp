// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page Traces: the run in progress, the last run, runs of the past, and files.

#include "hmi/traces.h"
#include "hmi/alarms.h"
#include "hmi/document.h"
#include "hmi/pages/pages.h"
#include "hmi/past_runs.h"
#include "hmi/run_controller.h"
#include "hmi/trace_layouts.h"
#include "session/background.h"
#include "widgets/common/error_text.h"
#include "widgets/runs/run_texts.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

namespace {

struct TracesPage {
  Q_DECLARE_TR_FUNCTIONS(TracesPage)

 public:
  static QString damagedLayouts(const QString& keptAs) {
    return tr("The file of the pane layouts is damaged. What can be read of it is used, and the "
              "file is kept as %1.")
        .arg(keptAs);
  }
  static QString inProgress() { return tr("A run is in progress. Open files after it has ended."); }
};

void connectRuns(Alarms* alarms, RunController* runs, PastRuns* pastRuns, Traces* traces,
                 widgets::TracePage* page) {
  QObject::connect(runs, &RunController::started, page, [page, traces] {
    traces->cancel();
    page->clear();
  });
  QObject::connect(runs, &RunController::sampled, page, &widgets::TracePage::append);
  QObject::connect(runs, &RunController::paused, page, &widgets::TracePage::addPause);
  QObject::connect(alarms, &Alarms::happened, page, [page](const alarm::Transition& transition) {
    if (transition.event == alarm::Event::Raised) {
      page->noticeAlarm();
    }
  });
  QObject::connect(runs, &RunController::finished, page,
                   [page, traces](const std::shared_ptr<const streaming::RunReport>& report) {
                     page->finishLive();
                     // Without a trace of the control, the live samples stay.
                     traces->show(report->controlTrace);
                   });
  QObject::connect(pastRuns, &PastRuns::recordingRead, page,
                   [page, traces](const std::shared_ptr<const trace::Recording>& recording,
                                  const std::shared_ptr<const report::FinishedRun>& run) {
                     page->clear();
                     page->setPastRun(widgets::startText(run->summary),
                                      QString::fromStdString(run->summary.programName));
                     traces->show(recording);
                     showPageOf(page);
                   });
}

void showLayouts(widgets::TracePage* page) {
  const auto loaded = loadTraceLayouts(traceLayoutsFile());
  if (!loaded) {
    page->showProblem(widgets::errorText(loaded.error()));
    return;
  }
  page->setLayouts(loaded->layouts);
  if (!loaded->keptAs.empty()) {
    page->showProblem(TracesPage::damagedLayouts(QString::fromStdString(loaded->keptAs.string())));
  }
}

}  // namespace

QWidget* makeTracePage(Alarms* alarms, Document* document, RunController* runs, PastRuns* pastRuns,
                       Traces* traces, QWidget* parent) {
  auto* page = new widgets::TracePage(parent);
  page->setRunner(&session::runInBackground);
  connectRuns(alarms, runs, pastRuns, traces, page);
  showLayouts(page);
  QObject::connect(page, &widgets::TracePage::layoutsChanged, page,
                   [page](const widgets::ScopeLayouts& layouts) {
                     if (const auto done = saveTraceLayouts(traceLayoutsFile(), layouts); !done) {
                       page->showProblem(widgets::errorText(done.error()));
                     }
                   });
  const auto showProgram = [page, document] { page->setProgram(document->view()); };
  QObject::connect(document, &Document::programLoaded, page, showProgram);
  QObject::connect(document, &Document::programPlaced, page, showProgram);
  QObject::connect(page, &widgets::TracePage::openRequested, traces,
                   [page, traces, runs](const QStringList& paths) {
                     if (runs->isRunning()) {
                       page->showProblem(TracesPage::inProgress());
                     } else {
                       traces->open(paths);
                     }
                   });
  QObject::connect(page, &widgets::TracePage::mappingChosen, traces,
                   [page, traces](const std::string& layout, const trace::TableMapping& mapping) {
                     if (const auto done = traces->setMapping(layout, mapping); !done) {
                       page->showProblem(widgets::errorText(done.error()));
                     }
                   });
  QObject::connect(traces, &Traces::reading, page, [page](const QStringList& names) {
    page->showReading(names);
    showPageOf(page);
  });
  QObject::connect(traces, &Traces::filesShown, page, [page](const Traces::List& list) {
    page->setPastRun({}, {});
    page->showTraces(list, widgets::TracePage::Source::Files);
  });
  QObject::connect(traces, &Traces::runShown, page, [page](const Traces::List& list) {
    page->showTraces(list, widgets::TracePage::Source::Control);
  });
  QObject::connect(traces, &Traces::failed, page, [page](const base::Error& error) {
    page->showProblem(widgets::errorText(error));
  });
  return page;
}

}  // namespace rivulet::hmi
