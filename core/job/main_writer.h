// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The main program of a whole job, in the language of the control: the native blocks at their
/// place, and calls of the loop between them. @threadsafety pure.
#pragma once

#include <string>

#include "base/result.h"
#include "job/plan.h"
#include "templates/job_loop.h"

namespace rivulet::job {

/// @param number  of the job, see `JobName`
/// @return NotTranslated: the control has no words for a block
[[nodiscard]] base::Result<std::string> mainProgramOf(const Plan& plan,
                                                      const templates::JobLoop& loop, int number);

}  // namespace rivulet::job
