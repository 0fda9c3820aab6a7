// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page on which a machine is made ready for streaming.

#include <QCoreApplication>

#include "hmi/certificates.h"
#include "hmi/control_tests.h"
#include "hmi/document.h"
#include "hmi/logins.h"
#include "hmi/machine_model.h"
#include "hmi/machine_profiles.h"
#include "hmi/messages.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "hmi/users.h"
#include "machine/config.h"
#include "report/known_machine.h"
#include "widgets/setup/profile_page.h"
#include "widgets/setup/set_up_page.h"

namespace rivulet::hmi {

using widgets::ProfilePage;
using widgets::SetUpPage;
using widgets::Status;

namespace {

struct SetUpTexts {
  Q_DECLARE_TR_FUNCTIONS(SetUpTexts)
};

ProfilePage* makeProfilePage(MachineModel* machine, MachineProfiles* profiles) {
  auto* page = new ProfilePage;
  QStringList presets;
  for (const std::string& name : machine::presetNames()) {
    presets.push_back(QString::fromStdString(name));
  }
  page->setPresets(presets);
  const auto show = [page, profiles] {
    page->setFunctions(profiles->functions());
    page->setProfile(profiles->shown(), profiles->profile().has_value());
  };
  const auto block = [page, machine, profiles] {
    page->setBlocked(!machine->isConnected()
                         ? SetUpTexts::tr("Connect first: limits belong to one machine.")
                     : profiles->canSave()
                         ? QString()
                         : SetUpTexts::tr("Only an engineer can do this, and not during a run."));
  };
  QObject::connect(profiles, &MachineProfiles::changed, page, show);
  QObject::connect(profiles, &MachineProfiles::permissionsChanged, page, block);
  QObject::connect(page, &ProfilePage::saveRequested, profiles, &MachineProfiles::save);
  QObject::connect(page, &ProfilePage::functionsSaveRequested, profiles,
                   &MachineProfiles::saveFunctions);
  QObject::connect(page, &ProfilePage::presetRequested, page, [page](const QString& name) {
    if (const auto profile = report::profileOfPreset(name.toStdString())) {
      page->takeOver(*profile);
    }
  });
  show();
  block();
  return page;
}

/// What has been done, and still holds.
void showStatus(SetUpPage* page, MachineModel* machine, ControlTests* tests,
                MachineProfiles* profiles, const std::vector<QWidget*>& steps) {
  const bool isConnected = machine->isConnected();
  const auto state = [](bool isThere, bool isOutdated) {
    return !isThere ? Status::Unknown : isOutdated ? Status::Attention : Status::Good;
  };
  page->setStatus(steps[0], isConnected ? Status::Good : Status::Unknown);
  page->setStatus(steps[1], state(profiles->profile().has_value(), false));
  page->setStatus(steps[3],
                  state(machine->calibration() != nullptr, machine->isCalibrationOutdated()));
  const auto tested = [&](const auto& test, bool isEnough) {
    return test && !test->result.passed()
               ? Status::Fault
               : state(test.has_value(), tests->isOutdated(test) || !isEnough);
  };
  const auto& feed = tests->feedTest();
  page->setStatus(steps[4], tested(feed, feed && feed->result.proves()));
  page->setStatus(steps[5], tested(tests->jobTest(), true));
  page->setStatus(steps[6], tested(tests->test(), true));
}

}  // namespace

QWidget* makeSetUpPage(Messages* messages, Users* users, MachineModel* machine, Document* document,
                       RunController* runs, ControlTests* tests, MachineProfiles* profiles,
                       Certificates* certificates, Logins* logins, QWidget* parent) {
  auto* page = new SetUpPage(parent);
  const std::vector<QWidget*> steps{
      makeConnectionPanel(machine, runs, logins),
      makeProfilePage(machine, profiles),
      makeTemplatePage(messages, document, nullptr),
      makeCalibrationPage(machine, runs, nullptr),
      makeCommissioningPage(messages, machine, tests, session::TestKind::FeedCell, nullptr),
      makeCommissioningPage(messages, machine, tests, session::TestKind::Jobs, nullptr),
      makeCommissioningPage(messages, machine, tests, session::TestKind::Credit, nullptr),
      makeCertificatesPage(users, machine, runs, certificates, nullptr),
      makeRightsPage(machine, runs, nullptr)};
  page->addStep(steps[0], [] { return SetUpTexts::tr("Connection"); });
  page->addStep(steps[1], [] { return SetUpTexts::tr("Limits"); });
  page->addStep(steps[2], [] { return SetUpTexts::tr("Template"); });
  page->addStep(steps[3], [] { return SetUpTexts::tr("Calibration"); });
  page->addStep(steps[4], [] { return SetUpTexts::tr("Stop test"); });
  page->addStep(steps[5], [] { return SetUpTexts::tr("Job test"); });
  page->addStep(steps[6], [] { return SetUpTexts::tr("Credit test"); });
  page->addStep(steps[7], [] { return SetUpTexts::tr("Certificates"); });
  page->addStep(steps[8], [] { return SetUpTexts::tr("Rights"); });
  const auto show = [page, steps, machine, tests, profiles] {
    showStatus(page, machine, tests, profiles, steps);
  };
  QObject::connect(machine, &MachineModel::linkChanged, page, show);
  QObject::connect(machine, &MachineModel::calibrationChanged, page, show);
  QObject::connect(profiles, &MachineProfiles::changed, page, show);
  QObject::connect(tests, &ControlTests::testChanged, page, show);
  show();
  return page;
}

}  // namespace rivulet::hmi
