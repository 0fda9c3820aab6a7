// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "hmi/document.h"
#include "hmi/found_runs.h"
#include "hmi/live_source.h"
#include "hmi/machine_model.h"
#include "hmi/messages.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "hmi/settings.h"
#include "session/background.h"
#include "sources/open_source.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/sheet_area.h"
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

void open(Messages* messages, Document* document, RunController* runs, const QString& path) {
  if (runs->isRunning()) {
    messages->show(Severity::Warning, [] {
      return ProgramTexts::tr("A run is in progress. Open another program after it has ended.");
    });
    return;
  }
  document->open(path);
}

/// The program is read again in the way `change` makes of the present one.
template <class Change>
void readAgain(Document* document, Change change) {
  session::Reading reading = document->reading();
  change(reading);
  document->readAgain(reading);
}

void connectReading(ProgramPanel* panel, Messages* messages, Document* document,
                    RunController* runs) {
  QObject::connect(
      panel, &ProgramPanel::openRequested, panel,
      [messages, document, runs](const QString& path) { open(messages, document, runs, path); });
  QObject::connect(
      panel, &ProgramPanel::fileDropped, panel,
      [messages, document, runs](const QString& path) { open(messages, document, runs, path); });
  QObject::connect(panel, &ProgramPanel::dialectRequested, panel,
                   [document](const std::optional<gcode::Dialect>& dialect) {
                     readAgain(document,
                               [&](session::Reading& reading) { reading.dialect = dialect; });
                   });
  QObject::connect(panel, &ProgramPanel::acceptRequested, panel, [document](const QString& name) {
    readAgain(document,
              [&](session::Reading& reading) { reading.accepted.push_back(name.toStdString()); });
  });
  QObject::connect(panel, &ProgramPanel::takeBackRequested, panel, [document](const QString& name) {
    readAgain(document,
              [&](session::Reading& reading) { std::erase(reading.accepted, name.toStdString()); });
  });
  QObject::connect(
      panel, &ProgramPanel::centresRequested, panel, [document](gcode::CentreReading centres) {
        readAgain(document, [&](session::Reading& reading) { reading.centres = centres; });
      });
}

/// What the program leaves open is answered by reading it again.
void connectQuestions(widgets::ReadingBar* bar, Document* document, RunController* runs) {
  QObject::connect(
      bar, &widgets::ReadingBar::dialectChosen, bar, [document](gcode::Dialect dialect) {
        readAgain(document, [&](session::Reading& reading) { reading.dialect = dialect; });
      });
  QObject::connect(bar, &widgets::ReadingBar::unitsChosen, bar, [document](gcode::FileUnits units) {
    readAgain(document, [&](session::Reading& reading) { reading.units = units; });
  });
  QObject::connect(
      bar, &widgets::ReadingBar::noPointChosen, bar, [document](gcode::NoPoint meaning) {
        readAgain(document, [&](session::Reading& reading) { reading.noPoint = meaning; });
      });
  QObject::connect(bar, &widgets::ReadingBar::settingsChosen, bar,
                   [document](gcode::ControlSettings settings) {
                     readAgain(document, [&](session::Reading& reading) {
                       settings.merge(reading.settings);
                       reading.settings = std::move(settings);
                     });
                   });
  QObject::connect(runs, &RunController::permissionsChanged, bar,
                   [bar, runs] { bar->setAnswerable(!runs->isRunning()); });
}

