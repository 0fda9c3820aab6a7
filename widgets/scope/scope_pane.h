// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One of the panes that share their time: curves with one scale, bands of the stops, the two
/// cursors. The curves are painted from their extremes per column of pixels into a picture, which
/// is kept until what is seen changes. @threadsafety GUI thread.
#pragma once

#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/common/page.h"
#include "widgets/scope/scope_curves.h"
#include "widgets/scope/stop_row.h"

namespace rivulet::widgets {

/// Of the numbers at panes and strip.
inline constexpr double kScopeFontPt = 9.0;

class TimeWindow;

/// The two cursors of all panes.
class ScopeCursors final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  enum Which { A, B };
  [[nodiscard]] const std::optional<double>& atS(Which which) const { return m_atS[which]; }
  void set(Which which, std::optional<double> atS);

 Q_SIGNALS:
  void changed();

 private:
  std::optional<double> m_atS[2];
};

/// Left and right border of what all panes show, so that they share their time to the pixel.
inline constexpr double kScopeLeftPx = 84.0;
inline constexpr double kScopeRightPx = 14.0;

class ScopePane final : public Page {
  Q_OBJECT

 public:
  /// Between two pictures while a run is followed, ms: the eye needs no more, and a run needs the
  /// processor.
  static constexpr int kFollowMs = 100;

  /// @param stops  outlives the pane
  ScopePane(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
            const std::vector<StopRow>* stops, QWidget* parent = nullptr);

  void setFormulas(const QStringList& formulas);
  [[nodiscard]] const QStringList& formulas() const { return m_formulas; }
  /// Bands with their durations.
  void setStopLabels(bool visible);
  /// Where dragged signals take their name from.
  static QString mimeType();

  void scheduleRedraw();
  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();
  /// Draws everything anew, as lines and texts: for pictures in files.
  void paintOn(QPainter& painter);
  /// The picture of the curves, drawn anew: for measurements.
  void drawCurves();
  /// Colour of a curve: the one after another by signal, and by trace if there are several.
  [[nodiscard]] static QColor curveColor(std::size_t index, const QPalette& palette);

  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void redrawn();
  void selected();
  /// The last signal was taken out, or the operator does not want the pane.
  void removeRequested();
  void formulasChanged();
  /// Somebody holds a signal over the pane and lets it go.
  void signalDropped(const QString& formula);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  using Curve = ScopeCurves::Curve;
  enum class Drag { None, Pan, Band, CursorA, CursorB };

  [[nodiscard]] TimeArea area() const;
  [[nodiscard]] std::vector<Curve> curves() const;
  void fitValues(const std::vector<Curve>& curves);
  void paintContent(QPainter& painter, const std::vector<Curve>& curves) const;
  void paintGrid(QPainter& painter) const;
  void paintCurve(QPainter& painter, const Curve& curve, const QColor& color) const;
  void paintLegend(QPainter& painter, const std::vector<Curve>& curves) const;
  void paintCursors(QPainter& painter) const;
  [[nodiscard]] double yOf(double value) const;
  [[nodiscard]] std::optional<ScopeCursors::Which> cursorAt(double x) const;
  [[nodiscard]] double secondsAt(double x) const;
  /// @return false: the key means nothing here
  bool handleKey(int key, Qt::KeyboardModifiers modifiers);
  void describe();

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  const std::vector<StopRow>* m_stops;
  QStringList m_formulas;
  bool m_stopLabels = false;
  double m_min = 0.0;
  double m_max = 1.0;
  double m_step = 0.5;
  QPixmap m_picture;
  QTimer m_redraw;
  Drag m_drag = Drag::None;
  QPointF m_pressed;
  double m_dragX = 0.0;
  bool m_hasMoved = false;
};

}  // namespace rivulet::widgets
