// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A few curves of few points over one axis, each axis even or logarithmic: for what is calculated,
/// not for traces, which have panes. @threadsafety GUI thread.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/plots/chart_axis.h"

namespace rivulet::widgets {

struct ChartCurve {
  QString name;
  std::size_t color = 0;  ///< as `ScopePane::curveColor`
  bool isDots = false;    ///< else a line
  std::vector<QPointF> points;
};

class CurveChart final : public QWidget {
  Q_OBJECT

 public:
  explicit CurveChart(AxisScale x, AxisScale y, QWidget* parent = nullptr);

  /// @param name  of the chart, also for a screen reader
  void setTitles(const QString& name, const QString& x, const QString& y);
  /// What goes to the right is counted: 1, 2, 3.
  void setCounts() { m_x.counts = true; }
  /// The axes reach at least from left to right and from top to bottom of this, whatever the
  /// curves.
  void setShown(const QRectF& shown);
  /// Points that are not finite, or not positive on a logarithmic axis, are left out.
  void setCurves(std::vector<ChartCurve> curves);
  [[nodiscard]] const std::vector<ChartCurve>& curves() const { return m_curves; }
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void measure();
  /// @return its left border
  double drawLegend(QPainter& painter, const QRectF& room) const;

  ChartAxis m_x;
  ChartAxis m_y;
  QString m_xTitle;
  QString m_yTitle;
  std::optional<QRectF> m_shown;
  std::vector<ChartCurve> m_curves;
};

}  // namespace rivulet::widgets
