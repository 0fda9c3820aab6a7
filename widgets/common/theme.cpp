// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/theme.h"

#include <QApplication>
#include <QFont>
#include <QPushButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/common/operator_style.h"

namespace rivulet::widgets {

namespace {

/// By `Theme`.
constexpr std::array<const char*, 4> kThemeNames{"light", "dark", "contrast", "system"};

ThemeColors lightColors() {
  ThemeColors colors;
  colors.isDark = false;
  colors.window = QColor(0xee, 0xf0, 0xf3);
  colors.surface = QColor(0xff, 0xff, 0xff);
  colors.button = QColor(0xff, 0xff, 0xff);
  colors.text = QColor(0x15, 0x19, 0x1f);
  colors.mutedText = QColor(0x53, 0x5d, 0x69);
  colors.line = QColor(0xcd, 0xd3, 0xdb);
  colors.outline = QColor(0x7a, 0x84, 0x90);
  colors.grid = QColor(0xe7, 0xea, 0xef);
  colors.accent = QColor(0x15, 0x60, 0xd4);
  colors.attention = QColor(0x8f, 0x5a, 0x00);
  colors.fault = QColor(0x96, 0x0c, 0x14);
  colors.stop = QColor(0xc8, 0x1e, 0x1e);
  colors.start = QColor(0x0b, 0x7a, 0x4b);
  colors.onFill = Qt::white;
  colors.rail = QColor(0x22, 0x29, 0x32);
  colors.railText = QColor(0xc4, 0xcc, 0xd6);
  colors.railChosen = QColor(0x15, 0x60, 0xd4);
  colors.railHover = QColor(0x34, 0x3d, 0x49);
  colors.path = QColor(0x7d, 0x86, 0x8f);
  colors.rapid = QColor(0x9a, 0x7b, 0x3c);
  colors.native = QColor(0xa0, 0x1a, 0x6e);
  colors.trace = QColor(0x2f, 0x4b, 0x66);
  colors.equations = {colors.accent, QColor(0x56, 0x10, 0x52), QColor(0x34, 0x57, 0x4a),
                      QColor(0x95, 0x57, 0x31), colors.accent};
  colors.feasibleFill = QColor(0x5b, 0x7d, 0x9b, 46);
  colors.safetyFill = QColor(0xd0, 0x94, 0x2b, 60);
  colors.pauseFill = QColor(0x6b, 0x74, 0x7d, 70);
  return colors;
}

ThemeColors darkColors() {
  ThemeColors colors;
  colors.isDark = true;
  colors.window = QColor(0x14, 0x18, 0x1d);
  colors.surface = QColor(0x1c, 0x22, 0x29);
  colors.button = QColor(0x26, 0x2e, 0x37);
  colors.text = QColor(0xee, 0xf2, 0xf6);
  colors.mutedText = QColor(0xa6, 0xb1, 0xbe);
  colors.line = QColor(0x3c, 0x46, 0x51);
  colors.outline = QColor(0x7c, 0x88, 0x95);
  colors.grid = QColor(0x26, 0x2e, 0x37);
  colors.accent = QColor(0x6a, 0xa6, 0xff);
  colors.attention = QColor(0xff, 0xb8, 0x4d);
  colors.fault = QColor(0xff, 0x8d, 0x83);
  colors.stop = QColor(0xd6, 0x2f, 0x2f);
  colors.start = QColor(0x12, 0x80, 0x50);
  colors.onFill = Qt::white;
  colors.rail = QColor(0x0c, 0x0f, 0x13);
  colors.railText = QColor(0xb4, 0xbe, 0xca);
  colors.railChosen = QColor(0x15, 0x60, 0xd4);
  colors.railHover = QColor(0x26, 0x2e, 0x37);
  colors.path = QColor(0x86, 0x90, 0x9a);
  colors.rapid = QColor(0xa8, 0x8c, 0x55);
  colors.native = QColor(0xff, 0x8a, 0xc8);
  colors.trace = QColor(0xa9, 0xc4, 0xdd);
  colors.equations = {colors.accent, QColor(0xc0, 0x8f, 0xb8), QColor(0xb4, 0xf0, 0xdc),
                      QColor(0xe9, 0xa0, 0x4d), colors.accent};
  colors.feasibleFill = QColor(0x74, 0xa5, 0xd0, 48);
  colors.safetyFill = QColor(0xe0, 0xa4, 0x3b, 56);
  colors.pauseFill = QColor(0xa0, 0xa9, 0xb2, 64);
  return colors;
}

ThemeColors contrastColors() {
  ThemeColors colors;
  colors.isDark = true;
  colors.isContrast = true;
  colors.window = Qt::black;
  colors.surface = Qt::black;
  colors.button = Qt::black;
  colors.text = Qt::white;
  colors.mutedText = QColor(0xe6, 0xe6, 0xe6);
  colors.line = QColor(0xb0, 0xb0, 0xb0);
  colors.outline = Qt::white;
  colors.grid = QColor(0x40, 0x40, 0x40);
  colors.accent = QColor(0x4c, 0xc9, 0xff);
  colors.attention = QColor(0xff, 0xd4, 0x00);
  colors.fault = QColor(0xff, 0x9a, 0x90);
  colors.stop = QColor(0xc8, 0x1e, 0x1e);
  colors.start = QColor(0x0b, 0x7a, 0x4b);
  colors.onFill = Qt::white;
  colors.rail = Qt::black;
  colors.railText = Qt::white;
  colors.railChosen = QColor(0x15, 0x60, 0xd4);
  colors.railHover = QColor(0x30, 0x30, 0x30);
  colors.path = QColor(0xc8, 0xc8, 0xc8);
  colors.rapid = QColor(0xd0, 0xb0, 0x70);
  colors.native = QColor(0xff, 0x4f, 0xb0);
  colors.trace = QColor(0xb8, 0xe0, 0xff);
  colors.equations = {QColor(0x4c, 0xc9, 0xff), QColor(0xc9, 0x4b, 0xee), QColor(0x86, 0xb0, 0x9c),
                      QColor(0xff, 0xb2, 0x5e), QColor(0x4c, 0xc9, 0xff)};
  colors.feasibleFill = QColor(0x4c, 0xc9, 0xff, 60);
  colors.safetyFill = QColor(0xff, 0xd4, 0x00, 70);
  colors.pauseFill = QColor(0xff, 0xff, 0xff, 80);
  return colors;
}

ThemeColors colorsOf(Theme theme) {
  switch (theme) {
    case Theme::Dark:
      return darkColors();
    case Theme::Contrast:
      return contrastColors();
    case Theme::Light:
    case Theme::System:
      break;
  }
  return lightColors();
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::WindowText).lightness() >
         palette.color(QPalette::Window).lightness();
}

double luminance(const QColor& color) {
  const auto linear = [](double channel) {
    return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

}  // namespace

QString themeName(Theme theme) {
  return QLatin1String(kThemeNames[static_cast<std::size_t>(theme)]);
}

Theme themeFromName(const QString& name) {
  for (std::size_t i = 0; i < kThemeNames.size(); ++i) {
    if (name == QLatin1String(kThemeNames[i])) {
      return static_cast<Theme>(i);
    }
  }
  return Theme::System;
}

const ThemeColors& themeColors(const QPalette& palette) {
  static const ThemeColors light = lightColors();
  static const ThemeColors dark = darkColors();
  static const ThemeColors contrast = contrastColors();
  if (palette.color(QPalette::Window) == contrast.window) {
    return contrast;  // no other theme is black
  }
  return isDark(palette) ? dark : light;
}

QPalette themePalette(Theme theme) {
  const ThemeColors colors = colorsOf(theme);
  QPalette palette;
  palette.setColor(QPalette::Window, colors.window);
  palette.setColor(QPalette::WindowText, colors.text);
  palette.setColor(QPalette::Base, colors.surface);
  palette.setColor(QPalette::AlternateBase, colors.isContrast ? QColor(0x1c, 0x1c, 0x1c)
                                            : colors.isDark   ? QColor(0x22, 0x26, 0x2a)
                                                              : QColor(0xf1, 0xf2, 0xf4));
  palette.setColor(QPalette::Text, colors.text);
  palette.setColor(QPalette::PlaceholderText, colors.mutedText);
  palette.setColor(QPalette::Button, colors.button);
  palette.setColor(QPalette::ButtonText, colors.text);
  palette.setColor(QPalette::BrightText, colors.fault);
  palette.setColor(QPalette::ToolTipBase, colors.surface);
  palette.setColor(QPalette::ToolTipText, colors.text);
  palette.setColor(QPalette::Highlight, colors.isContrast ? colors.attention : colors.railChosen);
  palette.setColor(QPalette::HighlightedText, colors.isContrast ? Qt::black : Qt::white);
  palette.setColor(QPalette::Link, colors.accent);
  palette.setColor(QPalette::LinkVisited, colors.accent);
  palette.setColor(QPalette::Light, colors.isContrast
                                        ? QColor(0x38, 0x38, 0x38)
                                        : colors.button.lighter(colors.isDark ? 130 : 104));
  palette.setColor(QPalette::Midlight, colors.isContrast
                                           ? QColor(0x28, 0x28, 0x28)
                                           : colors.button.lighter(colors.isDark ? 115 : 102));
  palette.setColor(QPalette::Mid, colors.line);
  palette.setColor(QPalette::Dark,
                   colors.isDark ? QColor(0x14, 0x16, 0x18) : QColor(0x8a, 0x92, 0x9a));
  palette.setColor(QPalette::Shadow, colors.isDark ? Qt::black : QColor(0x5a, 0x60, 0x66));
  const QColor disabled = colors.isContrast ? colors.line
                          : colors.isDark   ? QColor(0x8a, 0x92, 0x9a)
                                            : QColor(0x6a, 0x72, 0x7a);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, disabled);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colors.line);
  return palette;
}

