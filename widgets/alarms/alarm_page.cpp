// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/alarms/alarm_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <array>

#include "widgets/alarms/alarm_text.h"
#include "widgets/common/table_style.h"

namespace rivulet::widgets {

namespace {

/// How long an alarm may be put aside, in minutes; not longer than a shift.
constexpr std::array<int, 4> kShelvingMinutes{10, 30, 120, 480};

QLabel* wrapping(QWidget* parent) {
  QLabel* label = makeValueLabel(parent);
  label->setWordWrap(true);
  return label;
}

}  // namespace

AlarmModel::AlarmModel(QObject* parent)
    : TableModel({{[] { return tr("Alarm"); },
                   [](const alarm::Alarm& alarm) { return alarmText(alarm); }, false,
                   [this](const alarm::Alarm& alarm, int role) {
                     if (role == Qt::DecorationRole) {
                       return QVariant(severityIcon(severityOf(alarm::factsOf(alarm.code).priority),
                                                    m_palette));
                     }
                     if (role == Qt::FontRole && !alarm.isAcknowledged) {
                       QFont font;
                       font.setBold(true);
                       return QVariant(font);
                     }
                     return QVariant();
                   }},
                  {[] { return tr("State"); },
                   [](const alarm::Alarm& alarm) { return stateText(alarm.state()); }},
                  {[] { return tr("Time"); },
                   [](const alarm::Alarm& alarm) { return dateTimeText(alarm.raisedAt); }},
                  {[] { return tr("Count"); },
                   [](const alarm::Alarm& alarm) { return QString::number(alarm.count); }, true}},
                 parent) {
}

void AlarmModel::setColors(const QPalette& palette) {
  m_palette = palette;
  refresh();
}

AlarmHistoryModel::AlarmHistoryModel(QObject* parent)
    : TableModel({{[] { return tr("Time"); },
                   [](const alarm::Transition& transition) { return dateTimeText(transition.at); }},
                  {[] { return tr("What"); },
                   [](const alarm::Transition& transition) { return eventText(transition.event); }},
                  {[] { return tr("Alarm"); },
                   [](const alarm::Transition& transition) {
                     const QString cause = alarmCause(transition.alarm);
                     const QString text = alarmText(transition.alarm);
                     return cause.isEmpty() ? text : text + QLatin1Char(' ') + cause;
                   }},
                  {[] { return tr("By"); },
                   [](const alarm::Transition& transition) {
                     return QString::fromStdString(transition.by);
                   }}},
                 parent, kCapacity) {
}

AlarmPage::AlarmPage(QWidget* parent)
    : Page(parent),
      m_model(new AlarmModel(this)),
      m_historyModel(new AlarmHistoryModel(this)),
      m_tabs(new QTabBar(this)),
      m_table(new QTableView(this)),
      m_history(new QTableView(this)),
      m_details(makeDetails()),
      m_shelveMenu(new QMenu(this)) {
  m_tabs->addTab(QString());
  m_tabs->addTab(QString());
  m_tabs->setDrawBase(false);
  for (QTableView* table : {m_table, m_history}) {
    styleTable(table);
  }
  m_table->setModel(m_model);
  m_table->horizontalHeader()->setSectionResizeMode(AlarmModel::Text, QHeaderView::Stretch);
  m_table->setColumnWidth(AlarmModel::StateColumn, 220);
  m_table->setColumnWidth(AlarmModel::Time, 180);
  m_table->setColumnWidth(AlarmModel::Count, 80);
  m_history->setModel(m_historyModel);
  m_history->horizontalHeader()->setSectionResizeMode(AlarmHistoryModel::Text,
                                                      QHeaderView::Stretch);
  m_history->setColumnWidth(AlarmHistoryModel::Time, 180);
  m_history->setColumnWidth(AlarmHistoryModel::EventColumn, 170);
  m_shelve->setMenu(m_shelveMenu);

  inColumn({m_tabs, {m_table, 1}, {m_history, 1}, m_details}, this);
  connect(m_tabs, &QTabBar::currentChanged, this, &AlarmPage::showTable);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            m_selected = index.isValid() ? m_model->row(index.row()).number : 0;
            showSelected();
          });
  connect(m_acknowledge, &QPushButton::clicked, this,
          [this] { Q_EMIT acknowledgeRequested(m_selected); });
  for (const int minutes : kShelvingMinutes) {
    m_shelveMenu->addAction(QString(), this,
                            [this, minutes] { Q_EMIT shelveRequested(m_selected, minutes); });
  }
  m_shelveMenu->addAction(QString(), this, [this] { Q_EMIT unshelveRequested(m_selected); });
  showTable();
  retranslate();
  restyle();
}

