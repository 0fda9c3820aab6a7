// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/feasibility/feasibility_page.h"

#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/feasibility/advice_panel.h"
#include "widgets/plots/legend_strip.h"

namespace rivulet::widgets {

using feasibility::Border;
using feasibility::Equation;
using feasibility::SweepAxis;

namespace {

constexpr int kAdvicePx = 300;
constexpr int kAdviceMostPx = 460;
constexpr int kWidePx = 760;
constexpr int kButtonRoomPx = 28;  // beside the text, both sides together

}  // namespace

FeasibilityPage::FeasibilityPage(QWidget* parent)
    : Page(parent),
      m_simulate(
          say(new QPushButton(this), {.text = QT_TR_NOOP("Simulate around the operating point")})),
      m_progress(new QProgressBar(this)),
      m_cancel(say(new QPushButton(this), {.text = QT_TR_NOOP("Cancel")})),
      m_tabs(new QTabWidget(this)),
      m_legend(new LegendStrip(this)),
      m_advice(new AdvicePanel(this)),
      m_columns(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  for (const SweepAxis axis :
       {SweepAxis::PointDistance, SweepAxis::PointsPerLoop, SweepAxis::Delta}) {
    auto* chart = new RegionChart(axis, this);
    m_charts[static_cast<std::size_t>(axis)] = chart;
    m_tabs->addTab(chart, QString());
    connect(chart, &RegionChart::operatingPointRequested, this,
            &FeasibilityPage::operatingPointRequested);
  }
  m_tabs->setDocumentMode(true);
  auto* layout = new QVBoxLayout;
  m_columns->addLayout(layout, 1);
  m_columns->addWidget(m_advice);
  layout->addWidget(m_hint);
  layout->addWidget(m_tabs, 1);
  layout->addWidget(m_legend);
  layout->addWidget(m_access);
  m_progress->setRange(0, 100);
  for (QPushButton* button : {m_simulate, m_cancel}) {
    button->setMinimumHeight(kTouchHeightPx);
  }
  layout->addLayout(inRow({m_simulate, {m_progress, 1}, m_cancel, spring()}));
  connect(m_simulate, &QPushButton::clicked, this, [this] {
    const auto* chart = static_cast<RegionChart*>(m_tabs->currentWidget());
    const SimulationWanted wanted = chart->simulationWanted();
    if (!wanted.abscissas.empty()) {
      Q_EMIT simulationRequested(wanted);
    }
  });
  connect(m_cancel, &QPushButton::clicked, this, &FeasibilityPage::simulationCancelRequested);
  connect(m_advice, &AdvicePanel::operatingPointRequested, this,
          &FeasibilityPage::operatingPointRequested);
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
  m_advice->setVerdict(model.verdict);
  m_advice->setOperatingPoint(model.operatingPoint, model.pointsPerLoopMax, model.scale);
  showTitles();
  dropStaleRegions();
  showSimulation();
  showHint();
  showAccess();
  showLegend();
}

void FeasibilityPage::setRegion(const SimulatedRegion& region) {
  chart(region.axis)->setRegion(region);
  dropStaleRegions();
  showHint();
  showLegend();
}

void FeasibilityPage::clearRegions() {
  for (RegionChart* chart : m_charts) {
    chart->setRegion(std::nullopt);
  }
  showHint();
  showLegend();
}

void FeasibilityPage::setSimulationProgress(std::optional<int> percent) {
  m_percent = percent;
  showSimulation();
}

/// The feed may change, because each simulated point has its own; the swept quantity may change
/// too.
void FeasibilityPage::dropStaleRegions() {
  for (RegionChart* chart : m_charts) {
    if (!chart->region() || !m_model) {
      continue;
    }
    const SimulatedRegion& region = *chart->region();
    const feasibility::OperatingPoint& now = m_model->operatingPoint;
    const feasibility::OperatingPoint& then = region.operatingPoint;
    const bool position = base::usesDelta(now.method);
    const bool holds =
        now.method == then.method && now.cellsPerPoint == then.cellsPerPoint &&
        m_model->scale == region.scale &&
        (region.axis == SweepAxis::PointsPerLoop || now.pointsPerLoop == then.pointsPerLoop) &&
        (!position || region.axis == SweepAxis::Delta || now.deltaMm == then.deltaMm);
    if (!holds) {
      chart->setRegion(std::nullopt);
    }
  }
}

void FeasibilityPage::showSimulation() {
  const bool busy = m_percent.has_value();
  const bool known = m_model && m_model->distances.windowSteps > 0;
  m_simulate->setVisible(!busy);
  m_simulate->setEnabled(m_editable && known);
  m_progress->setVisible(busy);
  m_cancel->setVisible(busy);
  m_progress->setValue(m_percent.value_or(0));
}

void FeasibilityPage::setEditable(bool editable) {
  m_editable = editable;
  m_advice->setEditable(editable);
  showSimulation();
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
  showTitles();
  for (RegionChart* chart : m_charts) {
    chart->retranslate();
  }
  m_progress->setFormat(tr("Simulating: %p %"));
  for (QPushButton* button : {m_simulate, m_cancel}) {
    button->setMinimumWidth(button->sizeHint().width() + kButtonRoomPx);
  }
  showSimulation();
  showHint();
  showAccess();
  showLegend();
}

void FeasibilityPage::showTitles() {
  const bool isOverride = m_model && m_model->scale.isOverride();
  m_tabs->setTabText(0, isOverride ? tr("Override over t_min") : tr("F over d_min"));
  m_tabs->setTabText(1, isOverride ? tr("Override over N") : tr("F over N"));
  m_tabs->setTabText(2, isOverride ? tr("Override over δ") : tr("F over δ"));
}

void FeasibilityPage::restyle() {
  for (RegionChart* chart : m_charts) {
    chart->restyle(palette());
  }
  showLegend();
}

void FeasibilityPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  // Beside the chart if that leaves it its size, else below it.
  const bool isWide = width() >= kWidePx;
  m_columns->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  const int width = std::clamp(this->width() / 3, kAdvicePx, kAdviceMostPx);
  m_advice->setMinimumWidth(isWide ? width : 0);
  m_advice->setMaximumWidth(isWide ? width : QWIDGETSIZE_MAX);
}

