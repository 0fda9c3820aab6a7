// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How the flexible program is brought to a control by a person, on one page of paper: the steps,
/// the rights, what is seen meanwhile, and how all of it is taken back. @threadsafety GUI thread.
#pragma once

#include "templates/flexible_program.h"
#include "widgets/paper/page.h"

namespace rivulet::widgets {

/// @param cells  what each R-parameter means, as the page Template shows it
[[nodiscard]] paper::Page templatePage(const templates::FlexibleProgram& program,
                                       const paper::Table& cells, const QString& appVersion);

}  // namespace rivulet::widgets
