// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The path in X and Y during the time that the panes show, with the places of the two cursors. A
/// click on the path puts cursor A there, with Shift cursor B. @threadsafety GUI thread.
#pragma once

#include <QPixmap>
#include <QTimer>
#include <optional>
#include <vector>

#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

class TimeWindow;

class PathPane final : public Page {
  Q_OBJECT

 public:
  PathPane(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
           QWidget* parent = nullptr);

  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();
  /// Where the picture shows the place of a time; nothing: it has none there.
  [[nodiscard]] std::optional<QPointF> placeOf(double atS) const;
  /// What is said of the place of cursor A.
  [[nodiscard]] QString placeText() const;

  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void retranslate() override;
  void restyle() override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  struct Place {
    double atS = 0.0;
    double xMm = 0.0;
    double yMm = 0.0;
  };
  struct Axes {
    ScopeCurves::Samples x;
    ScopeCurves::Samples y;
  };

  void schedule();
  void draw();
  [[nodiscard]] Axes axesOf(std::size_t trace) const;
  [[nodiscard]] QRectF room() const;
  [[nodiscard]] QPointF pixelOf(double xMm, double yMm) const;
  [[nodiscard]] std::optional<Place> placeAt(double atS) const;

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  std::vector<std::vector<Place>> m_paths;  ///< one per trace, thinned
  double m_pxPerMm = 1.0;
  double m_middleXMm = 0.0;
  double m_middleYMm = 0.0;
  QPixmap m_picture;
  QTimer m_redraw;
};

}  // namespace rivulet::widgets
