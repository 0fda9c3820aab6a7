// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The menu of the pane layouts: show one, keep the present one under a name, delete one, choose
/// that of new traces. @threadsafety GUI thread.
#pragma once

#include <QMenu>

#include "widgets/scope/scope_layout.h"

namespace rivulet::widgets {

class LayoutMenu final : public QMenu {
  Q_OBJECT

 public:
  explicit LayoutMenu(QWidget* parent = nullptr);

  void setLayouts(ScopeLayouts layouts);
  [[nodiscard]] const ScopeLayouts& layouts() const { return m_layouts; }

 Q_SIGNALS:
  void showRequested(const QString& name);
  /// The operator wants to keep the present arrangement.
  void keepRequested(const QString& name);
  void deleteRequested(const QString& name);
  /// @param name  empty: as the page proposes
  void standardRequested(const QString& name);

 private:
  void fill();
  void askName();

  ScopeLayouts m_layouts;
};

}  // namespace rivulet::widgets
