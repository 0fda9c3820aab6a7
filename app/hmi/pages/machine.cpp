// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Pages about the machine: connection, calibration, and the program it is to be given.

#include <QCoreApplication>
#include <QTimer>

#include "hmi/alarms.h"
#include "hmi/control_tests.h"
#include "hmi/document.h"
#include "hmi/logins.h"
#include "hmi/machine_model.h"
#include "hmi/machine_profiles.h"
#include "hmi/machines.h"
#include "hmi/messages.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "qtopcua/open_link.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/commissioning/commissioning_page.h"
#include "widgets/common/blocked_text.h"
#include "widgets/common/error_text.h"
#include "widgets/connection/connection_panel.h"
#include "widgets/connection/machine_button.h"
#include "widgets/connection/machines_page.h"
#include "widgets/connection/position_line.h"
#include "widgets/program/program_page.h"
#include "widgets/templates/template_page.h"

namespace rivulet::hmi {

using widgets::CalibrationPage;
using widgets::ConnectionPanel;

namespace {

/// The age of a look is shown in seconds.
constexpr int kLookMs = 1000;

struct MachinesTexts {
  Q_DECLARE_TR_FUNCTIONS(MachinesTexts)
};

}  // namespace

QWidget* makeConnectionPanel(MachineModel* machine, RunController* runs, Logins* logins) {
  auto* panel = new ConnectionPanel;
  panel->setEndpoint(machine->endpoint());
  QObject::connect(panel, &ConnectionPanel::connectRequested, machine, &MachineModel::connectAs);
  QObject::connect(logins, &Logins::changed, panel,
                   [panel, logins] { panel->setLogin(logins->view()); });
  panel->setLogin(logins->view());
  panel->setHasQtOpcUa(qtopcua::isAvailable(opcua::LinkKind::QtOpcUa));
  panel->setControl(machine->control());
  QObject::connect(panel, &ConnectionPanel::disconnectRequested, machine,
                   &MachineModel::disconnectFrom);
  QObject::connect(machine, &MachineModel::endpointChanged, panel, [panel, machine] {
    panel->setEndpoint(machine->endpoint());
    panel->setControl(machine->control());
  });
  QObject::connect(machine, &MachineModel::linkChanged, panel, [panel, machine] {
    const base::Error& error = machine->link().error;
    panel->setConnectionState(machine->connectionState(),
                              error.code ? widgets::errorText(error) : QString());
    panel->setProtection(machine->protection(), machine->link().security);
  });
  QObject::connect(machine, &MachineModel::viewChanged, panel,
                   [panel, machine] { panel->setMachineState(machine->view()); });
  QObject::connect(runs, &RunController::permissionsChanged, panel, [panel, runs] {
    panel->setDisconnectEnabled(!runs->isRunning() && !runs->isCalibrating());
  });
  return panel;
}

QToolButton* makeMachineButton(MachineModel* machine, QWidget* parent) {
  auto* button = new widgets::MachineButton(parent);
  QObject::connect(machine, &MachineModel::linkChanged, button, [button, machine] {
    const auto& security = machine->link().security;
    button->setConnectionState(
        machine->connectionState(), machine->protection(),
        security ? QString::fromStdString(opcua::securityText(*security)) : QString());
  });
  QObject::connect(machine, &MachineModel::viewChanged, button,
                   [button, machine] { button->setMachineState(machine->view()); });
  return button;
}

widgets::MachinesPage* makeMachinesPage(Messages* messages, Alarms* alarms, MachineModel* machine,
                                        RunController* runs, MachineProfiles* profiles,
                                        Machines* machines, QWidget* parent) {
  auto* page = new widgets::MachinesPage(parent);
  const auto show = [page, machines, alarms] {
    std::vector<widgets::MachineCardView> cards = machines->cards();
    for (widgets::MachineCardView& card : cards) {
      card.alarms = card.isPresent ? alarms->list().shownCount() : 0;
    }
    page->setMachines(cards);
  };
  const auto showIfSeen = [page, show] {
    if (page->isVisible()) {
      show();
    }
  };
  QObject::connect(machines, &Machines::changed, page, show);
  QObject::connect(alarms, &Alarms::changed, page, show);
  QObject::connect(profiles, &MachineProfiles::changed, machines, &Machines::refresh);
  QObject::connect(machine, &MachineModel::viewChanged, page, showIfSeen);
  QObject::connect(runs, &RunController::updated, page, showIfSeen);
  QObject::connect(page, &widgets::MachinesPage::removeRequested, machines, &Machines::remove);
  QObject::connect(machines, &Machines::removed, page,
                   [messages, machine](const QString& endpoint) {
                     messages->didAct(permission::Act::ChangeSettings,
                                      {{"machine", endpoint.toStdString()}, {"removed", "true"}});
                   });
  QObject::connect(machines, &Machines::removeFailed, page, [messages](const base::Error& error) {
    messages->show(gcode::Severity::Error, [error] { return widgets::errorText(error); });
  });
  auto* looks = new QTimer(page);
  looks->start(kLookMs);
  QObject::connect(looks, &QTimer::timeout, page, [page, machines, show] {
    if (page->isVisible()) {
      machines->look();
      show();  // what was seen gets older
    }
  });
  QObject::connect(page, &widgets::MachinesPage::openRequested, machines,
                   [page, machines](const QString& endpoint) {
                     machines->open(endpoint);
                     if (auto* program = page->window()->findChild<widgets::ProgramPage*>()) {
                       showPageOf(program);
                     }
                   });
  const auto block = [page, machines] {
    page->setBlocked(machines->canChange()
                         ? QString()
                         : MachinesTexts::tr("During a run, the window stays with its machine."));
  };
  QObject::connect(runs, &RunController::permissionsChanged, page, block);
  return page;
}

QWidget* makePositionLine(MachineModel* machine, QWidget* parent) {
  auto* line = new widgets::PositionLine(parent);
  QObject::connect(machine, &MachineModel::viewChanged, line,
                   [line, machine] { line->setMachineState(machine->view()); });
  return line;
}

QWidget* makeCalibrationPage(MachineModel* machine, RunController* runs, QWidget* parent) {
  auto* page = new CalibrationPage(parent);
  QObject::connect(page, &CalibrationPage::calibrationRequested, runs, &RunController::calibrate);
  QObject::connect(page, &CalibrationPage::cancelRequested, runs,
                   &RunController::cancelCalibration);
  QObject::connect(
      runs, &RunController::calibrationProgressed, page,
      [page](const streaming::CalibrationProgress& progress) { page->setProgress(progress); });
  QObject::connect(runs, &RunController::permissionsChanged, page, [page, runs] {
    page->setBlocked(widgets::blockedText(runs->calibrationBlocked()));
  });
  QObject::connect(machine, &MachineModel::calibrationEnded, page,
                   [page] { page->setProgress(std::nullopt); });
  QObject::connect(machine, &MachineModel::calibrationChanged, page, [page, machine] {
    page->setRecord(machine->calibration(), machine->isCalibrationOutdated());
  });
  return page;
}

QWidget* makeCommissioningPage(Messages* messages, MachineModel* machine, ControlTests* tests,
                               session::TestKind kind, QWidget* parent) {
  using session::TestKind;
  auto* page = new widgets::CommissioningPage(kind == TestKind::FeedCell ? widgets::feedTestTexts()
                                              : kind == TestKind::Jobs   ? widgets::jobTestTexts()
                                                                       : widgets::creditTestTexts(),
                                              parent);
  QObject::connect(
      page, &widgets::CommissioningPage::testRequested, tests,
      [=](int firstCell, bool isByHand, const std::optional<streaming::AirMove>& move,
          const std::vector<std::string>& blocks) {
        if (tests->blocked()) {
          return;
        }
        tests->start({kind, firstCell,
                      isByHand ? streaming::TransferWay::ByHand : streaming::TransferWay::Link,
                      move, blocks});
        std::vector<std::pair<std::string, std::string>> facts{
            {"machine", machine->endpoint().toStdString()},
            {"test", kind == TestKind::FeedCell ? "feed-cell"
                     : kind == TestKind::Jobs   ? "jobs"
                                                : "credit"},
            {"first_cell", std::to_string(firstCell)}};
        if (move) {
          facts.emplace_back("air_move", streaming::describe(*move));
        }
        for (const std::string& block : blocks) {
          facts.emplace_back("block", block);
        }
        messages->didAct(permission::Act::Calibrate, facts);
      });
  QObject::connect(page, &widgets::CommissioningPage::blockConfirmed, tests,
                   [=](std::size_t index) {
                     messages->didAct(permission::Act::Calibrate,
                                      {{"machine", machine->endpoint().toStdString()},
                                       {"block_seen", std::to_string(index + 1)}});
                     tests->confirmBlock(index);
                   });
  QObject::connect(page, &widgets::CommissioningPage::cancelRequested, tests,
                   &ControlTests::cancel);
  QObject::connect(tests, &ControlTests::progressed, page,
                   [=](TestKind of, const std::optional<streaming::CommissioningStep>& step) {
                     page->setProgress(of == kind ? step : std::nullopt);
                   });
  QObject::connect(tests, &ControlTests::testChanged, page, [=] {
    const auto show = [&](const auto& test) {
      page->setTest(test ? std::optional(widgets::shownTest(*test)) : std::nullopt,
                    tests->isOutdated(test));
    };
    kind == TestKind::FeedCell ? show(tests->feedTest())
    : kind == TestKind::Jobs   ? show(tests->jobTest())
                               : show(tests->test());
  });
  QObject::connect(tests, &ControlTests::failed, page, [=](TestKind of, const base::Error& error) {
    if (of == kind) {
      page->setProblem(widgets::errorText(error));
    }
  });
  const auto block = [=] { page->setBlocked(widgets::blockedText(tests->blocked())); };
  QObject::connect(tests, &ControlTests::permissionsChanged, page, block);
  block();
  return page;
}

QWidget* makeTemplatePage(Messages* messages, Document* document, QWidget* parent) {
  auto* page = new widgets::TemplatePage(parent);
  QObject::connect(document, &Document::judged, page, [page, document] {
    const Findings& findings = document->findings();
    if (!findings.flexible) {
      page->setProblem(widgets::errorText(*findings.settingsError));
      return;
    }
    page->setTemplate(*findings.flexible);
  });
  QObject::connect(
      page, &widgets::TemplatePage::saveRequested, page,
      [page, messages](const QString& path) { saveText(messages, path, page->text()); });
  QObject::connect(page, &widgets::TemplatePage::sheetRequested, page,
                   [page, messages](const QString& path) {
                     saveSheet(messages, path, page->sheet(QStringLiteral(RIVULET_VERSION)));
                   });
  return page;
}

}  // namespace rivulet::hmi
