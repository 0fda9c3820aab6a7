// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run of the pipeline in real time: starts the tasks as threads or as processes, schedules them,
/// moves the axes, and notices a task that dies. Then no task runs any more but position control,
/// until the set points that are ready have been sent; the axes stand there.
/// @threadsafety one call, one thread; one run at a time in a process, because of SIGCHLD.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "machine/config.h"
#include "pipeline/dispatcher.h"
#include "pipeline/event.h"
#include "pipeline/policy.h"
#include "trace/control_trace.h"

namespace rivulet::cnc {

struct RunOptions {
  std::string preset;
  std::string program;     ///< path; empty: over TCP
  std::uint16_t port = 0;  ///< where it is expected then; 0: any free one
  pipeline::PolicyKind policy = pipeline::PolicyKind::TaskDependency;
  pipeline::DispatchOptions dispatch;
  bool inProcesses = false;
  int priority = 0;                              ///< of SCHED_FIFO for position control; 0: none
  int core = -1;                                 ///< for position control; -1: any
  base::Duration until = base::Duration::max();  ///< the run is ended then
  /// What the user may want to know while it runs: a port, the processes.
  std::function<void(const std::string&)> say;
  /// Called with the events since its last call, some ten times a second and at the end; may be
  /// empty. The scheduler waits meanwhile.
  std::function<void(std::span<const pipeline::Event>)> watch;
};

struct RunResult {
  bool hasEnded = false;  ///< the program is at its end
  std::string failure;    ///< a sentence; empty: none
  trace::ControlTrace trace;
  std::vector<pipeline::Event> events;
  std::array<pipeline::TaskRecord, pipeline::kTaskCount> records;
  std::vector<base::Duration> wakeUps;  ///< of position control: how long after each instant
  std::vector<base::Duration> cycles;   ///< from one set point to the next, while none was missing
  base::Duration duration{};
};

/// @param stop  ends the run as an end of the program does not: the axes stand where they are
/// @return errors before the start
[[nodiscard]] base::Result<RunResult> runCnc(const RunOptions& options,
                                             const std::atomic<bool>& stop);

/// What a process does that is one task. @return the exit code
[[nodiscard]] int runTaskProcess(const std::string& segment, int task);

}  // namespace rivulet::cnc
