// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/operator_style.h"

#include <QAbstractSpinBox>
#include <QPainter>
#include <QStyleOption>
#include <algorithm>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kIndicatorPx = 22;
constexpr int kSliderHandlePx = 28;
constexpr int kScrollBarPx = 18;
constexpr int kMenuRowPx = 36;
constexpr qreal kRadiusPx = 6.0;
constexpr qreal kBoxRadiusPx = 4.0;
constexpr int kSelectedTabLinePx = 3;
constexpr int kCheckedLinePx = 4;

/// The border of something that can be operated.
QPen border(const QStyleOption& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  return {isEnabled ? colors.outline : colors.line, colors.isContrast && isEnabled ? 2.0 : 1.0};
}

void drawBorder(QPainter& painter, const QRect& rect, const QPen& pen) {
  const qreal inset = pen.widthF() / 2.0;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(rect).adjusted(inset, inset, -inset, -inset), kRadiusPx,
                          kRadiusPx);
  painter.restore();
}

/// Flat, in the colour of the button; darker while it is pressed, a little while a pointer is over
/// it.
void drawButton(QPainter& painter, const QStyleOption& option) {
  constexpr int kPressedPercent = 118;
  constexpr int kHoverPercent = 105;
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  const bool isPressed = isEnabled && option.state.testFlag(QStyle::State_Sunken);
  const bool isUnder = isEnabled && option.state.testFlag(QStyle::State_MouseOver);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(option.palette.color(QPalette::Button)
                       .darker(isPressed ? kPressedPercent
                               : isUnder ? kHoverPercent
                                         : 100));
  painter.drawRoundedRect(option.rect, kRadiusPx, kRadiusPx);
  painter.restore();
  drawBorder(painter, option.rect, border(option));
}

/// A button that stays pressed: the shade alone is not seen in every theme.
void markChecked(QPainter& painter, const QStyleOption& option) {
  if (option.state.testFlag(QStyle::State_On)) {
    QRect line = option.rect.adjusted(4, 0, -4, -3);
    line.setTop(line.bottom() - kCheckedLinePx + 1);
    painter.fillRect(line, themeColors(option.palette).accent);
  }
}

void drawCheckBox(QPainter& painter, const QStyleOption& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  const bool isOn = option.state.testFlag(QStyle::State_On);
  const bool isPartly = option.state.testFlag(QStyle::State_NoChange);
  const int side = std::min(option.rect.width(), option.rect.height());
  QRectF box(0.0, 0.0, side - 2.0, side - 2.0);
  box.moveCenter(QRectF(option.rect).center());
  const QColor mark = isEnabled ? colors.accent : colors.line;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(isOn || isPartly ? mark : border(option).color(), 2.0));
  painter.setBrush(isOn ? mark : colors.surface);
  painter.drawRoundedRect(box, kBoxRadiusPx, kBoxRadiusPx);
  painter.setBrush(Qt::NoBrush);
  if (isOn) {
    painter.setPen(QPen(colors.surface, 0.14 * side, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [&box](double x, double y) {
      return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    painter.drawPolyline(QPolygonF{at(0.22, 0.53), at(0.43, 0.74), at(0.79, 0.28)});
  } else if (isPartly) {
    painter.fillRect(box.adjusted(4.0, box.height() / 2.0 - 1.5, -4.0, 1.5 - box.height() / 2.0),
                     mark);
  }
  painter.restore();
}

void drawRadioButton(QPainter& painter, const QStyleOption& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  const bool isOn = option.state.testFlag(QStyle::State_On);
  const double radius = std::min(option.rect.width(), option.rect.height()) / 2.0 - 1.0;
  const QPointF centre = QRectF(option.rect).center();
  const QColor mark = isEnabled ? colors.accent : colors.line;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(isOn ? mark : border(option).color(), 2.0));
  painter.setBrush(colors.surface);
  painter.drawEllipse(centre, radius, radius);
  if (isOn) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark);
    painter.drawEllipse(centre, radius * 0.55, radius * 0.55);
  }
  painter.restore();
}

