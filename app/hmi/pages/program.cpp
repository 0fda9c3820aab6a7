// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "hmi/pages/pages.h"
#include "sources/open_source.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/live/live_dialog.h"
#include "widgets/live/live_panel.h"
#include "widgets/program/file_bars.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/program/reading_bar.h"
#include "widgets/program/text_pane.h"

namespace rivulet::hmi {

using gcode::Severity;
using Source = Messages::Source;
using widgets::FileBanner;
using widgets::LoadBar;
using widgets::PathView;
using widgets::ProgramPage;
using widgets::ProgramPanel;

namespace {

struct ProgramTexts {
  Q_DECLARE_TR_FUNCTIONS(ProgramTexts)

 public:
  /// Why the program that has just been loaded cannot be streamed; empty: it can.
  static QString refusal(const gcode::Program& program, bool hasPoints) {
    const QString name = QString::fromStdString(program.name);
    if (program.isStreamable()) {
      return {};
    }
    if (!program.isUnderstood()) {
      return tr("Parts of the path of %1 are not known: see the findings. The program cannot be "
                "streamed.")
          .arg(name);
    }
    return hasPoints
               ? tr("%1 needs a transformation of the control. No method can stream it.").arg(name)
               : tr("%1 moves no axis: there is nothing to stream.").arg(name);
  }
};

void showReading(ProgramPanel* panel, const session::Reading& reading) {
  panel->setReading(reading.dialect, reading.accepted, reading.centres);
}

void open(const Models& models, const QString& path) {
  if (models.runs.isRunning()) {
    models.messages.show(Severity::Warning, [] {
      return ProgramTexts::tr("A run is in progress. Open another program after it has ended.");
    });
    return;
  }
  models.document.open(path);
}

/// The program is read again in the way `change` makes of the present one.
template <class Change>
void readAgain(const Models& models, Change change) {
  session::Reading reading = models.document.reading();
  change(reading);
  models.document.readAgain(reading);
}

void connectReading(ProgramPanel* panel, const Models& models) {
  QObject::connect(panel, &ProgramPanel::openRequested, panel,
                   [models](const QString& path) { open(models, path); });
  QObject::connect(panel, &ProgramPanel::fileDropped, panel,
                   [models](const QString& path) { open(models, path); });
  QObject::connect(panel, &ProgramPanel::dialectRequested, panel,
                   [models](const std::optional<gcode::Dialect>& dialect) {
                     readAgain(models,
                               [&](session::Reading& reading) { reading.dialect = dialect; });
                   });
  QObject::connect(panel, &ProgramPanel::acceptRequested, panel, [models](const QString& name) {
    readAgain(models,
              [&](session::Reading& reading) { reading.accepted.push_back(name.toStdString()); });
  });
  QObject::connect(panel, &ProgramPanel::takeBackRequested, panel, [models](const QString& name) {
    readAgain(models,
              [&](session::Reading& reading) { std::erase(reading.accepted, name.toStdString()); });
  });
  QObject::connect(
      panel, &ProgramPanel::centresRequested, panel, [models](gcode::CentreReading centres) {
        readAgain(models, [&](session::Reading& reading) { reading.centres = centres; });
      });
}

/// What the program leaves open is answered by reading it again.
void connectQuestions(widgets::ReadingBar* bar, const Models& models) {
  QObject::connect(bar, &widgets::ReadingBar::dialectChosen, bar, [models](gcode::Dialect dialect) {
    readAgain(models, [&](session::Reading& reading) { reading.dialect = dialect; });
  });
  QObject::connect(bar, &widgets::ReadingBar::unitsChosen, bar, [models](gcode::FileUnits units) {
    readAgain(models, [&](session::Reading& reading) { reading.units = units; });
  });
  QObject::connect(bar, &widgets::ReadingBar::noPointChosen, bar, [models](gcode::NoPoint meaning) {
    readAgain(models, [&](session::Reading& reading) { reading.noPoint = meaning; });
  });
  const RunController* runs = &models.runs;
  QObject::connect(runs, &RunController::permissionsChanged, bar,
                   [bar, runs] { bar->setAnswerable(!runs->isRunning()); });
}

void connectLoading(ProgramPage* page, const Models& models) {
  Document* document = &models.document;
  ProgramPanel* panel = page->panel();
  QObject::connect(document, &Document::programLoaded, page, [page, panel, models] {
    page->setProgram(models.document.view());
    if (models.document.live()) {
      return;  // the source has said what there is to be said
    }
    const gcode::Program& program = *models.document.program();
    models.settings.addRecentFile(models.document.path());
    panel->setRecentFiles(models.settings.recentFiles);
    showReading(panel, models.document.reading());
    models.messages.clear();
    models.messages.settle(alarm::Code::FileChanged);
    models.messages.settle(alarm::Code::FileGone);
    models.messages.didAct(permission::Act::OpenProgram,
                           {{"program", program.name},
                            {"hash", program.hash},
                            {"file", models.document.path().toStdString()}});
    const std::size_t points = models.document.points().size();
    models.messages.log(Severity::Note, Source::Program,
                        [name = QString::fromStdString(program.name),
                         hash = QString::fromStdString(program.hash), points] {
                          return ProgramTexts::tr("Opened %1 (%2), %Ln points.", nullptr,
                                                  static_cast<int>(points))
                              .arg(name, hash);
                        });
    if (!ProgramTexts::refusal(program, points > 0).isEmpty()) {
      models.messages.show(Severity::Error, [read = models.document.program(), points] {
        return ProgramTexts::refusal(*read, points > 0);
      });
    }
  });
  QObject::connect(document, &Document::programPlaced, page,
                   [page, document] { page->replaceProgram(document->view()); });
  QObject::connect(document, &Document::readingFailed, page,
                   [panel, models](const base::Error& error, const QString& path) {
                     showReading(panel, models.document.reading());
                     models.messages.show(Severity::Error,
                                          [error] { return widgets::errorText(error); });
                     models.messages.log(Severity::Error, Source::Program, [error, path] {
                       return QStringLiteral("%1: %2").arg(path, widgets::errorText(error));
                     });
                   });
  QObject::connect(document, &Document::readingCancelled, page, [panel, models] {
    showReading(panel, models.document.reading());
    models.messages.log(Severity::Note, Source::Program, [path = models.document.requestedPath()] {
      return ProgramTexts::tr("Reading %1 was cancelled.").arg(path);
    });
  });
}

/// Asks where live points come from, and what is agreed with their source.
void askForLive(QWidget* page, const Models& models) {
  auto* dialog = new widgets::LiveDialog(models.live.setup(), sources::inputBringsPoints(), page);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &widgets::LiveDialog::openRequested, &models.live, &LiveSource::open);
  dialog->open();
}

void connectLive(ProgramPage* page, const Models& models) {
  widgets::LivePanel* panel = page->livePanel();
  const auto ask = [page, models] { askForLive(page, models); };
  QObject::connect(page->panel(), &ProgramPanel::liveRequested, page, ask);
  QObject::connect(panel, &widgets::LivePanel::changeRequested, page, ask);
  QObject::connect(panel, &widgets::LivePanel::programRequested, page->panel(),
                   &ProgramPanel::chooseFile);
  const Document* document = &models.document;
  QObject::connect(document, &Document::programLoaded, page, [page, document] {
    const auto& live = document->live();
    page->setLive(live ? std::optional(live->setup.agreement) : std::nullopt);
  });
  QObject::connect(document, &Document::judged, panel, [panel, document] {
    if (const auto& live = document->live()) {
      panel->setSource(live->setup, QString::fromStdString(live->name),
                       live->obstacle ? widgets::errorText(*live->obstacle) : QString());
    }
  });
  QObject::connect(&models.live, &LiveSource::opened, page, [page] { showPageOf(page); });
  RunController* runs = &models.runs;
  QObject::connect(runs, &RunController::started, panel, &widgets::LivePanel::begin);
  QObject::connect(runs, &RunController::updated, panel, &widgets::LivePanel::setUpdate);
  QObject::connect(runs, &RunController::finished, panel,
                   [panel](const std::shared_ptr<const streaming::RunReport>& report) {
                     panel->setReport(*report);
                   });
  QObject::connect(runs, &RunController::permissionsChanged, panel,
                   [panel, runs] { panel->setEditable(!runs->isRunning()); });
}

void connectPath(PathView* path, const Models& models) {
  const Document* document = &models.document;
  QObject::connect(document, &Document::judged, path, [path, document] {
    path->setOperatingPoint(document->findings().operatingPoint, document->findings().access,
                            document->settings().usesProgramFeeds());
  });
  QObject::connect(document, &Document::pausesChanged, path, [path, document] {
    if (path->pauses() != document->pauses()) {
      path->setPauses(document->pauses());
    }
  });
  const MachineModel* machine = &models.machine;
  QObject::connect(machine, &MachineModel::viewChanged, path,
                   [path, machine] { path->setToolPosition(machine->view().positionMm); });
  QObject::connect(&models.runs, &RunController::placeFound, path,
                   [path](const widgets::ResumePlace& place) { path->markPoint(place.point); });
}

}  // namespace

