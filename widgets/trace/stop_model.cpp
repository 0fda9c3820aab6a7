// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/stop_model.h"

#include "widgets/common/note_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/trace_text.h"

namespace rivulet::widgets {

namespace {

QString causeText(const StopRow& stop) {
  return stop.cause ? stopCauseText(*stop.cause)
                    : QStringLiteral("%1 (%2)").arg(pauseOriginLetter(stop.origin),
                                                    pauseOriginText(stop.origin));
}

}  // namespace

StopModel::StopModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Start"); },
            [](const StopRow& stop) { return secondsText(base::toSeconds(stop.start), 3); }, true},
           {[] { return tr("Duration"); },
            [](const StopRow& stop) { return millisecondsText(stop.duration, 0); }, true},
           {[] { return tr("Line"); },
            [](const StopRow& stop) {
              return stop.line == 0 ? QString() : QString::number(stop.line);
            },
            true},
           {[] { return tr("Cause"); }, &causeText, false,
            [](const StopRow& stop, int role) {
              return role == Qt::ToolTipRole && !stop.evidence.empty()
                         ? QVariant(noteText(QString::fromStdString(stop.evidence)))
                         : QVariant();
            }}},
          parent) {
}

}  // namespace rivulet::widgets
