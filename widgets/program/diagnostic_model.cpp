// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/diagnostic_model.h"

#include "widgets/common/diagnostic_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/table_style.h"

namespace rivulet::widgets {

using gcode::Diagnostic;

DiagnosticModel::DiagnosticModel(QObject* parent)
    : TableModel({{[] { return tr("Severity"); },
                   [](const Diagnostic& finding) { return severityText(finding.severity); }, false,
                   [this](const Diagnostic& finding, int role) {
                     return role == kSortRole ? QVariant(static_cast<int>(finding.severity))
                            : role == Qt::DecorationRole
                                ? QVariant(severityIcon(finding.severity, m_palette))
                                : QVariant();
                   }},
                  {[] { return tr("Line"); },
                   [](const Diagnostic& finding) {
                     const QString line = countText(finding.line.value);
                     return finding.file.empty()
                                ? line
                                : QString::fromStdString(finding.file) + QLatin1Char(':') + line;
                   },
                   true,
                   [](const Diagnostic& finding, int role) {
                     // The program itself before the files it calls.
                     return role == kSortRole
                                ? QVariant(QString::fromStdString(finding.file) +
                                           QStringLiteral("%1").arg(finding.line.value, 10, 10,
                                                                    QLatin1Char('0')))
                                : QVariant();
                   }},
                  {[] { return tr("Column"); },
                   [](const Diagnostic& finding) { return QString::number(finding.column); }, true},
                  {[] { return tr("Finding"); }, diagnosticText, false,
                   [](const Diagnostic& finding, int role) {
                     return role == kSortRole ? QVariant(diagnosticText(finding)) : QVariant();
                   }}},
                 parent) {
}

void DiagnosticModel::setColors(const QPalette& palette) {
  m_palette = palette;
  refresh();
}

}  // namespace rivulet::widgets