QWidget* makeProgramPage(const Models& models, QWidget* parent) {
  auto* page = new ProgramPage(parent);
  ProgramPanel* panel = page->panel();
  panel->setRecentFiles(models.settings.recentFiles);
  connectReading(panel, models);
  connectQuestions(page->readingBar(), models);
  connectLoading(page, models);
  connectPath(page->path(), models);
  connectLive(page, models);
  RunController* runs = &models.runs;
  QObject::connect(runs, &RunController::started, page, [page, runs](std::size_t firstPoint) {
    page->followRun();
    page->setRunBegin(runs->runBegin());
    page->setExecuted(firstPoint);
  });
  const auto showRun = [page, runs] {
    const bool isNative = runs->job() && runs->job()->isNative;
    page->setExecuted(runs->update().counters.executed, isNative ? runs->job()->line.value : 0);
  };
  QObject::connect(runs, &RunController::updated, page, showRun);
  QObject::connect(runs, &RunController::jobChanged, page, showRun);
  QObject::connect(&models.document, &Document::programPlaced, page, [models, showRun] {
    if (models.document.live()) {
      showRun();  // what has been executed is on the path by now
    }
  });
  QObject::connect(&models.found, &FoundRuns::watched, page,
                   [page](std::size_t executed) { page->setExecuted(executed); });
  const Document* document = &models.document;
  QObject::connect(document, &Document::judged, panel,
                   [panel, document] { panel->setDistances(document->findings().distances); });
  QObject::connect(document, &Document::timesEstimated, page, &ProgramPage::setTimes);
  QObject::connect(runs, &RunController::permissionsChanged, panel, [page, panel, runs, document] {
    panel->setOpenEnabled(!runs->isRunning());
    page->textPane()->startHere()->setEnabled(!runs->isRunning() && !document->points().empty());
  });
  QObject::connect(page->textPane(), &widgets::TextPane::startHereRequested, runs,
                   &RunController::offerStartAtLine);
  return page;
}

