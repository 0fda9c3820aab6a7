// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Base of every page: texts are set in one place and set again when the language changes,
/// colours when the theme changes. A page that is not shown in a window that is follows when it is
/// shown. A derived constructor ends with `retranslate(); restyle();`.
/// @threadsafety GUI thread.
#pragma once

#include <QWidget>

class QPushButton;
class QLabel;

namespace rivulet::widgets {

class Page : public QWidget {
  Q_OBJECT

 public:
  explicit Page(QWidget* parent = nullptr);

 protected:
  /// Sets every text and shows every number again, in the present language.
  virtual void retranslate() = 0;
  /// Takes colours and icons from the present palette.
  virtual void restyle() {}

  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// All pages at once would keep the window busy for too long.
  [[nodiscard]] bool canWait() const { return !isVisible() && window()->isVisible(); }
  void followLanguage();

  bool m_waitsForLanguage = false;
  bool m_waitsForTheme = false;
};

/// A button large enough for a finger.
[[nodiscard]] QPushButton* makeTouchButton(QWidget* parent);

/// A label whose text can be selected and copied.
[[nodiscard]] QLabel* makeValueLabel(QWidget* parent);

/// A bold label as the heading of a group.
[[nodiscard]] QLabel* makeHeading(QWidget* parent);

/// Background of a bar over a page that asks for attention. To be called by its `paintEvent`.
void paintAttentionBar(QWidget& bar);

/// Gives a widget the colour of secondary text.
/// @param palette  of the page: while a theme changes, the children still have the old one
void setMuted(QWidget* widget, const QPalette& palette);

}  // namespace rivulet::widgets
