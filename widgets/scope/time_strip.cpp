// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/time_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "base/nice_step.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

namespace {

constexpr double kOverviewPx = 30.0;
constexpr double kFrameMinPx = 6.0;

}  // namespace

TimeStrip::TimeStrip(ScopeCurves* curves, TimeWindow* window, const std::vector<StopRow>* stops,
                     QWidget* parent)
    : Page(parent), m_curves(curves), m_window(window), m_stops(stops) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont small = font();
  small.setPointSizeF(kScopeFontPt);
  setFont(small);
  connect(m_window, &TimeWindow::changed, this, qOverload<>(&QWidget::update));
  connect(m_curves, &ScopeCurves::changed, this, qOverload<>(&QWidget::update));
  retranslate();
  onTheme([this] { update(); });
}

void TimeStrip::setFormula(const QString& formula) {
  m_formula = formula;
  update();
}

QSize TimeStrip::minimumSizeHint() const {
  return {180, fontMetrics().height() + static_cast<int>(kOverviewPx) + 8};
}

QSize TimeStrip::sizeHint() const {
  return minimumSizeHint();
}

TimeArea TimeStrip::overview() const {
  return {QRectF(kScopeLeftPx, height() - kOverviewPx - 2.0,
                 std::max(width() - kScopeLeftPx - kScopeRightPx, 10.0), kOverviewPx),
          0.0, std::max(m_window->endS(), 1e-3)};
}

void TimeStrip::paintTimes(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const QFontMetricsF metrics(font());
  const TimeArea seen{overview().rect, m_window->fromS(), m_window->toS()};
  const double step = base::niceStepAbove((seen.toS - seen.fromS) /
                                          std::clamp(seen.rect.width() / 75.0, 2.0, 20.0));
  const int decimals = std::min(base::decimalsOfStep(step), 6);
  painter.setPen(colors.text);
  double free = 0.0;
  for (double at = std::ceil(seen.fromS / step) * step; at <= seen.toS; at += step) {
    const QString text = numberText(std::abs(at) < step / 2.0 ? 0.0 : at, decimals);
    const double wide = metrics.horizontalAdvance(text);
    const double left = std::clamp(seen.xOf(at) - wide / 2.0, kScopeLeftPx - 6.0, width() - wide);
    if (left >= free) {
      painter.drawText(QRectF(left, 1.0, wide + 2.0, metrics.height()), Qt::AlignCenter, text);
      free = left + wide + 8.0;
    }
  }
  painter.setPen(colors.mutedText);
  painter.drawText(QRectF(0.0, 1.0, kScopeLeftPx - 10.0, metrics.height()),
                   Qt::AlignRight | Qt::AlignVCenter, m_curves->axisTitle());
}

const QPolygonF& TimeStrip::overviewLine() {
  const TimeArea whole = overview();
  const auto samples = m_curves->samples(0, m_formula);
  const std::size_t size = samples ? samples->size() : 0;
  if (samples == m_lineOf && size == m_lineSize && whole.rect == m_lineRect &&
      whole.toS == m_lineEndS) {
    return m_line;
  }
  m_lineOf = samples;
  m_lineSize = size;
  m_lineRect = whole.rect;
  m_lineEndS = whole.toS;
  m_line.clear();
  if (size == 0) {
    return m_line;
  }
  const auto range = samples->range(instantOf(whole.fromS), instantOf(whole.toS));
  const double min = range ? range->min : 0.0;
  const double span = range && range->max > range->min ? range->max - range->min : 1.0;
  for (const trace::SeriesPoint& point :
       samples->visible(instantOf(whole.fromS), instantOf(whole.toS),
                        static_cast<std::size_t>(std::max(16.0, whole.rect.width())))) {
    if (std::isfinite(point.value)) {
      m_line.append(
          {whole.xOf(base::toSeconds(point.at)),
           whole.rect.bottom() - 3.0 - (point.value - min) / span * (whole.rect.height() - 6.0)});
    }
  }
  return m_line;
}

void TimeStrip::paintOverview(QPainter& painter) {
  const ThemeColors& colors = themeColors(palette());
  const TimeArea whole = overview();
  painter.save();
  paintStopBands(painter, whole, *m_stops, false, palette());
  painter.restore();
  painter.setClipRect(whole.rect);
  if (const QPolygonF& line = overviewLine(); !line.isEmpty()) {
    painter.setPen(QPen(colors.trace, 1.0));
    painter.drawPolyline(line);
  }
  painter.setClipping(false);
  painter.setPen(QPen(colors.line, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(whole.rect.adjusted(0.5, 0.5, -0.5, -0.5));
  const double left =
      std::clamp(whole.xOf(m_window->fromS()), whole.rect.left(), whole.rect.right());
  const double right =
      std::clamp(whole.xOf(m_window->toS()), whole.rect.left(), whole.rect.right());
  const double wide = std::max(right - left, kFrameMinPx);
  const double at = std::min(left, whole.rect.right() - wide);
  QColor fill = colors.accent;
  fill.setAlpha(40);
  painter.setPen(QPen(colors.accent, 2));
  painter.setBrush(fill);
  painter.drawRect(QRectF(at, whole.rect.top(), wide, whole.rect.height()).adjusted(1, 1, -1, -1));
}

void TimeStrip::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  paintOn(painter);
}

void TimeStrip::paintOn(QPainter& painter) {
  painter.fillRect(rect(), themeColors(palette()).surface);
  painter.setFont(font());
  paintTimes(painter);
  paintOverview(painter);
}

void TimeStrip::mousePressEvent(QMouseEvent* event) {
  const double at = overview().secondsAt(event->position().x());
  const double middle = (m_window->fromS() + m_window->toS()) / 2.0;
  const bool isInFrame = at >= m_window->fromS() && at <= m_window->toS();
  m_grabS = isInFrame ? at - middle : 0.0;
  mouseMoveEvent(event);
}

void TimeStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) {
    const double at = overview().secondsAt(event->position().x()) - m_grabS;
    const double middle = (m_window->fromS() + m_window->toS()) / 2.0;
    m_window->pan(at - middle);
  }
}

void TimeStrip::retranslate() {
  setAccessibleName(tr("Overview of the whole trace"));
  update();
}

}  // namespace rivulet::widgets
