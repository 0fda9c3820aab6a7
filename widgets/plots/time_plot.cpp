// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/time_plot.h"

#include <QChart>
#include <QChartView>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLineSeries>
#include <QLocale>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QValueAxis>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "base/nice_step.h"
#include "widgets/common/theme.h"
#include "widgets/plots/chart_style.h"
#include "widgets/plots/pause_bands.h"
#include "widgets/plots/time_window.h"

namespace rivulet::widgets {

namespace {

// One left margin for all plots, so that stacked ones share their time axis to the pixel.
constexpr double kLeftPx = 84.0;
constexpr double kRightPx = 14.0;
constexpr double kTopPx = 8.0;
constexpr double kBottomPx = 8.0;
constexpr double kBottomWithLabelsPx = 46.0;
constexpr std::size_t kLinesMax = 64;  // stretches between gaps drawn at once

}  // namespace

TimePlot::TimePlot(TimeWindow* window, QWidget* parent)
    : Page(parent),
      m_window(window),
      m_series(std::make_unique<EnvelopeSeries>()),
      m_chart(new QChart),
      m_view(new QChartView(m_chart, this)),
      m_timeAxis(new QValueAxis(this)),
      m_valueAxis(new QValueAxis(this)),
      m_bands(new PauseBands(m_chart)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_view);
  m_view->setFrameShape(QFrame::NoFrame);
  m_view->setRenderHint(QPainter::Antialiasing);
  m_view->setMinimumHeight(80);
  m_chart->addAxis(m_timeAxis, Qt::AlignBottom);
  m_chart->addAxis(m_valueAxis, Qt::AlignLeft);
  m_chart->setAnimationOptions(QChart::NoAnimation);
  m_bands->setZValue(1.0);  // above the background, below the curves
  m_redraw.setSingleShot(true);
  m_redraw.setInterval(kRedrawIntervalMs);
  connect(&m_redraw, &QTimer::timeout, this, &TimePlot::redraw);
  connect(m_window, &TimeWindow::changed, this, &TimePlot::scheduleRedraw);
  connect(m_chart, &QChart::plotAreaChanged, this, &TimePlot::scheduleRedraw);
  m_view->installEventFilter(this);
  m_view->viewport()->installEventFilter(this);
  setTimeLabels(false, {});
  restyle();
}

TimePlot::~TimePlot() = default;

void TimePlot::setTitle(const QString& title) {
  m_valueAxis->setTitleText(title);
}

void TimePlot::setTimeLabels(bool visible, const QString& title) {
  m_timeLabels = visible;
  m_timeAxis->setLabelsVisible(visible);
  m_timeAxis->setTitleText(title);
  m_timeAxis->setTitleVisible(visible);
  layOut(m_view->size());
  m_chart->layout()->invalidate();
}

void TimePlot::append(double atS, double value) {
  m_series->append(atS, value);
  scheduleRedraw();
}

void TimePlot::setSeries(std::unique_ptr<EnvelopeSeries> series) {
  m_series = std::move(series);
  scheduleRedraw();
}

void TimePlot::clear() {
  m_series->clear();
  scheduleRedraw();
}

void TimePlot::setPauses(const std::vector<trace::Pause>* pauses, bool labels) {
  m_bands->setPauses(pauses, labels);
}

void TimePlot::scheduleRedraw() {
  if (!m_redraw.isActive()) {
    m_redraw.start();
  }
}

void TimePlot::redrawNow() {
  m_redraw.stop();
  redraw();
}

void TimePlot::retranslate() {
  m_chart->setLocale(QLocale());
  m_bands->update();
}

void TimePlot::restyle() {
  styleChart(m_chart, palette());
  m_view->setBackgroundBrush(themeColors(palette()).surface);
  m_bands->setPalette(palette());
  for (QLineSeries* line : m_lines) {
    line->setPen(QPen(themeColors(palette()).trace, 1.6));
  }
}

bool TimePlot::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_view) {
    if (event->type() == QEvent::Resize) {
      // Before the view itself is resized: the axes are laid out around the plot area when the
      // chart takes its new size.
      layOut(static_cast<QResizeEvent*>(event)->size());
    }
    return false;
  }
  const QRectF area = m_chart->plotArea();
  const double secondsPerPixel =
      (m_window->toS() - m_window->fromS()) / std::max(area.width(), 1.0);
  switch (event->type()) {
    case QEvent::Wheel: {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      m_window->zoom(std::pow(0.9985, wheel->angleDelta().y()), secondsAt(wheel->position().x()));
      return true;
    }
    case QEvent::MouseButtonPress:
      m_dragX = static_cast<QMouseEvent*>(event)->position().x();
      return true;
    case QEvent::MouseMove:
      if (m_dragX) {
        const double x = static_cast<QMouseEvent*>(event)->position().x();
        m_window->pan((*m_dragX - x) * secondsPerPixel);
        m_dragX = x;
      }
      return true;
    case QEvent::MouseButtonRelease:
      m_dragX.reset();
      return true;
    default:
      return Page::eventFilter(watched, event);
  }
}

void TimePlot::layOut(QSizeF size) {
  const double bottom = m_timeLabels ? kBottomWithLabelsPx : kBottomPx;
  m_chart->setPlotArea(QRectF(kLeftPx, kTopPx, std::max(size.width() - kLeftPx - kRightPx, 10.0),
                              std::max(size.height() - kTopPx - bottom, 10.0)));
  scheduleRedraw();
}

void TimePlot::redraw() {
  const double fromS = m_window->fromS();
  const double toS = m_window->toS();
  const QRectF area = m_chart->plotArea();
  divideAxis(m_timeAxis, fromS, toS, std::clamp(static_cast<int>(area.width() / 75.0), 2, 20));

  double min = 0.0;
  double max = m_leastSpan;
  if (const auto range = m_series->range(fromS, toS)) {
    min = m_fromZero ? 0.0 : range->min;
    max = range->max;
    const double padding = std::max(0.08 * (max - min), (m_leastSpan - (max - min)) / 2.0);
    max += padding;
    if (!m_fromZero) {
      min -= padding;
    }
  }
  const int ticks = std::clamp(static_cast<int>(area.height() / 34.0), 1, 6);
  const double step = base::niceStepAbove((max - min) / ticks);
  min = std::floor(min / step) * step;
  max = std::ceil(max / step) * step;
  divideAxis(m_valueAxis, min, max, ticks);

  const auto lines =
      m_series->lines(fromS, toS, static_cast<std::size_t>(std::clamp(area.width(), 16.0, 4000.0)));
  const std::size_t shown = std::min(lines.size(), kLinesMax);
  for (std::size_t index = 0; index < shown; ++index) {
    lineSeries(index)->replace(lines[index]);
  }
  for (std::size_t index = shown; index < m_lines.size(); ++index) {
    m_lines[index]->clear();
  }
  m_bands->setArea(area, fromS, toS);
  Q_EMIT redrawn();
}

QLineSeries* TimePlot::lineSeries(std::size_t index) {
  while (m_lines.size() <= index) {
    auto* line = new QLineSeries;
    line->setPen(QPen(themeColors(palette()).trace, 1.6));
    m_chart->addSeries(line);
    line->attachAxis(m_timeAxis);
    line->attachAxis(m_valueAxis);
    m_lines.push_back(line);
  }
  return m_lines[index];
}

double TimePlot::secondsAt(double x) const {
  const QRectF area = m_chart->plotArea();
  return m_window->fromS() +
         (x - area.left()) / std::max(area.width(), 1.0) * (m_window->toS() - m_window->fromS());
}

}  // namespace rivulet::widgets
