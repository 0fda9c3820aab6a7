// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/legend_strip.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kSymbolPx = 28;
constexpr int kSymbolGapPx = 6;
constexpr int kSpacingPx = 18;

}  // namespace

LegendStrip::LegendStrip(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void LegendStrip::setEntries(std::vector<LegendEntry> entries) {
  m_entries = std::move(entries);
  updateGeometry();
  update();
}

int LegendStrip::heightForWidth(int width) const {
  const std::vector<QRect> rects = places(width);
  return rects.empty() ? 0 : rects.back().bottom() + 1;
}

QSize LegendStrip::sizeHint() const {
  return {600, heightForWidth(600)};
}

QSize LegendStrip::minimumSizeHint() const {
  return {200, m_entries.empty() ? 0 : fontMetrics().height() + 6};
}

void LegendStrip::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& colors = themeColors(palette());
  const std::vector<QRect> rects = places(width());
  for (std::size_t index = 0; index < m_entries.size(); ++index) {
    const LegendEntry& entry = m_entries[index];
    const QRectF symbol(rects[index].left(), rects[index].top() + 3, kSymbolPx,
                        rects[index].height() - 6);
    painter.setPen(entry.pen);
    painter.setBrush(entry.brush);
    switch (entry.symbol) {
      case LegendEntry::Symbol::Line:
        painter.drawLine(QPointF(symbol.left(), symbol.center().y()),
                         QPointF(symbol.right(), symbol.center().y()));
        break;
      case LegendEntry::Symbol::Fill:
        painter.drawRect(symbol);
        break;
      case LegendEntry::Symbol::Dot:
        painter.drawEllipse(symbol.center(), 3.5, 3.5);
        break;
      case LegendEntry::Symbol::Triangle: {
        const QPointF centre = symbol.center();
        painter.drawPolygon(QPolygonF{centre + QPointF(0.0, -5.0), centre + QPointF(5.0, 4.0),
                                      centre + QPointF(-5.0, 4.0)});
        break;
      }
      case LegendEntry::Symbol::Square:
        painter.drawRect(QRectF(symbol.center() - QPointF(4.0, 4.0), QSizeF(8.0, 8.0)));
        break;
      case LegendEntry::Symbol::Diamond: {
        const QPointF centre = symbol.center();
        painter.drawPolygon(QPolygonF{centre + QPointF(0.0, -5.5), centre + QPointF(5.5, 0.0),
                                      centre + QPointF(0.0, 5.5), centre + QPointF(-5.5, 0.0)});
        break;
      }
      case LegendEntry::Symbol::Marker:
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(symbol.center(), 6.5, 6.5);
        painter.setBrush(entry.pen.color());
        painter.drawEllipse(symbol.center(), 1.5, 1.5);
        break;
    }
    painter.setPen(colors.text);
    painter.drawText(rects[index].adjusted(kSymbolPx + kSymbolGapPx, 0, 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, entry.text);
  }
}

std::vector<QRect> LegendStrip::places(int width) const {
  std::vector<QRect> rects;
  const QFontMetrics metrics = fontMetrics();
  const int height = metrics.height() + 6;
  int x = 0;
  int y = 0;
  for (const LegendEntry& entry : m_entries) {
    const int entryWidth = kSymbolPx + kSymbolGapPx + metrics.horizontalAdvance(entry.text) + 2;
    if (x > 0 && x + entryWidth > width) {
      x = 0;
      y += height;
    }
    rects.emplace_back(x, y, entryWidth, height);
    x += entryWidth + kSpacingPx;
  }
  return rects;
}

}  // namespace rivulet::widgets
