// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/operator_style.h"

#include <QAbstractSpinBox>
#include <QPainter>
#include <QSlider>
#include <QStyleOption>
#include <algorithm>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kIndicatorPx = 22;
constexpr int kSliderHandlePx = 28;
constexpr int kScrollBarPx = 18;
constexpr int kMenuRowPx = 36;
constexpr int kScrollHandlePx = 8;
constexpr int kChevronPx = 10;
constexpr int kThinBarPx = 8;  ///< of a progress that has no room for a text
constexpr qreal kGroovePx = 4.0;
constexpr qreal kRadiusPx = 8.0;
constexpr qreal kBoxRadiusPx = 4.0;
constexpr int kSelectedTabLinePx = 3;
constexpr int kCheckedLinePx = 4;
constexpr float kCheckedTint = 0.14F;  ///< share of the accent in the fill of what is chosen

/// The border of a field: something is entered there.
QPen border(const QStyleOption& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  return {isEnabled ? colors.outline : colors.line, colors.isContrast && isEnabled ? 2.0 : 1.0};
}

/// The border of a button, whose word says what it is: a hairline, in the accent while it is
/// chosen.
QPen buttonBorder(const QStyleOption& option) {
  const ThemeColors& colors = themeColors(option.palette);
  if (colors.isContrast) {
    return border(option);
  }
  return {option.state.testFlag(QStyle::State_On) ? colors.accent : colors.line, 1.0};
}

void fillRounded(QPainter& painter, const QRect& rect, const QBrush& brush) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(brush);
  painter.drawRoundedRect(rect, kRadiusPx, kRadiusPx);
  painter.restore();
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
  const ThemeColors& colors = themeColors(option.palette);
  const QColor ground = option.palette.color(QPalette::Button);
  const bool isChosen = option.state.testFlag(QStyle::State_On) && !colors.isContrast;
  fillRounded(painter, option.rect,
              (isChosen ? mixed(ground, colors.accent, kCheckedTint) : ground)
                  .darker(isPressed ? kPressedPercent
                          : isUnder ? kHoverPercent
                                    : 100));
  // A filled button is seen by its colour.
  const bool isFilled = ground != colors.button && !colors.isContrast;
  if (!isFilled) {
    drawBorder(painter, option.rect, buttonBorder(option));
  }
}

