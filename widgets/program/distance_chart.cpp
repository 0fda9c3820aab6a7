// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/distance_chart.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr double kBarPxMin = 3.0;  // a single point of a million is to be seen
constexpr double kLabelPx = 20.0;

/// "0.01" with as many decimals as it needs.
QString distanceText(double distanceMm, int more = 0) {
  const int decimals = static_cast<int>(std::ceil(-std::log10(distanceMm) - 1e-9)) + more;
  return numberText(distanceMm, std::clamp(decimals, 0, 9));
}

}  // namespace

DistanceChart::DistanceChart(QWidget* parent) : QWidget(parent) {
}

void DistanceChart::setHistogram(feasibility::DistanceHistogram histogram) {
  m_histogram = std::move(histogram);
  update();
}

QRectF DistanceChart::plot() const {
  return QRectF(rect()).adjusted(8.0, 6.0, -8.0, -kLabelPx - 4.0);
}

double DistanceChart::placeOf(double distanceMm) const {
  const double low = std::log10(m_histogram.bordersMm.front());
  const double high = std::log10(m_histogram.bordersMm.back());
  const QRectF area = plot();
  if (!(high > low)) {
    return area.center().x();
  }
  return area.left() + area.width() * (std::log10(distanceMm) - low) / (high - low);
}

QRectF DistanceChart::bar(std::size_t one) const {
  const QRectF area = plot();
  const std::size_t most = *std::max_element(m_histogram.counts.begin(), m_histogram.counts.end());
  double left = placeOf(m_histogram.bordersMm[one]);
  double right = placeOf(m_histogram.bordersMm[one + 1]);
  if (m_histogram.counts.size() == 1) {
    left -= 10.0;
    right += 10.0;
  }
  const std::size_t count = m_histogram.counts[one];
  const double height =
      count == 0 ? 0.0
                 : std::max(kBarPxMin, area.height() * static_cast<double>(count) /
                                           static_cast<double>(std::max<std::size_t>(most, 1)));
  return {left, area.bottom() - height, std::max(1.0, right - left - 1.0), height};
}

void DistanceChart::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColors& colors = themeColors(palette());
  const QRectF area = plot();
  painter.fillRect(rect(), colors.surface);
  if (m_histogram.counts.empty()) {
    painter.setPen(colors.mutedText);
    painter.drawText(rect(), Qt::AlignCenter, noValue());
    return;
  }
  // Powers of ten as far as their labels have room; with less than two, the ends themselves.
  const double smallest = m_histogram.bordersMm.front();
  const double largest = m_histogram.bordersMm.back();
  std::vector<std::pair<double, QString>> labels;
  const int first = static_cast<int>(std::ceil(std::log10(smallest) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  const int every = std::max(
      1, static_cast<int>(std::ceil((last - first + 1) * 56.0 / std::max(area.width(), 56.0))));
  for (int decade = first; decade <= last; decade += every) {
    const double value = std::pow(10.0, decade);
    labels.emplace_back(std::clamp(value, smallest, largest), distanceText(value));
  }
  if (labels.size() < 2) {
    labels.clear();
    labels.emplace_back(smallest, distanceText(smallest, 2));
    if (placeOf(largest) - placeOf(smallest) > 80.0) {
      labels.emplace_back(largest, distanceText(largest, 2));
    }
  }
  for (const auto& [value, text] : labels) {
    const double x = placeOf(value);
    painter.setPen(colors.grid);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom() + 3.0));
    QRectF place(x - 40.0, area.bottom() + 4.0, 80.0, kLabelPx);
    place.moveLeft(std::clamp(place.left(), 2.0 - 20.0, width() - 62.0));
    painter.setPen(colors.mutedText);
    painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop, text);
  }
  for (std::size_t one = 0; one < m_histogram.counts.size(); ++one) {
    painter.fillRect(bar(one), colors.trace);
  }
  painter.setPen(colors.line);
  painter.drawLine(area.bottomLeft(), area.bottomRight());
}

bool DistanceChart::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    for (std::size_t one = 0; one < m_histogram.counts.size(); ++one) {
      const QRectF column = bar(one);
      if (help->pos().x() >= column.left() && help->pos().x() < column.right() + 1.0) {
        QToolTip::showText(help->globalPos(),
                           tr("%1 … %2: %3 distances")
                               .arg(distanceText(m_histogram.bordersMm[one], 2),
                                    lengthText(m_histogram.bordersMm[one + 1], 4),
                                    countText(m_histogram.counts[one])),
                           this);
        return true;
      }
    }
    QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

}  // namespace rivulet::widgets
