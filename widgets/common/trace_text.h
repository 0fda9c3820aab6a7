// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The words for what a trace shows, in the language of the reader: the same in the window and on
/// paper. @threadsafety GUI thread.
#pragma once

#include <QString>

#include "trace/analysis/standstills.h"
#include "trace/remark.h"

namespace rivulet::widgets {

/// "Exact stop", "Waiting for data" and so on.
[[nodiscard]] QString stopCauseText(trace::StopCause cause);

/// One sentence.
[[nodiscard]] QString traceRemarkText(const trace::Remark& remark);

}  // namespace rivulet::widgets
