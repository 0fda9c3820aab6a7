// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/diagnostic_text.h"

#include <QCoreApplication>

namespace rivulet::widgets {

namespace {

struct DiagnosticTexts {
  Q_DECLARE_TR_FUNCTIONS(DiagnosticTexts)

 public:
  static QString severity(gcode::Severity severity) {
    switch (severity) {
      case gcode::Severity::Note:
        return tr("Note");
      case gcode::Severity::Warning:
        return tr("Warning");
      case gcode::Severity::Error:
        return tr("Error");
    }
    return {};
  }
};

}  // namespace

QString severityText(gcode::Severity severity) {
  return DiagnosticTexts::severity(severity);
}

QString severityIconName(gcode::Severity severity) {
  switch (severity) {
    case gcode::Severity::Note:
      return QStringLiteral("status-note");
    case gcode::Severity::Warning:
      return QStringLiteral("status-attention");
    case gcode::Severity::Error:
      return QStringLiteral("status-fault");
  }
  return {};
}

QString diagnosticText(const gcode::Diagnostic& diagnostic) {
  const auto filled = [](QString pattern, const QString& parameter) {
    return pattern.replace(QStringLiteral("%1"), parameter);
  };
  QString parameter = QString::fromStdString(diagnostic.argument);
  if (diagnostic.cause) {
    parameter = filled(
        QCoreApplication::translate("FaultTexts", nc::clausePattern(*diagnostic.cause)), parameter);
  }
  return filled(QCoreApplication::translate("DiagnosticTexts", gcode::sentencePattern(diagnostic)),
                parameter);
}

}  // namespace rivulet::widgets
