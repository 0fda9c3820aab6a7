// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/thin_line.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/contract.h"

namespace rivulet::widgets {

namespace {

/// Clips a line to the part at or above 0 of one edge. @return false: none does
bool clipAt(double from, double to, double& first, double& last) {
  if (from < 0.0 && to < 0.0) {
    return false;
  }
  if (from < 0.0) {
    first = std::max(first, from / (from - to));
  } else if (to < 0.0) {
    last = std::min(last, from / (from - to));
  }
  return first <= last;
}

constexpr double kOne = 65536.0;  // of the fixed point the line is walked in

}  // namespace

void drawThinLine(QImage& picture, QPointF from, QPointF to, QRgb color, int widthPx) {
  RIVULET_ASSERT(picture.format() == QImage::Format_RGB32);
  const int width = picture.width();
  const int height = picture.height();
  double first = 0.0;
  double last = 1.0;
  if (!clipAt(from.x(), to.x(), first, last) ||
      !clipAt(width - from.x(), width - to.x(), first, last) ||
      !clipAt(from.y(), to.y(), first, last) ||
      !clipAt(height - from.y(), height - to.y(), first, last)) {
    return;
  }
  const QPointF way = to - from;
  const QPointF begin = from + first * way;
  const QPointF end = from + last * way;
  const bool isFlat = std::abs(end.x() - begin.x()) >= std::abs(end.y() - begin.y());
  const double length = std::max(std::abs(end.x() - begin.x()), std::abs(end.y() - begin.y()));
  const int steps = static_cast<int>(length);
  // A picture has less than 32768 pixels a side: 16 bits before and 16 after the point.
  auto x = static_cast<std::int32_t>(begin.x() * kOne);
  auto y = static_cast<std::int32_t>(begin.y() * kOne);
  const double share = length > 0.0 ? kOne / length : 0.0;
  const auto stepX = static_cast<std::int32_t>((end.x() - begin.x()) * share);
  const auto stepY = static_cast<std::int32_t>((end.y() - begin.y()) * share);
  auto* pixels = reinterpret_cast<QRgb*>(picture.bits());
  const qsizetype stride = picture.bytesPerLine() / static_cast<qsizetype>(sizeof(QRgb));
  const auto set = [&](int column, int row) {
    if (static_cast<unsigned>(column) < static_cast<unsigned>(width) &&
        static_cast<unsigned>(row) < static_cast<unsigned>(height)) {
      pixels[row * stride + column] = color;
    }
  };
  for (int i = 0; i <= steps; ++i) {
    const int column = x >> 16;
    const int row = y >> 16;
    set(column, row);
    for (int extra = 1; extra < widthPx; ++extra) {
      set(isFlat ? column : column + extra, isFlat ? row + extra : row);
    }
    x += stepX;
    y += stepY;
  }
}

}  // namespace rivulet::widgets
