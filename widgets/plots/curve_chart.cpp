// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/curve_chart.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "widgets/common/theme.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

namespace {

constexpr double kChartPaddingPx = 6.0;
constexpr double kChartDotPx = 3.0;
constexpr double kChartLinePx = 1.8;
constexpr int kTicksAcross = 7;
constexpr int kTicksUp = 4;
constexpr double kRoom = 0.06;  ///< of the height, above and below the curves

}  // namespace

CurveChart::CurveChart(AxisScale x, AxisScale y, QWidget* parent) : QWidget(parent) {
  m_x.scale = x;
  m_y.scale = y;
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CurveChart::setTitles(const QString& name, const QString& x, const QString& y) {
  m_xTitle = x;
  m_yTitle = y;
  setAccessibleName(name);
  setToolTip(name);
  update();
}

void CurveChart::setCurves(std::vector<ChartCurve> curves) {
  m_curves = std::move(curves);
  for (ChartCurve& curve : m_curves) {
    std::erase_if(curve.points, [this](const QPointF& point) {
      return !m_x.has(point.x()) || !m_y.has(point.y());
    });
  }
  measure();
  update();
}

void CurveChart::setShown(const QRectF& shown) {
  m_shown = shown;
  measure();
  update();
}

void CurveChart::measure() {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double left = kNone;
  double right = -kNone;
  double low = kNone;
  double high = -kNone;
  for (const ChartCurve& curve : m_curves) {
    for (const QPointF& point : curve.points) {
      left = std::min(left, point.x());
      right = std::max(right, point.x());
      low = std::min(low, point.y());
      high = std::max(high, point.y());
    }
  }
  if (m_shown) {
    left = std::min(left, m_shown->left());
    right = std::max(right, m_shown->right());
    low = std::min(low, m_shown->top());
    high = std::max(high, m_shown->bottom());
  }
  if (m_y.scale == AxisScale::Logarithmic) {
    const double factor = std::pow(std::max(high / low, 1.2), kRoom);
    m_y.fit(low / factor, high * factor, kTicksUp);
  } else {
    const double room = kRoom * (high - low);
    m_y.fit(low - room, high + room, kTicksUp);
  }
  m_x.fit(left, right, kTicksAcross);
}

QSize CurveChart::minimumSizeHint() const {
  return {220, 130};
}

QSize CurveChart::sizeHint() const {
  return {420, 200};
}

void CurveChart::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  QFont small = font();
  small.setPointSizeF(kScopeFontPt);
  painter.setFont(small);
  const QFontMetricsF metrics(small);
  double widest = 0.0;
  for (const double tick : m_y.ticks) {
    widest = std::max(widest, metrics.horizontalAdvance(m_y.textOf(tick)));
  }
  const QRectF plot = QRectF(rect()).adjusted(
      widest + 2.0 * kChartPaddingPx, metrics.height() + 2.0 * kChartPaddingPx,
      -2.0 * kChartPaddingPx, -2.0 * metrics.height() - 2.0 * kChartPaddingPx);
  painter.setPen(colors.mutedText);
  painter.drawText(QRectF(plot.left(), plot.bottom() + metrics.height() + kChartPaddingPx,
                          plot.width(), metrics.height()),
                   Qt::AlignRight | Qt::AlignVCenter, m_xTitle);
  const auto place = [&](const QPointF& point) {
    return QPointF(plot.left() + m_x.share(point.x()) * plot.width(),
                   plot.bottom() - m_y.share(point.y()) * plot.height());
  };
  double written = -1e9;
  for (const double tick : m_x.ticks) {
    const double x = plot.left() + m_x.share(tick) * plot.width();
    painter.setPen(QPen(colors.grid, 1.0));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    const QString label = m_x.textOf(tick);
    const double width = metrics.horizontalAdvance(label);
    if (x - width / 2.0 > written + kChartPaddingPx) {
      painter.setPen(colors.text);
      const double at = std::min(x - width / 2.0, this->width() - width);
      painter.drawText(QPointF(at, plot.bottom() + kChartPaddingPx / 2.0 + metrics.ascent()),
                       label);
      written = at + width;
    }
  }
  for (const double tick : m_y.ticks) {
    const double y = plot.bottom() - m_y.share(tick) * plot.height();
    painter.setPen(QPen(colors.grid, 1.0));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(colors.text);
    painter.drawText(
        QRectF(0.0, y - metrics.height() / 2.0, plot.left() - kChartPaddingPx, metrics.height()),
        Qt::AlignRight | Qt::AlignVCenter, m_y.textOf(tick));
  }
  painter.setPen(QPen(colors.line, 1.0));
  painter.drawRect(plot);
  for (const ChartCurve& curve : m_curves) {
    const QColor color = ScopePane::curveColor(curve.color, palette());
    if (curve.isDots) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(color);
      for (const QPointF& point : curve.points) {
        painter.drawEllipse(place(point), kChartDotPx, kChartDotPx);
      }
      continue;
    }
    QPolygonF line;
    for (const QPointF& point : curve.points) {
      line.append(place(point));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, kChartLinePx));
    painter.drawPolyline(line);
  }
  const double room = drawLegend(painter, plot) - 2.0 * kChartPaddingPx;
  painter.setPen(colors.mutedText);
  painter.drawText(QPointF(kChartPaddingPx, kChartPaddingPx + metrics.ascent()),
                   metrics.elidedText(m_yTitle, Qt::ElideRight, room));
}

/// Names of the curves, from the right border to the left, above them.
double CurveChart::drawLegend(QPainter& painter, const QRectF& room) const {
  const QFontMetricsF metrics(painter.font());
  double right = room.right();
  for (auto curve = m_curves.rbegin(); curve != m_curves.rend(); ++curve) {
    if (curve->name.isEmpty()) {
      continue;
    }
    const double width = metrics.horizontalAdvance(curve->name);
    const double y = kChartPaddingPx + metrics.ascent();
    painter.setPen(themeColors(palette()).text);
    painter.drawText(QPointF(right - width, y), curve->name);
    right -= width + 2.0 * kChartPaddingPx;
    painter.setPen(QPen(ScopePane::curveColor(curve->color, palette()), 3.0));
    const double middle = y - metrics.ascent() / 2.0 + 1.0;
    painter.drawLine(QPointF(right - kChartPaddingPx, middle),
                     QPointF(right + kChartPaddingPx, middle));
    right -= 3.0 * kChartPaddingPx;
  }
  return right + kChartPaddingPx;
}

}  // namespace rivulet::widgets
