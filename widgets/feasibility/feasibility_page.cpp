// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/feasibility/feasibility_page.h"

#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/plots/legend_strip.h"

namespace rivulet::widgets {

using feasibility::Border;
using feasibility::Equation;
using feasibility::SweepAxis;

FeasibilityPage::FeasibilityPage(QWidget* parent)
    : Page(parent),
      m_hint(new StatusLabel(this)),
      m_tabs(new QTabWidget(this)),
      m_legend(new LegendStrip(this)) {
  m_hint->setWordWrap(true);
  for (const SweepAxis axis :
       {SweepAxis::PointDistance, SweepAxis::PointsPerLoop, SweepAxis::Delta}) {
    auto* chart = new RegionChart(axis, this);
    m_charts[static_cast<std::size_t>(axis)] = chart;
    m_tabs->addTab(chart, QString());
    connect(chart, &RegionChart::operatingPointRequested, this,
            &FeasibilityPage::operatingPointRequested);
  }
  m_tabs->setDocumentMode(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_hint);
  layout->addWidget(m_tabs, 1);
  layout->addWidget(m_legend);
  connect(m_tabs, &QTabWidget::currentChanged, this, [this] {
    showHint();
    showLegend();
  });
  retranslate();
  restyle();
}

void FeasibilityPage::setModel(const FeasibilityModel& model) {
  m_model = model;
  for (RegionChart* chart : m_charts) {
    chart->setModel(model);
  }
  showHint();
  showLegend();
}

void FeasibilityPage::setEditable(bool editable) {
  for (RegionChart* chart : m_charts) {
    chart->setEditable(editable);
  }
}

RegionChart* FeasibilityPage::chart(SweepAxis axis) const {
  return m_charts[static_cast<std::size_t>(axis)];
}

void FeasibilityPage::showChart(SweepAxis axis) {
  m_tabs->setCurrentWidget(chart(axis));
}

void FeasibilityPage::retranslate() {
  m_tabs->setTabText(0, tr("F over d_min"));
  m_tabs->setTabText(1, tr("F over N"));
  m_tabs->setTabText(2, tr("F over δ"));
  for (RegionChart* chart : m_charts) {
    chart->retranslate();
  }
  showHint();
  showLegend();
}

void FeasibilityPage::restyle() {
  for (RegionChart* chart : m_charts) {
    chart->restyle(palette());
  }
  showLegend();
}

void FeasibilityPage::showHint() {
  if (!m_model) {
    m_hint->setStatus(Status::Unknown, tr("Load a program to see where it can be streamed."));
    return;
  }
  const bool position = m_model->operatingPoint.method == base::MethodKind::Position;
  QString text = tr("Drag the ring to change the feed.");
  if (m_tabs->currentIndex() == 1) {
    text = position ? tr("Drag the ring to change N and the feed. Method position does not depend "
                         "on N.")
                    : tr("Drag the ring to change N and the feed.");
  } else if (m_tabs->currentIndex() == 2) {
    text = position ? tr("Drag the ring to change δ and the feed.")
                    : tr("Method signal does not use δ: the borders do not depend on it.");
  }
  m_hint->setStatus(Status::Plain, text);
}

void FeasibilityPage::showLegend() {
  const ThemeColors& colors = themeColors(palette());
  std::vector<LegendEntry> entries;
  entries.push_back(
      {LegendEntry::Symbol::Marker, QPen(colors.text, 2.0), {}, tr("Operating point")});
  entries.push_back(
      {LegendEntry::Symbol::Fill, QPen(colors.line, 1), colors.feasibleFill, tr("Feasible")});
  entries.push_back(
      {LegendEntry::Symbol::Fill, QPen(colors.line, 1), colors.safetyFill, tr("Safety band")});
  const auto* chart = static_cast<RegionChart*>(m_tabs->currentWidget());
  QPen published(colors.text, 1.4);
  published.setDashPattern({5.0, 4.0});
  for (const Border& border : chart->borders()) {
    if (!border.withSafety) {
      continue;
    }
    QString text;
    switch (border.equation) {
      case Equation::PointDistance:
        text = tr("(1) point distance");
        break;
      case Equation::Delta:
        text = tr("(2) distance δ");
        break;
      case Equation::Window:
        text =
            chart->decides(border) ? tr("(3) half a loop") : tr("(3) half a loop, for information");
        break;
      case Equation::RealWindow:
        text = tr("(3ᴺ) half a loop, real path");
        break;
    }
    entries.push_back({LegendEntry::Symbol::Line,
                       QPen(colors.equations[static_cast<std::size_t>(border.equation)],
                            chart->decides(border) ? 2.4 : 1.2),
                       {},
                       text});
  }
  entries.push_back({LegendEntry::Symbol::Line, published, {}, tr("dashed: as published")});
  if (m_tabs->currentIndex() == 0 && m_model && !m_model->smallestDistancesMm.empty()) {
    entries.push_back({LegendEntry::Symbol::Dot, QPen(Qt::NoPen), colors.mutedText,
                       tr("Smallest distances of the program")});
  }
  m_legend->setEntries(std::move(entries));
}

}  // namespace rivulet::widgets
