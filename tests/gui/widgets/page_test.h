// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What every test of a page needs: languages, pictures, and the texts a page shows.
#pragma once

#include <QImage>
#include <QString>
#include <QTranslator>
#include <QWidget>

namespace rivulet::test {

/// A warning of Qt fails the test; but for one of the offscreen platform that tells nothing.
void failOnWarnings();

/// Switches the language of the application as the application does; English again at the end.
class Language {
 public:
  Language();
  ~Language();
  void german();
  void english();

 private:
  QTranslator m_translator;
};

/// Every visible text of a widget and its children, joined; for checks of what is shown.
[[nodiscard]] QString visibleText(const QWidget& widget);
/// Tool tip of the figure that shows this value; empty: none shows it.
[[nodiscard]] QString hintOf(const QWidget& widget, const QString& value);

/// Handles events until nothing that the widget or its children have put off is left.
/// @return false if that does not happen
bool settle(const QWidget& widget);

/// Shows the widget in a size, lets everything due be drawn and takes a picture of it.
[[nodiscard]] QImage picture(QWidget& widget, QSize size);

/// Stores a picture in the build folder under `name`.png.
void keep(const QImage& picture, const QString& name);

/// Number of different colours, at most `limit`.
[[nodiscard]] int colourCount(const QImage& picture, int limit = 1000);

/// Children whose text does not fit: buttons, labels of one line, headers.
[[nodiscard]] QStringList cutTexts(const QWidget& widget);

}  // namespace rivulet::test
