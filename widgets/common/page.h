// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Base of every page: its parts (see `Parts`) follow language and theme by themselves. What
/// depends on a state as well is shown by functions that a constructor gives to `onLanguage` and
/// `onTheme`, or by `retranslate` and `restyle`, with which the constructor then ends. A page that
/// is not shown in a window that is follows when it is shown.
/// @threadsafety GUI thread.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/common/parts.h"

class QPushButton;
class QLabel;

namespace rivulet::widgets {

class Page : public QWidget, protected Parts {
  Q_OBJECT

 public:
  explicit Page(QWidget* parent = nullptr);

 protected:
  /// Shows again what depends on a state, in the present language.
  virtual void retranslate() {}
  /// Takes colours from the present palette, for what is painted or depends on a state.
  virtual void restyle() {}

  /// Calls these functions, of the page or any, now and whenever the language changes.
  template <class... Calls>
  void onLanguage(Calls... calls) {
    (follow(m_onLanguage, calls), ...);
  }
  /// The same for the theme.
  template <class... Calls>
  void onTheme(Calls... calls) {
    (follow(m_onTheme, calls), ...);
  }

  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// All pages at once would keep the window busy for too long.
  [[nodiscard]] bool canWait() const { return !isVisible() && window()->isVisible(); }
  void followLanguage();
  void followTheme();

  using Call = std::function<void()>;
  static void follow(std::vector<Call>& calls, const Call& call);
  template <class Derived>
  void follow(std::vector<Call>& calls, void (Derived::*call)()) {
    follow(calls, [this, call] { (static_cast<Derived*>(this)->*call)(); });
  }

  std::vector<Call> m_onLanguage;
  std::vector<Call> m_onTheme;
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
