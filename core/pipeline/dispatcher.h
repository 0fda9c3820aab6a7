// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The scheduler: keeps the levels of the buffers, starts tasks that have data and room, and gives
/// processors to them by a policy. A state machine: it is told what happens and when, and says who
/// runs. The same one serves threads, processes and virtual time. The net of [P3]
/// (resources/nets/p3.toml) is its specification; recorded events are replayed against it
/// (conformance.h).
///
/// Position control is released at the multiples of its cycle. If no processor is free then, it
/// takes the one of the task that would go last, which goes on later with what it has left to do.
/// @threadsafety one object, one thread. @source [P3] III, Fig. 10 to 12
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "pipeline/event.h"
#include "pipeline/policy.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

struct DispatchOptions {
  int processors = 2;              ///< 1 to kTaskCount
  int capacity = 50;               ///< of each buffer, 1 to kRingCapacity
  base::Duration positionCycle{};  ///< > 0
  base::Duration taskCycle{};      ///< tasks 2 to 5 start at its multiples; 0: at any time
};

/// What the caller has to do.
struct Command {
  enum class Kind : std::uint8_t {
    Run,      ///< call the task's step
    Suspend,  ///< it has lost its processor
    Resume,   ///< it goes on
  };
  Kind kind = Kind::Run;
  Task task = Task::Receive;
};

class Dispatcher {
 public:
  /// @param needs  of each task, at the beginning
  Dispatcher(const DispatchOptions& options, const SchedulingPolicy& policy,
             const std::array<Need, kTaskCount>& needs);

  /// Everything that is recorded; may be empty.
  void setRecorder(std::function<void(const Event&)> recorder) { m_recorder = std::move(recorder); }

  /// Starts what can start and hands out processors. @param now  never before an earlier one
  void advance(base::Instant now, std::vector<Command>& commands);
  /// A step is done. A task that has lost its processor meanwhile ends when it has one again.
  /// @return TaskBroken if the task was not running
  [[nodiscard]] base::Result<void> complete(Task task, const StepDone& done, base::Instant now);
  /// What task 1 waited for has come.
  void inputArrived();

  /// When a task that waits for its cycle may start; nothing if none does.
  [[nodiscard]] std::optional<base::Instant> nextRelease(base::Instant now) const;
  /// When position control will start next, if nothing can prevent it: its set point is there, and
  /// it waits only for its cycle.
  [[nodiscard]] std::optional<base::Instant> certainRelease() const;
  [[nodiscard]] bool hasEnded() const;
  [[nodiscard]] bool isRunning(Task task) const;
  /// A processor works for it, or it waits for one after it has been preempted.
  [[nodiscard]] bool isUnderWay(Task task) const;

  [[nodiscard]] const std::array<int, kBufferCount>& levels() const { return m_outlook.levels; }
  [[nodiscard]] const TaskRecord& record(Task task) const { return m_tasks[indexOf(task)].record; }

  /// From when on a task that has ended a step may start again.
  [[nodiscard]] static base::Instant availableAfter(Task task, base::Instant end,
                                                    const DispatchOptions& options);

 private:
  enum class State : std::uint8_t { Waiting, Ready, Running };
  struct Entry {
    State state = State::Waiting;
    Need need = Need::Ended;
    base::Instant availableAt{};  ///< may not start earlier
    base::Instant waitsSince{};   ///< for data or for the processor
    base::Instant readySince{};
    base::Instant runsSince{};
    bool isPreempted = false;      ///< Ready: it has begun
    std::optional<StepDone> held;  ///< Ready: it has ended without its processor
    std::size_t processor = 0;     ///< Running
    base::Duration busy{};         ///< of the step in progress
    TaskRecord record;
  };

  [[nodiscard]] bool canStart(Task task, base::Instant now) const;
  void start(Task task, base::Instant now);
  [[nodiscard]] std::optional<Task> firstInQueue() const;
  [[nodiscard]] bool goesBefore(Task a, Task b) const;
  [[nodiscard]] Candidate candidateOf(Task task) const;
  void give(Task task, std::size_t processor, base::Instant now, std::vector<Command>& commands);
  void finish(Task task, const StepDone& done, base::Instant now);
  void record(Event::Kind kind, Task task, base::Instant now, std::optional<Task> other = {},
              bool took = false, bool made = false) const;
  [[nodiscard]] static base::Instant nextMultiple(base::Instant time, base::Duration cycle);

  DispatchOptions m_options;
  const SchedulingPolicy& m_policy;
  std::array<Entry, kTaskCount> m_tasks;
  struct Processor {
    bool isFree = true;
    std::optional<Task> last;
  };
  std::vector<Processor> m_processors;
  Outlook m_outlook;
  std::function<void(const Event&)> m_recorder;
};

}  // namespace rivulet::pipeline
