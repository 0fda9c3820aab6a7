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
        return tr("Hold: override 0");
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

}  // namespace rivulet::widgets
