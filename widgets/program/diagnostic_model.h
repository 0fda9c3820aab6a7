// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The findings of a program as a table: severity, line, column, sentence.
/// @threadsafety GUI thread.
#pragma once

#include <QPalette>

#include "gcode/diagnostic.h"
#include "widgets/common/table_model.h"

namespace rivulet::widgets {

class DiagnosticModel final : public TableModel<gcode::Diagnostic> {
  Q_OBJECT

 public:
  /// Of a cell, for sorting.
  static constexpr int kSortRole = Qt::UserRole;

  enum Column { SeverityColumn, Line, ColumnInLine, Text };

  explicit DiagnosticModel(QObject* parent = nullptr);

  /// Icons are drawn in the colours of this palette.
  void setColors(const QPalette& palette);

 private:
  QPalette m_palette;
};

}  // namespace rivulet::widgets
