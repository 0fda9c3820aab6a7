// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Pictures for paper: lines over two axes, or a map with the same scale in both directions. They
/// are black on white in every theme. @threadsafety GUI thread.
#pragma once

#include <QByteArray>
#include <QColor>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <vector>

class QPainter;

namespace rivulet::paper {

struct Line {
  QPolygonF points;
  QColor color = Qt::black;
  double widthMm = 0.2;
  bool isDashed = false;
};

/// Vertical, over the whole height.
struct Band {
  double from = 0.0;
  double to = 0.0;
  QColor color;
};

struct Mark {
  QPointF place;
  QColor color;
};

struct Picture {
  QString caption;
  QString note;        ///< shown instead of content, if there is none
  bool isMap = false;  ///< without axes; y points up
  QString xTitle;      ///< with the unit
  QString yTitle;
  std::vector<Band> bands;
  std::vector<Line> lines;
  std::vector<Mark> marks;

  [[nodiscard]] QRectF bounds() const;
};

/// The caption is not drawn. @param millimetre  in the painter's units
void paintPicture(QPainter& painter, const QRectF& frame, double millimetre,
                  const Picture& picture);

/// As an element of HTML, or a file of its own if `isFile`.
[[nodiscard]] QByteArray pictureSvg(const Picture& picture, QSizeF millimetres, bool isFile);

}  // namespace rivulet::paper
