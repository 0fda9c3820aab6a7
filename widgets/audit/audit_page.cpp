// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/audit/audit_page.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>

#include "widgets/alarms/alarm_text.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"

namespace rivulet::widgets {

namespace {

struct AuditTexts {
  Q_DECLARE_TR_FUNCTIONS(AuditTexts)

 public:
  static QString act(permission::Act act) {
    using permission::Act;
    switch (act) {
      case Act::Stop:
        return tr("Stop");
      case Act::Hold:
        return tr("Pause");
      case Act::Continue:
        return tr("Continue");
      case Act::Override:
        return tr("Override");
      case Act::Start:
        return tr("Start");
      case Act::Resume:
        return tr("Resume");
      case Act::Watch:
        return tr("Watch");
      case Act::Correct:
        return tr("Online correction");
      case Act::OpenProgram:
        return tr("Program opened");
      case Act::ChangeSettings:
        return tr("Settings changed");
      case Act::Connect:
        return tr("Connect");
      case Act::Disconnect:
        return tr("Disconnect");
      case Act::Trust:
        return tr("Trust");
      case Act::Calibrate:
        return tr("Calibration");
      case Act::Release:
        return tr("Released");
      case Act::TakeBackRelease:
        return tr("Release taken back");
      case Act::Acknowledge:
        return tr("Alarm acknowledged");
      case Act::Shelve:
        return tr("Alarm shelved");
      case Act::SetUpUsers:
        return tr("Users set up");
      case Act::LogIn:
        return tr("Logged in");
      case Act::LogInFailed:
        return tr("Wrong PIN");
      case Act::Lock:
        return tr("Locked");
      case Act::ProgramStart:
        return tr("Rivulet started");
      case Act::ProgramEnd:
        return tr("Rivulet ended");
    }
    return {};
  }
  static QString role(permission::Role role) {
    return role == permission::Role::Operator ? tr("Operator") : tr("Engineer");
  }
};

}  // namespace

QString actText(const QString& act) {
  const auto known = permission::actOfName(act.toStdString());
  return known ? AuditTexts::act(*known) : act;
}

QString roleText(permission::Role role) {
  return AuditTexts::role(role);
}

AuditModel::AuditModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Line"); },
            [](const AuditRow& row) { return QString::number(row.line); }, true},
           {[] { return tr("Time"); }, [](const AuditRow& row) { return dateTimeText(row.at); }},
           {[] { return tr("Who"); }, [](const AuditRow& row) { return row.who; }},
           {[] { return tr("Role"); },
            [](const AuditRow& row) {
              const auto role = permission::roleOfName(row.role.toStdString());
              return role ? roleText(*role) : QString();
            }},
           {[] { return tr("What"); }, [](const AuditRow& row) { return actText(row.act); }, false,
            [this](const AuditRow& row, int role) {
              return role == Qt::DecorationRole && row.isSuspect
                         ? QVariant(severityIcon(gcode::Severity::Error, m_palette))
                         : QVariant();
            }},
           {[] { return tr("Details"); }, [](const AuditRow& row) { return row.details; }}},
          parent) {
}

void AuditModel::setColors(const QPalette& palette) {
  m_palette = palette;
  refresh();
}

AuditPage::AuditPage(QWidget* parent)
    : Page(parent),
      m_model(new AuditModel(this)),
      m_filter(new QSortFilterProxyModel(this)),
      m_state(new StatusLabel(this, StatusLabel::Elided{2})),
      m_table(say(new QTableView(this), {.name = QT_TR_NOOP("Audit")})) {
  m_filter->setSourceModel(m_model);
  m_filter->setFilterKeyColumn(-1);  // all columns
  m_filter->setFilterCaseSensitivity(Qt::CaseInsensitive);
  m_table->setModel(m_filter);
  styleTable(m_table);
  m_table->setColumnWidth(AuditModel::Line, 70);
  m_table->setColumnWidth(AuditModel::Time, 180);
  m_table->setColumnWidth(AuditModel::Who, 120);
  m_table->setColumnWidth(AuditModel::RoleColumn, 110);
  m_table->setColumnWidth(AuditModel::Act, 190);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_search->setClearButtonEnabled(true);
  m_hash->setWordWrap(false);

  inColumn({inRow({{m_state, 3}, {m_search, 1}}),
            {m_table, 1},
            inRow({m_csv, m_json, spring(), m_hash})},
           this);
  connect(m_search, &QLineEdit::textChanged, m_filter,
          &QSortFilterProxyModel::setFilterFixedString);
  connect(m_csv, &QPushButton::clicked, this, [this] { chooseFile(QStringLiteral("csv")); });
  connect(m_json, &QPushButton::clicked, this, [this] { chooseFile(QStringLiteral("json")); });
  onLanguage([this] { m_model->refresh(); }, &AuditPage::showState);
  onTheme([this] { m_model->setColors(palette()); });
}

void AuditPage::chooseFile(const QString& suffix) {
  askWhereToSave(this, {tr("Export the audit trail"), QStringLiteral("audit.") + suffix, {}},
                 [this](const QString& path, auto) { Q_EMIT exportRequested(path); });
}

void AuditPage::setAudit(const AuditView& audit) {
  m_audit = audit;
  m_model->setRows(audit.rows);
  m_table->scrollToBottom();
  showState();
}

void AuditPage::showState() {
  if (m_audit.file.isEmpty()) {
    m_state->setStatus(Status::Unknown, tr("No audit trail is kept."));
  } else if (m_audit.firstChange > 0) {
    m_state->setStatus(
        Status::Fault,
        tr("The audit trail was changed: line %1 was edited, or lines before it were "
           "inserted or removed.")
            .arg(m_audit.firstChange));
  } else {
    QString text = tr("Unchanged: every line follows from the one before it.");
    if (m_audit.cutLines > 0) {
      text += QLatin1Char(' ') + tr("Cut by a loss of power: %1.").arg(m_audit.cutLines);
    }
    m_state->setStatus(Status::Good, text);
  }
  m_state->setToolTip(m_audit.file);
  constexpr qsizetype kShownDigits = 16;
  m_hash->setText(m_audit.lastHash.isEmpty()
                      ? QString()
                      : tr("Last hash: %1 …").arg(m_audit.lastHash.left(kShownDigits)));
  m_hash->setToolTip(m_audit.lastHash);
  m_csv->setEnabled(!m_audit.rows.empty());
  m_json->setEnabled(!m_audit.rows.empty());
}

void AuditPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  Q_EMIT refreshRequested();
}

}  // namespace rivulet::widgets
