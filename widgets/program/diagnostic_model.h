// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The findings of a program as a table: severity, line, column, sentence.
/// @threadsafety GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <memory>

#include "gcode/program.h"

namespace rivulet::widgets {

class DiagnosticModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { SeverityColumn, Line, ColumnInLine, Text, ColumnCount };

  explicit DiagnosticModel(QObject* parent = nullptr);

  /// @param program  may be null
  void setProgram(std::shared_ptr<const gcode::Program> program);
  void setColors(const QPalette& palette);
  void retranslate();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  std::shared_ptr<const gcode::Program> m_program;
  QPalette m_palette;
};

}  // namespace rivulet::widgets
