// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/cursor_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/scope_view.h"

namespace rivulet::widgets {

namespace {

constexpr int kStatisticsDelayMs = 40;
constexpr int kDigits = 6;

QString figureText(double value) {
  return std::isfinite(value) ? QLocale().toString(value, 'g', kDigits) : noValue();
}

}  // namespace

CursorPanel::CursorPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                         ScopeView* view, QWidget* parent)
    : Page(parent),
      m_curves(curves),
      m_window(window),
      m_cursors(cursors),
      m_view(view),
      m_table(say(new QTableWidget(kRows, 0, this),
                  {.name = QT_TR_NOOP("At the cursors and between them"), .id = "cursorTable"})) {
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setMinimumHeight(100);
  m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  m_table->verticalHeader()->setDefaultSectionSize(26);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_what->addItems({QString(), QString(), QString()});
  m_note->hide();
  auto* goTo = inRow({m_what, {m_where, 1}, m_go});
  goTo->setSpacing(4);
  inColumn({m_times, {m_table, 1}, goTo, m_note}, this, QMargins(4, 6, 4, 4));

  m_delay.setParent(this);  // whoever waits for the page finds it
  m_delay.setSingleShot(true);
  m_delay.setInterval(kStatisticsDelayMs);
  connect(&m_delay, &QTimer::timeout, this, &CursorPanel::refresh);
  connect(m_cursors, &ScopeCursors::changed, this, &CursorPanel::schedule);
  connect(m_curves, &ScopeCurves::changed, this, &CursorPanel::schedule);
  connect(m_curves, &ScopeCurves::axisChanged, this, &CursorPanel::retranslate);
  connect(m_curves, &ScopeCurves::tracesChanged, this, &CursorPanel::retranslate);
  connect(m_view, &ScopeView::changed, this, &CursorPanel::schedule);
  connect(m_where, &QLineEdit::returnPressed, this, &CursorPanel::go);
  connect(m_where, &QLineEdit::textEdited, m_note, &QWidget::hide);
  retranslate();
  restyle();
}

void CursorPanel::schedule() {
  if (!m_delay.isActive()) {
    m_delay.start();
  }
}

void CursorPanel::refreshNow() {
  m_delay.stop();
  refresh();
}

void CursorPanel::setCell(int row, std::size_t column, const QString& text) {
  const int at = static_cast<int>(column);
  QTableWidgetItem* item = m_table->item(row, at);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->setItem(row, at, item);
  }
  item->setText(text);
}

void CursorPanel::refresh() {
  m_columns.clear();
  for (const QStringList& pane : m_view->arrangement()) {
    for (const QString& formula : pane) {
      for (ScopeCurves::Curve& curve : m_curves->curves(formula)) {
        if (!curve.samples || curve.samples->empty()) {
          continue;
        }
        QString title = curve.title.replace(QStringLiteral(" · "), QStringLiteral("\n"));
        if (const QString unit = m_curves->unit(formula); !unit.isEmpty()) {
          const qsizetype end = title.indexOf(QLatin1Char('\n'));
          title.insert(end < 0 ? title.size() : end, QStringLiteral(", ") + unit);
        }
        m_columns.push_back({title, curve.samples});
      }
    }
  }
  m_table->setColumnCount(static_cast<int>(m_columns.size()));
  const auto& a = m_cursors->atS(ScopeCursors::A);
  const auto& b = m_cursors->atS(ScopeCursors::B);
  if (a && b) {
    const double apart = *b - *a;
    m_times->setText(tr("A %1, B %2, B − A %3")
                         .arg(m_curves->axisText(*a, 4), m_curves->axisText(*b, 4),
                              m_curves->axisText(apart, 4)));
  } else if (a || b) {
    m_times->setText((a ? tr("A %1") : tr("B %1")).arg(m_curves->axisText(a ? *a : *b, 4)));
  } else {
    m_times->setText(tr("A click on a curve sets cursor A, with Shift cursor B."));
  }
  ++m_request;
  for (std::size_t i = 0; i < m_columns.size(); ++i) {
    const Column& column = m_columns[i];
    m_table->setHorizontalHeaderItem(static_cast<int>(i), new QTableWidgetItem(column.title));
    const double nan = std::nan("");
    const double atA = a ? trace::valueAt(*column.samples, instantOf(*a)) : nan;
    const double atB = b ? trace::valueAt(*column.samples, instantOf(*b)) : nan;
    setCell(AtA, i, figureText(atA));
    setCell(AtB, i, figureText(atB));
    setCell(Difference, i, figureText(atB - atA));
    setCell(Slope, i, a && b && *a != *b ? figureText((atB - atA) / (*b - *a)) : noValue());
    for (int row = Min; row < kRows; ++row) {
      setCell(row, i, noValue());
    }
    if (!a || !b) {
      continue;
    }
    m_curves->run([self = QPointer(this), request = m_request, i, samples = column.samples,
                   from = instantOf(std::min(*a, *b)),
                   to = instantOf(std::max(*a, *b))]() -> std::function<void()> {
      const trace::SampleStatistics figures = trace::sampleStatistics(*samples, from, to);
      return [self, request, i, figures] {
        if (self && self->m_request == request) {
          self->showFigures(i, figures);
        }
      };
    });
  }
}

