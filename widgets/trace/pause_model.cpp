// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/pause_model.h"

#include "widgets/common/number_format.h"
#include "widgets/plots/pause_bands.h"

namespace rivulet::widgets {

PauseModel::PauseModel(QObject* parent) : QAbstractTableModel(parent) {
}

void PauseModel::setPauses(std::vector<trace::Pause> pauses) {
  beginResetModel();
  m_pauses = std::move(pauses);
  endResetModel();
}

void PauseModel::append(const trace::Pause& pause) {
  const int row = static_cast<int>(m_pauses.size());
  beginInsertRows({}, row, row);
  m_pauses.push_back(pause);
  endInsertRows();
}

void PauseModel::retranslate() {
  if (!m_pauses.empty()) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

int PauseModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_pauses.size());
}

int PauseModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant PauseModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const trace::Pause& pause = m_pauses[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole) {
    return index.column() == Origin ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                    : QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (index.column()) {
    case Start:
      return secondsText(base::toSeconds(pause.start), 3);
    case Duration:
      return millisecondsText(pause.duration, 0);
    case Origin:
      return QStringLiteral("%1 (%2)").arg(pauseOriginLetter(pause.origin),
                                           pauseOriginText(pause.origin));
    default:
      return {};
  }
}

QVariant PauseModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return section == Origin ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                             : QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Start:
      return tr("Start");
    case Duration:
      return tr("Duration");
    case Origin:
      return tr("Origin");
    default:
      return {};
  }
}

}  // namespace rivulet::widgets