/// The line on both sides of the handle.
void drawGroove(QPainter& painter, const QRect& groove, const QRect& handle,
                const QStyleOption& option) {
  const QPen pen(themeColors(option.palette).outline, 2.0);
  painter.save();
  painter.setPen(pen);
  if (option.state.testFlag(QStyle::State_Horizontal)) {
    const int y = groove.center().y();
    painter.drawLine(groove.left(), y, handle.left() - 1, y);
    painter.drawLine(handle.right() + 2, y, groove.right(), y);
  } else {
    const int x = groove.center().x();
    painter.drawLine(x, groove.top(), x, handle.top() - 1);
    painter.drawLine(x, handle.bottom() + 2, x, groove.bottom());
  }
  painter.restore();
}

}  // namespace

OperatorStyle::OperatorStyle() : QProxyStyle(QStringLiteral("Fusion")) {
}

void OperatorStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                  QPainter* painter, const QWidget* widget) const {
  switch (element) {
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      drawCheckBox(*painter, *option);
      return;
    case PE_IndicatorRadioButton:
      drawRadioButton(*painter, *option);
      return;
    case PE_PanelButtonCommand:
      drawButton(*painter, *option);
      markChecked(*painter, *option);
      return;
    case PE_FrameFocusRect:
      return;  // FocusFrame shows it
    default:
      break;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  switch (element) {
    case PE_FrameLineEdit:
      drawBorder(*painter, option->rect, border(*option));
      break;
    case PE_PanelButtonTool:
      if (!option->state.testFlag(State_AutoRaise) || option->state.testFlag(State_On)) {
        drawBorder(*painter, option->rect, border(*option));
        markChecked(*painter, *option);
      }
      break;
    case PE_FrameGroupBox:
    case PE_FrameTabWidget:
    case PE_Frame:
      drawBorder(*painter, option->rect, QPen(themeColors(option->palette).line, 1.0));
      break;
    default:
      break;
  }
}

void OperatorStyle::drawControl(ControlElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawControl(element, option, painter, widget);
  if (element == CE_ProgressBarGroove) {
    drawBorder(*painter, option->rect, border(*option));
  } else if (element == CE_TabBarTabShape && option->state.testFlag(State_Selected)) {
    QRect line = option->rect;
    line.setHeight(kSelectedTabLinePx);
    painter->fillRect(line, themeColors(option->palette).accent);
  }
}

void OperatorStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                       QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  const auto part = [&](SubControl which) {
    return proxy()->subControlRect(control, option, which, widget);
  };
  switch (control) {
    case CC_ComboBox:
    case CC_SpinBox:
      drawBorder(*painter, option->rect, border(*option));
      break;
    case CC_Slider:
      drawBorder(*painter, part(SC_SliderHandle), border(*option));
      drawGroove(*painter, part(SC_SliderGroove), part(SC_SliderHandle), *option);
      break;
    case CC_ScrollBar:
      drawBorder(*painter, part(SC_ScrollBarSlider).adjusted(1, 1, -1, -1), border(*option));
      break;
    default:
      break;
  }
}

int OperatorStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                               const QWidget* widget) const {
  switch (metric) {
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight:
      return kIndicatorPx;
    case PM_SliderThickness:
    case PM_SliderControlThickness:
    case PM_SliderLength:
      return kSliderHandlePx;
    case PM_ScrollBarExtent:
      return kScrollBarPx;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

QSize OperatorStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                      const QSize& contents, const QWidget* widget) const {
  const QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
  const auto atLeast = [&size](int height) {
    return QSize(size.width(), std::max(size.height(), height));
  };
  switch (type) {
    case CT_LineEdit:
      // The field in a spin box has the room that the spin box gives it.
      return widget != nullptr && qobject_cast<const QAbstractSpinBox*>(widget->parentWidget())
                 ? size
                 : atLeast(kTouchHeightPx);
    case CT_CheckBox:
    case CT_RadioButton:
    case CT_ComboBox:
    case CT_SpinBox:
    case CT_PushButton:
    case CT_Slider:
    case CT_TabBarTab:
      return atLeast(kTouchHeightPx);
    case CT_ToolButton:
      return {std::max(size.width(), kTouchHeightPx), std::max(size.height(), kTouchHeightPx)};
    case CT_MenuItem:
      return size.height() < 12 ? size : atLeast(kMenuRowPx);  // a separator stays thin
    case CT_MenuBarItem:
      return atLeast(kMenuRowPx);
    default:
      return size;
  }
}

}  // namespace rivulet::widgets
