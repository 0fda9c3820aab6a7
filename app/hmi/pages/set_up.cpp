// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page on which a machine is made ready for streaming.

#include <QCoreApplication>

#include "hmi/pages/pages.h"
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

ProfilePage* makeProfilePage(const Models& models) {
  auto* page = new ProfilePage;
  MachineProfiles* profiles = &models.profiles;
  QStringList presets;
  for (const std::string& name : machine::presetNames()) {
    presets.push_back(QString::fromStdString(name));
  }
  page->setPresets(presets);
  const auto show = [page, profiles] {
    page->setFunctions(profiles->functions());
    page->setProfile(profiles->shown(), profiles->profile().has_value());
  };
  const auto block = [page, models] {
    page->setBlocked(!models.machine.isConnected()
                         ? SetUpTexts::tr("Connect first: limits belong to one machine.")
                     : models.profiles.canSave()
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
void showStatus(SetUpPage* page, const Models& models, const std::vector<QWidget*>& steps) {
  const bool isConnected = models.machine.isConnected();
  const auto state = [](bool isThere, bool isOutdated) {
    return !isThere ? Status::Unknown : isOutdated ? Status::Attention : Status::Good;
  };
  page->setStatus(steps[0], isConnected ? Status::Good : Status::Unknown);
  page->setStatus(steps[1], state(models.profiles.profile().has_value(), false));
  page->setStatus(steps[3], state(models.machine.calibration() != nullptr,
                                  models.machine.isCalibrationOutdated()));
  const auto& test = models.credit.test();
  page->setStatus(steps[4], test && !test->result.passed()
                                ? Status::Fault
                                : state(test.has_value(), models.credit.isOutdated()));
}

}  // namespace

QWidget* makeSetUpPage(const Models& models, QWidget* parent) {
  auto* page = new SetUpPage(parent);
  const std::vector<QWidget*> steps{makeConnectionPanel(models),
                                    makeProfilePage(models),
                                    makeTemplatePage(models, nullptr),
                                    makeCalibrationPage(models, nullptr),
                                    makeCommissioningPage(models, nullptr),
                                    makeCertificatesPage(models, nullptr),
                                    makeRightsPage(models, nullptr)};
  page->addStep(steps[0], [] { return SetUpTexts::tr("Connection"); });
  page->addStep(steps[1], [] { return SetUpTexts::tr("Limits"); });
  page->addStep(steps[2], [] { return SetUpTexts::tr("Template"); });
  page->addStep(steps[3], [] { return SetUpTexts::tr("Calibration"); });
  page->addStep(steps[4], [] { return SetUpTexts::tr("Credit test"); });
  page->addStep(steps[5], [] { return SetUpTexts::tr("Certificates"); });
  page->addStep(steps[6], [] { return SetUpTexts::tr("Rights"); });
  const auto show = [page, models, steps] { showStatus(page, models, steps); };
  QObject::connect(&models.machine, &MachineModel::linkChanged, page, show);
  QObject::connect(&models.machine, &MachineModel::calibrationChanged, page, show);
  QObject::connect(&models.profiles, &MachineProfiles::changed, page, show);
  QObject::connect(&models.credit, &CreditCommissioning::testChanged, page, show);
  show();
  return page;
}

}  // namespace rivulet::hmi
