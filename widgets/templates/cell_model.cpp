// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/templates/cell_model.h"

#include <QStringList>

namespace rivulet::widgets {

namespace {

/// Rows in front of the points: of the methods of [P1], and of method window.
enum FixedRow { Signal, Run, Stop, Feed, LayoutNumber, FixedRowCount };
enum WindowRow {
  WindowRun,
  Delivered,
  Latched,
  Executed,
  WindowLayout,
  State,
  ClientNumber,
  Owner,
  Heartbeat,
  WindowRowCount
};
/// Rows in front of the points of each window.
enum OwnRow { Count, WindowFeed, Check, OwnRowCount };

QString cellName(int number) {
  return QStringLiteral("R%1").arg(number);
}

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
  if (parent.isValid() || !m_cells) {
    return 0;
  }
  return m_cells->windows > 0
             ? WindowRowCount + m_cells->windows * (OwnRowCount + m_cells->pointsPerLoop) +
                   (m_cells->corrects() ? 1 : 0)
             : FixedRowCount + m_cells->pointsPerLoop;
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

QString CellModel::pointText(int slot, const QString& role, int column) const {
  if (column == Role) {
    QStringList axes;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (m_cells->axes[axis]) {
        axes.append(QString(QLatin1Char(base::kAxisNames[axis])));
      }
    }
    for (const char name : base::rotaryNames(m_cells->rotaryAxes)) {
      axes.append(QString(QLatin1Char(name)));
    }
    return role.arg(axes.join(QLatin1Char(' ')));
  }
  if (column == Parameters) {
    QStringList cells;
    for (const int number : m_cells->slotCells(slot)) {
      cells.append(cellName(number));
    }
    return cells.join(QLatin1Char(' '));
  }
  return tr("Client");
}

QString CellModel::correctionText(int column) const {
  QStringList axes;
  QStringList numbers;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (m_cells->correction[axis] >= 0) {
      axes.append(QString(QLatin1Char(base::kAxisNames[axis])));
      numbers.append(cellName(m_cells->correction[axis]));
    }
  }
  const QLatin1Char blank(' ');
  return column == Role         ? tr("Online correction: %1").arg(axes.join(blank))
         : column == Parameters ? numbers.join(blank)
                                : tr("Client");
}

QString CellModel::windowText(int row, int column) const {
  const templates::CellMap& cells = *m_cells;
  const auto pick = [column](const QString& role, int number, const QString& writer) {
    return column == Role ? role : (column == Parameters ? cellName(number) : writer);
  };
  const QString client = tr("Client");
  const QString nc = tr("NC");
  if (row >= WindowRowCount) {
    const int perWindow = OwnRowCount + cells.pointsPerLoop;
    const int window = (row - WindowRowCount) / perWindow;
    const int own = (row - WindowRowCount) % perWindow;
    if (window >= cells.windows) {
      return correctionText(column);
    }
    const QString number = QString::number(window + 1);
    switch (own) {
      case Count:
        return pick(tr("Window %1: points").arg(number), cells.windowCount(window), client);
      case WindowFeed:
        return pick(tr("Window %1: feed (mm/min)").arg(number), cells.windowFeed(window), client);
      case Check:
        return pick(tr("Window %1: check number").arg(number), cells.windowCheck(window), client);
      default: {
        const int place = own - OwnRowCount;
        return pointText(window * cells.pointsPerLoop + place,
                         tr("Window %1 point %2: %3").arg(number, QString::number(place + 1)),
                         column);
      }
    }
  }
  switch (row) {
    case WindowRun:
      return pick(tr("Run"), cells.run, client);
    case Delivered:
      return pick(tr("Windows delivered"), cells.delivered, client);
    case Latched:
      return pick(tr("Windows taken"), cells.latched, nc);
    case Executed:
      return pick(tr("Windows executed"), cells.executed, nc);
    case WindowLayout:
      return pick(tr("Layout number"), cells.layout, nc);
    case State:
      return pick(tr("State"), cells.state, nc);
    case ClientNumber:
      return pick(tr("Number of the run"), cells.client, client);
    case Owner:
      return pick(tr("Run obeyed"), cells.owner, nc);
    case Heartbeat:
      return pick(tr("Heartbeat"), cells.heartbeat, client);
    default:
      return {};
  }
}

QString CellModel::text(int row, int column) const {
  if (m_cells->windows > 0) {
    return windowText(row, column);
  }
  const auto cell = cellName;
  if (row >= FixedRowCount) {
    const int slot = row - FixedRowCount;
    return pointText(slot, tr("Point %1: %2").arg(slot + 1), column);
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
