// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The pipeline in virtual time: each step takes as long as it is told to. @threadsafety pure.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "base/instant.h"
#include "base/result.h"
#include "pipeline/dispatcher.h"
#include "pipeline/event.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

struct VirtualOptions {
  DispatchOptions dispatch;
  /// How long a step takes, > 0. @param step  of this task, from 0
  std::function<base::Duration(Task task, std::uint64_t step)> duration;
  /// What it costs to change to another task, at the beginning of the step.
  base::Duration switchCost{};
  base::Instant until = base::Instant::max();
  std::function<void(const Event&)> recorder{};  ///< may be empty
};

struct VirtualRun {
  base::Instant end{};  ///< when position control has ended, or `until`
  bool hasEnded = false;
  std::array<TaskRecord, kTaskCount> records;
  std::array<double, kBufferCount> meanLevels{};  ///< over time
};

/// @param stages  by task @return errors of the tasks
[[nodiscard]] base::Result<VirtualRun> runVirtual(const std::array<Stage*, kTaskCount>& stages,
                                                  const SchedulingPolicy& policy,
                                                  const VirtualOptions& options);

}  // namespace rivulet::pipeline
