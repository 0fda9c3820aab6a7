// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/trace_page.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>

#include "base/units.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/plots/legend_strip.h"
#include "widgets/plots/pause_bands.h"
#include "widgets/plots/time_plot.h"
#include "widgets/plots/time_window.h"
#include "widgets/trace/pause_model.h"

namespace rivulet::widgets {

TracePage::TracePage(QWidget* parent)
    : Page(parent),
      m_window(new TimeWindow(this)),
      m_sourceNote(new StatusLabel(this)),
      m_live(makeTouchButton(this)),
      m_all(makeTouchButton(this)),
      m_legend(new LegendStrip(this)),
      m_pausesGroup(new QGroupBox(this)),
      m_pauses(new PauseModel(this)),
      m_table(new QTableView(this)) {
  m_sourceNote->setWordWrap(true);
  m_live->setCheckable(true);
  m_live->setChecked(true);
  auto* top = new QHBoxLayout;
  top->addWidget(m_sourceNote, 1, Qt::AlignVCenter);
  top->addWidget(m_live);
  top->addWidget(m_all);

  auto* plots = new QVBoxLayout;
  plots->setSpacing(0);
  for (std::size_t index = 0; index < m_plots.size(); ++index) {
    m_plots[index] = new TimePlot(m_window, this);
    m_plots[index]->setPauses(&m_pauses->rows(), index == kFeedPlot);
    // The lowest plot also carries the times, the feed plot the labels of the pauses.
    plots->addWidget(m_plots[index], index == kFeedPlot ? 6 : 4);
  }
  m_plots[kFeedPlot]->setFromZero(true);
  m_plots[kFeedPlot]->setLeastSpan(10.0);
  auto* left = new QVBoxLayout;
  left->addLayout(plots, 1);
  left->addWidget(m_legend);

  m_table->setModel(m_pauses);
  styleTable(m_table);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setResizeContentsPrecision(50);  // not all of a long run
  auto* pauses = new QVBoxLayout(m_pausesGroup);
  auto* summary = new QGridLayout;
  summary->setHorizontalSpacing(16);
  summary->setColumnStretch(1, 1);
  for (std::size_t row = 0; row < m_summaryNames.size(); ++row) {
    m_summaryNames[row] = new QLabel(this);
    m_summaryValues[row] = makeValueLabel(this);
    summary->addWidget(m_summaryNames[row], static_cast<int>(row), 0);
    summary->addWidget(m_summaryValues[row], static_cast<int>(row), 1);
  }
  pauses->addLayout(summary);
  pauses->addWidget(m_table, 1);
  m_pausesGroup->setFixedWidth(330);

  auto* body = new QHBoxLayout;
  body->addLayout(left, 1);
  body->addWidget(m_pausesGroup);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addLayout(body, 1);

  connect(m_live, &QPushButton::clicked, m_window, &TimeWindow::goLive);
  connect(m_all, &QPushButton::clicked, m_window, &TimeWindow::showAll);
  connect(m_window, &TimeWindow::changed, this, [this] { m_live->setChecked(m_window->isLive()); });
  retranslate();
  restyle();
}

TracePage::~TracePage() = default;

void TracePage::clear() {
  for (TimePlot* plot : m_plots) {
    plot->clear();
  }
  m_pauses->clear();
  m_pauseTotal = {};
  m_source = Source::Nothing;
  m_pastStart.clear();
  m_window->clear();
  showNote();
  showSummary();
}

void TracePage::append(const TraceSample& sample) {
  if (m_source != Source::Live) {
    m_source = Source::Live;
    showNote();
  }
  if (sample.positionMm) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      m_plots[axis]->append(sample.atS, (*sample.positionMm)[axis]);
    }
  }
  if (sample.feedMmPerS) {
    m_plots[kFeedPlot]->append(sample.atS, base::mmPerMinFromMmPerS(*sample.feedMmPerS));
  }
  m_window->setEnd(sample.atS);
}

void TracePage::addPause(const trace::Pause& pause) {
  const QScrollBar* bar = m_table->verticalScrollBar();
  const bool atEnd = bar->value() >= bar->maximum();
  m_pauses->append(pause);
  m_pauseTotal += pause.duration;
  if (atEnd) {
    m_table->scrollToBottom();
  }
  showSummary();
  for (TimePlot* plot : m_plots) {
    plot->scheduleRedraw();
  }
}

