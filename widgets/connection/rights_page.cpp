// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/rights_page.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <string_view>

#include "widgets/common/error_text.h"
#include "widgets/common/status_label.h"

namespace rivulet::widgets {

QString rightText(std::string_view sentence) {
  return QCoreApplication::translate("RightTexts", std::string(sentence).c_str());
}

RightsPage::RightsPage(QWidget* parent) : Page(parent), m_rows(new QGridLayout) {
  setObjectName(QStringLiteral("rights"));
  m_outcome->setEmphasis(11.0, true);
  m_rows->setHorizontalSpacing(16);
  m_rows->setVerticalSpacing(8);
  m_rows->setColumnStretch(2, 1);
  auto* layout =
      inColumn({label({.text = QT_TR_NOOP("Asks the control which of the rights that a run needs "
                                          "the user of this connection has. Nothing is changed."),
                       .isMuted = true,
                       .wraps = true}),
                inRow({m_examine, {m_outcome, 1}}), m_rows, m_excess, spring()},
               this);
  layout->setSpacing(10);
  connect(m_examine, &QPushButton::clicked, this, [this] {
    m_isAsking = true;
    showReport();
    Q_EMIT examineRequested();
  });
  onLanguage(&RightsPage::showReport);
}

void RightsPage::setReport(const std::optional<opcua::RightsReport>& report,
                           const base::Error& error) {
  m_report = report;
  m_error = error;
  m_isAsking = false;
  showReport();
}

void RightsPage::setBlocked(const QString& reason) {
  m_blocked = reason;
  showReport();
}

void RightsPage::addRow(const opcua::RightFinding& finding) {
  const bool isMissing = finding.isGiven.has_value() && !*finding.isGiven;
  const Status status = !finding.isGiven                    ? Status::Unknown
                        : *finding.isGiven                  ? Status::Good
                        : opcua::isEssential(finding.right) ? Status::Fault
                                                            : Status::Attention;
  const int row = m_nextRow++;
  auto* name = new QLabel(rightText(opcua::rightTitle(finding.right)), this);
  auto* answer = new StatusLabel(this);
  answer->setStatus(status, !finding.isGiven ? tr("not known")
                            : isMissing      ? tr("missing")
                                             : tr("given"));
  QString text = rightText(opcua::rightPurpose(finding.right));
  if (!finding.isGiven.value_or(false)) {
    text += QLatin1Char('\n') + rightText(opcua::rightRemedy(finding.right, m_report->isMapped));
  }
  auto* purpose = makeValueLabel(this);
  purpose->setWordWrap(true);
  purpose->setText(text);
  m_rows->addWidget(name, row, 0, Qt::AlignTop);
  m_rows->addWidget(answer, row, 1, Qt::AlignTop);
  m_rows->addWidget(purpose, row, 2, Qt::AlignTop);
  for (QWidget* widget : std::initializer_list<QWidget*>{name, answer, purpose}) {
    m_shown.push_back(widget);
    if (isVisible()) {
      widget->show();
    }
  }
}

void RightsPage::showReport() {
  for (QWidget* widget : m_shown) {
    m_rows->removeWidget(widget);
    widget->hide();
    widget->deleteLater();
  }
  m_shown.clear();
  m_nextRow = 0;
  m_examine->setEnabled(m_blocked.isEmpty() && !m_isAsking);
  m_excess->clear();
  if (m_isAsking) {
    m_outcome->setStatus(Status::Busy, tr("Asking the control …"));
    return;
  }
  if (!m_report) {
    const bool isError = bool(m_error.code);
    m_outcome->setStatus(isError ? Status::Fault : Status::Plain,
                         isError ? errorText(m_error) : m_blocked);
    return;
  }
  const auto& findings = m_report->findings;
  const auto lacks = [&](bool essential) {
    return std::any_of(findings.begin(), findings.end(), [essential](const auto& finding) {
      return opcua::isEssential(finding.right) == essential && !finding.isGiven.value_or(false);
    });
  };
  m_outcome->setStatus(lacks(true)    ? Status::Fault
                       : lacks(false) ? Status::Attention
                                      : Status::Good,
                       lacks(true)    ? tr("A run is not possible with these rights.")
                       : lacks(false) ? tr("A run is possible; some steps remain to the operator.")
                                      : tr("This user has all rights that a run needs."));
  for (const opcua::RightFinding& finding : findings) {
    addRow(finding);
  }
  if (!m_report->excess.empty()) {
    QStringList names;
    for (const std::string& name : m_report->excess) {
      names.append(QString::fromStdString(name));
    }
    m_excess->setText(tr("More than a run needs: %1. Call DeleteUserAccess with them, or use a "
                         "user of its own for Rivulet.")
                          .arg(names.join(QStringLiteral(", "))));
  } else if (!m_report->isListed) {
    m_excess->setText(
        tr("The server does not tell which other rights this user has. Look at the "
           "list of users on the control."));
  }
}

}  // namespace rivulet::widgets
