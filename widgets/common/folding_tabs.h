// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Tabs for a narrow place: where their names do not fit side by side, a list takes their place, so
/// that none is cut or scrolled away. @threadsafety GUI thread.
#pragma once

#include <QWidget>

class QComboBox;
class QIcon;
class QTabWidget;

namespace rivulet::widgets {

class FoldingTabs final : public QWidget {
  Q_OBJECT

 public:
  explicit FoldingTabs(QWidget* parent = nullptr);

  /// A page that scrolls where it is higher than its place.
  void addPage(QWidget* page);
  [[nodiscard]] QTabWidget* tabs() const { return m_tabs; }
  /// @param texts  one for each tab @param name  of the list, for a screen reader
  void setTexts(const QStringList& texts, const QString& name);
  /// Of one tab, and of its line in the list.
  void setIcon(int index, const QIcon& icon);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fold();

  QComboBox* m_list;
  QTabWidget* m_tabs;
};

}  // namespace rivulet::widgets
