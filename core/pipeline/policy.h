// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Who of the tasks that can run gets the next processor. Position control always comes first; the
/// dispatcher sees to it, and a policy orders the others. One file each in `policies`.
/// @threadsafety const functions from any thread.
/// @source [P3] III.A, Fig. 10 and 11
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "base/instant.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

/// A task that can run.
struct Candidate {
  Task task = Task::Receive;
  int upstream = 0;     ///< items in the buffer before it; before the first task it counts as full
  int downstream = 0;   ///< items in the buffer after it
  bool isWarm = false;  ///< a processor that is free has executed it last
};

/// Whether a processor that stays with its task saves a switch and keeps nobody waiting for long: the
/// task has executed last, and what lies after it is less than a batch.
[[nodiscard]] bool isWithinBatch(const Candidate& candidate);

/// What the scheduler knows besides.
struct Outlook {
  std::array<int, kBufferCount> levels{};
  int capacity = 0;
  base::Duration positionCycle{};
  std::array<base::Duration, kTaskCount> meanTimes{};  ///< of a step, so far; 0: none yet
  std::array<std::uint64_t, kTaskCount> made{};        ///< items of each task, so far
};

class SchedulingPolicy {
 public:
  virtual ~SchedulingPolicy() = default;
  /// Whether `a` gets the processor rather than `b`; a strict order. Neither is position control.
  [[nodiscard]] virtual bool goesBefore(const Candidate& a, const Candidate& b,
                                        const Outlook& outlook) const = 0;
};

enum class PolicyKind : std::uint8_t { TaskDependency, DataFlow, EarliestStarvation, Steady };

struct PolicyFacts {
  PolicyKind kind;
  std::string_view name;  ///< on the command line
  std::string_view title;
  std::unique_ptr<SchedulingPolicy> (*make)();
};

/// All of them: the two of [P3], then ours.
[[nodiscard]] const std::array<PolicyFacts, 4>& policies();
[[nodiscard]] const PolicyFacts& factsOf(PolicyKind kind);

std::unique_ptr<SchedulingPolicy> makeTaskDependency();
std::unique_ptr<SchedulingPolicy> makeDataFlow();
std::unique_ptr<SchedulingPolicy> makeEarliestStarvation();
std::unique_ptr<SchedulingPolicy> makeSteady();

}  // namespace rivulet::pipeline
