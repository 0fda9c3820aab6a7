// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which R-parameter means what, as a table: role, R-parameters, who writes them.
/// @threadsafety GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <optional>

#include "templates/cells.h"

namespace rivulet::widgets {

class CellModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Role, Parameters, Writer, ColumnCount };

  explicit CellModel(QObject* parent = nullptr);

  void setCells(const std::optional<templates::CellMap>& cells);
  void retranslate();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  [[nodiscard]] QString text(int row, int column) const;
  [[nodiscard]] QString windowText(int row, int column) const;
  [[nodiscard]] QString correctionText(int column) const;
  /// @param role  with one place left for the names of the axes
  [[nodiscard]] QString pointText(int slot, const QString& role, int column) const;

  std::optional<templates::CellMap> m_cells;
};

}  // namespace rivulet::widgets
