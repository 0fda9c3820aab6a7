// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/calibration/calibration_charts.h"

#include <QAreaSeries>
#include <QChart>
#include <QLineSeries>
#include <QLocale>
#include <QResizeEvent>
#include <QScatterSeries>
#include <QValueAxis>
#include <algorithm>
#include <array>

#include "widgets/calibration/access_source.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/chart_style.h"

namespace rivulet::widgets {

namespace {

constexpr double kLeftPx = 72.0;
constexpr double kRightPx = 18.0;
constexpr double kTopPx = 10.0;
constexpr double kBottomPx = 48.0;
constexpr double kMarkPx = 7.0;
constexpr int kTicksX = 8;
constexpr int kTicksY = 5;
constexpr double kRoomAbove = 1.08;
/// Only these percentiles are drawn: more would overlap.
constexpr std::array kMarked{500, 990};

QColor formColour(opcua::Grouping form, const QPalette& palette) {
  return themeColors(palette).equations[static_cast<std::size_t>(form)];
}

QPen linePen(opcua::Grouping form, bool write, const QPalette& palette) {
  QPen pen(formColour(form, palette), 2.0);
  if (!write) {
    pen.setDashPattern({4.0, 3.0});
  }
  return pen;
}

QPen markPen(int perMille, const QPalette& palette) {
  QPen pen(themeColors(palette).text, 1.6);
  if (perMille != kMarked.front()) {
    pen.setDashPattern({4.0, 3.0});
  }
  return pen;
}

}  // namespace

CalibrationChart::CalibrationChart(QWidget* parent)
    : QChartView(new QChart, parent), m_x(new QValueAxis(this)), m_y(new QValueAxis(this)) {
  setFrameShape(QFrame::NoFrame);
  setRenderHint(QPainter::Antialiasing);
  setMinimumHeight(150);
  chart()->setAnimationOptions(QChart::NoAnimation);
  chart()->addAxis(m_x, Qt::AlignBottom);
  chart()->addAxis(m_y, Qt::AlignLeft);
  m_palette = palette();
}

void CalibrationChart::resizeEvent(QResizeEvent* event) {
  // The plot area first: the axes are laid out around it when the chart takes its new size.
  chart()->setPlotArea(QRectF(kLeftPx, kTopPx, std::max(10.0, width() - kLeftPx - kRightPx),
                              std::max(10.0, height() - kTopPx - kBottomPx)));
  QChartView::resizeEvent(event);
}

void CalibrationChart::restyle(const QPalette& palette) {
  m_palette = palette;
  setBackgroundBrush(themeColors(palette).surface);
  styleChart(chart(), palette);
  redraw();
}

void CalibrationChart::clear() {
  chart()->removeAllSeries();
}

void CalibrationChart::add(QAbstractSeries* series) {
  chart()->addSeries(series);
  series->attachAxis(m_x);
  series->attachAxis(m_y);
}

void CalibrationChart::setRange(double xMin, double xMax, double yMax) {
  divideAxis(m_x, xMin, std::max(xMax, xMin + 1e-3), kTicksX);
  divideAxis(m_y, 0.0, std::max(yMax, 1e-3), kTicksY);
}

void CalibrationChart::setTitles(const QString& x, const QString& y) {
  m_x->setTitleText(x);
  m_y->setTitleText(y);
  chart()->setLocale(QLocale());
  redraw();
}

LinesChart::LinesChart(QWidget* parent) : CalibrationChart(parent) {
}

void LinesChart::setCalibration(const streaming::Calibration* calibration) {
  m_series = calibration == nullptr ? std::vector<streaming::AccessSeries>{} : calibration->series;
  m_fits = calibration == nullptr ? std::vector<streaming::AccessFit>{} : calibration->fits;
  redraw();
}

void LinesChart::retranslate() {
  setTitles(tr("R-parameters of the request"), tr("Duration, ms"));
}

void LinesChart::redraw() {
  clear();
  double cells = 1.0;
  double mostMs = 1.0;
  for (const streaming::AccessSeries& series : m_series) {
    cells = std::max(cells, static_cast<double>(series.nodes));
    mostMs = std::max(mostMs, base::toMilliseconds(series.mean));
  }
  for (const streaming::AccessFit& fit : m_fits) {
    auto* line = new QLineSeries;
    line->setPen(linePen(fit.grouping, fit.write, colours()));
    for (const double at : {0.0, cells}) {
      line->append(at, base::toMilliseconds(fit.at(at)));
    }
    add(line);
    auto* marks = new QScatterSeries;
    marks->setMarkerSize(kMarkPx);
    marks->setColor(formColour(fit.grouping, colours()));
    marks->setBorderColor(themeColors(colours()).surface);
    for (const streaming::AccessSeries& series : m_series) {
      if (series.write == fit.write && series.grouping == fit.grouping && series.shotsMade > 0) {
        marks->append(series.nodes, base::toMilliseconds(series.mean));
      }
    }
    add(marks);
  }
  setRange(0.0, cells, mostMs * kRoomAbove);
}

std::vector<LegendEntry> LinesChart::legend() const {
  std::vector<LegendEntry> entries;
  std::vector<opcua::Grouping> shown;
  for (const streaming::AccessFit& fit : m_fits) {
    if (std::find(shown.begin(), shown.end(), fit.grouping) == shown.end()) {
      shown.push_back(fit.grouping);
      entries.push_back({LegendEntry::Symbol::Dot, QPen(Qt::NoPen),
                         formColour(fit.grouping, colours()), formText(fit.grouping)});
    }
  }
  if (!entries.empty()) {
    QPen pen(themeColors(colours()).text, 2.0);
    entries.push_back({LegendEntry::Symbol::Line, pen, {}, tr("write")});
    pen.setDashPattern({4.0, 3.0});
    entries.push_back({LegendEntry::Symbol::Line, pen, {}, tr("read")});
  }
  return entries;
}

HistogramChart::HistogramChart(QWidget* parent) : CalibrationChart(parent) {
}

void HistogramChart::setSeries(const std::optional<streaming::AccessSeries>& series) {
  m_series = series;
  redraw();
}

void HistogramChart::retranslate() {
  setTitles(tr("Duration, ms"), tr("Shots"));
}

void HistogramChart::redraw() {
  clear();
  if (!m_series || m_series->histogram.counts.empty()) {
    setRange(0.0, 10.0, 10.0);
    return;
  }
  const trace::Histogram& bins = m_series->histogram;
  auto* upper = new QLineSeries;
  auto* lower = new QLineSeries;
  std::size_t most = 1;
  const double width = base::toMilliseconds(bins.width);
  double left = base::toMilliseconds(bins.from);
  const double first = left;
  for (const std::size_t count : bins.counts) {
    for (const double at : {left, left + width}) {
      upper->append(at, static_cast<double>(count));
      lower->append(at, 0.0);
    }
    most = std::max(most, count);
    left += width;
  }
  auto* area = new QAreaSeries(upper, lower);
  upper->setParent(area);
  lower->setParent(area);
  const ThemeColors& colors = themeColors(colours());
  QColor fill = colors.trace;
  fill.setAlpha(110);
  area->setBrush(fill);
  area->setPen(QPen(colors.trace, 1.2));
  add(area);
  const double top = static_cast<double>(most) * kRoomAbove;
  for (const int perMille : kMarked) {
    if (const auto value = m_series->percentile(perMille)) {
      auto* mark = new QLineSeries;
      mark->setPen(markPen(perMille, colours()));
      mark->append(base::toMilliseconds(*value), 0.0);
      mark->append(base::toMilliseconds(*value), top);
      add(mark);
    }
  }
  setRange(std::max(0.0, first - width), left + width, top);
}

std::vector<LegendEntry> HistogramChart::legend() const {
  std::vector<LegendEntry> entries;
  if (!m_series || m_series->shotsMade == 0) {
    return entries;
  }
  QColor fill = themeColors(colours()).trace;
  fill.setAlpha(110);
  entries.push_back({LegendEntry::Symbol::Fill, QPen(themeColors(colours()).trace, 1.2), fill,
                     QStringLiteral("%1, %2, n = %3")
                         .arg(m_series->write ? tr("write") : tr("read"),
                              formText(m_series->grouping), QString::number(m_series->nodes))});
  for (const int perMille : kMarked) {
    if (const auto value = m_series->percentile(perMille)) {
      entries.push_back(
          {LegendEntry::Symbol::Line,
           markPen(perMille, colours()),
           {},
           tr("%1 %: %2").arg(QString::number(perMille / 10), millisecondsText(*value, 2))});
    }
  }
  if (m_series->histogram.above > 0) {
    entries.push_back(
        {LegendEntry::Symbol::Line,
         QPen(Qt::NoPen),
         {},
         tr("%1 beyond, the longest %2")
             .arg(countText(m_series->histogram.above), millisecondsText(m_series->max, 2))});
  }
  return entries;
}

}  // namespace rivulet::widgets
