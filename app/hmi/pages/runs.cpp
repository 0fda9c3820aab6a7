// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page of the runs that have ended.

#include <QCoreApplication>
#include <QFileInfo>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "hmi/pages/pages.h"
#include "hmi/past_runs.h"
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
                    const Models& models) {
  PastRuns* past = &models.pastRuns;
  QObject::connect(past, &PastRuns::listed, page,
                   [page](const std::shared_ptr<const report::HistoryList>& list) {
                     std::vector<widgets::UnreadableRunView> unreadable;
                     for (const report::UnreadableRun& run : list->unreadable) {
                       unreadable.push_back({QString::fromStdString(run.file.filename().string()),
                                             RunsTexts::problem(run.error)});
                     }
                     page->setRuns(list->runs, unreadable);
                   });
  QObject::connect(page, &RunsPage::detailRequested, past, &PastRuns::readRun);
  QObject::connect(page, &RunsPage::openRequested, past, &PastRuns::readFile);
  QObject::connect(past, &PastRuns::read, page,
                   [page, shown](const QString& id, const FinishedRunPtr& run) {
                     *shown = run;
                     if (id.isEmpty()) {
                       page->showFile(run->summary, run->report);
                     } else {
                       page->setDetail(id.toStdString(), run->report);
                     }
                   });
  QObject::connect(past, &PastRuns::unreadable, page,
                   [page, models](const QString& id, const base::Error& error) {
                     if (id.isEmpty()) {
                       models.messages.show(Severity::Warning, [error] {
                         return QStringLiteral("%1: %2").arg(QString::fromStdString(error.context),
                                                             RunsTexts::problem(error));
                       });
                     } else {
                       page->setDetailProblem(id.toStdString(), RunsTexts::problem(error));
                     }
                   });
  QObject::connect(&models.runs, &RunController::started, page, [shown] { shown->reset(); });
}

void connectExports(RunsPage* page, const std::shared_ptr<FinishedRunPtr>& shown,
                    const Models& models) {
  QObject::connect(page, &RunsPage::sheetRequested, page, [shown, models](const QString& path) {
    if (*shown && paper::writePdf(
                      path, widgets::runPage({(*shown)->summary, (*shown)->report, (*shown)->sketch,
                                              QStringLiteral(RIVULET_VERSION)}))) {
      models.messages.show(Severity::Note, [path] { return RunsTexts::tr("Saved %1.").arg(path); });
    } else {
      models.messages.show(Severity::Error, [path] {
        return RunsTexts::tr("%1 cannot be written. Check permissions and free space.").arg(path);
      });
    }
  });
  QObject::connect(page, &RunsPage::jsonRequested, page, [shown, models](const QString& path) {
    if (*shown) {
      saveText(models, path,
               QString::fromStdString(report::finishedRunJson(**shown).dump(
                   2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) +
                   QLatin1Char('\n'));
    }
  });
  QObject::connect(page, &RunsPage::csvRequested, page, [page, models](const QString& path) {
    saveText(models, path, QString::fromStdString(report::runsCsv(page->shownRuns())));
  });
}

void connectActions(RunsPage* page, const std::shared_ptr<FinishedRunPtr>& shown,
                    const Models& models) {
  PastRuns* past = &models.pastRuns;
  QObject::connect(page, &RunsPage::tracesRequested, past, [past, shown] {
    if (*shown) {
      past->openRecording(**shown);
    }
  });
  QObject::connect(page, &RunsPage::repeatRequested, past, [past, shown] {
    if (*shown) {
      past->repeat(**shown);
    }
  });
  QObject::connect(page, &RunsPage::resumeRequested, &models.runs, &RunController::askResume);
  RunController* runs = &models.runs;
  QObject::connect(runs, &RunController::permissionsChanged, page, [page, runs] {
    page->setRepeatEnabled(runs->canChangeSettings() && !runs->isCalibrating());
    page->setBoundsEnabled(runs->canChangeSettings());
    const auto& report = runs->report();
    const bool isLeft = runs->hasRunToResume() && report && report->checkpoint;
    page->setResumable(isLeft ? std::optional(report->checkpoint->runNumber) : std::nullopt);
  });
  QObject::connect(page, &RunsPage::boundsRequested, past,
                   [past](const widgets::HistoryBounds& bounds) {
                     past->setLimits({static_cast<std::size_t>(bounds.runs),
                                      static_cast<std::uintmax_t>(bounds.gibibytes) * kGibibyte});
                   });
}

}  // namespace

QWidget* makeRunsPage(const Models& models, QWidget* parent) {
  auto* page = new RunsPage(parent);
  const auto shown = std::make_shared<FinishedRunPtr>();
  connectReading(page, shown, models);
  connectExports(page, shown, models);
  connectActions(page, shown, models);
  const report::HistoryLimits limits = models.pastRuns.limits();
  page->setBounds({static_cast<int>(limits.runsMax),
                   static_cast<int>(std::max<std::uintmax_t>(1, limits.bytesMax / kGibibyte))});
  models.pastRuns.refresh();
  return page;
}

}  // namespace rivulet::hmi
