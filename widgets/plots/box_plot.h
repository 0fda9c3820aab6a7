// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Boxes on a logarithmic axis, one below the other, each with its name: from the lower to the
/// upper quartile, a line at the median, whiskers to the least and the greatest. @threadsafety GUI
/// thread.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "widgets/plots/chart_axis.h"

namespace rivulet::widgets {

struct ChartBox {
  QString name;
  std::size_t color = 0;       ///< as `ScopePane::curveColor`
  std::vector<double> values;  ///< what is not positive cannot be drawn, and is left out
};

class BoxPlot final : public QWidget {
  Q_OBJECT

 public:
  explicit BoxPlot(QWidget* parent = nullptr);

  /// @param name  of the plot, also for a screen reader
  void setTitles(const QString& name, const QString& values);
  void setBoxes(std::vector<ChartBox> boxes);
  /// Those with values that can be drawn; ascending values.
  [[nodiscard]] const std::vector<ChartBox>& boxes() const { return m_boxes; }
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawBox(QPainter& painter, const ChartBox& box, const QRectF& row) const;

  ChartAxis m_axis{.scale = AxisScale::Logarithmic};
  QString m_title;
  std::vector<ChartBox> m_boxes;
};

}  // namespace rivulet::widgets
