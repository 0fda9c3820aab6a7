// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/box_plot.h"

#include <QPainter>
#include <algorithm>
#include <limits>
#include <utility>

#include "base/quantile.h"
#include "widgets/common/theme.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

namespace {

constexpr double kBoxPaddingPx = 6.0;
constexpr double kBoxNamesShare = 0.45;  ///< of the width, at most
constexpr double kBoxRowPx = 20.0;       ///< least height
constexpr double kBoxRowPxMax = 40.0;
constexpr double kBoxHeightShare = 0.5;  ///< of its row
constexpr double kBoxPxMin = 3.0;        ///< one value is a box as well
constexpr int kBoxTicks = 6;
constexpr double kBoxRoom = 1.15;  ///< factor beside the outermost values

}  // namespace

BoxPlot::BoxPlot(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void BoxPlot::setTitles(const QString& name, const QString& values) {
  m_title = values;
  setAccessibleName(name);
  setToolTip(name);
  update();
}

void BoxPlot::setBoxes(std::vector<ChartBox> boxes) {
  m_boxes = std::move(boxes);
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (ChartBox& box : m_boxes) {
    std::erase_if(box.values, [this](double value) { return !m_axis.has(value); });
    std::ranges::sort(box.values);
    if (!box.values.empty()) {
      least = std::min(least, box.values.front());
      greatest = std::max(greatest, box.values.back());
    }
  }
  std::erase_if(m_boxes, [](const ChartBox& box) { return box.values.empty(); });
  m_axis.fit(least / kBoxRoom, greatest * kBoxRoom, kBoxTicks);
  updateGeometry();
  update();
}

QSize BoxPlot::minimumSizeHint() const {
  return {260, 60 + static_cast<int>(kBoxRowPx * static_cast<double>(m_boxes.size()))};
}

QSize BoxPlot::sizeHint() const {
  return {460, minimumSizeHint().height()};
}

void BoxPlot::drawBox(QPainter& painter, const ChartBox& box, const QRectF& row) const {
  const auto place = [&](double value) { return row.left() + m_axis.share(value) * row.width(); };
  const double low = place(base::quantile(box.values, 250));
  const double high = std::max(low + kBoxPxMin, place(base::quantile(box.values, 750)));
  const double median = place(base::quantile(box.values, 500));
  const double middle = row.center().y();
  const double height = kBoxHeightShare * row.height();
  const QColor color = ScopePane::curveColor(box.color, palette());
  painter.setPen(QPen(color, 1.5));
  const double least = place(box.values.front());
  const double greatest = place(box.values.back());
  painter.drawLine(QPointF(least, middle), QPointF(low, middle));
  painter.drawLine(QPointF(high, middle), QPointF(greatest, middle));
  for (const double end : {least, greatest}) {
    painter.drawLine(QPointF(end, middle - height / 4.0), QPointF(end, middle + height / 4.0));
  }
  QColor fill = color;
  fill.setAlphaF(0.35F);
  painter.setBrush(fill);
  painter.drawRect(QRectF(low, middle - height / 2.0, high - low, height));
  painter.setPen(QPen(themeColors(palette()).text, 2.0));
  painter.drawLine(QPointF(median, middle - height / 2.0), QPointF(median, middle + height / 2.0));
}

void BoxPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  if (m_boxes.empty()) {
    return;
  }
  QFont small = font();
  small.setPointSizeF(kScopeFontPt);
  painter.setFont(small);
  const QFontMetricsF metrics(small);
  double widest = 0.0;
  for (const ChartBox& box : m_boxes) {
    widest = std::max(widest, metrics.horizontalAdvance(box.name));
  }
  const double namesPx = std::min(widest, kBoxNamesShare * width());
  const double left = namesPx + 2.0 * kBoxPaddingPx;
  const double rowHeight =
      std::min(kBoxRowPxMax, (height() - 2.0 * metrics.height() - 4.0 * kBoxPaddingPx) /
                                 static_cast<double>(m_boxes.size()));
  const QRectF plot(left, kBoxPaddingPx, width() - left - 2.0 * kBoxPaddingPx,
                    rowHeight * static_cast<double>(m_boxes.size()));
  double written = -1e9;
  for (const double tick : m_axis.ticks) {
    const double x = plot.left() + m_axis.share(tick) * plot.width();
    painter.setPen(QPen(colors.grid, 1.0));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    const QString label = m_axis.textOf(tick);
    const double width = metrics.horizontalAdvance(label);
    if (x - width / 2.0 > written + kBoxPaddingPx) {
      painter.setPen(colors.text);
      const double at = std::min(x - width / 2.0, this->width() - width);
      painter.drawText(QPointF(at, plot.bottom() + kBoxPaddingPx / 2.0 + metrics.ascent()), label);
      written = at + width;
    }
  }
  painter.setPen(colors.mutedText);
  painter.drawText(QRectF(plot.left(), plot.bottom() + metrics.height() + kBoxPaddingPx,
                          plot.width(), metrics.height()),
                   Qt::AlignRight | Qt::AlignVCenter, m_title);
  painter.setPen(QPen(colors.line, 1.0));
  painter.drawRect(plot);
  for (std::size_t i = 0; i < m_boxes.size(); ++i) {
    const double y = plot.top() + rowHeight * static_cast<double>(i);
    painter.setPen(colors.text);
    painter.setBrush(Qt::NoBrush);
    painter.drawText(QRectF(kBoxPaddingPx, y, namesPx, rowHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(m_boxes[i].name, Qt::ElideRight, namesPx));
    drawBox(painter, m_boxes[i], QRectF(plot.left(), y, plot.width(), rowHeight));
  }
}

}  // namespace rivulet::widgets
