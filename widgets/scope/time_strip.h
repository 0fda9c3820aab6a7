// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Below the panes: the times of what is seen, and the whole trace small, with a frame around what
/// is seen. The frame is dragged; a click elsewhere brings it there. @threadsafety GUI thread.
#pragma once

#include <QPolygonF>
#include <QWidget>

#include "widgets/common/page.h"
#include "widgets/scope/scope_curves.h"
#include "widgets/scope/stop_row.h"

namespace rivulet::widgets {

class TimeWindow;

class TimeStrip final : public Page {
  Q_OBJECT

 public:
  /// @param stops  outlives the strip
  TimeStrip(ScopeCurves* curves, TimeWindow* window, const std::vector<StopRow>* stops,
            QWidget* parent = nullptr);

  /// The curve in the small picture.
  void setFormula(const QString& formula);

  /// Everything, as lines and texts: for pictures in files.
  void paintOn(QPainter& painter);

  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void retranslate() override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] TimeArea overview() const;
  void paintTimes(QPainter& painter) const;
  void paintOverview(QPainter& painter);
  /// The curve of the small picture; calculated again only if it has changed.
  [[nodiscard]] const QPolygonF& overviewLine();

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  const std::vector<StopRow>* m_stops;
  QString m_formula;
  double m_grabS = 0.0;  ///< from the middle of what is seen
  QPolygonF m_line;
  /// What the line was made of.
  ScopeCurves::Samples m_lineOf;
  std::size_t m_lineSize = 0;
  QRectF m_lineRect;
  double m_lineEndS = 0.0;
};

}  // namespace rivulet::widgets
