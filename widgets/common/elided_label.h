// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A text that takes the room it is given: what does not fit its lines ends with "…", and the tool
/// tip has all of it. It never makes its window wider or higher.
/// @threadsafety GUI thread.
#pragma once

#include <QLabel>

namespace rivulet::widgets {

class ElidedLabel final : public QLabel {
  Q_OBJECT

 public:
  /// @param lines  at most this many, >= 1; the height is always that of all of them
  explicit ElidedLabel(int lines, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  /// The lines as they are drawn.
  [[nodiscard]] QStringList shownLines() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] int heightPx() const;

  int m_lines;
};

}  // namespace rivulet::widgets
