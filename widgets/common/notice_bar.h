// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A bar above the bottom of the window: something that the operator has to know or decide, with
/// buttons for it. It covers nothing, so Stop stays within reach. Derived classes set texts and
/// buttons. @threadsafety GUI thread.
#pragma once

#include "widgets/common/page.h"
#include "widgets/common/status_label.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace rivulet::widgets {

class HoldButton;

class NoticeBar : public Page {
  Q_OBJECT

 public:
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  explicit NoticeBar(QWidget* parent);

  void setNotice(Status status, const QString& text);
  /// Another icon than that of the status. @param name  empty: that of the status
  void setIcon(const QString& name);
  /// A button at the right, after those before.
  QPushButton* addButton(const Part& part);
  HoldButton* addHoldButton(const Part& part);

  void restyle() override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Text and buttons side by side, or on a narrow window one above the other.
  void arrange();

  Status m_status = Status::Busy;
  QString m_iconName;
  QGridLayout* m_rows;
  QLabel* m_icon = label({});
  QLabel* m_text = value({.wraps = true});
  QWidget* m_buttons;
  QHBoxLayout* m_buttonRow;
};

}  // namespace rivulet::widgets
