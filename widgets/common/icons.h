// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The icons of resources/icons in the required colour. The files draw in `currentColor`, so one
/// file serves both themes.
/// @threadsafety GUI thread.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

class QAbstractButton;

namespace rivulet::widgets {

/// @param name file name without folder and suffix, e.g. "play"
[[nodiscard]] QPixmap iconPixmap(const QString& name, const QColor& color, int sizePx,
                                 qreal devicePixelRatio = 1.0);

/// As `iconPixmap`, in 16 to 64 px; greyed out for disabled buttons by the style. In a selected row it
/// has the colour of the text there.
[[nodiscard]] QIcon themedIcon(const QString& name, const QColor& color);

/// Gives the button that icon, unless it has it: it would be laid out and painted anew.
void setThemedIcon(QAbstractButton& button, const QString& name, const QColor& color);

}  // namespace rivulet::widgets