void TracePage::showControlTrace(const std::shared_ptr<const trace::ControlTrace>& trace,
                                 const std::vector<trace::Pause>& pauses) {
  if (!trace || trace->samples.empty()) {
    return;  // the live samples stay: better than nothing
  }
  const base::Instant origin = trace->samples.front().at;
  std::array<std::unique_ptr<EnvelopeSeries>, base::kAxisCount + 1> series;
  for (auto& one : series) {
    one = std::make_unique<EnvelopeSeries>();
  }
  for (const trace::ControlSample& sample : trace->samples) {
    const double atS = base::toSeconds(sample.at - origin);
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      series[axis]->append(atS, sample.actualMm[axis]);
    }
    series[kFeedPlot]->append(atS, base::mmPerMinFromMmPerS(sample.feedMmPerS));
  }
  for (std::size_t index = 0; index < m_plots.size(); ++index) {
    m_plots[index]->setSeries(std::move(series[index]));
  }
  std::vector<trace::Pause> shifted = pauses;
  m_pauseTotal = {};
  for (trace::Pause& pause : shifted) {
    pause.start = base::Instant{pause.start - origin};
    m_pauseTotal += pause.duration;
  }
  m_pauses->setRows(shifted);
  m_cycle = trace->cycle;
  m_truncated = trace->truncated;
  m_source = Source::Control;
  m_window->clear();
  m_window->setEnd(base::toSeconds(trace->samples.back().at - origin));
  m_window->showAll();
  showNote();
  showSummary();
}

void TracePage::redrawNow() {
  for (TimePlot* plot : m_plots) {
    plot->redrawNow();
  }
}

void TracePage::retranslate() {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_plots[axis]->setTitle(QStringLiteral("%1, mm").arg(QLatin1Char(base::kAxisNames[axis])));
  }
  m_plots[kFeedPlot]->setTitle(tr("F, mm/min"));
  m_plots[kFeedPlot]->setTimeLabels(true, tr("Time, s"));
  m_live->setText(tr("Live"));
  m_live->setToolTip(tr("Follow the newest samples"));
  m_all->setText(tr("Show all"));
  m_all->setToolTip(tr("Wheel: zoom. Drag: move."));
  m_pausesGroup->setTitle(tr("Pauses (STOPRE)"));
  m_table->setAccessibleName(tr("Pauses (STOPRE)"));
  m_summaryNames[0]->setText(tr("Number"));
  m_summaryNames[1]->setText(tr("Mean"));
  m_summaryNames[2]->setText(tr("Total"));
  m_pauses->refresh();
  showNote();
  showSummary();
  showLegend();
}

void TracePage::restyle() {
  const QColor color = themeColors(palette()).text;
  m_live->setIcon(themedIcon(QStringLiteral("live"), color));
  m_all->setIcon(themedIcon(QStringLiteral("fit"), color));
  for (QLabel* label : m_summaryNames) {
    setMuted(label, palette());
  }
  showLegend();
}

void TracePage::setPastRun(const QString& start, const QString& program) {
  m_pastStart = start;
  m_pastProgram = program;
  showNote();
}

void TracePage::showNote() {
  const QString of =
      m_pastStart.isEmpty() ? QString() : tr("Run of %1, %2. ").arg(m_pastStart, m_pastProgram);
  switch (m_source) {
    case Source::Nothing:
      m_sourceNote->setStatus(Status::Unknown, of + tr("No samples yet"));
      break;
    case Source::Live:
      m_sourceNote->setStatus(of.isEmpty() ? Status::Busy : Status::Unknown,
                              of + tr("Live samples: read while the stream has time; short pauses "
                                      "may be missing from the curves"));
      break;
    case Source::Control: {
      const QString text =
          of + tr("The control's own trace: one sample every %1").arg(millisecondsText(m_cycle, 0));
      m_sourceNote->setStatus(
          m_truncated ? Status::Attention : Status::Good,
          m_truncated ? text + QStringLiteral("; ") + tr("incomplete: the trace memory was full")
                      : text);
      break;
    }
  }
}

void TracePage::showSummary() {
  const std::size_t count = m_pauses->rows().size();
  m_summaryValues[0]->setText(countText(count));
  m_summaryValues[1]->setText(count == 0 ? noValue()
                                         : millisecondsText(base::toMilliseconds(m_pauseTotal) /
                                                            static_cast<double>(count)));
  m_summaryValues[2]->setText(secondsText(base::toSeconds(m_pauseTotal), 2));
}

void TracePage::showLegend() {
  std::vector<LegendEntry> entries;
  for (const trace::PauseOrigin origin :
       {trace::PauseOrigin::Measured, trace::PauseOrigin::Inferred,
        trace::PauseOrigin::Predicted}) {
    entries.push_back({LegendEntry::Symbol::Fill, QPen(themeColors(palette()).line, 1),
                       pauseBrush(origin, palette()),
                       tr("%1: pause %2").arg(pauseOriginLetter(origin), pauseOriginText(origin))});
  }
  m_legend->setEntries(std::move(entries));
}

}  // namespace rivulet::widgets
