// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a line about a run says, in the operator's language. @threadsafety GUI thread.
#pragma once

#include <QDateTime>
#include <QString>

#include "streaming/run/run.h"
#include "streaming/run/run_summary.h"

namespace rivulet::widgets {

/// "Completed", "Stopped, not judged", …: how a run ended, and whether its motion was right.
[[nodiscard]] QString resultText(streaming::Outcome outcome, streaming::RunFinding finding);
[[nodiscard]] QString methodText(base::MethodKind method);
/// When the run began, as the computer's clock shows it; not valid if it is not known.
[[nodiscard]] QDateTime startOf(const streaming::RunSummary& run);
/// "2026-11-22 06:00:12".
[[nodiscard]] QString startText(const streaming::RunSummary& run);
/// Address of the control without what all have in common.
[[nodiscard]] QString machineText(const streaming::RunSummary& run);
/// The feed of the run, or "program, 80 %".
[[nodiscard]] QString feedsText(const streaming::RunSummary& run);
[[nodiscard]] QString feedsText(const streaming::RunSettings& settings);
/// What the time of a whole job was spent on, in one sentence.
[[nodiscard]] QString jobTimesText(const streaming::JobTimes& times);
/// "T5 MILL: 1:01 in the spindle, 0:04 change, 0:58 at 3000 1/min, G54".
[[nodiscard]] QString toolUseText(const trace::ToolUse& use);
/// "T5 MILL"; for what was there before the first change, a sentence.
[[nodiscard]] QString toolText(const trace::ToolUse& use);
/// "3000", "500 – 3000"; empty if it did not turn.
[[nodiscard]] QString perMinText(const trace::ToolUse& use);
/// "anna on cell-pc-3".
[[nodiscard]] QString originText(const streaming::RunOrigin& origin);

}  // namespace rivulet::widgets