void FeasibilityPage::showAccess() {
  m_access->setVisible(m_model.has_value());
  if (m_model) {
    const feasibility::OperatingPoint& point = m_model->operatingPoint;
    const AccessSourceText shown =
        accessSourceText(m_model->source, m_model->access.timePerNode(point.turn()));
    m_access->setStatus(shown.status, shown.text);
  }
}

void FeasibilityPage::showHint() {
  if (!m_model) {
    m_hint->setStatus(Status::Unknown, tr("Load a program to see where it can be streamed."));
    return;
  }
  const bool position = base::usesDelta(m_model->operatingPoint.method);
  const bool isOverride = m_model->scale.isOverride();
  QString text = isOverride
                     ? tr("Drag the ring to change the override on the feeds of the program.")
                     : tr("Drag the ring to change the feed.");
  if (m_tabs->currentIndex() == 1 && isOverride) {
    text = tr("Drag the ring to change N and the override.");
  } else if (m_tabs->currentIndex() == 1) {
    text = position ? tr("Drag the ring to change N and the feed. Method position does not depend "
                         "on N.")
                    : tr("Drag the ring to change N and the feed.");
  } else if (m_tabs->currentIndex() == 2) {
    text = position ? tr("Drag the ring to change δ and the feed.")
                    : tr("This method does not use δ: the limits do not depend on it.");
  }
  if (!m_model->limitedBy.isEmpty()) {
    text += QLatin1Char(' ') + tr("Largest override: %1.").arg(m_model->limitedBy);
  }
  const auto* shown = static_cast<RegionChart*>(m_tabs->currentWidget());
  if (shown->region()) {
    text += QLatin1Char(' ') +
            tr("Simulated on the virtual machine, %1 points around the tightest place.")
                .arg(countText(shown->region()->programPoints));
  }
  m_hint->setStatus(Status::Plain, text);
}

void FeasibilityPage::showLegend() {
  const ThemeColors& colors = themeColors(palette());
  std::vector<LegendEntry> entries;
  entries.push_back(
      {LegendEntry::Symbol::Marker, QPen(colors.text, 2.0), {}, tr("Operating point")});
  const bool window = m_model && base::hasWindows(m_model->operatingPoint.method);
  entries.push_back({LegendEntry::Symbol::Fill, QPen(colors.line, 1), colors.feasibleFill,
                     window ? tr("Without waiting") : tr("Feasible")});
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
      case Equation::Reach:
        text = tr("reach: the client keeps up");
        break;
      case Equation::Machine:
        break;  // has no border
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
                       m_model->scale.isOverride() ? tr("Shortest moves of the program")
                                                   : tr("Smallest distances of the program")});
  }
  if (chart->region()) {
    const std::array<QColor, 3> simulated = RegionChart::pointColors(palette());
    entries.push_back({LegendEntry::Symbol::Dot, QPen(Qt::NoPen), simulated[0], tr("Runs")});
    entries.push_back(
        {LegendEntry::Symbol::Triangle, QPen(Qt::NoPen), simulated[1], tr("Sometimes fails")});
    entries.push_back(
        {LegendEntry::Symbol::Square, QPen(Qt::NoPen), simulated[2], tr("Always fails")});
    entries.push_back({LegendEntry::Symbol::Fill, QPen(colors.line, 1),
                       RegionChart::bandBrush(palette()), tr("Model: 0.1 % to 50 % fail")});
    QColor failed = colors.fault;
    failed.setAlphaF(0.45F);
    entries.push_back({LegendEntry::Symbol::Fill, QPen(colors.line, 1), failed,
                       tr("Runs failed in the simulation")});
  }
  m_legend->setEntries(std::move(entries));
}

}  // namespace rivulet::widgets
