// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Paints a program's path, what of it is executed, and the tool. The path is projected once per
/// view and drawn into a picture once per zoom, thinned to the resolution of the screen; a move
/// of the tool costs one copy of that picture, and newly executed points are added to it.
/// @threadsafety GUI thread.
#pragma once

#include <QPixmap>
#include <QPointF>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "gcode/program.h"

namespace rivulet::widgets {

class PathCanvas final : public QWidget {
  Q_OBJECT

 public:
  enum class View { Top, Isometric };

  /// What the canvas writes on itself, in the language of the operator.
  struct Texts {
    QString empty;
    QString cut;
    QString rapid;
    QString executed;
    QString start;
    QString tool;
  };

  explicit PathCanvas(QWidget* parent = nullptr);

  void setTexts(const Texts& texts);
  /// The path as programmed, shown until the streamed points are known. @param program or null
  void setProgram(std::shared_ptr<const gcode::Program> program);
  /// The points as streamed: executed points count in this list.
  void setPoints(const std::vector<gcode::StreamPoint>& points);
  /// How many of the points are behind the tool.
  void setExecuted(std::size_t count);
  void setToolPosition(const std::optional<base::Vec3>& positionMm);
  void setView(View view);
  [[nodiscard]] View view() const { return m_view; }
  void fit();

  [[nodiscard]] QSize sizeHint() const override { return {520, 400}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 200}; }
  /// Points drawn for the present zoom, after thinning: for tests of speed.
  [[nodiscard]] std::size_t drawnVertices() const { return m_drawnVertices; }

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  struct Vertex {
    base::Vec3 positionMm;
    bool isRapid = false;  ///< the move that ends here
  };

  void takeVertices(std::vector<Vertex> vertices);
  void project();
  void dropPicture();
  void makePicture();
  /// Draws the moves that end at [from, to). @return vertices left after thinning
  std::size_t drawMoves(QPainter& painter, std::size_t from, std::size_t to, const QPen& cut,
                        const QPen& rapid) const;
  void drawExecuted(QPainter& painter, std::size_t from, std::size_t to);
  void drawGrid(QPainter& painter) const;
  void drawScaleBar(QPainter& painter) const;
  void drawAxes(QPainter& painter) const;
  void drawLegend(QPainter& painter) const;
  void drawStart(QPainter& painter) const;
  void drawTool(QPainter& painter) const;
  [[nodiscard]] QPointF projected(base::Vec3 positionMm) const;
  [[nodiscard]] QPointF onScreen(QPointF projectedMm) const;
  [[nodiscard]] double gridStepMm() const;

  Texts m_texts;
  std::shared_ptr<const gcode::Program> m_program;
  std::vector<Vertex> m_vertices;
  std::vector<QPointF> m_projectedMm;  ///< right and up, mm
  std::size_t m_executed = 0;
  std::optional<base::Vec3> m_toolMm;
  View m_view = View::Top;

  bool m_fits = true;  ///< the whole path is shown; stays so when the widget is resized
  QPointF m_centreMm;
  double m_pixelsPerMm = 10.0;
  std::optional<QPointF> m_dragFrom;

  QPixmap m_picture;  ///< null: to be made
  std::size_t m_executedInPicture = 0;
  std::size_t m_drawnVertices = 0;
};

}  // namespace rivulet::widgets
