// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page of the runs that have ended.

#include <QCoreApplication>
#include <QFileInfo>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "hmi/messages.h"
#include "hmi/pages/pages.h"
#include "hmi/past_runs.h"
#include "hmi/run_controller.h"
#include "widgets/common/error_text.h"
#include "widgets/runs/run_sheet.h"
#include "widgets/runs/runs_page.h"

namespace rivulet::hmi {

using gcode::Severity;
using report::ReportError;
using widgets::RunsPage;

namespace {

constexpr std::uintmax_t kGibibyte = std::uintmax_t{1} << 30U;
using FinishedRunPtr = std::shared_ptr<const report::FinishedRun>;

struct RunsTexts {
  Q_DECLARE_TR_FUNCTIONS(RunsTexts)

 public:
  /// Why a report cannot be shown.
  static QString problem(const base::Error& error) {
    if (error.code == ReportError::NotAReport) {
      return tr(
          "This is not the report of a run. Choose a file that this page or stream --json has "
          "written.");
    }
    if (error.code == ReportError::NewerVersion) {
      return tr("The report was written by a later version of Rivulet. Use that one to open it.");
    }
    if (error.code == ReportError::Damaged) {
      return tr("The report is damaged and cannot be shown.");
    }
    base::Error plain = error;
    plain.context.clear();
    return widgets::errorText(plain);
  }
};

void connectReading(RunsPage* page, const std::shared_ptr<FinishedRunPtr>& shown,
                    Messages* messages, RunController* runs, PastRuns* pastRuns) {
  QObject::connect(pastRuns, &PastRuns::listed, page,
                   [page](const std::shared_ptr<const report::HistoryList>& list) {
                     std::vector<widgets::UnreadableRunView> unreadable;
                     for (const report::UnreadableRun& run : list->unreadable) {
                       unreadable.push_back({QString::fromStdString(run.file.filename().string()),
                                             RunsTexts::problem(run.error)});
                     }
                     page->setRuns(list->runs, unreadable);
                   });
  QObject::connect(page, &RunsPage::detailRequested, pastRuns, &PastRuns::readRun);
  QObject::connect(page, &RunsPage::openRequested, pastRuns, &PastRuns::readFile);
  QObject::connect(pastRuns, &PastRuns::read, page,
                   [page, shown](const QString& id, const FinishedRunPtr& run) {
                     *shown = run;
                     if (id.isEmpty()) {
                       page->showFile(run->summary, run->report);
                     } else {
                       page->setDetail(id.toStdString(), run->report);
                     }
                   });
  QObject::connect(pastRuns, &PastRuns::unreadable, page,
                   [page, messages](const QString& id, const base::Error& error) {
                     if (id.isEmpty()) {
                       messages->show(Severity::Warning, [error] {
                         return QStringLiteral("%1: %2").arg(QString::fromStdString(error.context),
                                                             RunsTexts::problem(error));
                       });
                     } else {
                       page->setDetailProblem(id.toStdString(), RunsTexts::problem(error));
                     }
                   });
  QObject::connect(runs, &RunController::started, page, [shown] { shown->reset(); });
}

void connectExports(RunsPage* page, const std::shared_ptr<FinishedRunPtr>& shown,
                    Messages* messages) {
  QObject::connect(page, &RunsPage::sheetRequested, page, [shown, messages](const QString& path) {
    if (*shown) {
      saveSheet(messages, path,
                widgets::runPage({(*shown)->summary, (*shown)->report, (*shown)->sketch,
                                  QStringLiteral(RIVULET_VERSION)}));
    }
  });
  QObject::connect(page, &RunsPage::jsonRequested, page, [shown, messages](const QString& path) {
    if (*shown) {
      saveText(messages, path,
               QString::fromStdString(report::finishedRunJson(**shown).dump(
                   2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) +
                   QLatin1Char('\n'));
    }
  });
  QObject::connect(page, &RunsPage::csvRequested, page, [page, messages](const QString& path) {
    saveText(messages, path, QString::fromStdString(report::runsCsv(page->shownRuns())));
  });
}

void connectActions(RunsPage* page, const std::shared_ptr<FinishedRunPtr>& shown,
                    RunController* runs, PastRuns* pastRuns) {
  QObject::connect(page, &RunsPage::tracesRequested, pastRuns, [pastRuns, shown] {
    if (*shown) {
      pastRuns->openRecording(**shown);
    }
  });
  QObject::connect(page, &RunsPage::repeatRequested, pastRuns, [pastRuns, shown] {
    if (*shown) {
      pastRuns->repeat(**shown);
    }
  });
  QObject::connect(page, &RunsPage::resumeRequested, runs, &RunController::askResume);
  QObject::connect(runs, &RunController::permissionsChanged, page, [page, runs] {
    page->setRepeatEnabled(runs->canChangeSettings() && !runs->isCalibrating());
    page->setBoundsEnabled(runs->canChangeSettings());
    const auto& report = runs->report();
    const bool isLeft = runs->hasRunToResume() && report && report->checkpoint;
    page->setResumable(isLeft ? std::optional(report->checkpoint->runNumber) : std::nullopt);
  });
  QObject::connect(
      page, &RunsPage::boundsRequested, pastRuns, [pastRuns](const widgets::HistoryBounds& bounds) {
        pastRuns->setLimits({static_cast<std::size_t>(bounds.runs),
                             static_cast<std::uintmax_t>(bounds.gibibytes) * kGibibyte});
      });
}

}  // namespace

QWidget* makeRunsPage(Messages* messages, RunController* runs, PastRuns* pastRuns,
                      QWidget* parent) {
  auto* page = new RunsPage(parent);
  const auto shown = std::make_shared<FinishedRunPtr>();
  connectReading(page, shown, messages, runs, pastRuns);
  connectExports(page, shown, messages);
  connectActions(page, shown, runs, pastRuns);
  const report::HistoryLimits limits = pastRuns->limits();
  page->setBounds({static_cast<int>(limits.runsMax),
                   static_cast<int>(std::max<std::uintmax_t>(1, limits.bytesMax / kGibibyte))});
  pastRuns->refresh();
  return page;
}

}  // namespace rivulet::hmi
