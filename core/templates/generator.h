// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Writes the flexible program the control runs. SINUMERIK dialect. @threadsafety pure.
#pragma once

#include <string>

#include "templates/cells.h"

namespace rivulet::templates {

/// NC text, LF line ends, ASCII. For the methods of [P1] the loop is Algorithm I; the signals of
/// method 2 follow Algorithm III. For method window it waits for each window, copies it, checks the
/// copy and moves from the copy; for method credit it does so while the windows before are still
/// under way, without a stop. @return the errors of `planCells`
[[nodiscard]] base::Result<std::string> generateTemplate(const TemplateParameters& parameters);

/// File name on the control, e.g. "RIVULET_SIGNAL_7.MPF": at most 24 characters before the dot.
[[nodiscard]] std::string templateFileName(const TemplateParameters& parameters);

}  // namespace rivulet::templates
