// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Pages with their names in a column at the left, one below the other and upright, each large
/// enough for a finger; in a low window they move together before they scroll. Arrow keys and
/// Ctrl+Tab change the page, as in any tab widget.
/// @threadsafety GUI thread.
#pragma once

#include <QTabWidget>

namespace rivulet::widgets {

class SideTabs final : public QTabWidget {
  Q_OBJECT

 public:
  explicit SideTabs(QWidget* parent = nullptr);

  /// Names of all pages and their tool tips: laid out once, not for each name.
  void setTitles(const QStringList& titles, const QStringList& toolTips);

 protected:
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace rivulet::widgets
