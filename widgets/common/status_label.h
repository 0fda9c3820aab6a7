// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A state as icon and text, coloured only if it is abnormal.
/// @threadsafety GUI thread.
#pragma once

#include <QWidget>

class QLabel;

namespace rivulet::widgets {

enum class Status {
  Plain,      ///< a value like any other: no icon
  Unknown,    ///< hollow circle
  Busy,       ///< hour glass
  Good,       ///< check mark; stays grey
  Attention,  ///< triangle
  Fault,      ///< octagon
  Simulated,  ///< letter C in a square: not the real thing (NAMUR NE 107 "check")
};

/// Name of the icon that stands for a state.
[[nodiscard]] QString statusIconName(Status status);
/// Its colour in a palette: neutral unless abnormal.
[[nodiscard]] QColor statusColor(Status status, const QPalette& palette);

class StatusLabel final : public QWidget {
  Q_OBJECT

 public:
  explicit StatusLabel(QWidget* parent = nullptr);
  /// The text takes the room it is given, in this many lines (`ElidedLabel`).
  struct Elided {
    int lines = 1;
  };
  StatusLabel(QWidget* parent, Elided elided);

  void setStatus(Status status, const QString& text);
  [[nodiscard]] Status status() const { return m_status; }
  [[nodiscard]] QString text() const;
  /// Size of the text in points and whether it is bold; the icon follows.
  void setEmphasis(qreal pointSize, bool bold);
  void setWordWrap(bool wrap);
  /// The text cannot be copied: cheaper for one that changes many times a second.
  void setFigure();
  /// What is shown may not be true any more: grey and crossed out.
  void setOutdated(bool isOutdated);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void restyle();

  StatusLabel(QWidget* parent, QLabel* text);

  Status m_status = Status::Unknown;
  bool m_isOutdated = false;
  QLabel* m_icon;
  QLabel* m_text;
};

}  // namespace rivulet::widgets
