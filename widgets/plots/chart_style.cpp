// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/chart_style.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLocale>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

double niceStep(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value * (1.0 - 1e-9)) {
      return step * power;
    }
  }
  return 10.0 * power;
}

double niceCeil(double value) {
  const double step = niceStep(value / 10.0);
  return std::ceil(value / step - 1e-9) * step;
}

void styleChart(QChart* chart, const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  chart->setBackgroundBrush(colors.surface);
  chart->setBackgroundPen(Qt::NoPen);
  chart->setBackgroundRoundness(0);
  chart->setPlotAreaBackgroundVisible(false);
  chart->setMargins(QMargins());
  chart->layout()->setContentsMargins(0, 0, 0, 0);
  chart->legend()->hide();
  chart->setLocalizeNumbers(true);
  chart->setLocale(QLocale());
  const QList<QAbstractAxis*> axes = chart->axes();
  for (QAbstractAxis* axis : axes) {
    axis->setLinePen(QPen(colors.line, 1));
    axis->setGridLinePen(QPen(colors.grid, 1));
    axis->setLabelsBrush(colors.text);
    axis->setTitleBrush(colors.text);
    QFont font = chart->font();
    font.setPointSizeF(9.0);
    axis->setLabelsFont(font);
    font.setBold(true);
    axis->setTitleFont(font);
  }
}

void divideAxis(QValueAxis* axis, double min, double max, int ticks) {
  const double step = niceStep((max - min) / std::max(ticks, 1));
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  const QString format = QStringLiteral("%.%1f").arg(decimals);
  // The ticks are laid out again at each of these calls, so nothing is set that is already set, and
  // the step comes first: a wide range divided by an old, small step would make a million ticks.
  if (axis->tickType() != QValueAxis::TicksDynamic) {
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0.0);
  }
  const double span = axis->max() - axis->min();
  const bool grows = max - min > span;
  if (grows && axis->tickInterval() != step) {
    axis->setTickInterval(step);
  }
  if (axis->min() != min || axis->max() != max) {
    axis->setRange(min, max);
  }
  if (axis->tickInterval() != step) {
    axis->setTickInterval(step);
  }
  if (axis->labelFormat() != format) {
    axis->setLabelFormat(format);
  }
}

}  // namespace rivulet::widgets
