// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The flexible program the control has to run, as generated for the present settings, and the
/// meaning of its R-parameters.
/// @threadsafety GUI thread.
#pragma once

#include <optional>

#include "templates/flexible_program.h"
#include "widgets/common/page.h"

class QGroupBox;
class QPlainTextEdit;
class QPushButton;
class QTableView;

namespace rivulet::widgets {

class CellModel;
class NcHighlighter;
class StatusLabel;

class TemplatePage final : public Page {
  Q_OBJECT

 public:
  explicit TemplatePage(QWidget* parent = nullptr);

  void setTemplate(const templates::FlexibleProgram& program);
  /// There is no template for these settings; one sentence says why.
  void setProblem(const QString& problem);
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  void saveRequested(const QString& path);

 private:
  void showState();

  QString m_fileName;
  QString m_problem;
  int m_layoutNumber = 0;

  StatusLabel* m_state = status({.wraps = true});
  QPushButton* m_copy = button({.text = QT_TR_NOOP("Copy"), .icon = "copy"});
  QPushButton* m_save = button({.text = QT_TR_NOOP("Save…"), .icon = "save"});
  QPlainTextEdit* m_text;
  NcHighlighter* m_highlighter;
  QGroupBox* m_cellsGroup = group({.text = QT_TR_NOOP("Cells")});
  CellModel* m_cells;
  QTableView* m_table;
};

}  // namespace rivulet::widgets
