// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/compare_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QTableWidget>
#include <array>

#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/scope_view.h"

namespace rivulet::widgets {

namespace {

constexpr int kCompareDelayMs = 60;
constexpr int kDifferenceDigits = 4;

}  // namespace

ComparePanel::ComparePanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                           ScopeView* view, QWidget* parent)
    : Page(parent),
      m_curves(curves),
      m_window(window),
      m_cursors(cursors),
      m_view(view),
      m_table(say(new QTableWidget(0, kColumns, this),
                  {.name = QT_TR_NOOP("Differences"), .id = "compareTable"})) {
  m_note->setTextFormat(Qt::PlainText);
  styleTable(m_table);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setMinimumHeight(100);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setSectionResizeMode(Signal, QHeaderView::Stretch);
  inColumn({inRow({label({.text = QT_TR_NOOP("Compare at the same"), .wraps = true}, m_axis),
                   {m_axis, 1}}),
            m_differences,
            m_note,
            {m_table, 1}},
           this, QMargins(2, 6, 2, 4));

  m_delay.setParent(this);  // whoever waits for the page finds it
  m_delay.setSingleShot(true);
  m_delay.setInterval(kCompareDelayMs);
  connect(&m_delay, &QTimer::timeout, this, &ComparePanel::refresh);
  connect(m_axis, &QComboBox::activated, this, [this](int chosen) {
    m_problem.clear();
    m_curves->setAxis(static_cast<trace::RunAxis>(chosen));
  });
  connect(m_differences, &QCheckBox::toggled, m_curves, &ScopeCurves::showDifferences);
  connect(m_curves, &ScopeCurves::axisChanged, this, &ComparePanel::schedule);
  connect(m_curves, &ScopeCurves::axisFailed, this, [this](const base::Error& error) {
    m_problem = errorText(error);
    showAxis();
  });
  connect(m_curves, &ScopeCurves::tracesChanged, this, [this] {
    m_problem.clear();
    schedule();
  });
  connect(m_table, &QTableWidget::cellClicked, this, &ComparePanel::goTo);
  connect(m_table, &QTableWidget::cellActivated, this, &ComparePanel::goTo);
  retranslate();
  restyle();
}

void ComparePanel::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  schedule();
}

void ComparePanel::schedule() {
  showAxis();
  if (isVisible() && !m_delay.isActive()) {
    m_delay.start();
  }
}

void ComparePanel::refreshNow() {
  m_delay.stop();
  refresh();
}

void ComparePanel::showAxis() {
  const bool hasSeveral = m_curves->traces().size() > 1;
  m_axis->setEnabled(hasSeveral);
  m_differences->setEnabled(hasSeveral);
  m_axis->setCurrentIndex(static_cast<int>(m_curves->axis()));
  const QSignalBlocker quiet(m_differences);
  m_differences->setChecked(m_curves->showsDifferences());
  showNote();
}

void ComparePanel::showNote() {
  const trace::RunAlignment& alignment = m_curves->alignment();
  QString text;
  if (!m_problem.isEmpty()) {
    text = m_problem;
  } else if (m_curves->traces().size() < 2) {
    text = tr("Open two traces or more to compare them.");
  } else if (m_isBusy) {
    text = tr("Comparing …");
  } else if (alignment.axis == trace::RunAxis::Path && !alignment.isOfProgram) {
    text =
        tr("Each run has the length that it moved itself. With their NC program open, the runs "
           "are compared at the same places of the program.");
  } else {
    text = tr("Differences from %1").arg(QString::fromStdString(m_curves->traces().front()->name));
  }
  m_note->setText(text);
  restyle();
}

void ComparePanel::refresh() {
  const ScopeCurves::Traces traces = m_curves->traces();
  if (traces.size() < 2) {
    m_isBusy = false;
    showRows({});
    return;
  }
  m_isBusy = true;
  showNote();
  m_curves->run([self = QPointer(this), request = ++m_request, traces,
                 alignment = m_curves->alignment()]() -> std::function<void()> {
    std::vector<Row> rows;
    for (std::size_t run = 1; run < traces.size(); ++run) {
      const auto differences = trace::compareRuns(traces, alignment, 0, run, {});
      for (std::size_t i = 0; differences && i < differences->size(); ++i) {
        if ((*differences)[i].figures.count > 0) {
          rows.push_back({run, (*differences)[i]});
        }
      }
    }
    return [self, request, rows = std::move(rows)]() mutable {
      if (self && self->m_request == request) {
        self->m_isBusy = false;
        self->showRows(std::move(rows));
      }
    };
  });
}

void ComparePanel::showRows(std::vector<Row> rows) {
  m_rows = std::move(rows);
  m_table->setRowCount(static_cast<int>(m_rows.size()));
  const bool hasSeveral = m_curves->traces().size() > 2;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const auto& [trace, difference] = m_rows[i];
    const trace::DifferenceFigures& figures = difference.figures;
    const QString run = QString::fromStdString(m_curves->traces()[trace]->name);
    const QString unit = QString::fromStdString(difference.offer.unit);
    QString name = signalTitle(difference.offer);
    name += unit.isEmpty() ? QString() : QStringLiteral(", ") + unit;
    name += hasSeveral ? QStringLiteral(" · ") + run : QString();
    const QLocale locale;
    const std::array<QString, kColumns> cells{
        name, locale.toString(figures.max, 'g', kDifferenceDigits), numberText(figures.atAxis, 2),
        locale.toString(figures.rms, 'g', kDifferenceDigits)};
    for (int column = 0; column < kColumns; ++column) {
      auto* item = new QTableWidgetItem(cells[static_cast<std::size_t>(column)]);
      item->setTextAlignment((column == Signal ? Qt::AlignLeft : Qt::AlignRight) |
                             Qt::AlignVCenter);
      item->setToolTip(tr("%1\n%2 minus %3: largest %4 at %5, mean %6, RMS %7")
                           .arg(name, run, QString::fromStdString(m_curves->traces().front()->name),
                                cells[1], m_curves->axisText(figures.atAxis),
                                locale.toString(figures.mean, 'g', kDifferenceDigits), cells[3]));
      m_table->setItem(static_cast<int>(i), column, item);
    }
  }
  showNote();
}

void ComparePanel::goTo(int row) {
  const double at = m_rows[static_cast<std::size_t>(row)].difference.figures.atAxis;
  m_window->reveal(at);
  m_cursors->set(ScopeCursors::A, at);
}

void ComparePanel::retranslate() {
  m_table->setHorizontalHeaderLabels({tr("Signal"), tr("Largest"), tr("At"), tr("RMS")});
  showAxis();
  showRows(m_rows);
}

void ComparePanel::restyle() {
  const ThemeColors& colors = themeColors(palette());
  QPalette note = m_note->palette();
  note.setColor(QPalette::WindowText, m_problem.isEmpty() ? colors.mutedText : colors.attention);
  m_note->setPalette(note);
}

}  // namespace rivulet::widgets
