// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the scheduler records: the fields of TASK, TREC and DREC. @threadsafety plain values.
/// @source [P3] Fig. 8
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/instant.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

struct Event {
  enum class Kind : std::uint8_t {
    Start,     ///< the task has its data and waits for a processor
    Select,    ///< it gets one that is free
    Preempt,   ///< it takes one from `other`, which waits again
    Complete,  ///< it is done, and its processor is free
  };
  Kind kind = Kind::Start;
  Task task = Task::Receive;
  std::optional<Task> other;
  bool took = false;  ///< Start: an item of the buffer before it
  bool made = false;  ///< Complete: an item for the buffer after it
  base::Instant at{};
  std::array<int, kBufferCount> levels{};  ///< after the event

  friend bool operator==(const Event&, const Event&) = default;
};

/// TREC: what a task has done so far.
struct TaskRecord {
  std::uint64_t count = 0;       ///< steps
  base::Duration waitedData{};   ///< for data, for room after it, or for its next cycle
  base::Duration waitedTurn{};   ///< for the processor
  base::Duration responseSum{};  ///< from the start to the end of each step
  base::Duration responseMin{};
  base::Duration responseMax{};
  std::uint64_t preemptions = 0;
  std::uint64_t switches = 0;  ///< got a processor that had executed another task last
  std::uint64_t late = 0;      ///< position control: steps that took longer than its cycle
  base::Duration busy{};       ///< on a processor

  [[nodiscard]] base::Duration responseMean() const {
    return count == 0 ? base::Duration{} : responseSum / static_cast<base::Duration::rep>(count);
  }
};

}  // namespace rivulet::pipeline