void CursorPanel::showFigures(std::size_t column, const trace::SampleStatistics& figures) {
  if (figures.count > 0) {
    setCell(Min, column, figureText(figures.min));
    setCell(Max, column, figureText(figures.max));
    setCell(Mean, column, figureText(figures.mean));
    setCell(Rms, column, figureText(figures.rms));
    setCell(Median, column, figureText(figures.p50));
    setCell(P95, column, figureText(figures.p95));
    setCell(P99, column, figureText(figures.p99));
  }
  setCell(Count, column, countText(figures.count));
}

std::optional<double> CursorPanel::timeOf(const QString& formula, double value) const {
  const auto samples = m_curves->samples(0, formula);
  if (!samples) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < samples->size(); ++i) {
    if (samples->valueAt(i) == value) {
      return base::toSeconds(samples->timeAt(i));
    }
  }
  return std::nullopt;
}

void CursorPanel::go() {
  bool isNumber = false;
  const QString text = m_where->text().trimmed();
  double value = QLocale().toDouble(text, &isNumber);
  if (!isNumber) {
    value = text.toDouble(&isNumber);
  }
  std::optional<double> at;
  if (isNumber) {
    switch (m_what->currentIndex()) {
      case Time:
        at = value >= 0.0 && value <= m_window->endS() ? std::optional(value) : std::nullopt;
        break;
      case Line: {
        at = timeOf(QStringLiteral("program_line"), value);
        at = at ? at : timeOf(QStringLiteral("line"), value);
        break;
      }
      default:
        // Points are counted from 1.
        at = timeOf(QStringLiteral("program_point"), value - 1.0);
        break;
    }
  }
  if (!at) {
    m_note->setText(isNumber ? tr("The trace has no such place.") : tr("Type a number."));
    m_note->show();
    return;
  }
  m_note->hide();
  m_window->reveal(*at);
  m_cursors->set(ScopeCursors::A, *at);
}

QString CursorPanel::slopeTitle() const {
  switch (m_curves->axis()) {
    case trace::RunAxis::Time:
      return tr("Slope, 1/s");
    case trace::RunAxis::Path:
      return tr("Slope, 1/mm");
    case trace::RunAxis::Point:
      return tr("Slope");
  }
  return {};
}

void CursorPanel::retranslate() {
  m_table->setVerticalHeaderLabels(
      {tr("At A"), tr("At B"), tr("B − A"), slopeTitle(), tr("Minimum"), tr("Maximum"), tr("Mean"),
       tr("RMS"), tr("Median"), tr("95 % below"), tr("99 % below"), tr("Samples")});
  m_what->setItemText(Time, m_curves->axisTitle());
  m_what->setItemText(Line, tr("Line"));
  m_what->setItemText(Point, tr("Point"));
  schedule();
}

void CursorPanel::restyle() {
  QPalette attention = m_note->palette();
  attention.setColor(QPalette::WindowText, themeColors(palette()).attention);
  m_note->setPalette(attention);
}

}  // namespace rivulet::widgets
