// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A frame of 3 px around what has the keyboard focus, the same for every widget of the
/// application. It shows when the focus came by a key, and always around what one types into.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace rivulet::widgets {

class FocusFrame final : public QObject {
  Q_OBJECT

 public:
  static constexpr int kWidthPx = 3;

  /// Follows the focus as long as it lives.
  explicit FocusFrame(QObject* parent);
  ~FocusFrame() override;

  /// What it is drawn around; null: nothing.
  [[nodiscard]] const QWidget* target() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void surround(QWidget* target);
  void hide();

  QPointer<QWidget> m_frame;  ///< a child of what it surrounds: it moves and is cut with it
};

}  // namespace rivulet::widgets
