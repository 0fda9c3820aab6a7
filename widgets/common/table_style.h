// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How every table looks: calm, whole rows, no numbers of rows, high enough for a finger.
/// @threadsafety GUI thread.
#pragma once

#include <QIcon>
#include <QPalette>

#include "gcode/diagnostic.h"

class QTableView;

namespace rivulet::widgets {

void styleTable(QTableView* table);

/// Icon of a severity in the colours of a palette.
[[nodiscard]] QIcon severityIcon(gcode::Severity severity, const QPalette& palette);

}  // namespace rivulet::widgets
