// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The notices above the strip with Stop, one above the other. They get the height they need as
/// long as the window has it; then they scroll, so that they never push the strip out of the
/// window.
/// @threadsafety GUI thread.
#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace rivulet::widgets {

class NoticeArea final : public QScrollArea {
  Q_OBJECT

 public:
  explicit NoticeArea(QWidget* parent);

  void add(QWidget* notice);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QVBoxLayout* m_rows;
};

}  // namespace rivulet::widgets
