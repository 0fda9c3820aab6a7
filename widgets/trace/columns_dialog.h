// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Asks what the columns of a table mean: each with its guess, its unit and its first values; the
/// rate of a table without time; and where its first sample is on the common time axis. The answer
/// is a mapping as the command line takes it. @threadsafety GUI thread.
#pragma once

#include <QDialog>
#include <vector>

#include "trace/import/import.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace rivulet::widgets {

class NumberField;
class StatusLabel;

class ColumnsDialog final : public QDialog {
  Q_OBJECT

 public:
  /// @param file  its name  @param table  with its columns
  ColumnsDialog(const QString& file, const trace::TablePreview& table, QWidget* parent = nullptr);

  /// What was chosen; the columns that were not given a meaning have none.
  [[nodiscard]] trace::TableMapping mapping() const;
  /// Why the choice cannot be taken; empty: it can.
  [[nodiscard]] QString problem() const;

 private:
  enum Column { Name, Meaning, Unit, Values, kColumns };
  struct Row {
    QComboBox* role = nullptr;
    QComboBox* unit = nullptr;
  };

  void addRow(const trace::ColumnPreview& column);
  void offerUnits(const Row& row, const QString& wanted);
  void check();
  [[nodiscard]] bool hasTime() const;

  trace::TablePreview m_preview;
  QTableWidget* m_table;
  std::vector<Row> m_rows;
  QLabel* m_rateName;
  NumberField* m_rate;
  NumberField* m_offset;
  StatusLabel* m_note;
  QPushButton* m_accept;
};

}  // namespace rivulet::widgets