void connectLoading(ProgramPage* page, Settings* settings, Messages* messages, Document* document) {
  ProgramPanel* panel = page->panel();
  QObject::connect(
      document, &Document::programLoaded, page, [page, panel, settings, messages, document] {
        page->setProgram(document->view());
        if (document->live()) {
          return;  // the source has said what there is to be said
        }
        const gcode::Program& program = *document->program();
        settings->addRecentFile(document->path());
        panel->setRecentFiles(settings->recentFiles);
        showReading(panel, document->reading());
        messages->clear();
        messages->settle(alarm::Code::FileChanged);
        messages->settle(alarm::Code::FileGone);
        messages->didAct(permission::Act::OpenProgram, {{"program", program.name},
                                                        {"hash", program.hash},
                                                        {"file", document->path().toStdString()}});
        const std::size_t points = document->points().size();
        messages->log(Severity::Note, Source::Program,
                      [name = QString::fromStdString(program.name),
                       hash = QString::fromStdString(program.hash), points] {
                        return ProgramTexts::tr("Opened %1 (%2), %Ln points.", nullptr,
                                                static_cast<int>(points))
                            .arg(name, hash);
                      });
        if (!ProgramTexts::refusal(program, points > 0).isEmpty()) {
          messages->show(Severity::Error, [read = document->program(), points] {
            return ProgramTexts::refusal(*read, points > 0);
          });
        }
      });
  QObject::connect(document, &Document::programPlaced, page,
                   [page, document] { page->replaceProgram(document->view()); });
  QObject::connect(document, &Document::readingFailed, page,
                   [panel, messages, document](const base::Error& error, const QString& path) {
                     showReading(panel, document->reading());
                     messages->show(Severity::Error, [error] { return widgets::errorText(error); });
                     messages->log(Severity::Error, Source::Program, [error, path] {
                       return QStringLiteral("%1: %2").arg(path, widgets::errorText(error));
                     });
                   });
  QObject::connect(document, &Document::readingCancelled, page, [panel, messages, document] {
    showReading(panel, document->reading());
    messages->log(Severity::Note, Source::Program, [path = document->requestedPath()] {
      return ProgramTexts::tr("Reading %1 was cancelled.").arg(path);
    });
  });
}

/// Asks where live points come from, and what is agreed with their source.
void askForLive(QWidget* page, MachineModel* machine, LiveSource* live) {
  const auto toolMm = machine->positionNowMm();
  auto* dialog = new widgets::LiveDialog(live->proposal(toolMm), sources::inputBringsPoints(),
                                         toolMm, nullptr);
  QObject::connect(dialog, &widgets::LiveDialog::openRequested, live, &LiveSource::open);
  widgets::openSheet(dialog, page);
}

void connectLive(ProgramPage* page, MachineModel* machine, Document* document, RunController* runs,
                 LiveSource* live) {
  widgets::LivePanel* panel = page->livePanel();
  const auto ask = [page, machine, live] { askForLive(page, machine, live); };
  QObject::connect(page->panel(), &ProgramPanel::liveRequested, page, ask);
  QObject::connect(panel, &widgets::LivePanel::changeRequested, page, ask);
  QObject::connect(panel, &widgets::LivePanel::programRequested, page->panel(),
                   &ProgramPanel::chooseFile);
  QObject::connect(document, &Document::programLoaded, page, [page, document] {
    const auto& source = document->live();
    page->setLive(source ? std::optional(source->setup.agreement) : std::nullopt);
  });
  QObject::connect(document, &Document::judged, panel, [panel, document] {
    if (const auto& source = document->live()) {
      panel->setSource(source->setup, QString::fromStdString(source->name),
                       source->obstacle ? widgets::errorText(*source->obstacle) : QString());
    }
  });
  QObject::connect(live, &LiveSource::opened, page, [page] { showPageOf(page); });
  QObject::connect(runs, &RunController::started, panel, &widgets::LivePanel::begin);
  QObject::connect(runs, &RunController::updated, panel, &widgets::LivePanel::setUpdate);
  QObject::connect(runs, &RunController::finished, panel,
                   [panel](const std::shared_ptr<const streaming::RunReport>& report) {
                     panel->setReport(*report);
                   });
  QObject::connect(runs, &RunController::permissionsChanged, panel,
                   [panel, runs] { panel->setEditable(!runs->isRunning()); });
}

