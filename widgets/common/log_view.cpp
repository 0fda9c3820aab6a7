// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/log_view.h"

#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>

#include "widgets/common/diagnostic_text.h"
#include "widgets/common/icons.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

LogModel::LogModel(QObject* parent) : QAbstractTableModel(parent) {
}

void LogModel::append(const LogLine& line) {
  if (m_lines.size() == kCapacity) {
    beginRemoveRows({}, 0, 0);
    m_lines.pop_front();
    endRemoveRows();
  }
  const int row = static_cast<int>(m_lines.size());
  beginInsertRows({}, row, row);
  m_lines.push_back(line);
  endInsertRows();
}

void LogModel::clear() {
  beginResetModel();
  m_lines.clear();
  endResetModel();
}

void LogModel::setColors(const QPalette& palette) {
  m_palette = palette;
  retranslate();
}

void LogModel::retranslate() {
  if (!m_lines.empty()) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

QString LogModel::toText() const {
  QString text;
  for (const LogLine& line : m_lines) {
    text += QStringLiteral("%1\t%2\t%3\n")
                .arg(line.at.toString(Qt::ISODateWithMs), severityText(line.severity), line.text);
  }
  return text;
}

int LogModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int LogModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant LogModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const LogLine& line = m_lines[static_cast<std::size_t>(index.row())];
  if (role == Qt::DisplayRole || role == Qt::ToolTipRole) {
    switch (index.column()) {
      case Time:
        return line.at.toString(QStringLiteral("hh:mm:ss.zzz"));
      case SeverityColumn:
        return severityText(line.severity);
      case Text:
        return line.text;
      default:
        return {};
    }
  }
  if (role == Qt::DecorationRole && index.column() == SeverityColumn) {
    return severityIcon(line.severity, m_palette);
  }
  return {};
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const {
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
    case Time:
      return tr("Time");
    case SeverityColumn:
      return tr("Severity");
    case Text:
      return tr("Message");
    default:
      return {};
  }
}

LogView::LogView(QWidget* parent)
    : Page(parent),
      m_model(new LogModel(this)),
      m_table(new QTableView(this)),
      m_copy(makeTouchButton(this)),
      m_save(makeTouchButton(this)),
      m_clear(makeTouchButton(this)) {
  m_table->setModel(m_model);
  styleTable(m_table);
  m_table->setColumnWidth(LogModel::Time, 120);
  m_table->setColumnWidth(LogModel::SeverityColumn, 120);
  m_table->horizontalHeader()->setStretchLastSection(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_copy);
  buttons->addWidget(m_save);
  buttons->addStretch();
  buttons->addWidget(m_clear);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_table, 1);
  layout->addLayout(buttons);
  connect(m_copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(toText()); });
  connect(m_clear, &QPushButton::clicked, this, &LogView::clear);
  connect(m_save, &QPushButton::clicked, this, [this] {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the log"), QStringLiteral("rivulet.log"));
    if (!path.isEmpty()) {
      Q_EMIT saveRequested(path);
    }
  });
  retranslate();
  restyle();
}

void LogView::append(const LogLine& line) {
  // Follow the end only while the operator looks at it.
  const QScrollBar* bar = m_table->verticalScrollBar();
  const bool atEnd = bar->value() >= bar->maximum();
  m_model->append(line);
  if (atEnd) {
    m_table->scrollToBottom();
  }
}

void LogView::clear() {
  m_model->clear();
}

void LogView::retranslate() {
  m_copy->setText(tr("Copy"));
  m_save->setText(tr("Save…"));
  m_clear->setText(tr("Clear"));
  m_model->retranslate();
}

void LogView::restyle() {
  const QColor color = themeColors(palette()).text;
  m_copy->setIcon(themedIcon(QStringLiteral("copy"), color));
  m_save->setIcon(themedIcon(QStringLiteral("save"), color));
  m_clear->setIcon(themedIcon(QStringLiteral("clear"), color));
  m_model->setColors(palette());
}

}  // namespace rivulet::widgets
