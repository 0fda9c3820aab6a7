// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The one table model: rows are values, and a column is a value that says how to show a row.
/// @threadsafety GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace rivulet::widgets {

template <class Row>
struct TableColumn {
  using Title = std::function<QString()>;
  using Text = std::function<QString(const Row&)>;
  using Extra = std::function<QVariant(const Row&, int)>;

  TableColumn(Title columnTitle, Text rowText, bool alignRight = false, Extra rowExtra = nullptr)
      : title(std::move(columnTitle)),
        text(std::move(rowText)),
        isNumber(alignRight),
        extra(std::move(rowExtra)) {}

  Title title;    ///< in the present language
  Text text;      ///< in the present language
  bool isNumber;  ///< aligned to the right, without a tool tip
  Extra extra;    ///< of a role: icon, font, tool tip; an invalid value means the default
};

template <class Row>
class TableModel : public QAbstractTableModel {
 public:
  static constexpr std::size_t kUnbounded = std::numeric_limits<int>::max();

  /// @param capacity  most rows that are kept; `append` drops the oldest beyond it
  explicit TableModel(std::vector<TableColumn<Row>> columns, QObject* parent = nullptr,
                      std::size_t capacity = kUnbounded)
      : QAbstractTableModel(parent), m_columns(std::move(columns)), m_capacity(capacity) {}

  template <class Rows>
  void setRows(const Rows& rows) {
    beginResetModel();
    m_rows.assign(rows.begin(), rows.end());
    endResetModel();
  }
  void clear() { setRows(std::vector<Row>()); }

  void append(Row row) {
    if (m_rows.size() == m_capacity) {
      beginRemoveRows({}, 0, 0);
      m_rows.erase(m_rows.begin());
      endRemoveRows();
    }
    const int at = rowCount();
    beginInsertRows({}, at, at);
    m_rows.push_back(std::move(row));
    endInsertRows();
  }

  [[nodiscard]] const std::vector<Row>& rows() const { return m_rows; }
  [[nodiscard]] const Row& row(int index) const { return m_rows[static_cast<std::size_t>(index)]; }

  /// Shows every cell and title again: the language, the palette or a setting has changed.
  void refresh() {
    if (!m_rows.empty()) {
      Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const final {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
  }
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const final {
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
  }

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const final {
    if (!index.isValid()) {
      return {};
    }
    const TableColumn<Row>& column = m_columns[static_cast<std::size_t>(index.column())];
    if (column.extra) {
      if (QVariant value = column.extra(row(index.row()), role); value.isValid()) {
        return value;
      }
    }
    if (role == Qt::DisplayRole || (role == Qt::ToolTipRole && !column.isNumber)) {
      return column.text(row(index.row()));
    }
    return role == Qt::TextAlignmentRole ? alignment(column) : QVariant();
  }

  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const final {
    if (orientation != Qt::Horizontal) {
      return {};
    }
    const TableColumn<Row>& column = m_columns[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) {
      return column.title();
    }
    return role == Qt::TextAlignmentRole ? alignment(column) : QVariant();
  }

 private:
  static QVariant alignment(const TableColumn<Row>& column) {
    return QVariant((column.isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }

  std::vector<TableColumn<Row>> m_columns;
  std::vector<Row> m_rows;
  std::size_t m_capacity;
};

}  // namespace rivulet::widgets
