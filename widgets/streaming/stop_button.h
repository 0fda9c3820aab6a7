// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A button with a line in small letters below its word: Stop, and how soon the axes stand.
/// @threadsafety GUI thread.
#pragma once

#include <QPushButton>

namespace rivulet::widgets {

class StopButton final : public QPushButton {
  Q_OBJECT

 public:
  explicit StopButton(QWidget* parent = nullptr);

  /// @param note  empty: the word alone
  void setNote(const QString& note);
  [[nodiscard]] const QString& note() const { return m_note; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QFont noteFont() const;

  QString m_note;
};

}  // namespace rivulet::widgets
