// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the tasks have done (TREC), from the events of the scheduler alone: for a run that is
/// watched from outside, and for one that was recorded. The same as `Dispatcher::record`, but for
/// `switches`: events do not say which processor they are about.
/// @threadsafety one object, one thread. @source [P3] Fig. 8
#pragma once

#include <array>

#include "pipeline/dispatcher.h"
#include "pipeline/event.h"

namespace rivulet::pipeline {

class EventRecords {
 public:
  /// @param options  with which the events are recorded
  explicit EventRecords(const DispatchOptions& options) : m_options(options) {}

  /// @param event  not earlier than the last one
  void add(const Event& event);
  [[nodiscard]] const std::array<TaskRecord, kTaskCount>& records() const { return m_records; }

 private:
  struct Entry {
    base::Instant waitsSince{};
    base::Instant availableAt{};
    base::Instant readySince{};
    base::Instant runsSince{};
    base::Duration busy{};  ///< of the step in progress
  };

  void give(Task task, base::Instant now);
  void finish(Task task, base::Instant now);

  DispatchOptions m_options;
  std::array<Entry, kTaskCount> m_tasks;
  std::array<TaskRecord, kTaskCount> m_records;
};

}  // namespace rivulet::pipeline
