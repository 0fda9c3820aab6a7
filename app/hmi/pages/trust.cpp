// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Pages about trust: what has to be decided before a machine is connected, and certificates.

#include <QCoreApplication>

#include "hmi/certificates.h"
#include "hmi/machine_model.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "hmi/users.h"
#include "widgets/connection/certificates_page.h"
#include "widgets/connection/rights_page.h"
#include "widgets/connection/trust_sheet.h"

namespace rivulet::hmi {

using widgets::CertificatesPage;
using widgets::RightsPage;
using widgets::TrustSheet;

namespace {

struct TrustTexts {
  Q_DECLARE_TR_FUNCTIONS(TrustTexts)
};

/// Why this user may not decide whom to trust; empty: they may.
QString trustBlocked(Users* users) {
  return users->refusal(permission::Act::Trust, false)
             ? TrustTexts::tr("Only an engineer can do this.")
             : QString();
}

}  // namespace

QWidget* makeTrustSheet(Users* users, MachineModel* machine, RunController* runs,
                        Certificates* certificates, QWidget* parent) {
  auto* sheet = new TrustSheet(parent);
  QObject::connect(machine, &MachineModel::linkChanged, sheet, [sheet, machine, certificates] {
    const auto& question = machine->link().question;
    if (question && question != sheet->question()) {
      certificates->refresh();  // this computer's may have been made for the attempt
    }
    sheet->setQuestion(question && widgets::isOnSheet(*question) ? question : nullptr);
  });
  QObject::connect(certificates, &Certificates::changed, sheet,
                   [sheet, certificates] { sheet->setOwnCertificate(certificates->view().own); });
  QObject::connect(sheet, &TrustSheet::certificateAccepted, machine,
                   &MachineModel::acceptCertificate);
  QObject::connect(sheet, &TrustSheet::choiceAllowed, machine, &MachineModel::allow);
  QObject::connect(sheet, &TrustSheet::declined, machine, &MachineModel::dropQuestion);
  QObject::connect(sheet, &TrustSheet::exportRequested, certificates, [sheet, certificates] {
    widgets::askForCertificateFile(
        sheet, [certificates](const QString& path) { certificates->exportOwn(path); });
  });
  const auto block = [sheet, users] { sheet->setBlocked(trustBlocked(users)); };
  QObject::connect(runs, &RunController::permissionsChanged, sheet, block);
  block();
  return sheet;
}

QWidget* makeCertificatesPage(Users* users, MachineModel* machine, RunController* runs,
                              Certificates* certificates, QWidget* parent) {
  auto* page = new CertificatesPage(parent);
  const auto show = [page, certificates] { page->setCertificates(certificates->view()); };
  QObject::connect(certificates, &Certificates::changed, page, show);
  QObject::connect(machine, &MachineModel::linkChanged, certificates, &Certificates::refresh);
  QObject::connect(page, &CertificatesPage::exportRequested, certificates,
                   &Certificates::exportOwn);
  QObject::connect(page, &CertificatesPage::renewRequested, certificates, &Certificates::renewOwn);
  QObject::connect(page, &CertificatesPage::forgetRequested, certificates, &Certificates::forget);
  QObject::connect(page, &CertificatesPage::strengthenRequested, certificates,
                   &Certificates::strengthen);
  QObject::connect(page, &CertificatesPage::acceptRequested, certificates,
                   &Certificates::acceptRejected);
  QObject::connect(page, &CertificatesPage::dropRequested, certificates,
                   &Certificates::dropRejected);
  const auto block = [page, users] { page->setBlocked(trustBlocked(users)); };
  QObject::connect(runs, &RunController::permissionsChanged, page, block);
  block();
  show();
  return page;
}

QWidget* makeRightsPage(MachineModel* machine, RunController* runs, QWidget* parent) {
  auto* page = new RightsPage(parent);
  QObject::connect(page, &RightsPage::examineRequested, machine, &MachineModel::examineRights);
  QObject::connect(
      machine, &MachineModel::rightsSeen, page,
      [page](const session::RightsSeen& seen) { page->setReport(seen.report, seen.error); });
  QObject::connect(machine, &MachineModel::linkChanged, page,
                   [page] { page->setReport(std::nullopt); });
  const auto block = [page, machine, runs] {
    page->setBlocked(!machine->isConnected() ? TrustTexts::tr("Connect first.")
                     : runs->isRunning() || runs->isCalibrating()
                         ? TrustTexts::tr("During a run there is no time for it.")
                         : QString());
  };
  QObject::connect(runs, &RunController::permissionsChanged, page, block);
  QObject::connect(machine, &MachineModel::linkChanged, page, block);
  block();
  return page;
}

}  // namespace rivulet::hmi