void connectPath(PathView* path, MachineModel* machine, Document* document, RunController* runs) {
  path->setElsewhere(session::runInBackground);
  QObject::connect(document, &Document::judged, path, [path, document] {
    path->setOperatingPoint(document->findings().operatingPoint, document->findings().access,
                            document->settings().usesProgramFeeds());
  });
  QObject::connect(document, &Document::pausesChanged, path, [path, document] {
    if (path->pauses() != document->pauses()) {
      path->setPauses(document->pauses());
    }
  });
  QObject::connect(machine, &MachineModel::viewChanged, path,
                   [path, machine] { path->setToolPosition(machine->view().positionMm); });
  QObject::connect(runs, &RunController::placeFound, path,
                   [path](const widgets::ResumePlace& place) { path->markPoint(place.point); });
}

}  // namespace

QWidget* makeProgramPage(Settings* settings, Messages* messages, MachineModel* machine,
                         Document* document, RunController* runs, LiveSource* live,
                         FoundRuns* found, QWidget* parent) {
  auto* page = new ProgramPage(parent);
  ProgramPanel* panel = page->panel();
  panel->setRecentFiles(settings->recentFiles);
  connectReading(panel, messages, document, runs);
  connectQuestions(page->readingBar(), document, runs);
  connectLoading(page, settings, messages, document);
  connectPath(page->path(), machine, document, runs);
  connectLive(page, machine, document, runs, live);
  QObject::connect(runs, &RunController::started, page, [page, runs](std::size_t firstPoint) {
    page->followRun();
    page->setRunBegin(runs->runBegin());
    page->setExecuted(firstPoint);
  });
  const auto showRun = [page, runs] { page->setExecuted(runs->passed(), runs->runLine()); };
  QObject::connect(runs, &RunController::updated, page, showRun);
  QObject::connect(runs, &RunController::jobChanged, page, showRun);
  QObject::connect(document, &Document::programPlaced, page, [showRun, document] {
    if (document->live()) {
      showRun();  // what has been executed is on the path by now
    }
  });
  QObject::connect(found, &FoundRuns::watched, page,
                   [page](std::size_t executed) { page->setExecuted(executed); });
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

QWidget* makeLoadBar(Document* document, QWidget* parent) {
  auto* bar = new LoadBar(parent);
  QObject::connect(document, &Document::readingProgressed, bar,
                   [bar, document](const std::optional<double>& share) {
                     bar->setProgress(share, QFileInfo(document->requestedPath()).fileName());
                   });
  QObject::connect(bar, &LoadBar::cancelRequested, document, &Document::cancelReading);
  return bar;
}

QWidget* makeFileBanner(Messages* messages, Document* document, RunController* runs,
                        QWidget* parent) {
  auto* banner = new FileBanner(parent);
  QObject::connect(document, &Document::programLoaded, banner, [banner, messages, document] {
    if (document->live()) {
      messages->settle(alarm::Code::FileChanged);
      messages->settle(alarm::Code::FileGone);
    }
    const gcode::Program& program = *document->program();
    banner->setProgram(QString::fromStdString(program.name), QString::fromStdString(program.hash));
    banner->setState(FileBanner::State::Same);
  });
  QObject::connect(document, &Document::fileStateChanged, banner,
                   [banner, messages, document](session::FileWatch::State state) {
                     const std::string path = document->path().toStdString();
                     switch (state) {
                       case session::FileWatch::State::Same:
                         banner->setState(FileBanner::State::Same);
                         messages->settle(alarm::Code::FileChanged);
                         messages->settle(alarm::Code::FileGone);
                         return;
                       case session::FileWatch::State::Changed:
                         banner->setState(FileBanner::State::Changed);
                         messages->settle(alarm::Code::FileGone);
                         messages->raise(alarm::Code::FileChanged, {path});
                         return;
                       case session::FileWatch::State::Gone:
                         banner->setState(FileBanner::State::Gone);
                         messages->raise(alarm::Code::FileGone, {path});
                         return;
                     }
                   });
  QObject::connect(banner, &FileBanner::reloadRequested, document,
                   [document] { document->readAgain(document->reading()); });
  QObject::connect(runs, &RunController::permissionsChanged, banner,
                   [banner, runs] { banner->setRunning(runs->isRunning()); });
  return banner;
}

}  // namespace rivulet::hmi
