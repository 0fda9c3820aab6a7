// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/diagnostic_model.h"

#include "widgets/common/diagnostic_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/table_style.h"

namespace rivulet::widgets {

DiagnosticModel::DiagnosticModel(QObject* parent) : QAbstractTableModel(parent) {
}

void DiagnosticModel::setProgram(std::shared_ptr<const gcode::Program> program) {
  beginResetModel();
  m_program = std::move(program);
  endResetModel();
}

void DiagnosticModel::setColors(const QPalette& palette) {
  m_palette = palette;
  retranslate();
}

void DiagnosticModel::retranslate() {
  if (rowCount() > 0) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

int DiagnosticModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !m_program ? 0 : static_cast<int>(m_program->diagnostics.size());
}

int DiagnosticModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant DiagnosticModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const gcode::Diagnostic& diagnostic =
      m_program->diagnostics[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      switch (index.column()) {
        case SeverityColumn:
          return severityText(diagnostic.severity);
        case Line:
          return countText(diagnostic.line.value);
        case ColumnInLine:
          return QString::number(diagnostic.column);
        case Text:
          return diagnosticText(diagnostic);
        default:
          return {};
      }
    case Qt::DecorationRole:
      return index.column() == SeverityColumn
                 ? QVariant(severityIcon(diagnostic.severity, m_palette))
                 : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() == Line || index.column() == ColumnInLine
                 ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                 : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant DiagnosticModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return section == Line || section == ColumnInLine ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                                      : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case SeverityColumn:
      return tr("Severity");
    case Line:
      return tr("Line");
    case ColumnInLine:
      return tr("Column");
    case Text:
      return tr("Finding");
    default:
      return {};
  }
}

}  // namespace rivulet::widgets