/// A button that stays pressed, in the theme whose buttons have no shades.
void markChecked(QPainter& painter, const QStyleOption& option) {
  if (option.state.testFlag(QStyle::State_On) && themeColors(option.palette).isContrast) {
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

/// A line up to the handle in the accent, and a round handle.
void drawSlider(QPainter& painter, const QRect& groove, const QRect& handle,
                const QStyleOptionSlider& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  const bool isFlat = option.orientation == Qt::Horizontal;
  const QPointF centre = QRectF(handle).center();
  QRectF line(groove);
  if (isFlat) {
    line.setHeight(kGroovePx);
    line.moveCenter({line.center().x(), centre.y()});
  } else {
    line.setWidth(kGroovePx);
    line.moveCenter({centre.x(), line.center().y()});
  }
  QRectF passed = line;
  if (isFlat) {
    option.upsideDown ? passed.setLeft(centre.x()) : passed.setRight(centre.x());
  } else {
    option.upsideDown ? passed.setTop(centre.y()) : passed.setBottom(centre.y());
  }
  const QColor mark = isEnabled ? colors.accent : colors.line;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.isContrast ? colors.outline : colors.line);
  painter.drawRoundedRect(line, kGroovePx / 2.0, kGroovePx / 2.0);
  painter.setBrush(mark);
  painter.drawRoundedRect(passed, kGroovePx / 2.0, kGroovePx / 2.0);
  painter.setPen(QPen(mark, 3.0));
  painter.setBrush(colors.surface);
  const double radius = std::min(handle.width(), handle.height()) / 2.0 - 4.0;
  painter.drawEllipse(centre, radius, radius);
  painter.restore();
}

/// Behind a line of text that can be edited.
void drawField(QPainter& painter, const QStyleOption& option) {
  fillRounded(painter, option.rect, option.palette.brush(QPalette::Base));
  drawBorder(painter, option.rect, border(option));
}

/// How far it is, as a line.
void drawThinBar(QPainter& painter, const QStyleOptionProgressBar& option) {
  const ThemeColors& colors = themeColors(option.palette);
  painter.fillRect(option.rect, colors.line);
  QRect done = option.rect;
  const int span = std::max(1, option.maximum - option.minimum);
  done.setWidth(done.width() * (option.progress - option.minimum) / span);
  painter.fillRect(done, colors.accent);
}

/// Only the handle: where one is in a list, and what can be dragged.
void drawScrollHandle(QPainter& painter, const QRect& part, const QStyleOptionSlider& option) {
  QRectF handle(part);
  const QPointF centre = handle.center();
  if (option.orientation == Qt::Vertical) {
    handle.setWidth(kScrollHandlePx);
  } else {
    handle.setHeight(kScrollHandlePx);
  }
  handle.moveCenter(centre);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(themeColors(option.palette).outline);
  painter.drawRoundedRect(handle, kScrollHandlePx / 2.0, kScrollHandlePx / 2.0);
  painter.restore();
}

/// A list to choose from, closed.
void drawList(QPainter& painter, const QRect& arrow, const QStyleOptionComboBox& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
  fillRounded(painter, option.rect, colors.button);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF centre = QRectF(arrow).center();
  painter.setPen(QPen(isEnabled ? colors.mutedText : colors.line, 2.0, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  constexpr double kHalf = kChevronPx / 2.0;
  painter.drawPolyline(QPolygonF{centre + QPointF(-kHalf, -kHalf / 2.0),
                                 centre + QPointF(0.0, kHalf / 2.0),
                                 centre + QPointF(kHalf, -kHalf / 2.0)});
  painter.restore();
  drawBorder(painter, option.rect, border(option));
}

/// A word over a line: the page it belongs to is below. The one that is shown has the accent.
void drawTab(QPainter& painter, const QStyleOptionTab& option) {
  const ThemeColors& colors = themeColors(option.palette);
  const bool isChosen = option.state.testFlag(QStyle::State_Selected);
  QRect line = option.rect;
  line.setTop(line.bottom() - (isChosen ? kSelectedTabLinePx : 1) + 1);
  if (!isChosen && option.state.testFlag(QStyle::State_MouseOver)) {
    painter.fillRect(option.rect, mixed(colors.window, colors.accent, kCheckedTint / 2.0F));
  }
  painter.fillRect(line, isChosen ? colors.accent : colors.line);
}

}  // namespace

QColor mixed(const QColor& ground, const QColor& other, float share) {
  const auto channel = [share](auto a, auto b) {
    return (1.0F - share) * static_cast<float>(a) + share * static_cast<float>(b);
  };
  return QColor::fromRgbF(channel(ground.redF(), other.redF()),
                          channel(ground.greenF(), other.greenF()),
                          channel(ground.blueF(), other.blueF()));
}

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
    case PE_PanelButtonTool:
      if (!option->state.testFlag(State_AutoRaise) || option->state.testFlag(State_On)) {
        drawButton(*painter, *option);
        markChecked(*painter, *option);
        return;
      }
      break;
    case PE_PanelLineEdit:
      if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
          frame != nullptr && frame->lineWidth > 0) {
        drawField(*painter, *option);
        return;
      }
      break;
    case PE_FrameTabBarBase: {
      QRect line = option->rect;
      line.setTop(line.bottom());
      painter->fillRect(line, themeColors(option->palette).line);
      return;
    }
    case PE_FrameFocusRect:
      return;  // FocusFrame shows it
    default:
      break;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  switch (element) {
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
  const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
  if (element == CE_TabBarTabShape && tab != nullptr) {
    drawTab(*painter, *tab);
    return;
  }
  if (element == CE_TabBarTabLabel && tab != nullptr) {
    QStyleOptionTab label(*tab);
    const ThemeColors& colors = themeColors(option->palette);
    if (option->state.testFlag(State_Enabled)) {
      label.palette.setColor(QPalette::WindowText, option->state.testFlag(State_Selected)
                                                       ? colors.text
                                                       : colors.mutedText);
    }
    QProxyStyle::drawControl(element, &label, painter, widget);
    return;
  }
  const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option);
  if (element == CE_ProgressBar && bar != nullptr && option->rect.height() <= kThinBarPx) {
    drawThinBar(*painter, *bar);
    return;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
  if (element == CE_ProgressBarGroove) {
    drawBorder(*painter, option->rect, border(*option));
  }
}

void OperatorStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                       QPainter* painter, const QWidget* widget) const {
  const auto part = [&](SubControl which) {
    return proxy()->subControlRect(control, option, which, widget);
  };
  const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
  const auto* list = qstyleoption_cast<const QStyleOptionComboBox*>(option);
  if (control == CC_ScrollBar && slider != nullptr) {
    painter->fillRect(option->rect, option->palette.color(QPalette::Window));
    drawScrollHandle(*painter, part(SC_ScrollBarSlider), *slider);
    return;
  }
  if (control == CC_Slider && slider != nullptr) {
    if (slider->tickPosition != QSlider::NoTicks) {
      QStyleOptionSlider ticks(*slider);
      ticks.subControls = SC_SliderTickmarks;
      QProxyStyle::drawComplexControl(control, &ticks, painter, widget);
    }
    drawSlider(*painter, part(SC_SliderGroove), part(SC_SliderHandle), *slider);
    return;
  }
  if (control == CC_ComboBox && list != nullptr && !list->editable) {
    drawList(*painter, part(SC_ComboBoxArrow), *list);
    return;
  }
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (control == CC_ComboBox || control == CC_SpinBox) {
    drawBorder(*painter, option->rect, border(*option));
  }
}

QRect OperatorStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                    SubControl part, const QWidget* widget) const {
  const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control != CC_ScrollBar || bar == nullptr) {
    return QProxyStyle::subControlRect(control, option, part, widget);
  }
  // No buttons at the ends: the whole length is for the handle.
  const QRect all = option->rect;
  const bool isUpright = bar->orientation == Qt::Vertical;
  const int length = isUpright ? all.height() : all.width();
  const int span = bar->maximum - bar->minimum;
  const double share = span > 0 ? static_cast<double>(bar->pageStep) / (span + bar->pageStep) : 1.0;
  const int handle =
      std::clamp(static_cast<int>(share * length), std::min(kTouchHeightPx, length), length);
  const int begin = sliderPositionFromValue(bar->minimum, bar->maximum, bar->sliderPosition,
                                            length - handle, bar->upsideDown);
  const auto between = [&](int from, int to) {
    const QRect rect = isUpright ? QRect(all.left(), all.top() + from, all.width(), to - from)
                                 : QRect(all.left() + from, all.top(), to - from, all.height());
    return visualRect(option->direction, all, rect);
  };
  switch (part) {
    case SC_ScrollBarSlider:
      return between(begin, begin + handle);
    case SC_ScrollBarSubPage:
      return between(0, begin);
    case SC_ScrollBarAddPage:
      return between(begin + handle, length);
    case SC_ScrollBarGroove:
      return all;
    default:
      return {};
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
