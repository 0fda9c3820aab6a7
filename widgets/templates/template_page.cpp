// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/templates/template_page.h"

#include <QClipboard>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGroupBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>

#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/templates/cell_model.h"
#include "widgets/templates/nc_highlighter.h"
#include "widgets/templates/template_sheet.h"

namespace rivulet::widgets {

TemplatePage::TemplatePage(QWidget* parent)
    : Page(parent),
      m_text(say(new QPlainTextEdit(this), {.name = QT_TR_NOOP("Flexible program")})),
      m_highlighter(new NcHighlighter(m_text->document())),
      m_cells(new CellModel(this)),
      m_table(say(new QTableView(this), {.name = QT_TR_NOOP("R-parameters")})) {
  m_text->setReadOnly(true);
  m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setPointSizeF(10.0);
  m_text->setFont(fixed);
  m_table->setModel(m_cells);
  styleTable(m_table);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setStretchLastSection(true);

  auto* cells = new QVBoxLayout(m_cellsGroup);
  cells->addWidget(m_table);
  m_cellsGroup->setMinimumWidth(400);
  inColumn({inRow({{m_state, 1, Qt::AlignVCenter}, m_copy, m_save, m_sheet}),
            {inRow({{m_text, 3}, {m_cellsGroup, 2}}), 1}},
           this);

  connect(m_copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(text()); });
  connect(m_save, &QPushButton::clicked, this, [this] {
    askWhereToSave(this, {tr("Save the template"), m_fileName, tr("NC programs (*.MPF *.mpf)")},
                   [this](const QString& path, auto) { Q_EMIT saveRequested(path); });
  });
  connect(m_sheet, &QPushButton::clicked, this, [this] {
    askWhereToSave(
        this,
        {tr("Save the steps"), QFileInfo(m_fileName).completeBaseName() + QStringLiteral(".pdf"),
         QStringLiteral("*.pdf;;*.html")},
        [this](const QString& path, auto) { Q_EMIT sheetRequested(path); });
  });
  onLanguage([this] { m_cells->refresh(); }, &TemplatePage::showState);
  onTheme([this] { m_highlighter->setColors(palette()); });
}

void TemplatePage::setTemplate(const templates::FlexibleProgram& program) {
  m_program = program;
  m_fileName = QString::fromStdString(program.name);
  m_layoutNumber = program.layoutNumber;
  m_problem.clear();
  if (const QString text = QString::fromStdString(program.text); m_text->toPlainText() != text) {
    m_text->setPlainText(text);
  }
  m_cells->setCells(program.cells);
  showState();
}

void TemplatePage::setProblem(const QString& problem) {
  m_program.reset();
  m_fileName.clear();
  m_problem = problem;
  m_text->clear();
  m_cells->setCells(std::nullopt);
  showState();
}

QString TemplatePage::text() const {
  return m_text->toPlainText();
}

paper::Page TemplatePage::sheet(const QString& appVersion) const {
  paper::Table table{tr("R-parameters"), {}, {5.0, 6.0, 2.0}, {}};
  const auto row = [this](const auto& textOf) {
    QStringList texts;
    for (int column = 0; column < m_cells->columnCount(); ++column) {
      texts.append(textOf(column));
    }
    return texts;
  };
  table.headings = row([this](int column) {
    return m_cells->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
  });
  for (int i = 0; i < m_cells->rowCount(); ++i) {
    table.rows.append(row([this, i](int column) {
      return m_cells->index(i, column).data(Qt::DisplayRole).toString();
    }));
  }
  return templatePage(*m_program, table, appVersion);
}

void TemplatePage::showState() {
  const bool there = !m_fileName.isEmpty();
  m_copy->setEnabled(there);
  m_save->setEnabled(there);
  m_sheet->setEnabled(there);
  if (!m_problem.isEmpty()) {
    m_state->setStatus(Status::Attention, tr("No template: %1").arg(m_problem));
  } else if (!there) {
    m_state->setStatus(Status::Unknown, tr("No template yet"));
  } else {
    m_state->setStatus(Status::Good,
                       tr("%1, layout number %2").arg(m_fileName, QString::number(m_layoutNumber)));
  }
}

}  // namespace rivulet::widgets
