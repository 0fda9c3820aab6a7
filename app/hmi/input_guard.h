// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Two rules for the whole application, menus and dialogs included:
/// - Escape stops the run in progress, whatever has the focus. It still closes a menu or a dialog.
/// - The mouse wheel changes no setting. It scrolls what is around the field.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <functional>

namespace rivulet::hmi {

class InputGuard final : public QObject {
  Q_OBJECT

 public:
  /// @param stop  stops the run in progress, if there is one; may be called more than once for a
  ///              key
  /// @param touched  somebody uses keys, mouse or screen
  InputGuard(std::function<void()> stop, std::function<void()> touched, QObject* parent = nullptr);
  ~InputGuard() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::function<void()> m_stop;
  std::function<void()> m_touched;
};

}  // namespace rivulet::hmi
