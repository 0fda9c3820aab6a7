// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Findings in NC programs, in the language of the operator.
/// @threadsafety GUI thread.
#pragma once

#include <QString>

#include "gcode/diagnostic.h"

namespace rivulet::widgets {

/// "Note", "Warning", "Error".
[[nodiscard]] QString severityText(gcode::Severity severity);

/// Icon of a severity: each has its own shape.
[[nodiscard]] QString severityIconName(gcode::Severity severity);

/// One sentence: what was found and what Rivulet does about it.
[[nodiscard]] QString diagnosticText(const gcode::Diagnostic& diagnostic);

}  // namespace rivulet::widgets