QWidget* makeLoadBar(const Models& models, QWidget* parent) {
  auto* bar = new LoadBar(parent);
  Document* document = &models.document;
  QObject::connect(document, &Document::readingProgressed, bar,
                   [bar, document](const std::optional<double>& share) {
                     bar->setProgress(share, QFileInfo(document->requestedPath()).fileName());
                   });
  QObject::connect(bar, &LoadBar::cancelRequested, document, &Document::cancelReading);
  return bar;
}

QWidget* makeFileBanner(const Models& models, QWidget* parent) {
  auto* banner = new FileBanner(parent);
  QObject::connect(&models.document, &Document::programLoaded, banner, [banner, models] {
    if (models.document.live()) {
      models.messages.settle(alarm::Code::FileChanged);
      models.messages.settle(alarm::Code::FileGone);
    }
    const gcode::Program& program = *models.document.program();
    banner->setProgram(QString::fromStdString(program.name), QString::fromStdString(program.hash));
    banner->setState(FileBanner::State::Same);
  });
  QObject::connect(&models.document, &Document::fileStateChanged, banner,
                   [banner, models](session::FileWatch::State state) {
                     const std::string path = models.document.path().toStdString();
                     switch (state) {
                       case session::FileWatch::State::Same:
                         banner->setState(FileBanner::State::Same);
                         models.messages.settle(alarm::Code::FileChanged);
                         models.messages.settle(alarm::Code::FileGone);
                         return;
                       case session::FileWatch::State::Changed:
                         banner->setState(FileBanner::State::Changed);
                         models.messages.settle(alarm::Code::FileGone);
                         models.messages.raise(alarm::Code::FileChanged, {path});
                         return;
                       case session::FileWatch::State::Gone:
                         banner->setState(FileBanner::State::Gone);
                         models.messages.raise(alarm::Code::FileGone, {path});
                         return;
                     }
                   });
  QObject::connect(banner, &FileBanner::reloadRequested, &models.document,
                   [models] { models.document.readAgain(models.document.reading()); });
  const RunController* runs = &models.runs;
  QObject::connect(runs, &RunController::permissionsChanged, banner,
                   [banner, runs] { banner->setRunning(runs->isRunning()); });
  return banner;
}

}  // namespace rivulet::hmi
