// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/certificates_page.h"

#include <QFontDatabase>
#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

#include "widgets/common/error_text.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/connection/certificate_text.h"

namespace rivulet::widgets {

namespace {

/// A certificate that ends sooner is to be renewed.
constexpr int kSoonDays = 30;
constexpr int kTableHeightPx = 150;

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

QString fingerprintCell(const std::string& fingerprint) {
  return text(opcua::fingerprintText(fingerprint));
}

}  // namespace

ServerModel::ServerModel(QObject* parent)
    : TableModel({{[] { return tr("Machine"); },
                   [](const CertificatesView::Server& server) { return text(server.endpoint); }},
                  {[] { return tr("Certificate"); },
                   [](const CertificatesView::Server& server) {
                     return server.fingerprint.empty() ? tr("none accepted")
                            : !server.facts            ? tr("accepted, not kept")
                            : server.daysLeft < 0
                                ? tr("has ended")
                                : tr("valid for %Ln days", nullptr, server.daysLeft);
                   }},
                  {[] { return tr("Protection"); },
                   [](const CertificatesView::Server& server) {
                     return server.allowed.empty() ? tr("the strongest")
                                                   : tr("allowed: %1").arg(text(server.allowed));
                   }},
                  {[] { return tr("Fingerprint"); },
                   [](const CertificatesView::Server& server) {
                     return fingerprintCell(server.fingerprint);
                   }}},
                 parent) {
}

RejectedModel::RejectedModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Machine"); },
            [](const CertificatesView::Rejected& server) { return text(server.endpoint); }},
           {[] { return tr("Issued to"); },
            [](const CertificatesView::Rejected& server) {
              return untrustedText(server.facts.subject);
            }},
           {[] { return tr("Valid"); },
            [](const CertificatesView::Rejected& server) { return validityText(server.facts); }},
           {[] { return tr("Fingerprint"); },
            [](const CertificatesView::Rejected& server) {
              return fingerprintCell(server.facts.fingerprint);
            }}},
          parent) {
}

void askForCertificateFile(QWidget* asker, const std::function<void(const QString&)>& chosen) {
  askWhereToSave(
      asker,
      {CertificatesPage::tr("Save this computer's certificate"), QStringLiteral("rivulet.der"), {}},
      [chosen](const QString& path, auto) { chosen(path); });
}

CertificatesPage::CertificatesPage(QWidget* parent) : Page(parent) {
  setObjectName(QStringLiteral("certificates"));
  inColumn({m_blockedText, makeOwn(), makeServers(), makeRejected(),
            label({.text = QT_TR_NOOP(
                       "Only the very certificates that were accepted are trusted, not who issued "
                       "them. So revocation lists are not needed: forget the machine instead."),
                   .isMuted = true,
                   .wraps = true}),
            spring()},
           this);
  onLanguage(
      [this] {
        m_servers->refresh();
        m_rejected->refresh();
      },
      &CertificatesPage::fitColumns, &CertificatesPage::showOwn, &CertificatesPage::showButtons);
}

QWidget* CertificatesPage::makeOwn() {
  m_ownGroup = group({.text = QT_TR_NOOP("Certificate of this computer")});
  m_days = new StatusLabel(m_ownGroup);
  m_days->setWordWrap(true);
  m_fingerprintTitle = label({.text = QT_TR_NOOP("Fingerprint (SHA-256)"), .isMuted = true});
  m_fingerprint = makeValueLabel(m_ownGroup);
  m_fingerprint->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_library = label({.isMuted = true, .wraps = true});
  m_export = button(
      {.text = QT_TR_NOOP("Save …"),
       .tip = QT_TR_NOOP(
           "Writes the certificate, without its key, for the control's list of trusted clients."),
       .icon = "save",
       .id = "certificate-export"},
      &CertificatesPage::chooseFile);
  m_renew = say(new HoldButton(m_ownGroup),
                {.text = QT_TR_NOOP("Hold: renew"),
                 .tip = QT_TR_NOOP("Makes a new one. Every control has to trust it anew."),
                 .icon = "resume",
                 .id = "certificate-renew",
                 .isTouch = true});
  auto* rows = new QGridLayout(m_ownGroup);
  rows->setHorizontalSpacing(16);
  rows->setColumnStretch(1, 1);
  rows->addWidget(m_days, 0, 0, 1, 2);
  rows->addWidget(m_fingerprintTitle, 1, 0, Qt::AlignTop);
  rows->addWidget(m_fingerprint, 1, 1);
  rows->addWidget(m_library, 2, 0, 1, 2);
  rows->addLayout(inRow({m_export, m_renew, spring()}), 3, 0, 1, 2);
  connect(m_renew, &HoldButton::held, this, &CertificatesPage::renewRequested);
  return m_ownGroup;
}