void applyTheme(Theme theme) {
  if (qobject_cast<OperatorStyle*>(QApplication::style()) == nullptr) {
    QApplication::setStyle(new OperatorStyle);
  }
  if (theme == Theme::System) {
    QApplication::setPalette(QPalette());  // back to what the desktop says
    theme = isDark(QGuiApplication::palette()) ? Theme::Dark : Theme::Light;
  }
  const QPalette palette = themePalette(theme);
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
  QFont font = QApplication::font();
  if (font.pointSizeF() < 10.0) {
    font.setPointSizeF(10.0);  // readable at arm's length
    QApplication::setFont(font);
  }
}

void fillButton(QPushButton& button, const QColor& fill) {
  constexpr float kPaleShare = 0.45F;
  QPalette own = QApplication::palette();
  const ThemeColors& colors = themeColors(own);
  const auto pale = [&colors](const QColor& color) {
    return mixed(colors.window, color, kPaleShare);
  };
  own.setColor(QPalette::Button, fill);
  own.setColor(QPalette::ButtonText, colors.onFill);
  own.setColor(QPalette::Disabled, QPalette::Button, pale(fill));
  own.setColor(QPalette::Disabled, QPalette::ButtonText,
               colors.isDark ? pale(colors.onFill) : colors.onFill);
  button.setPalette(own);
}

double contrastRatio(const QColor& first, const QColor& second) {
  const double a = luminance(first);
  const double b = luminance(second);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

}  // namespace rivulet::widgets
