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
#include "widgets/paper/page.h"

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
  /// To print. There is a template.
  [[nodiscard]] paper::Page sheet(const QString& appVersion) const;

 Q_SIGNALS:
  void saveRequested(const QString& path);
  /// The page for a person who brings the program to the control: PDF, or HTML by its ending.
  void sheetRequested(const QString& path);

 private:
  void showState();

  std::optional<templates::FlexibleProgram> m_program;
  QString m_fileName;
  QString m_problem;
  int m_layoutNumber = 0;

  StatusLabel* m_state = status({.wraps = true});
  QPushButton* m_copy = button({.text = QT_TR_NOOP("Copy"), .icon = "copy"});
  QPushButton* m_save = button({.text = QT_TR_NOOP("Save…"), .icon = "save"});
  QPushButton* m_sheet =
      button({.text = QT_TR_NOOP("Steps to print…"),
              .tip = QT_TR_NOOP("A page with the steps at the control, the rights, what the "
                                "operator sees, and how it is taken back"),
              .icon = "save",
              .id = "template-sheet"});
  QPlainTextEdit* m_text;
  NcHighlighter* m_highlighter;
  QGroupBox* m_cellsGroup = group({.text = QT_TR_NOOP("R-parameters")});
  CellModel* m_cells;
  QTableView* m_table;
};

}  // namespace rivulet::widgets
