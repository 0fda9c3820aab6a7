// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The audit trail: who did what when, whether somebody changed it, and its export.
/// @threadsafety GUI thread.
#pragma once

#include <QPalette>
#include <QString>
#include <optional>
#include <vector>

#include "base/utc.h"
#include "permission/permission.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace rivulet::widgets {

class StatusLabel;

struct AuditRow {
  std::size_t line = 0;  ///< of the file
  base::UtcMs at = 0;
  QString who;
  QString role;     ///< `permission::roleName`; empty: no roles are set up
  QString act;      ///< `permission::actName`
  QString details;  ///< "feed=829; points=7"
  bool isSuspect = false;
};

struct AuditView {
  std::vector<AuditRow> rows;   ///< the oldest first
  std::size_t firstChange = 0;  ///< line that was changed, inserted or removed; 0: none
  std::size_t cutLines = 0;     ///< cut or damaged
  QString lastHash;
  QString file;
};

/// An act in the language of the operator; as it is if it is not known.
[[nodiscard]] QString actText(const QString& act);
[[nodiscard]] QString roleText(permission::Role role);

class AuditModel final : public TableModel<AuditRow> {
  Q_OBJECT

 public:
  enum Column { Line, Time, Who, RoleColumn, Act, Details };
  explicit AuditModel(QObject* parent = nullptr);
  void setColors(const QPalette& palette);

 private:
  QPalette m_palette;
};

class AuditPage final : public Page {
  Q_OBJECT

 public:
  explicit AuditPage(QWidget* parent = nullptr);
  void setAudit(const AuditView& audit);

 Q_SIGNALS:
  /// The page is shown: it wants what the file holds now.
  void refreshRequested();
  /// @param path  ends in .json for JSON, else CSV is wanted
  void exportRequested(const QString& path);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void showState();
  void chooseFile(const QString& suffix);

  AuditView m_audit;
  AuditModel* m_model;
  QSortFilterProxyModel* m_filter;
  StatusLabel* m_state;
  QLabel* m_hash = value({.isMuted = true});
  QLineEdit* m_search = lineEdit(
      {.name = QT_TR_NOOP("Search"), .placeholder = QT_TR_NOOP("Search"), .isTouch = true});
  QTableView* m_table;
  QPushButton* m_csv = button({.text = QT_TR_NOOP("Export as CSV…"), .icon = "save"});
  QPushButton* m_json = button({.text = QT_TR_NOOP("Export as JSON…"), .icon = "save"});
};

}  // namespace rivulet::widgets
