// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A page with two columns at its right, closed at first. Where there is room, a column stands
/// beside the page; where there is not, it takes the place of the page.
/// Nothing in it makes the window wider or higher: what does not fit scrolls.
/// @threadsafety GUI thread.
#pragma once

#include <QWidget>

class QScrollArea;

namespace rivulet::widgets {

/// A page that scrolls in both directions when there is less room than it needs.
[[nodiscard]] QScrollArea* makeScrolling(QWidget* page, QWidget* parent = nullptr);
/// The same for a page of text and fields: it is never lower than its texts need at its width.
[[nodiscard]] QScrollArea* makeColumn(QWidget* page, QWidget* parent = nullptr);

class FoldingColumns final : public QWidget {
  Q_OBJECT

 public:
  enum Column { First, Second };

  /// Takes the three parts.
  FoldingColumns(QWidget* centre, QWidget* first, QWidget* second, QWidget* parent = nullptr);

  void setOpen(Column column, bool open);
  [[nodiscard]] bool isOpen(Column column) const { return m_isOpen[column]; }
  /// An open column leaves no room for the page.
  [[nodiscard]] bool coversCentre() const;
  void setColumnsEnabled(bool areEnabled);
  /// Closes what covers the page.
  void uncover();
  /// In a very low window the page gives way to what is above and below it.
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// A column was opened or closed, by whomever.
  void changed();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Room { Page, OneColumn, BothColumns };
  [[nodiscard]] Room room() const;
  void show();

  QScrollArea* m_columns[2];
  QWidget* m_centre;
  bool m_isOpen[2] = {false, false};
  Room m_room = Room::Page;
};

}  // namespace rivulet::widgets
