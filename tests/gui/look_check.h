// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program can find wrong with a picture of a window: widgets outside their parent or on top
/// of each other, text that is cut, text that is hard to read, controls too small for a finger,
/// inputs without a name. It looks at the widgets as they stand and at the pixels as they are.
/// @threadsafety GUI thread.
#pragma once

#include <QImage>
#include <QStringList>
#include <QWidget>
#include <memory>

class QTranslator;

namespace rivulet::tests {

/// One sentence for each fault of what is visible in the window; empty: none was found.
/// @param picture  of the window as it is now, as `QWidget::grab` makes it
[[nodiscard]] QStringList lookFaults(const QWidget& window, const QImage& picture);

/// Texts 40 % longer than the English ones, accented and in brackets: what shows without brackets
/// was not translated, and what lacks its closing bracket is cut. Arguments (%1) and mnemonics
/// stay.
[[nodiscard]] QString pseudoText(const QString& english);

/// Translates every text by `pseudoText`.
[[nodiscard]] std::unique_ptr<QTranslator> makePseudoTranslator();

}  // namespace rivulet::tests
