// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How controls are drawn and how large they are, for the whole application: Qt's Fusion, flat,
/// with hairlines around buttons, borders of 3:1 around fields, lines around everything in the
/// theme of high contrast, and room for a finger. A page need not ask for any of it.
/// @threadsafety GUI thread.
#pragma once

#include <QColor>
#include <QProxyStyle>

namespace rivulet::widgets {

/// A colour between two opaque ones. @param share  of the other one, 0 to 1
[[nodiscard]] QColor mixed(const QColor& ground, const QColor& other, float share);

class OperatorStyle final : public QProxyStyle {
  Q_OBJECT

 public:
  OperatorStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override;
  [[nodiscard]] QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                     SubControl part, const QWidget* widget) const override;
  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option,
                                const QWidget* widget) const override;
  [[nodiscard]] QSize sizeFromContents(ContentsType type, const QStyleOption* option,
                                       const QSize& contents, const QWidget* widget) const override;
};

}  // namespace rivulet::widgets
