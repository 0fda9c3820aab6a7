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

LogModel::LogModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Time"); },
            [](const LogLine& line) { return line.at.toString(QStringLiteral("hh:mm:ss.zzz")); }},
           {[] { return tr("Severity"); },
            [](const LogLine& line) { return severityText(line.severity); }, false,
            [this](const LogLine& line, int role) {
              return role == Qt::DecorationRole ? QVariant(severityIcon(line.severity, m_palette))
                                                : QVariant();
            }},
           {[] { return tr("Message"); }, [](const LogLine& line) { return line.text; }}},
          parent, kCapacity) {
}

void LogModel::setColors(const QPalette& palette) {
  m_palette = palette;
  refresh();
}

QString LogModel::toText() const {
  QString text;
  for (const LogLine& line : rows()) {
    text += QStringLiteral("%1\t%2\t%3\n")
                .arg(line.at.toString(Qt::ISODateWithMs), severityText(line.severity), line.text);
  }
  return text;
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
  m_model->refresh();
}

void LogView::restyle() {
  const QColor color = themeColors(palette()).text;
  m_copy->setIcon(themedIcon(QStringLiteral("copy"), color));
  m_save->setIcon(themedIcon(QStringLiteral("save"), color));
  m_clear->setIcon(themedIcon(QStringLiteral("clear"), color));
  m_model->setColors(palette());
}

}  // namespace rivulet::widgets
