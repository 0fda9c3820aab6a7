// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A button for what moves the machine: it acts only after it has been held for one second, by
/// mouse, finger or Space. A bar in the button fills meanwhile; letting go earlier does nothing.
/// @threadsafety GUI thread.
#pragma once

#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>

namespace rivulet::widgets {

class HoldButton final : public QPushButton {
  Q_OBJECT

 public:
  static constexpr int kHoldMs = 1000;

  explicit HoldButton(QWidget* parent = nullptr);

  /// Without it the button is an ordinary one, with `clicked` alone.
  void setNeedsHold(bool needsHold);

 Q_SIGNALS:
  /// It has been held long enough. `clicked` still follows when it is let go.
  void held();

 protected:
  void hideEvent(QHideEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void begin();
  void cancel();
  void advance();

  bool m_needsHold = true;
  QTimer m_timer;  ///< repaints the bar
  QElapsedTimer m_since;
};

}  // namespace rivulet::widgets
