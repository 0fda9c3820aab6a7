// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/job_text.h"

#include <QCoreApplication>

#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

struct JobTexts {
  Q_DECLARE_TR_FUNCTIONS(JobTexts)

 public:
  static QString reason(job::NativeReason reason) {
    using job::NativeReason;
    switch (reason) {
      case NativeReason::Transformation:
        return tr("swivels or transforms the coordinates");
      case NativeReason::RadiusCompensation:
        return tr("tool radius compensation");
      case NativeReason::Cycle:
        return tr("cycle of the control");
      case NativeReason::Subprogram:
        return tr("subprogram that is not at hand");
      case NativeReason::Probing:
        return tr("measures, or reads the machine");
      case NativeReason::Retract:
        return tr("moves in machine coordinates");
      case NativeReason::OtherMotion:
        return tr("path made by the control");
      case NativeReason::Corner:
        return tr("rounded or chamfered corner");
      case NativeReason::UnknownPosition:
        return tr("counts from a position that only the control knows");
      case NativeReason::Tool:
        return tr("tool or tool length");
      case NativeReason::WorkOffset:
        return tr("work offset");
      case NativeReason::Spindle:
        return tr("spindle");
      case NativeReason::Coolant:
        return tr("coolant");
      case NativeReason::Stop:
        return tr("stops until cycle start");
      case NativeReason::Dwell:
        return tr("dwell");
      case NativeReason::Message:
        return tr("message at the control");
      case NativeReason::Mode:
        return tr("how the control moves");
      case NativeReason::Other:
        return tr("function of the machine");
      case NativeReason::End:
        return tr("end of the program");
    }
    return {};
  }
  static QString native(const job::NativeBlock& block) {
    const QString text = tr("The control executes this block: %1.").arg(reason(block.reason));
    return job::rowOf(block.reason).after == job::PositionAfter::ControlOnly
               ? text + QLatin1Char(' ') + tr("Afterwards the position is read from the control.")
               : text;
  }
  static QString stretch(const job::Stretch& stretch, std::size_t stretches) {
    return tr("Part %1 of %2: lines %3 to %4 are streamed, %Ln points.", nullptr,
              static_cast<int>(stretch.pointCount))
        .arg(countText(static_cast<std::size_t>(stretch.number)), countText(stretches),
             countText(stretch.blocks.front().line.value),
             countText(stretch.blocks.back().line.value));
  }
};

}  // namespace

QString nativeReasonText(job::NativeReason reason) {
  return JobTexts::reason(reason);
}

QString nativeBlockText(const job::NativeBlock& block) {
  return JobTexts::native(block);
}

QString stretchText(const job::Stretch& stretch, std::size_t stretches) {
  return JobTexts::stretch(stretch, stretches);
}

}  // namespace rivulet::widgets
