// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One task at work: waits for the scheduler's instruction, makes a step, and says so. The same for
/// a thread and for a process of its own. @threadsafety one call, one thread.
#pragma once

#include "base/result.h"
#include "cnc/segment.h"
#include "machine/config.h"
#include "pipeline/task.h"

namespace rivulet::cnc {

/// Returns when the scheduler says so, or when the task has failed; why is in its mailbox then.
void runWorker(Segment& segment, pipeline::Task task);

/// The machine that all tasks of a segment plan for.
[[nodiscard]] base::Result<machine::MachineConfig> machineOf(const Setup& setup);

}  // namespace rivulet::cnc
