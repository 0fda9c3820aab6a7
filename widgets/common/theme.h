// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The colours of the HMI. The screen is calm grey; colour means "look here". Every colour is a
/// function of the palette, so a page needs no setting: it calls `themeColors(palette())` and is
/// notified of a change by `QEvent::PaletteChange`. Red is Stop and alarms, green may start.
/// @threadsafety GUI thread.
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>
#include <array>

class QPushButton;

namespace rivulet::widgets {

enum class Theme {
  Light,
  Dark,
  Contrast,  ///< black and white, with lines around everything that can be operated
  System,    ///< light or dark, as the desktop's own palette is
};

/// "light", "dark", "contrast", "system": as settings and command lines name a theme.
[[nodiscard]] QString themeName(Theme theme);
/// @return System for an unknown name
[[nodiscard]] Theme themeFromName(const QString& name);

/// Everything that is painted by hand or by a chart. Text colours have a contrast of at least
/// 4.5:1 on `window` and on `surface`.
struct ThemeColors {
  bool isDark = false;
  bool isContrast = false;
  QColor window;
  QColor surface;  ///< behind lists, charts and the path
  QColor button;
  QColor text;
  QColor mutedText;
  QColor line;     ///< frames and axes
  QColor outline;  ///< border of what can be operated: at least 3:1 on all grounds
  QColor grid;
  QColor accent;     ///< the current thing: state, executed path, tool
  QColor attention;  ///< text and icons of warnings
  QColor fault;      ///< text and icons of faults
  QColor stop;       ///< filled, of the button Stop alone
  QColor start;      ///< filled, of the button Start alone
  QColor onFill;     ///< text on these two, and on what is chosen in the rail
  QColor rail;       ///< behind the places of the window
  QColor railText;
  QColor railChosen;
  QColor railHover;
  QColor path;  ///< path still to be cut
  QColor rapid;
  QColor native;                    ///< what the control executes itself
  QColor trace;                     ///< measured curves
  std::array<QColor, 5> equations;  ///< by `feasibility::Equation`
  QColor feasibleFill;
  QColor safetyFill;
  QColor pauseFill;
};

/// The colours that belong to a palette made by `applyTheme` (or to any other: light or dark).
[[nodiscard]] const ThemeColors& themeColors(const QPalette& palette);

/// The palette of a theme. @param theme  not System
[[nodiscard]] QPalette themePalette(Theme theme);

/// `OperatorStyle`, palette and touch-friendly font for the whole application. Reaches every open
/// window at once.
void applyTheme(Theme theme);

/// Gives a button a colour of its own, with `ThemeColors::onFill` for its text; pale while it
/// cannot be pressed.
void fillButton(QPushButton& button, const QColor& fill);

/// Contrast of two opaque colours as WCAG defines it, 1 to 21.
[[nodiscard]] double contrastRatio(const QColor& first, const QColor& second);

inline constexpr int kTouchHeightPx = 44;  ///< least height of a button an operator needs

}  // namespace rivulet::widgets
