// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The path of the traces during the time that is seen, from above or turned by hand, with the
/// places of the two cursors. Coloured by trace or by any signal, with a scale; the contour error
/// may be drawn larger than it is. A click on the path puts cursor A there, with Shift cursor B.
/// @threadsafety GUI thread.
#pragma once

#include <QPixmap>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/vec3.h"
#include "overview/projection.h"
#include "trace/value_range.h"
#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

class TimeWindow;

class PathPane final : public Page {
  Q_OBJECT

 public:
  PathPane(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
           QWidget* parent = nullptr);

  /// Offered for `setEnlargement`.
  static constexpr std::array<double, 7> kEnlargements{1.0, 10.0, 20.0, 50.0, 100.0, 500.0, 1000.0};

  /// The signal that colours the path. @param formula  empty: each trace has its own colour
  void setColouring(const QString& formula);
  [[nodiscard]] const QString& colouring() const { return m_colouring; }
  /// How many times larger the distance to the programmed path is drawn, >= 1. More than 1 needs
  /// traces that were compared with their program.
  void setEnlargement(double factor);
  [[nodiscard]] double enlargement() const { return m_enlargement; }
  /// Whether the first trace can be drawn with enlarged errors.
  [[nodiscard]] bool canEnlarge() const;
  /// From above, or as it was turned last.
  void setSpatial(bool isSpatial);
  [[nodiscard]] bool isSpatial() const { return m_isSpatial; }
  /// Where the picture is seen from.
  [[nodiscard]] overview::Projection::Angles angles() const;
  /// Values of the colours' ends; empty: there are none in sight.
  [[nodiscard]] const trace::ValueRange& colourRange() const { return m_range; }

  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();
  /// Where the picture shows the place of a time; nothing: it has none there.
  [[nodiscard]] std::optional<QPointF> placeOf(double atS) const;
  /// The position that is drawn for a time of the first trace, with the error as large as it is
  /// drawn; nothing: it has none there.
  [[nodiscard]] std::optional<base::Vec3> shownMm(double atS) const;
  /// What is said of the place of cursor A.
  [[nodiscard]] QString placeText() const;

  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void retranslate() override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Place {
    double atS = 0.0;
    base::Vec3 shownMm;       ///< with the error as large as it is drawn
    base::Vec3 programmedMm;  ///< NaN: not known
    double value = 0.0;       ///< of the colouring; NaN: none
  };
  /// Signals of a trace; Z may be missing, as well as `lengthMm` on the programmed path.
  struct Course {
    ScopeCurves::Samples x;
    ScopeCurves::Samples y;
    ScopeCurves::Samples z;
    ScopeCurves::Samples lengthMm;
    std::shared_ptr<const trace::ProgramPath> program;
  };

  void schedule();
  void draw();
  void collect(std::size_t trace, std::vector<Place>& path) const;
  void fit();
  void drawPath(QPainter& painter, std::size_t trace) const;
  void drawScaleBar(QPainter& painter) const;
  void drawAxes(QPainter& painter) const;
  void drawRamp(QPainter& painter) const;
  void turn(double byDeg, double tiltByDeg);
  void chooseAt(QPointF place, bool isSecond);
  [[nodiscard]] Course courseOf(std::size_t trace) const;
  [[nodiscard]] static double lengthOn(const Course& course, base::Instant at,
                                       base::Vec3 positionMm);
  [[nodiscard]] Place placeOn(const Course& course, base::Instant at, base::Vec3 positionMm) const;
  [[nodiscard]] std::optional<Place> placeAt(double atS) const;
  [[nodiscard]] QRectF room() const;
  [[nodiscard]] double rampHeightPx() const;
  [[nodiscard]] QRectF rampBar() const;
  [[nodiscard]] QPointF pixelOf(base::Vec3 positionMm) const;
  [[nodiscard]] QString valueText(double value) const;

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  QString m_colouring;
  double m_enlargement = 1.0;
  bool m_isSpatial = false;
  overview::Projection::Angles m_turned = overview::Projection::isometric();
  overview::Projection m_projection{overview::Projection::Angles{}};
  std::vector<std::vector<Place>> m_paths;  ///< one per trace, thinned
  trace::ValueRange m_range;
  double m_pxPerMm = 1.0;
  overview::PlanePoint m_middle;
  QPixmap m_picture;
  QTimer m_redraw;
  QPointF m_pressed;
  QPointF m_dragged;  ///< until where the path was turned
  bool m_isDragging = false;
};

}  // namespace rivulet::widgets
