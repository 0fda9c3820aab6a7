// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the control's own trace of a whole job says of its stretches. The main program never moves
/// in a line in which the loop moves, so the line of a block tells who moved. @threadsafety pure.
#pragma once

#include <vector>

#include "gcode/trajectory.h"
#include "templates/job_loop.h"
#include "trace/analysis/integrity.h"
#include "trace/control_trace.h"
#include "trace/pause.h"

namespace rivulet::streaming {

/// The trace with the streamed blocks alone: what the control did between them is in its samples
/// and events.
[[nodiscard]] trace::ControlTrace streamedTrace(const trace::ControlTrace& trace,
                                                const templates::JobLoop& loop);

/// Standstills within stretches, not those of native blocks and of the change between the two.
[[nodiscard]] std::vector<trace::Pause> pausesInStretches(const trace::ControlTrace& trace,
                                                          const templates::JobLoop& loop);

}  // namespace rivulet::streaming
