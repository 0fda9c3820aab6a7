// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/paper/picture.h"

#include <QBuffer>
#include <QLocale>
#include <QPainter>
#include <QSvgGenerator>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/nice_step.h"

namespace rivulet::paper {

namespace {

constexpr double kTextMm = 2.6;
constexpr double kSmallest = 1e-6;
const QColor kFaint(0xd5, 0xdb, 0xe1);
const QColor kAxisText(0x4d, 0x55, 0x5d);

/// Where values are drawn.
struct PictureScale {
  QRectF values;
  QRectF room;
  double xScale = 1.0;
  double yScale = 1.0;

  PictureScale(const QRectF& shown, const QRectF& place, bool isMap) : values(shown), room(place) {
    xScale = room.width() / std::max(values.width(), kSmallest);
    yScale = room.height() / std::max(values.height(), kSmallest);
    if (isMap) {
      xScale = yScale = std::min(xScale, yScale);
    }
  }
  [[nodiscard]] QPointF operator()(QPointF value) const {
    return room.center() + QPointF((value.x() - values.center().x()) * xScale,
                                   (values.center().y() - value.y()) * yScale);
  }
};

QString tickText(double value, double step) {
  return QLocale().toString(value, 'f', base::decimalsOfStep(step));
}

/// Values at round places, with faint lines. @return space that the figures need at the left
void paintAxes(QPainter& painter, const PictureScale& scale, double mm, const Picture& picture) {
  const QRectF& room = scale.room;
  const double text = kTextMm * mm;
  const double xStep = base::niceStepAbove(std::max(scale.values.width(), kSmallest) / 8.0);
  const double yStep = base::niceStepAbove(std::max(scale.values.height(), kSmallest) / 4.0);
  const auto line = [&](QPointF from, QPointF to) {
    painter.setPen(QPen(kFaint, 0.15 * mm));
    painter.drawLine(from, to);
    painter.setPen(kAxisText);
  };
  for (double x = std::ceil(scale.values.left() / xStep) * xStep; x <= scale.values.right();
       x += xStep) {
    const double at = scale({x, 0.0}).x();
    line({at, room.top()}, {at, room.bottom()});
    painter.drawText(QRectF(at - 10.0 * mm, room.bottom() + 0.4 * mm, 20.0 * mm, text),
                     Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextDontClip, tickText(x, xStep));
  }
  for (double y = std::ceil(scale.values.top() / yStep) * yStep; y <= scale.values.bottom();
       y += yStep) {
    const double at = scale({0.0, y}).y();
    line({room.left(), at}, {room.right(), at});
    painter.drawText(QRectF(room.left() - 21.0 * mm, at - text / 2.0, 20.0 * mm, text),
                     Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, tickText(y, yStep));
  }
  painter.drawText(QRectF(room.left(), room.bottom() + 0.6 * mm + text, room.width(), text),
                   Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, picture.xTitle);
  painter.drawText(QRectF(room.left(), room.top() - text - 0.6 * mm, room.width(), text),
                   Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, picture.yTitle);
}

void setTextSize(QPainter& painter, double mm) {
  QFont font = painter.font();
  font.setBold(false);
  // In the units of the page: the same on paper and in a picture.
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(kTextMm * mm))));
  painter.setFont(font);
}

}  // namespace

QRectF Picture::bounds() const {
  double left = std::numeric_limits<double>::infinity();
  double top = left;
  double right = -left;
  double bottom = -left;
  const auto take = [&](QPointF point) {
    left = std::min(left, point.x());
    right = std::max(right, point.x());
    top = std::min(top, point.y());
    bottom = std::max(bottom, point.y());
  };
  for (const Line& line : lines) {
    for (const QPointF& point : line.points) {
      take(point);
    }
  }
  for (const Mark& mark : marks) {
    take(mark.place);
  }
  return left <= right ? QRectF(QPointF(left, top), QPointF(right, bottom)) : QRectF();
}

void paintPicture(QPainter& painter, const QRectF& frame, double mm, const Picture& picture) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kFaint, 0.2 * mm));
  painter.drawRect(frame);
  setTextSize(painter, mm);
  if (picture.lines.empty()) {
    painter.setPen(kAxisText);
    painter.drawText(frame, Qt::AlignCenter, picture.note);
    return;
  }
  QRectF values = picture.bounds();
  QRectF room = frame.adjusted(3.0 * mm, 3.0 * mm, -3.0 * mm, -3.0 * mm);
  if (!picture.isMap) {
    // Quantities that are drawn over time begin at zero.
    values.setTop(std::min(0.0, values.top()));
    room = frame.adjusted(15.0 * mm, 5.0 * mm, -4.0 * mm, -8.0 * mm);
  }
  const PictureScale scale(values, room, picture.isMap);
  for (const Band& band : picture.bands) {
    const double from = scale({band.from, 0.0}).x();
    const double width = std::max(0.15 * mm, scale({band.to, 0.0}).x() - from);
    painter.fillRect(QRectF(from, room.top(), width, room.height()), band.color);
  }
  if (!picture.isMap) {
    paintAxes(painter, scale, mm, picture);
  }
  for (const Line& line : picture.lines) {
    QPolygonF drawn;
    drawn.reserve(line.points.size());
    for (const QPointF& point : line.points) {
      drawn.append(scale(point));
    }
    painter.setPen(QPen(line.color, line.widthMm * mm, line.isDashed ? Qt::DashLine : Qt::SolidLine,
                        Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(drawn);
  }
  painter.setPen(Qt::NoPen);
  for (const Mark& mark : picture.marks) {
    painter.setBrush(mark.color);
    painter.drawEllipse(scale(mark.place), 1.0 * mm, 1.0 * mm);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(Qt::black);
}

QByteArray pictureSvg(const Picture& picture, QSizeF millimetres, bool isFile) {
  constexpr double kUnitsPerMm = 10.0;
  QBuffer buffer;
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setResolution(static_cast<int>(std::lround(25.4 * kUnitsPerMm)));
  const QRectF page(QPointF(), millimetres * kUnitsPerMm);
  svg.setViewBox(page);
  svg.setSize(page.size().toSize());
  svg.setTitle(picture.caption);
  QPainter painter(&svg);
  if (isFile) {
    painter.fillRect(page, Qt::white);
  }
  paintPicture(painter, page.adjusted(1.0, 1.0, -1.0, -1.0), kUnitsPerMm, picture);
  painter.end();
  const qsizetype begin = buffer.data().indexOf("<svg");
  return isFile ? buffer.data() : buffer.data().mid(std::max<qsizetype>(0, begin));
}

}  // namespace rivulet::paper