QWidget* CertificatesPage::makeServers() {
  m_serverGroup = group({.text = QT_TR_NOOP("Machines that are known")});
  m_servers = new ServerModel(this);
  m_serverTable = say(new QTableView(m_serverGroup),
                      {.name = QT_TR_NOOP("Machines that are known"), .id = "servers"});
  m_forget = button({.text = QT_TR_NOOP("Forget"),
                     .tip = QT_TR_NOOP("At the next connection the machine is new."),
                     .icon = "clear",
                     .id = "server-forget"});
  m_strengthen = button({.text = QT_TR_NOOP("Protect again"),
                         .tip = QT_TR_NOOP("Withdraws what was allowed for this machine: from then "
                                           "on, the strongest encryption or no connection."),
                         .icon = "locked",
                         .id = "server-strengthen"});
  m_serverTable->setModel(m_servers);
  styleTable(m_serverTable);
  m_serverTable->setMinimumHeight(kTableHeightPx);
  inColumn({m_serverTable, inRow({m_forget, m_strengthen, spring()})}, m_serverGroup);
  connect(m_serverTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &CertificatesPage::showButtons);
  connect(m_forget, &QPushButton::clicked, this,
          [this] { Q_EMIT forgetRequested(text(chosenServer()->endpoint)); });
  connect(m_strengthen, &QPushButton::clicked, this,
          [this] { Q_EMIT strengthenRequested(text(chosenServer()->endpoint)); });
  return m_serverGroup;
}

QWidget* CertificatesPage::makeRejected() {
  m_rejectedGroup = group({.text = QT_TR_NOOP("Certificates that were refused")});
  m_rejected = new RejectedModel(this);
  m_rejectedTable = say(new QTableView(m_rejectedGroup),
                        {.name = QT_TR_NOOP("Certificates that were refused"), .id = "rejected"});
  m_accept = say(
      new HoldButton(m_rejectedGroup),
      {.text = QT_TR_NOOP("Hold: accept"),
       .tip = QT_TR_NOOP("From then on it is trusted at its address, in place of any other one."),
       .icon = "apply",
       .id = "rejected-accept",
       .isTouch = true});
  m_drop = button({.text = QT_TR_NOOP("Remove"),
                   .tip = QT_TR_NOOP("Removes it from the list. It stays refused."),
                   .icon = "clear",
                   .id = "rejected-drop"});
  m_rejectedTable->setModel(m_rejected);
  styleTable(m_rejectedTable);
  m_rejectedTable->setMinimumHeight(kTableHeightPx);
  inColumn({m_rejectedTable, inRow({m_accept, m_drop, spring()})}, m_rejectedGroup);
  connect(m_rejectedTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &CertificatesPage::showButtons);
  connect(m_accept, &HoldButton::held, this, [this] {
    if (const auto* server = chosenRejected()) {
      Q_EMIT acceptRequested(text(server->facts.fingerprint));
    }
  });
  connect(m_drop, &QPushButton::clicked, this,
          [this] { Q_EMIT dropRequested(text(chosenRejected()->facts.fingerprint)); });
  return m_rejectedGroup;
}

const CertificatesView::Server* CertificatesPage::chosenServer() const {
  const QModelIndex index = m_serverTable->selectionModel()->currentIndex();
  return index.isValid() ? &m_servers->row(index.row()) : nullptr;
}

const CertificatesView::Rejected* CertificatesPage::chosenRejected() const {
  const QModelIndex index = m_rejectedTable->selectionModel()->currentIndex();
  return index.isValid() ? &m_rejected->row(index.row()) : nullptr;
}

void CertificatesPage::setCertificates(const CertificatesView& view) {
  m_view = view;
  m_servers->setRows(view.servers);
  m_rejected->setRows(view.rejected);
  fitColumns();
  showOwn();
  showButtons();
}

void CertificatesPage::fitColumns() {
  for (QTableView* table : {m_serverTable, m_rejectedTable}) {
    table->horizontalHeader()->setStretchLastSection(false);  // rather scroll than cut
    table->resizeColumnsToContents();
  }
}

void CertificatesPage::setBlocked(const QString& reason) {
  m_blocked = reason;
  showButtons();
}

void CertificatesPage::chooseFile() {
  askForCertificateFile(this, [this](const QString& path) { Q_EMIT exportRequested(path); });
}

void CertificatesPage::showOwn() {
  const auto& own = m_view.own;
  m_fingerprintTitle->setVisible(own.has_value());
  m_fingerprint->setVisible(own.has_value());
  if (m_view.isMaking) {
    m_days->setStatus(Status::Busy, tr("A certificate is being made …"));
  } else if (!own) {
    m_days->setStatus(Status::Unknown,
                      tr("There is none yet. It is made when it is first needed."));
  } else if (m_view.ownDaysLeft < 0) {
    m_days->setStatus(Status::Fault, tr("It has ended (%1). Renew it.").arg(validityText(*own)));
  } else {
    m_days->setStatus(
        m_view.ownDaysLeft < kSoonDays ? Status::Attention : Status::Good,
        tr("Valid for %Ln more days (%1)", nullptr, m_view.ownDaysLeft).arg(validityText(*own)));
  }
  m_fingerprint->setText(own ? fingerprintLines(own->fingerprint) : QString());
  m_library->setText(tr("Encryption by %1").arg(m_view.library));
}

void CertificatesPage::showButtons() {
  const bool isOpen = m_blocked.isEmpty();
  const bool isProblem = bool(m_view.problem.code);
  m_blockedText->setVisible(!isOpen || isProblem);
  m_blockedText->setStatus(isProblem ? Status::Fault : Status::Plain,
                           isProblem ? errorText(m_view.problem) : m_blocked);
  const auto* server = chosenServer();
  m_export->setEnabled(!m_view.isMaking);
  m_renew->setEnabled(isOpen && !m_view.isMaking);
  m_forget->setEnabled(isOpen && server != nullptr);
  m_strengthen->setEnabled(isOpen && server != nullptr && !server->allowed.empty());
  m_accept->setEnabled(isOpen && chosenRejected() != nullptr);
  m_drop->setEnabled(isOpen && chosenRejected() != nullptr);
}

}  // namespace rivulet::widgets
