// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/calibration/calibration_page.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <algorithm>
#include <cmath>

#include "feasibility/access_model.h"
#include "widgets/calibration/calibration_charts.h"
#include "widgets/calibration/calibration_models.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/table_style.h"

namespace rivulet::widgets {

namespace {

constexpr int kButtonRoomPx = 28;  // beside the text, both sides together
constexpr int kCellMax = 9999;
constexpr int kFirstCell = 50;
constexpr int kLastCell = 99;
constexpr int kShotsMax = 100'000;
constexpr int kMinutesMax = 600;
constexpr int kMinutes = 10;

QTableView* makeTable(QAbstractItemModel* model, QHeaderView::ResizeMode columns, QWidget* parent) {
  auto* table = new QTableView(parent);
  styleTable(table);
  table->setModel(model);
  table->horizontalHeader()->setSectionResizeMode(columns);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  return table;
}

}  // namespace

CalibrationPage::CalibrationPage(QWidget* parent)
    : Page(parent),
      m_firstCell(new WholeNumberField(this)),
      m_lastCell(new WholeNumberField(this)),
      m_shots(whole(2, kShotsMax)),
      m_budget(whole(0, kMinutesMax, {.special = QT_TR_NOOP("no limit")})),
      m_progress(new QProgressBar(this)),
      m_tabs(new QTabWidget(this)),
      m_lines(new LinesChart(this)),
      m_linesLegend(new LegendStrip(this)),
      m_fits(new FitModel(this)),
      m_series(new SeriesModel(this)),
      m_histogram(new HistogramChart(this)),
      m_histogramLegend(new LegendStrip(this)) {
  for (WholeNumberField* cell : {m_firstCell, m_lastCell}) {
    cell->setRange(0, kCellMax);
    cell->setPrefix(QStringLiteral("R"));
  }
  m_firstCell->setValue(kFirstCell);
  m_lastCell->setValue(kLastCell);
  m_shots->setValue(streaming::CalibrationPlan{}.shots);
  m_budget->setValue(kMinutes);
  m_arrays->setChecked(true);
  m_cellsName->setBuddy(m_firstCell);
  m_progress->setRange(0, 1000);

  auto* choices =
      inRow({m_cellsName, m_firstCell, label({.text = QT_TR_NOOP("to")}, m_lastCell), m_lastCell,
             gap(8), label({.text = QT_TR_NOOP("Shots of each kind")}, m_shots), m_shots, gap(8),
             label({.text = QT_TR_NOOP("At most")}, m_budget), m_budget, spring()});
  choices->setSpacing(8);

  buildTabs();
  inColumn({choices,
            m_arrays,
            m_confirm,
            inRow({m_start, {m_progress, 1}, m_cancel, gap(8), {m_hint, 2, Qt::AlignVCenter}}),
            m_state,
            {m_tabs, 1},
            spring()},
           this);

  connectFields();
  retranslate();
  onTheme(
      [this] {
        m_lines->restyle(palette());
        m_histogram->restyle(palette());
      },
      &CalibrationPage::showLegends);
}

void CalibrationPage::buildTabs() {
  auto* linesPage = new QWidget(this);
  m_fitTable = say(makeTable(m_fits, QHeaderView::Stretch, this), {.name = QT_TR_NOOP("Lines")});
  inColumn({{m_lines, 3}, m_linesLegend, {m_fitTable, 2}}, linesPage, QMargins(0, 6, 0, 0));
  auto* spreadPage = new QWidget(this);
  m_seriesTable = say(makeTable(m_series, QHeaderView::ResizeToContents, this),
                      {.name = QT_TR_NOOP("Spread (times in ms)")});
  inColumn({{m_seriesTable, 3}, {m_histogram, 3}, m_histogramLegend}, spreadPage,
           QMargins(0, 6, 0, 0));
  m_tabs->addTab(linesPage, QString());
  m_tabs->addTab(spreadPage, QString());
  say(m_tabs, {.items = {QT_TR_NOOP("Lines"), QT_TR_NOOP("Spread (times in ms)")}});
  m_tabs->setDocumentMode(true);
}

void CalibrationPage::connectFields() {
  for (WholeNumberField* cell : {m_firstCell, m_lastCell}) {
    connect(cell, &QSpinBox::valueChanged, this, &CalibrationPage::cellsChanged);
  }
  for (WholeNumberField* figure : {m_shots, m_budget}) {
    connect(figure, &QSpinBox::valueChanged, this, &CalibrationPage::refresh);
  }
  connect(m_arrays, &QCheckBox::toggled, this, &CalibrationPage::refresh);
  connect(m_confirm, &QCheckBox::toggled, this, &CalibrationPage::refresh);
  connect(m_start, &QPushButton::clicked, this, [this] {
    const streaming::CalibrationPlan chosen = plan();
    m_confirm->setChecked(false);  // once: the next time somebody else may use them
    Q_EMIT calibrationRequested(chosen);
  });
  connect(m_seriesTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &CalibrationPage::showSelected);
}

void CalibrationPage::setBlocked(const QString& reason) {
  if (m_blocked != reason) {
    m_blocked = reason;
    refresh();
  }
}

void CalibrationPage::setRecord(std::shared_ptr<const streaming::CalibrationRecord> record,
                                bool outdated) {
  m_record = std::move(record);
  m_outdated = outdated;
  const streaming::Calibration* calibration = m_record ? &m_record->calibration : nullptr;
  m_lines->setCalibration(calibration);
  m_fits->setRows(calibration != nullptr ? calibration->fits : std::vector<streaming::AccessFit>{});
  m_series->setSeries(
      calibration != nullptr ? calibration->series : std::vector<streaming::AccessSeries>{},
      calibration != nullptr ? calibration->plan.shots : 0);
  // The usual number of shots gives no 99.9 %: the space is for the others.
  const bool rare =
      calibration != nullptr &&
      std::any_of(calibration->series.begin(), calibration->series.end(),
                  [](const auto& series) { return series.percentile(999).has_value(); });
  m_seriesTable->setColumnHidden(SeriesModel::P999, !rare);
  if (m_series->rowCount() > 0) {
    m_seriesTable->selectRow(0);
  }
  showSelected();
  refresh();
}

void CalibrationPage::setProgress(const std::optional<streaming::CalibrationProgress>& progress) {
  m_progressShown = progress;
  refresh();
}

streaming::CalibrationPlan CalibrationPage::plan() const {
  streaming::CalibrationPlan plan;
  plan.firstCell = m_firstCell->value();
  plan.lastCell = m_lastCell->value();
  plan.shots = m_shots->value();
  plan.budget = std::chrono::minutes{m_budget->value()};
  plan.arrays = m_arrays->isChecked();
  return plan;
}

void CalibrationPage::setPlan(const streaming::CalibrationPlan& plan) {
  m_firstCell->setValue(plan.firstCell);
  m_lastCell->setValue(plan.lastCell);
  m_shots->setValue(plan.shots);
  m_budget->setValue(
      static_cast<int>(std::chrono::ceil<std::chrono::minutes>(plan.budget).count()));
  m_arrays->setChecked(plan.arrays);
}

void CalibrationPage::showSpread(int row) {
  m_tabs->setCurrentIndex(1);
  m_seriesTable->selectRow(row);
}

/// Changed cells are no longer confirmed.
void CalibrationPage::cellsChanged() {
  m_confirm->setChecked(false);
  retranslate();
}

void CalibrationPage::showSelected() {
  const int row = m_seriesTable->currentIndex().row();
  m_histogram->setSeries(
      row < 0 || row >= m_series->rowCount() ? std::nullopt : std::optional(m_series->row(row)));
  showLegends();
}

void CalibrationPage::retranslate() {
  m_budget->setSuffix(QStringLiteral(" min"));
  m_confirm->setText(
      tr("No program, cycle or other client uses R%1 to R%2: they may be written")
          .arg(QString::number(m_firstCell->value()), QString::number(m_lastCell->value())));
  for (QPushButton* button : {m_start, m_cancel}) {
    button->setMinimumWidth(button->sizeHint().width() + kButtonRoomPx);
  }
  m_fits->refresh();
  m_series->refresh();
  m_lines->retranslate();
  m_histogram->retranslate();
  refresh();
  showLegends();
}

void CalibrationPage::showLegends() {
  m_linesLegend->setEntries(m_lines->legend());
  m_histogramLegend->setEntries(m_histogram->legend());
}

void CalibrationPage::refresh() {
  const bool busy = m_progressShown.has_value();
  const bool range = m_lastCell->value() >= m_firstCell->value();
  m_start->setVisible(!busy);
  m_start->setEnabled(m_blocked.isEmpty() && range && m_confirm->isChecked());
  m_progress->setVisible(busy);
  m_cancel->setVisible(busy);
  for (QWidget* widget : {static_cast<QWidget*>(m_firstCell), static_cast<QWidget*>(m_lastCell),
                          static_cast<QWidget*>(m_shots), static_cast<QWidget*>(m_budget),
                          static_cast<QWidget*>(m_arrays), static_cast<QWidget*>(m_confirm)}) {
    widget->setEnabled(!busy);
  }
  showState();
  if (busy) {
    using Phase = streaming::CalibrationProgress::Phase;
    const streaming::CalibrationProgress& progress = *m_progressShown;
    m_progress->setValue(static_cast<int>(std::lround(1000.0 * progress.share)));
    const QString left = tr("%1 left").arg(durationText(base::toSeconds(progress.left)));
    switch (progress.phase) {
      case Phase::Forms:
        m_hint->setStatus(Status::Busy, tr("Testing the forms of access …"));
        break;
      case Phase::First:
        m_hint->setStatus(Status::Busy, tr("First request of each kind …"));
        break;
      case Phase::Shots:
        m_hint->setStatus(
            Status::Busy,
            tr("%1 of %2 shots, %3")
                .arg(countText(static_cast<std::size_t>(progress.shotsMade)),
                     countText(static_cast<std::size_t>(progress.shotsPlanned)), left));
        break;
      case Phase::Restore:
        m_hint->setStatus(Status::Busy, tr("Restoring the R-parameters …"));
        break;
    }
    return;
  }
  if (!m_blocked.isEmpty()) {
    m_hint->setStatus(Status::Attention, m_blocked);
  } else if (!range) {
    m_hint->setStatus(Status::Attention, tr("The last R-parameter is before the first."));
  } else {
    const base::Duration expected =
        streaming::expectedDuration(plan(), m_record ? &m_record->calibration : nullptr);
    const QString takes = tr("Takes about %1.").arg(durationText(base::toSeconds(expected)));
    m_hint->setStatus(Status::Plain,
                      m_confirm->isChecked()
                          ? takes
                          : takes + QLatin1Char(' ') + tr("Confirm the R-parameters to begin."));
  }
}

void CalibrationPage::showState() {
  m_tabs->setVisible(m_record != nullptr);
  if (!m_record) {
    m_state->setStatus(Status::Unknown,
                       tr("This machine is not calibrated: %1 for each R-parameter are assumed.")
                           .arg(millisecondsText(feasibility::AccessModel{}.accessTime)));
    return;
  }
  const streaming::Calibration& calibration = m_record->calibration;
  const QString what = tr("%1, %2, R%3 to R%4, took %5")
                           .arg(dateText(m_record->measuredAtUtc), serverText(m_record->server),
                                QString::number(calibration.plan.firstCell),
                                QString::number(calibration.plan.lastCell),
                                durationText(base::toSeconds(calibration.took)));
  if (m_outdated) {
    m_state->setStatus(Status::Attention,
                       tr("Outdated, not used: the server now has another version. %1").arg(what));
    return;
  }
  QString text = tr("Calibrated: %1.").arg(what);
  if (calibration.isCut()) {
    text += QLatin1Char(' ') +
            tr("There was not enough time for all shots: reduced numbers are bold in the table.");
  }
  m_state->setStatus(Status::Good, text);
}

}  // namespace rivulet::widgets
