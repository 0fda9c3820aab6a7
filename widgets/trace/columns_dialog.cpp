// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/columns_dialog.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "widgets/common/error_text.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/page.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/scope/scope_curves.h"

namespace rivulet::widgets {

using trace::SignalGroup;
using trace::SignalRole;

namespace {

constexpr double kRateHz = 1000.0;
constexpr double kRateHzMax = 1e6;
constexpr double kOffsetMaxS = 1e6;
constexpr int kFirstDigits = 6;

QString roleTitle(SignalRole role) {
  const auto axis = [role](SignalRole ofX) {
    return std::string(1, static_cast<char>('X' + static_cast<int>(role) - static_cast<int>(ofX)));
  };
  if (role == SignalRole::Time) {
    return ColumnsDialog::tr("Time");
  }
  if (role <= SignalRole::ZSet) {
    return signalTitle({SignalGroup::SetPoint, axis(SignalRole::XSet), {}, {}});
  }
  if (role <= SignalRole::ZActual) {
    return signalTitle({SignalGroup::Actual, axis(SignalRole::XActual), {}, {}});
  }
  if (role <= SignalRole::ZSpeed) {
    return signalTitle({SignalGroup::Speed, axis(SignalRole::XSpeed), {}, {}});
  }
  switch (role) {
    case SignalRole::PathSpeed:
      return signalTitle({SignalGroup::Speed, {}, "per_min(path_speed)", {}});
    case SignalRole::ProgrammedFeed:
      return signalTitle({SignalGroup::Program, {}, "per_min(programmed_feed)", {}});
    case SignalRole::Line:
      return signalTitle({SignalGroup::Program, {}, "program_line", {}});
    default:
      return signalTitle({SignalGroup::Program, {}, "override", {}});
  }
}

}  // namespace

ColumnsDialog::ColumnsDialog(const QString& file, const trace::TablePreview& table, QWidget* parent)
    : QDialog(parent),
      m_preview(table),
      m_table(new QTableWidget(0, kColumns, this)),
      m_rateName(new QLabel(tr("Samples per second"), this)),
      m_rate(new NumberField(this)),
      m_offset(new NumberField(this)),
      m_note(new StatusLabel(this)),
      m_accept(makeTouchButton(this)) {
  setObjectName(QStringLiteral("columnsDialog"));
  setWindowTitle(tr("Columns of %1").arg(file));
  auto* text = new QLabel(tr("What do the columns mean? The answer is kept for all files with the "
                             "same headings."),
                          this);
  text->setWordWrap(true);
  styleTable(m_table);
  m_table->setObjectName(QStringLiteral("columnsTable"));
  m_table->setAccessibleName(tr("Columns of the file"));
  m_table->setHorizontalHeaderLabels({tr("Column"), tr("Means"), tr("Unit"), tr("First values")});
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  for (const trace::ColumnPreview& column : table.columns) {
    addRow(column);
  }
  m_rate->setObjectName(QStringLiteral("columnsRate"));
  m_rate->setRange(0.001, kRateHzMax);
  m_rate->setDecimals(3);
  m_rate->setSuffix(QChar(0x00A0) + QStringLiteral("Hz"));
  m_rate->setValue(table.mapping.rateHz.value_or(kRateHz));
  m_rate->setAccessibleName(m_rateName->text());
  m_rate->setToolTip(tr("For a table without a column of time"));
  m_offset->setObjectName(QStringLiteral("columnsOffset"));
  m_offset->setRange(-kOffsetMaxS, kOffsetMaxS);
  m_offset->setDecimals(4);
  m_offset->setSuffix(QChar(0x00A0) + QStringLiteral("s"));
  m_offset->setValue(table.mapping.offsetS);
  auto* offsetName = new QLabel(tr("First sample at"), this);
  m_offset->setAccessibleName(offsetName->text());
  m_offset->setToolTip(tr("Place of the first sample on the time axis that several files share"));
  auto* cancel = makeTouchButton(this);
  cancel->setText(tr("Cancel"));
  cancel->setObjectName(QStringLiteral("columnsCancel"));
  m_accept->setText(tr("Apply"));
  m_accept->setObjectName(QStringLiteral("columnsAccept"));
  m_accept->setDefault(true);
  m_note->setObjectName(QStringLiteral("columnsNote"));
  m_note->setWordWrap(true);
  auto* fields = new QGridLayout;
  fields->addWidget(m_rateName, 0, 0);
  fields->addWidget(m_rate, 0, 1);
  fields->addWidget(offsetName, 0, 2);
  fields->addWidget(m_offset, 0, 3);
  fields->setColumnStretch(4, 1);
  for (NumberField* field : {m_rate, m_offset}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  inColumn({text, {m_table, 1}, fields, inRow({{m_note, 1, Qt::AlignVCenter}, cancel, m_accept})},
           this);
  resize(820, 560);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_accept, &QPushButton::clicked, this, &QDialog::accept);
  check();
}

void ColumnsDialog::addRow(const trace::ColumnPreview& column) {
  const int at = m_table->rowCount();
  m_table->insertRow(at);
  m_table->setRowHeight(at, kTouchHeightPx + 2);
  const QString name = QString::fromStdString(column.name);
  m_table->setItem(at, Name, new QTableWidgetItem(name));
  QStringList values;
  for (const double value : column.first) {
    values.append(std::isfinite(value) ? QLocale().toString(value, 'g', kFirstDigits) : noValue());
  }
  m_table->setItem(at, Values, new QTableWidgetItem(values.join(QStringLiteral("   "))));
  Row row{new QComboBox(m_table), new QComboBox(m_table)};
  row.role->setObjectName(QStringLiteral("columnRole%1").arg(at));
  row.role->setAccessibleName(tr("Meaning of %1").arg(name));
  row.role->setToolTip(tr("What this column is; without a meaning it is shown as it is"));
  row.unit->setObjectName(QStringLiteral("columnUnit%1").arg(at));
  row.unit->setAccessibleName(tr("Unit of %1").arg(name));
  row.unit->setToolTip(tr("Unit of the numbers in the file"));
  row.role->addItem(QStringLiteral("–"), -1);
  for (std::size_t role = 0; role < trace::kSignalRoleCount; ++role) {
    row.role->addItem(roleTitle(static_cast<SignalRole>(role)), static_cast<int>(role));
  }
  row.role->setCurrentIndex(column.role ? static_cast<int>(*column.role) + 1 : 0);
  for (QComboBox* list : {row.role, row.unit}) {
    list->setMinimumHeight(kTouchHeightPx);
  }
  m_table->setCellWidget(at, Meaning, row.role);
  m_table->setCellWidget(at, Unit, row.unit);
  m_rows.push_back(row);
  const QString unit = QString::fromStdString(column.unit);
  offerUnits(row, unit);
  connect(row.role, &QComboBox::currentIndexChanged, this, [this, row, unit] {
    offerUnits(row, unit);
    check();
  });
}

/// Those of the role, that of the file among them; without a role, the file's is only shown.
void ColumnsDialog::offerUnits(const Row& row, const QString& wanted) {
  row.unit->clear();
  const int role = row.role->currentData().toInt();
  if (role < 0) {
    row.unit->addItem(wanted);
    row.unit->setEnabled(false);
    return;
  }
  for (const std::string_view unit : trace::unitsOf(static_cast<SignalRole>(role))) {
    row.unit->addItem(QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size())));
  }
  row.unit->setEnabled(row.unit->count() > 0);
  if (trace::unitFactor(wanted.toStdString(), static_cast<SignalRole>(role))) {
    if (row.unit->findText(wanted) < 0) {
      row.unit->addItem(wanted);
    }
    row.unit->setCurrentText(wanted);
  }
}

