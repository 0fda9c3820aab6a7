// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The services on the board of machines.

#include <QCoreApplication>

#include "hmi/certificates.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "hmi/services.h"
#include "hmi/users.h"
#include "widgets/common/error_text.h"
#include "widgets/connection/certificates_page.h"
#include "widgets/connection/machines_page.h"
#include "widgets/connection/service_panel.h"

namespace rivulet::hmi {

namespace {

struct ServiceTexts {
  Q_DECLARE_TR_FUNCTIONS(ServiceTexts)
};

void connectTrust(Services* services, Certificates* certificates, widgets::ServicePanel& panel) {
  using widgets::ServicePanel;
  QObject::connect(&panel, &ServicePanel::certificateAccepted, services,
                   [services, panel = &panel] { services->accept(panel->endpoint()); });
  QObject::connect(&panel, &ServicePanel::choiceAllowed, services,
                   [services, panel = &panel](const opcua::SecurityChoice& choice) {
                     services->allow(panel->endpoint(), choice);
                   });
  QObject::connect(&panel, &ServicePanel::declined, services, [services, panel = &panel] {
    services->decline(panel->endpoint());
    Q_EMIT panel->closeRequested();
  });
  QObject::connect(
      &panel, &ServicePanel::exportRequested, certificates, [panel = &panel, certificates] {
        widgets::askForCertificateFile(
            panel, [certificates](const QString& path) { certificates->exportOwn(path); });
      });
  QObject::connect(certificates, &Certificates::changed, &panel, [panel = &panel, certificates] {
    panel->setOwnCertificate(certificates->view().own);
  });
  panel.setOwnCertificate(certificates->view().own);
}

}  // namespace

void connectServices(Users* users, RunController* runs, Services* services,
                     Certificates* certificates, widgets::MachinesPage& page) {
  using widgets::MachinesPage;
  using widgets::ServicePanel;
  ServicePanel* panel = page.servicePanel();
  const auto show = [services, page = &page] { page->setServices(services->views()); };
  QObject::connect(services, &Services::changed, &page, show);
  show();
  QObject::connect(&page, &MachinesPage::addServiceRequested, services,
                   [services, page = &page](const QString& endpoint) {
                     if (services->add(endpoint)) {
                       page->clearAddress();
                       page->setFound({}, {});
                     } else {
                       page->setFound({}, ServiceTexts::tr("This service is on the board."));
                     }
                   });
  QObject::connect(&page, &MachinesPage::removeServiceRequested, services, &Services::remove);
  QObject::connect(&page, &MachinesPage::searchRequested, services,
                   [services, page = &page](const QString& address) {
                     page->setFound({}, ServiceTexts::tr("Searching …"));
                     services->search(address);
                   });
  QObject::connect(services, &Services::searched, &page,
                   [page = &page](const QStringList& endpoints, const base::Error& problem) {
                     page->setFound(endpoints,
                                    problem.code ? widgets::errorText(problem)
                                    : endpoints.isEmpty()
                                        ? ServiceTexts::tr("No other services are known there.")
                                        : QString());
                   });
  QObject::connect(panel, &ServicePanel::callRequested, services,
                   [services, panel](const QString& method, const QStringList& inputs) {
                     services->call(panel->endpoint(), method, inputs);
                   });
  QObject::connect(panel, &ServicePanel::loginRequested, services,
                   [services, panel](const QString& user, const QString& pin) {
                     services->logIn(panel->endpoint(), user, pin);
                   });
  QObject::connect(services, &Services::answered, panel,
                   [panel](const QString& endpoint, const QString& method, bool accepted,
                           const QString& message, const QString& confirmation) {
                     if (endpoint == panel->endpoint()) {
                       panel->setAnswer(method, accepted, message, confirmation);
                     }
                   });
  connectTrust(services, certificates, *panel);
  const auto block = [page = &page, panel, users] {
    const auto refused = [users](permission::Act act) {
      return users->refusal(act, false) ? ServiceTexts::tr("Only an engineer can do this.")
                                        : QString();
    };
    page->setServicesBlocked(refused(permission::Act::ChangeSettings));
    panel->setTrustBlocked(refused(permission::Act::Trust));
  };
  QObject::connect(runs, &RunController::permissionsChanged, &page, block);
  block();
}

}  // namespace rivulet::hmi
