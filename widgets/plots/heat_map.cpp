// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/heat_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

namespace {

constexpr double kMapPaddingPx = 6.0;
constexpr double kMapNamesShare = 0.3;  ///< of the width, at most
constexpr double kMapCellPx = 28.0;     ///< least height
constexpr double kMapCellPxMax = 56.0;
constexpr int kMapDigits = 3;

QColor between(const QColor& from, const QColor& to, double share) {
  const auto mixed = [share](int a, int b) {
    return static_cast<int>(std::lround(a + share * (b - a)));
  };
  return {mixed(from.red(), to.red()), mixed(from.green(), to.green()),
          mixed(from.blue(), to.blue())};
}

}  // namespace

HeatMap::HeatMap(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void HeatMap::setTitles(const QString& name, const QString& rows, const QString& columns) {
  m_rowTitle = rows;
  m_columnTitle = columns;
  setAccessibleName(name);
  setToolTip(name);
  update();
}

void HeatMap::setCells(const QStringList& names, std::vector<std::vector<double>> values) {
  m_names = names;
  m_values = std::move(values);
  m_least = std::numeric_limits<double>::infinity();
  m_greatest = 0.0;
  for (const std::vector<double>& row : m_values) {
    for (const double value : row) {
      if (std::isfinite(value) && value > 0.0) {
        m_least = std::min(m_least, value);
        m_greatest = std::max(m_greatest, value);
      }
    }
  }
  updateGeometry();
  update();
}

QSize HeatMap::minimumSizeHint() const {
  const auto rows = static_cast<int>(m_values.size());
  return {260, 70 + rows * static_cast<int>(kMapCellPx)};
}

QSize HeatMap::sizeHint() const {
  return {460, minimumSizeHint().height()};
}

/// Equal ratios have equal steps of colour.
QColor HeatMap::colorOf(double value) const {
  const ThemeColors& colors = themeColors(palette());
  if (!std::isfinite(value)) {
    return colors.surface;
  }
  const double span = m_greatest > m_least ? std::log(m_greatest / m_least) : 1.0;
  const double share =
      value > m_least ? std::clamp(std::log(value / m_least) / span, 0.0, 1.0) : 0.0;
  return between(colors.surface, colors.accent, 0.06 + 0.94 * share);
}

void HeatMap::drawCell(QPainter& painter, const QRectF& cell, double value) const {
  const QColor fill = colorOf(value);
  painter.fillRect(cell, fill);
  painter.setPen(QPen(themeColors(palette()).line, 1.0));
  painter.drawRect(cell);
  const bool isLight = contrastRatio(fill, Qt::black) > contrastRatio(fill, Qt::white);
  painter.setPen(isLight ? Qt::black : Qt::white);
  const double finest = std::pow(10.0, -kMapDigits);
  if (value > 0.0 && value < finest) {
    painter.drawText(cell, Qt::AlignCenter,
                     QStringLiteral("<\u00a0%1").arg(numberText(finest, kMapDigits)));
    return;
  }
  const int whole = value > 0.0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  painter.drawText(cell, Qt::AlignCenter,
                   numberText(value, std::clamp(kMapDigits - whole, 0, kMapDigits)));
}

void HeatMap::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing, false);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  QFont small = font();
  small.setPointSizeF(kScopeFontPt);
  painter.setFont(small);
  const QFontMetricsF metrics(small);
  const auto count = static_cast<double>(m_values.size());
  if (m_values.empty()) {
    return;
  }
  std::vector<QString> rows;
  double widest = metrics.horizontalAdvance(m_rowTitle);
  for (int i = 0; i < m_names.size(); ++i) {
    rows.push_back(QStringLiteral("%1  %2").arg(i + 1).arg(m_names[i]));
    widest = std::max(widest, metrics.horizontalAdvance(rows.back()));
  }
  const double namesPx = std::min(widest, kMapNamesShare * width());
  const double left = namesPx + 2.0 * kMapPaddingPx;
  const double top = 2.0 * metrics.height() + 3.0 * kMapPaddingPx;
  const double cellWidth = (width() - left - kMapPaddingPx) / count;
  const double cellHeight = std::min(kMapCellPxMax, (height() - top - kMapPaddingPx) / count);
  painter.setPen(colors.mutedText);
  painter.drawText(QRectF(left, kMapPaddingPx, width() - left, metrics.height()),
                   Qt::AlignLeft | Qt::AlignVCenter, m_columnTitle);
  painter.drawText(
      QRectF(kMapPaddingPx, top - metrics.height() - kMapPaddingPx, namesPx, metrics.height()),
      Qt::AlignLeft | Qt::AlignVCenter, m_rowTitle);
  for (std::size_t row = 0; row < m_values.size(); ++row) {
    const double y = top + cellHeight * static_cast<double>(row);
    const double x = left + cellWidth * static_cast<double>(row);
    painter.setPen(colors.text);
    painter.drawText(QRectF(x, top - metrics.height() - kMapPaddingPx, cellWidth, metrics.height()),
                     Qt::AlignCenter, QString::number(row + 1));
    painter.drawText(QRectF(kMapPaddingPx, y, namesPx, cellHeight),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(rows[row], Qt::ElideMiddle, namesPx));
    for (std::size_t column = 0; column < m_values[row].size(); ++column) {
      drawCell(painter,
               QRectF(left + cellWidth * static_cast<double>(column), y, cellWidth, cellHeight),
               m_values[row][column]);
    }
  }
}

}  // namespace rivulet::widgets
