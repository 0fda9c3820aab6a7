// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page CNC tasks: its Petri net is played, and its tasks execute a program.

#include <QCoreApplication>
#include <QFileInfo>

#include "cnc/real_time.h"
#include "hmi/document.h"
#include "hmi/net_player.h"
#include "hmi/pages/pages.h"
#include "hmi/pipeline_run.h"
#include "hmi/run_controller.h"
#include "widgets/pipeline/net_panel.h"
#include "widgets/pipeline/parallel_page.h"
#include "widgets/pipeline/task_panel.h"

namespace rivulet::hmi {

using widgets::NetPanel;
using widgets::TaskPanel;

namespace {

struct ParallelPageTexts {
  Q_DECLARE_TR_FUNCTIONS(ParallelPageTexts)

 public:
  static QString inProgress() {
    return tr(
        "A run is in progress. Execute the program after it has ended: both would take the "
        "same processor.");
  }
};

void connectNet(NetPlayer* player, NetPanel* net) {
  const auto show = [net, player] { net->setState(player->state()); };
  QObject::connect(player, &NetPlayer::changed, net, show);
  QObject::connect(net, &NetPanel::choiceChanged, player, &NetPlayer::choose);
  QObject::connect(net, &NetPanel::stepRequested, player, &NetPlayer::step);
  QObject::connect(net, &NetPanel::playRequested, player, &NetPlayer::setPlaying);
  QObject::connect(net, &NetPanel::restartRequested, player, &NetPlayer::restart);
  QObject::connect(net, &NetPanel::speedChosen, player, &NetPlayer::setSpeed);
  show();
}

/// Nothing else in the window needs the tasks: they are the panel's.
void connectTasks(Document* document, RunController* runs, TaskPanel* panel) {
  auto* tasks = new PipelineRun(panel);
  const auto show = [panel, tasks] { panel->setView(tasks->view()); };
  const auto showProgram = [panel, document] {
    panel->setProgram(document->program() ? QFileInfo(document->path()).fileName() : QString());
  };
  const auto block = [panel, runs] {
    panel->setBlocked(runs->isRunning() ? ParallelPageTexts::inProgress() : QString());
  };
  QObject::connect(tasks, &PipelineRun::changed, panel, show);
  QObject::connect(panel, &TaskPanel::startRequested, tasks,
                   [tasks, document](const widgets::PipelineChoice& choice) {
                     tasks->start(choice, choice.isExample ? QString() : document->path());
                   });
  QObject::connect(panel, &TaskPanel::stopRequested, tasks, &PipelineRun::stop);
  QObject::connect(panel, &TaskPanel::openRequested, tasks, &PipelineRun::open);
  QObject::connect(panel, &TaskPanel::saveRequested, tasks, &PipelineRun::save);
  QObject::connect(document, &Document::programLoaded, panel, showProgram);
  QObject::connect(runs, &RunController::started, tasks, &PipelineRun::stop);
  QObject::connect(runs, &RunController::permissionsChanged, panel, block);
  panel->setRealTimeAllowed(cnc::grantsRealTime());
  showProgram();
  block();
  show();
}

}  // namespace

QWidget* makeParallelPage(Document* document, RunController* runs, NetPlayer* player,
                          QWidget* parent) {
  auto* page = new widgets::ParallelPage(parent);
  connectNet(player, page->net());
  connectTasks(document, runs, page->tasks());
  return page;
}

}  // namespace rivulet::hmi
