// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/pause_model.h"

#include "widgets/common/number_format.h"
#include "widgets/plots/pause_bands.h"

namespace rivulet::widgets {

using trace::Pause;

PauseModel::PauseModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Start"); },
            [](const Pause& pause) { return secondsText(base::toSeconds(pause.start), 3); }, true},
           {[] { return tr("Duration"); },
            [](const Pause& pause) { return millisecondsText(pause.duration, 0); }, true},
           {[] { return tr("Origin"); },
            [](const Pause& pause) {
              return QStringLiteral("%1 (%2)").arg(pauseOriginLetter(pause.origin),
                                                   pauseOriginText(pause.origin));
            }}},
          parent) {
}

}  // namespace rivulet::widgets
