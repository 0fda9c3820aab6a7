// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/certificates_page.h"

#include <QFileDialog>
#include <QFontDatabase>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/common/error_text.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/icons.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
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

QString askForCertificateFile(QWidget* parent) {
  return QFileDialog::getSaveFileName(parent,
                                      CertificatesPage::tr("Save this computer's certificate"),
                                      QStringLiteral("rivulet.der"));
}

CertificatesPage::CertificatesPage(QWidget* parent)
    : Page(parent), m_blockedText(new StatusLabel(this)), m_revocation(new QLabel(this)) {
  setObjectName(QStringLiteral("certificates"));
  m_blockedText->setWordWrap(true);
  m_revocation->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_blockedText);
  layout->addWidget(makeOwn());
  layout->addWidget(makeServers());
  layout->addWidget(makeRejected());
  layout->addWidget(m_revocation);
  layout->addStretch();
  retranslate();
  restyle();
}

QWidget* CertificatesPage::makeOwn() {
  m_ownGroup = new QGroupBox(this);
  m_days = new StatusLabel(m_ownGroup);
  m_days->setWordWrap(true);
  m_fingerprintTitle = new QLabel(m_ownGroup);
  m_fingerprint = makeValueLabel(m_ownGroup);
  m_fingerprint->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_library = new QLabel(m_ownGroup);
  m_library->setWordWrap(true);
  m_export = makeTouchButton(m_ownGroup);
  m_export->setObjectName(QStringLiteral("certificate-export"));
  m_renew = new HoldButton(m_ownGroup);
  m_renew->setObjectName(QStringLiteral("certificate-renew"));
  m_renew->setMinimumHeight(kTouchHeightPx);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_export);
  buttons->addWidget(m_renew);
  buttons->addStretch();
  auto* rows = new QGridLayout(m_ownGroup);
  rows->setHorizontalSpacing(16);
  rows->setColumnStretch(1, 1);
  rows->addWidget(m_days, 0, 0, 1, 2);
  rows->addWidget(m_fingerprintTitle, 1, 0, Qt::AlignTop);
  rows->addWidget(m_fingerprint, 1, 1);
  rows->addWidget(m_library, 2, 0, 1, 2);
  rows->addLayout(buttons, 3, 0, 1, 2);
  connect(m_export, &QPushButton::clicked, this, &CertificatesPage::chooseFile);
  connect(m_renew, &HoldButton::held, this, &CertificatesPage::renewRequested);
  return m_ownGroup;
}

QWidget* CertificatesPage::makeServers() {
  m_serverGroup = new QGroupBox(this);
  m_servers = new ServerModel(this);
  m_serverTable = new QTableView(m_serverGroup);
  m_forget = makeTouchButton(m_serverGroup);
  m_forget->setObjectName(QStringLiteral("server-forget"));
  m_strengthen = makeTouchButton(m_serverGroup);
  m_strengthen->setObjectName(QStringLiteral("server-strengthen"));
  m_serverTable->setObjectName(QStringLiteral("servers"));
  m_serverTable->setModel(m_servers);
  styleTable(m_serverTable);
  m_serverTable->setMinimumHeight(kTableHeightPx);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_forget);
  buttons->addWidget(m_strengthen);
  buttons->addStretch();
  auto* rows = new QVBoxLayout(m_serverGroup);
  rows->addWidget(m_serverTable);
  rows->addLayout(buttons);
  connect(m_serverTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &CertificatesPage::showButtons);
  connect(m_forget, &QPushButton::clicked, this,
          [this] { Q_EMIT forgetRequested(text(chosenServer()->endpoint)); });
  connect(m_strengthen, &QPushButton::clicked, this,
          [this] { Q_EMIT strengthenRequested(text(chosenServer()->endpoint)); });
  return m_serverGroup;
}

QWidget* CertificatesPage::makeRejected() {
  m_rejectedGroup = new QGroupBox(this);
  m_rejected = new RejectedModel(this);
  m_rejectedTable = new QTableView(m_rejectedGroup);
  m_accept = new HoldButton(m_rejectedGroup);
  m_accept->setObjectName(QStringLiteral("rejected-accept"));
  m_accept->setMinimumHeight(kTouchHeightPx);
  m_drop = makeTouchButton(m_rejectedGroup);
  m_drop->setObjectName(QStringLiteral("rejected-drop"));
  m_rejectedTable->setObjectName(QStringLiteral("rejected"));
  m_rejectedTable->setModel(m_rejected);
  styleTable(m_rejectedTable);
  m_rejectedTable->setMinimumHeight(kTableHeightPx);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_accept);
  buttons->addWidget(m_drop);
  buttons->addStretch();
  auto* rows = new QVBoxLayout(m_rejectedGroup);
  rows->addWidget(m_rejectedTable);
  rows->addLayout(buttons);
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
  const QString path = askForCertificateFile(this);
  if (!path.isEmpty()) {
    Q_EMIT exportRequested(path);
  }
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

void CertificatesPage::retranslate() {
  m_ownGroup->setTitle(tr("Certificate of this computer"));
  m_fingerprintTitle->setText(tr("Fingerprint (SHA-256)"));
  m_export->setText(tr("Save …"));
  m_export->setToolTip(
      tr("Writes the certificate, without its key, for the control's list of "
         "trusted clients."));
  m_renew->setText(tr("Hold: renew"));
  m_renew->setToolTip(tr("Makes a new one. Every control has to trust it anew."));
  m_serverGroup->setTitle(tr("Machines that are known"));
  m_serverTable->setAccessibleName(tr("Machines that are known"));
  m_forget->setText(tr("Forget"));
  m_forget->setToolTip(tr("At the next connection the machine is new."));
  m_strengthen->setText(tr("Protect again"));
  m_strengthen->setToolTip(
      tr("Withdraws what was allowed for this machine: from then on, the strongest encryption or "
         "no connection."));
  m_rejectedGroup->setTitle(tr("Certificates that were refused"));
  m_rejectedTable->setAccessibleName(tr("Certificates that were refused"));
  m_accept->setText(tr("Hold: accept"));
  m_accept->setToolTip(tr("From then on it is trusted at its address, in place of any other one."));
  m_drop->setText(tr("Remove"));
  m_drop->setToolTip(tr("Removes it from the list. It stays refused."));
  m_revocation->setText(
      tr("Only the very certificates that were accepted are trusted, not who issued them. So "
         "revocation lists are not needed: forget the machine instead."));
  m_servers->refresh();
  m_rejected->refresh();
  fitColumns();
  showOwn();
  showButtons();
}

void CertificatesPage::restyle() {
  const QColor color = themeColors(palette()).text;
  m_export->setIcon(themedIcon(QStringLiteral("save"), color));
  m_renew->setIcon(themedIcon(QStringLiteral("resume"), color));
  m_forget->setIcon(themedIcon(QStringLiteral("clear"), color));
  m_strengthen->setIcon(themedIcon(QStringLiteral("locked"), color));
  m_accept->setIcon(themedIcon(QStringLiteral("apply"), color));
  m_drop->setIcon(themedIcon(QStringLiteral("clear"), color));
  for (QLabel* label : {m_fingerprintTitle, m_library, m_revocation}) {
    setMuted(label, palette());
  }
}

}  // namespace rivulet::widgets