trace::TableMapping ColumnsDialog::mapping() const {
  trace::TableMapping mapping;
  mapping.isComplete = true;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const int role = m_rows[i].role->currentData().toInt();
    if (role >= 0) {
      mapping.columns.push_back({static_cast<SignalRole>(role),
                                 trace::columnReference(m_preview.columns[i].name, i),
                                 m_rows[i].unit->currentText().toStdString()});
    }
  }
  if (!hasTime()) {
    mapping.rateHz = m_rate->value();
  }
  mapping.offsetS = m_offset->value();
  return mapping;
}

bool ColumnsDialog::hasTime() const {
  return std::any_of(m_rows.begin(), m_rows.end(), [](const Row& row) {
    return row.role->currentData().toInt() == static_cast<int>(SignalRole::Time);
  });
}

QString ColumnsDialog::problem() const {
  // What is written is what is read: the rules are those of the command line.
  const auto parsed = trace::parseTableMapping(trace::printTableMapping(mapping()));
  return parsed ? QString() : errorCodeText(parsed.error().code);
}

void ColumnsDialog::check() {
  const QString wrong = problem();
  const trace::TableMapping chosen = mapping();
  const bool hasPosition =
      std::any_of(chosen.columns.begin(), chosen.columns.end(),
                  [](const trace::ColumnRole& column) { return trace::isPosition(column.role); });
  m_rate->setEnabled(!hasTime());
  m_rateName->setEnabled(!hasTime());
  m_accept->setEnabled(wrong.isEmpty());
  if (!wrong.isEmpty()) {
    m_note->setStatus(Status::Attention, wrong);
  } else if (!hasPosition) {
    m_note->setStatus(Status::Unknown,
                      tr("Without a position the columns are shown, but stops and errors are not "
                         "looked for."));
  } else {
    m_note->setStatus(Status::Good, tr("The trace can be analysed."));
  }
}

}  // namespace rivulet::widgets
