// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/chart_style.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLocale>
#include <QValueAxis>
#include <algorithm>

#include "base/nice_step.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

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
  const double step = base::niceStepAbove((max - min) / std::max(ticks, 1));
  const int decimals = std::min(base::decimalsOfStep(step), 6);
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
