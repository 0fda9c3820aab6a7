// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/trace_text.h"

#include <QCoreApplication>

namespace rivulet::widgets {

namespace {

struct StopCauseTexts {
  Q_DECLARE_TR_FUNCTIONS(StopCauseTexts)

 public:
  static QString text(trace::StopCause cause) {
    switch (cause) {
      case trace::StopCause::Unknown:
        return tr("Unknown");
      case trace::StopCause::ExactStop:
        return tr("Exact stop");
      case trace::StopCause::Dwell:
        return tr("Dwell (G4)");
      case trace::StopCause::ProgrammedStop:
        return tr("Programmed stop (M0, M1)");
      case trace::StopCause::ToolChange:
        return tr("Tool change or auxiliary function");
      case trace::StopCause::Hold:
        return tr("Pause: override 0");
      case trace::StopCause::WaitingForData:
        return tr("Waiting for data of the client");
      case trace::StopCause::PreprocessorStop:
        return tr("Preprocessor stop");
    }
    return {};
  }
};

}  // namespace

QString stopCauseText(trace::StopCause cause) {
  return StopCauseTexts::text(cause);
}

QString traceRemarkText(const trace::Remark& remark) {
  const QString pattern =
      QCoreApplication::translate("TraceRemarks", trace::remarkPattern(remark.code));
  QString text;
  for (qsizetype at = 0; at < pattern.size(); ++at) {
    const bool isPlace = pattern[at] == QLatin1Char('%') && at + 1 < pattern.size();
    const int index = isPlace ? pattern[at + 1].digitValue() - 1 : -1;
    if (index >= 0 && static_cast<std::size_t>(index) < remark.values.size()) {
      // A value may hold a percent sign of its own, as names of columns do.
      text += QString::fromStdString(remark.values[static_cast<std::size_t>(index)]);
      ++at;
    } else {
      text += pattern[at];
    }
  }
  return text;
}

}  // namespace rivulet::widgets
