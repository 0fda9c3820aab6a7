// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Pages about trust: what has to be decided before a machine is connected, and certificates.

#include <QCoreApplication>

#include "hmi/certificates.h"
#include "hmi/pages/pages.h"
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
QString trustBlocked(const Models& models) {
  return models.users.refusal(permission::Act::Trust, false)
             ? TrustTexts::tr("Only an engineer can do this.")
             : QString();
}

}  // namespace

QWidget* makeTrustSheet(const Models& models, QWidget* parent) {
  auto* sheet = new TrustSheet(parent);
  MachineModel* machine = &models.machine;
  Certificates* certificates = &models.certificates;
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
    const QString path = widgets::askForCertificateFile(sheet);
    if (!path.isEmpty()) {
      certificates->exportOwn(path);
    }
  });
  const auto block = [sheet, models] { sheet->setBlocked(trustBlocked(models)); };
  QObject::connect(&models.runs, &RunController::permissionsChanged, sheet, block);
  block();
  return sheet;
}

QWidget* makeCertificatesPage(const Models& models, QWidget* parent) {
  auto* page = new CertificatesPage(parent);
  Certificates* certificates = &models.certificates;
  const auto show = [page, certificates] { page->setCertificates(certificates->view()); };
  QObject::connect(certificates, &Certificates::changed, page, show);
  QObject::connect(&models.machine, &MachineModel::linkChanged, certificates,
                   &Certificates::refresh);
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
  const auto block = [page, models] { page->setBlocked(trustBlocked(models)); };
  QObject::connect(&models.runs, &RunController::permissionsChanged, page, block);
  block();
  show();
  return page;
}

QWidget* makeRightsPage(const Models& models, QWidget* parent) {
  auto* page = new RightsPage(parent);
  MachineModel* machine = &models.machine;
  QObject::connect(page, &RightsPage::examineRequested, machine, &MachineModel::examineRights);
  QObject::connect(
      machine, &MachineModel::rightsSeen, page,
      [page](const session::RightsSeen& seen) { page->setReport(seen.report, seen.error); });
  QObject::connect(machine, &MachineModel::linkChanged, page,
                   [page] { page->setReport(std::nullopt); });
  const auto block = [page, models] {
    page->setBlocked(!models.machine.isConnected() ? TrustTexts::tr("Connect first.")
                     : models.runs.isRunning() || models.runs.isCalibrating()
                         ? TrustTexts::tr("During a run there is no time for it.")
                         : QString());
  };
  QObject::connect(&models.runs, &RunController::permissionsChanged, page, block);
  QObject::connect(machine, &MachineModel::linkChanged, page, block);
  block();
  return page;
}

}  // namespace rivulet::hmi
