// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/templates/cell_model.h"

#include <QStringList>

namespace rivulet::widgets {

namespace {

enum FixedRow { Signal, Run, Stop, Feed, LayoutNumber, FixedRowCount };

}  // namespace

CellModel::CellModel(QObject* parent) : QAbstractTableModel(parent) {
}

void CellModel::setCells(const std::optional<templates::CellMap>& cells) {
  beginResetModel();
  m_cells = cells;
  endResetModel();
}

void CellModel::retranslate() {
  if (rowCount() > 0) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

int CellModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !m_cells ? 0 : FixedRowCount + m_cells->pointsPerLoop;
}

int CellModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant CellModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
    return {};
  }
  return text(index.row(), index.column());
}

QVariant CellModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Role:
      return tr("Role");
    case Parameters:
      return tr("R-parameters");
    case Writer:
      return tr("Writer");
    default:
      return {};
  }
}

QString CellModel::text(int row, int column) const {
  const auto cell = [](int number) { return QStringLiteral("R%1").arg(number); };
  if (row >= FixedRowCount) {
    const int slot = row - FixedRowCount;
    if (column == Role) {
      QStringList axes;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (m_cells->axes[axis]) {
          axes.append(QString(QLatin1Char(base::kAxisNames[axis])));
        }
      }
      return tr("Point %1: %2").arg(QString::number(slot + 1), axes.join(QLatin1Char(' ')));
    }
    if (column == Parameters) {
      QStringList cells;
      for (const int number : m_cells->slotCells(slot)) {
        cells.append(cell(number));
      }
      return cells.join(QLatin1Char(' '));
    }
    return tr("Client");
  }
  const QString client = tr("Client");
  const QString both = tr("Client, NC");
  const QString nc = tr("NC");
  switch (row) {
    case Signal:
      return column == Role ? tr("Signal") : (column == Parameters ? cell(m_cells->signal) : both);
    case Run:
      return column == Role ? tr("Run") : (column == Parameters ? cell(m_cells->run) : client);
    case Stop:
      return column == Role ? tr("Stop") : (column == Parameters ? cell(m_cells->stop) : client);
    case Feed:
      return column == Role ? tr("Feed (mm/min)")
                            : (column == Parameters ? cell(m_cells->feed) : client);
    case LayoutNumber:
      return column == Role ? tr("Layout number")
                            : (column == Parameters ? cell(m_cells->layout) : nc);
    default:
      return {};
  }
}

}  // namespace rivulet::widgets