QWidget* AlarmPage::makeDetails() {
  auto* details = new QWidget(this);
  m_text = wrapping(details);
  QFont font = m_text->font();
  font.setBold(true);
  m_text->setFont(font);
  m_causeTitle = label({.text = QT_TR_NOOP("Cause")});
  m_cause = wrapping(details);
  m_remedyTitle = label({.text = QT_TR_NOOP("What to do")});
  m_remedy = wrapping(details);
  m_facts = wrapping(details);
  m_acknowledge = button({.text = QT_TR_NOOP("Acknowledge")});
  m_acknowledgeAll =
      button({.text = QT_TR_NOOP("Acknowledge all")}, &AlarmPage::acknowledgeAllRequested);
  m_shelve = button({.text = QT_TR_NOOP("Shelve"),
                     .tip = QT_TR_NOOP("Put the alarm aside for a time. It stays in this list.")});
  auto* rows = new QGridLayout;
  rows->setColumnStretch(1, 1);
  rows->setHorizontalSpacing(16);
  rows->addWidget(m_text, 0, 0, 1, 2);
  rows->addWidget(m_causeTitle, 1, 0, Qt::AlignTop);
  rows->addWidget(m_cause, 1, 1);
  rows->addWidget(m_remedyTitle, 2, 0, Qt::AlignTop);
  rows->addWidget(m_remedy, 2, 1);
  rows->addWidget(m_facts, 3, 0, 1, 2);
  inColumn({rows, inRow({m_acknowledge, m_shelve, spring(), m_acknowledgeAll})}, details,
           QMargins(4, 8, 4, 0));
  return details;
}

const alarm::Alarm* AlarmPage::selected() const {
  for (const alarm::Alarm& alarm : m_model->rows()) {
    if (alarm.number == m_selected) {
      return &alarm;
    }
  }
  return nullptr;
}

void AlarmPage::setAlarms(const std::vector<alarm::Alarm>& alarms) {
  const int chosen = m_selected;
  m_model->setRows(alarms);
  int row = 0;
  for (std::size_t i = 0; i < alarms.size(); ++i) {
    if (alarms[i].number == chosen) {
      row = static_cast<int>(i);
    }
  }
  m_selected = 0;
  if (!alarms.empty()) {
    m_table->selectRow(row);
    m_selected = alarms[static_cast<std::size_t>(row)].number;
  }
  retranslate();
}

void AlarmPage::setHistory(const std::vector<alarm::Transition>& transitions) {
  m_historyModel->setRows(transitions);
}

void AlarmPage::showAlarms() {
  m_tabs->setCurrentIndex(0);
  if (m_model->rowCount() > 0) {
    m_table->selectRow(0);
  }
}

void AlarmPage::showTable() {
  const bool isHistory = m_tabs->currentIndex() == 1;
  m_table->setVisible(!isHistory);
  m_details->setVisible(!isHistory);
  m_history->setVisible(isHistory);
}

void AlarmPage::showSelected() {
  const alarm::Alarm* alarm = selected();
  for (QWidget* widget : {m_causeTitle, m_cause, m_remedyTitle, m_remedy, m_facts}) {
    widget->setVisible(alarm != nullptr);
  }
  m_acknowledge->setEnabled(alarm != nullptr && !alarm->isAcknowledged);
  m_acknowledgeAll->setEnabled(alarm != nullptr);
  m_shelve->setEnabled(alarm != nullptr);
  if (alarm == nullptr) {
    m_text->setText(tr("There is no alarm."));
    return;
  }
  m_text->setText(alarmText(*alarm));
  const QString cause = alarmCause(*alarm);
  const QString remedy = alarmRemedy(*alarm);
  const bool hasCause = !cause.isEmpty() && cause != remedy;
  m_cause->setText(cause);
  m_cause->setVisible(hasCause);
  m_causeTitle->setVisible(hasCause);
  m_remedy->setText(remedy);
  QString facts = QStringLiteral("%1 · %2 · %3")
                      .arg(sourceText(alarm::factsOf(alarm->code).source),
                           stateText(alarm->state()), dateTimeText(alarm->raisedAt));
  if (alarm->shelving) {
    facts += QStringLiteral(" · ") + tr("shelved by %1 until %2")
                                         .arg(QString::fromStdString(alarm->shelving->by),
                                              dateTimeText(alarm->shelving->until));
  }
  m_facts->setText(facts);
  m_shelveMenu->actions().last()->setEnabled(alarm->shelving.has_value());
}

void AlarmPage::retranslate() {
  m_tabs->setTabText(0, tr("Alarms (%1)").arg(m_model->rowCount()));
  m_tabs->setTabText(1, tr("History"));
  m_table->setAccessibleName(m_tabs->tabText(0));
  m_history->setAccessibleName(m_tabs->tabText(1));
  const QList<QAction*> actions = m_shelveMenu->actions();
  for (std::size_t i = 0; i < kShelvingMinutes.size(); ++i) {
    const int minutes = kShelvingMinutes[i];
    constexpr int kMinutesPerHour = 60;
    actions[static_cast<qsizetype>(i)]->setText(
        minutes < kMinutesPerHour ? tr("For %n minutes", nullptr, minutes)
                                  : tr("For %n hours", nullptr, minutes / kMinutesPerHour));
  }
  actions.last()->setText(tr("Show it again"));
  m_model->refresh();
  m_historyModel->refresh();
  showSelected();
}

void AlarmPage::restyle() {
  m_model->setColors(palette());
  for (QLabel* label : {m_causeTitle, m_remedyTitle, m_facts}) {
    setMuted(label, palette());
  }
}

}  // namespace rivulet::widgets
