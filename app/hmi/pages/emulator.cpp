// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page Emulator: from recordings to a virtual machine that answers like the real one.

#include <QCoreApplication>

#include "hmi/emulator_learning.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "machine/config.h"
#include "session/background.h"
#include "widgets/common/error_text.h"
#include "widgets/emulator/emulator_page.h"
#include "widgets/emulator/overlay_panel.h"

namespace rivulet::hmi {

using widgets::EmulatorPage;
using widgets::OverlayPanel;

namespace {

struct EmulatorPageTexts {
  Q_DECLARE_TR_FUNCTIONS(EmulatorPageTexts)

 public:
  static QString inProgress() {
    return tr(
        "A run is in progress. Learn after it has ended: both would take the same processor.");
  }
};

}  // namespace

QWidget* makeEmulatorPage(RunController* runs, EmulatorLearning* learning, QWidget* parent) {
  auto* page = new EmulatorPage(parent);
  page->overlay()->setRunner(&session::runInBackground);
  const auto showRecordings = [page, learning] { page->setRecordings(learning->recordings()); };
  const auto showPreset = [page, learning] {
    QStringList names;
    for (const std::string& name : machine::presetNames()) {
      names.append(QString::fromStdString(name));
    }
    page->setPresets(names, learning->preset());
  };
  const auto block = [page, runs] {
    page->setBlocked(runs->isRunning() ? EmulatorPageTexts::inProgress() : QString());
  };
  QObject::connect(learning, &EmulatorLearning::recordingsChanged, page, showRecordings);
  QObject::connect(learning, &EmulatorLearning::presetChanged, page, showPreset);
  QObject::connect(learning, &EmulatorLearning::started, page, &EmulatorPage::startLearning);
  QObject::connect(learning, &EmulatorLearning::progressed, page, &EmulatorPage::addProgress);
  QObject::connect(learning, &EmulatorLearning::ended, page, &EmulatorPage::endLearning);
  QObject::connect(learning, &EmulatorLearning::learned, page, &EmulatorPage::setEmulator);
  QObject::connect(learning, &EmulatorLearning::comparing, page, &EmulatorPage::showComparing);
  QObject::connect(learning, &EmulatorLearning::compared, page, &EmulatorPage::setCrossTest);
  QObject::connect(learning, &EmulatorLearning::saved, page, &EmulatorPage::showSaved);
  QObject::connect(learning, &EmulatorLearning::failed, page, [page](const base::Error& error) {
    page->showProblem(widgets::errorText(error));
  });
  QObject::connect(learning, &EmulatorLearning::overlayDrawn, page->overlay(),
                   &OverlayPanel::setOverlay);
  QObject::connect(page, &EmulatorPage::addRequested, learning, &EmulatorLearning::add);
  QObject::connect(page, &EmulatorPage::removeRequested, learning, &EmulatorLearning::remove);
  QObject::connect(page, &EmulatorPage::programChosen, learning, &EmulatorLearning::setProgram);
  QObject::connect(page, &EmulatorPage::useChosen, learning, &EmulatorLearning::setUse);
  QObject::connect(page, &EmulatorPage::presetChosen, learning, &EmulatorLearning::setPreset);
  QObject::connect(page, &EmulatorPage::learnRequested, learning, &EmulatorLearning::learn);
  QObject::connect(page, &EmulatorPage::compareRequested, learning, &EmulatorLearning::compare);
  QObject::connect(page, &EmulatorPage::cancelRequested, learning, &EmulatorLearning::cancel);
  QObject::connect(page, &EmulatorPage::saveRequested, learning, &EmulatorLearning::save);
  QObject::connect(
      page->overlay(), &OverlayPanel::overlayRequested, learning,
      [page, learning](int run) { learning->drawOverlay(run, page->overlay()->names()); });
  QObject::connect(runs, &RunController::started, learning, &EmulatorLearning::cancel);
  QObject::connect(runs, &RunController::permissionsChanged, page, block);
  showRecordings();
  showPreset();
  block();
  return page;
}

}  // namespace rivulet::hmi
