// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Thin lines drawn directly into a picture. A painter checks clip, brush and composition for each
/// pixel; a path of thousands of long moves needs none of this and is drawn ten times as fast.
/// @threadsafety pure but for the picture.
#pragma once

#include <QImage>
#include <QPointF>

namespace rivulet::widgets {

/// One pixel wide (or more, across its main direction), not smooth, both ends included.
/// @param picture  Format_RGB32; the line may be partly or entirely outside
/// @param from,to  pixels of the picture, its upper left corner is (0, 0)
void drawThinLine(QImage& picture, QPointF from, QPointF to, QRgb color, int widthPx = 1);

}  // namespace rivulet::widgets
