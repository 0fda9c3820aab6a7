// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/event_records.h"

#include <algorithm>

namespace rivulet::pipeline {

void EventRecords::add(const Event& event) {
  Entry& entry = m_tasks[indexOf(event.task)];
  switch (event.kind) {
    case Event::Kind::Start:
      m_records[indexOf(event.task)].waitedData +=
          event.at - std::max(entry.waitsSince, entry.availableAt);
      entry.readySince = event.at;
      entry.waitsSince = event.at;
      entry.busy = {};
      return;
    case Event::Kind::Select:
      give(event.task, event.at);
      return;
    case Event::Kind::Preempt:
      if (event.other) {
        Entry& victim = m_tasks[indexOf(*event.other)];
        victim.waitsSince = event.at;
        victim.busy += event.at - victim.runsSince;
        ++m_records[indexOf(*event.other)].preemptions;
      }
      give(event.task, event.at);
      return;
    case Event::Kind::Complete:
      finish(event.task, event.at);
      return;
  }
}

void EventRecords::give(Task task, base::Instant now) {
  Entry& entry = m_tasks[indexOf(task)];
  entry.runsSince = now;
  m_records[indexOf(task)].waitedTurn += now - entry.waitsSince;
}

void EventRecords::finish(Task task, base::Instant now) {
  Entry& entry = m_tasks[indexOf(task)];
  TaskRecord& record = m_records[indexOf(task)];
  const base::Duration response = now - entry.readySince;
  record.responseMin = record.count == 0 ? response : std::min(record.responseMin, response);
  record.responseMax = std::max(record.responseMax, response);
  record.responseSum += response;
  record.busy += entry.busy + (now - entry.runsSince);
  ++record.count;
  entry.waitsSince = now;
  entry.availableAt = Dispatcher::availableAfter(task, now, m_options);
  if (task == Task::Position && response > m_options.positionCycle) {
    ++record.late;
  }
}

}  // namespace rivulet::pipeline
