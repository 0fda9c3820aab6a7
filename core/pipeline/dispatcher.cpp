// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/dispatcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/contract.h"
#include "pipeline/error.h"

namespace rivulet::pipeline {

namespace {

constexpr std::array<Task, kTaskCount> kTasks{Task::Receive,   Task::Interpret,   Task::Discrete,
                                              Task::LookAhead, Task::Interpolate, Task::Position};

}  // namespace

Dispatcher::Dispatcher(const DispatchOptions& options, const SchedulingPolicy& policy,
                       const std::array<Need, kTaskCount>& needs)
    : m_options(options),
      m_policy(policy),
      m_processors(static_cast<std::size_t>(options.processors)) {
  RIVULET_ASSERT(options.processors > 0);
  RIVULET_ASSERT(options.capacity > 0);
  RIVULET_ASSERT(options.positionCycle > base::Duration{});
  m_outlook.capacity = options.capacity;
  m_outlook.positionCycle = options.positionCycle;
  for (const Task task : kTasks) {
    m_tasks[indexOf(task)].need = needs[indexOf(task)];
  }
}

base::Instant Dispatcher::nextMultiple(base::Instant time, base::Duration cycle) {
  if (cycle == base::Duration{}) {
    return time;
  }
  const base::Duration since = time.time_since_epoch();
  return base::Instant{(since + cycle - base::Duration{1}) / cycle * cycle};
}

base::Instant Dispatcher::availableAfter(Task task, base::Instant end,
                                         const DispatchOptions& options) {
  if (task == Task::Receive) {
    return end;
  }
  return nextMultiple(end, task == Task::Position ? options.positionCycle : options.taskCycle);
}

void Dispatcher::record(Event::Kind kind, Task task, base::Instant now, std::optional<Task> other,
                        bool took, bool made) const {
  if (m_recorder) {
    m_recorder({kind, task, other, took, made, now, m_outlook.levels});
  }
}

bool Dispatcher::canStart(Task task, base::Instant now) const {
  const Entry& entry = m_tasks[indexOf(task)];
  if (entry.state != State::Waiting || entry.availableAt > now) {
    return false;
  }
  if (entry.need == Need::Input || entry.need == Need::Ended) {
    return false;
  }
  if (entry.need == Need::Data && m_outlook.levels[indexOf(task) - 1] == 0) {
    return false;
  }
  return task == Task::Position || m_outlook.levels[indexOf(task)] < m_options.capacity;
}

void Dispatcher::start(Task task, base::Instant now) {
  Entry& entry = m_tasks[indexOf(task)];
  const bool takes = entry.need == Need::Data;
  if (takes) {
    --m_outlook.levels[indexOf(task) - 1];
  }
  // Waiting for its cycle is not waiting for data.
  entry.record.waitedData += now - std::max(entry.waitsSince, entry.availableAt);
  entry.state = State::Ready;
  entry.readySince = now;
  entry.waitsSince = now;
  entry.busy = {};
  record(Event::Kind::Start, task, now, {}, takes);
}

Candidate Dispatcher::candidateOf(Task task) const {
  const std::size_t index = indexOf(task);
  Candidate candidate;
  candidate.task = task;
  candidate.upstream = index == 0 ? m_options.capacity : m_outlook.levels[index - 1];
  candidate.downstream = index < kBufferCount ? m_outlook.levels[index] : 0;
  candidate.isWarm = std::any_of(
      m_processors.begin(), m_processors.end(),
      [&](const Processor& processor) { return processor.isFree && processor.last == task; });
  return candidate;
}

bool Dispatcher::goesBefore(Task a, Task b) const {
  if (a == Task::Position || b == Task::Position) {
    return a == Task::Position && b != Task::Position;
  }
  return m_policy.goesBefore(candidateOf(a), candidateOf(b), m_outlook);
}

std::optional<Task> Dispatcher::firstInQueue() const {
  std::optional<Task> first;
  for (const Task task : kTasks) {
    if (m_tasks[indexOf(task)].state == State::Ready && (!first || goesBefore(task, *first))) {
      first = task;
    }
  }
  return first;
}

void Dispatcher::give(Task task, std::size_t processor, base::Instant now,
                      std::vector<Command>& commands) {
  Entry& entry = m_tasks[indexOf(task)];
  Processor& given = m_processors[processor];
  if (given.last != task) {
    ++entry.record.switches;
  }
  given = {false, task};
  entry.state = State::Running;
  entry.processor = processor;
  entry.runsSince = now;
  entry.record.waitedTurn += now - entry.waitsSince;
  commands.push_back({entry.isPreempted ? Command::Kind::Resume : Command::Kind::Run, task});
  entry.isPreempted = false;
}

void Dispatcher::advance(base::Instant now, std::vector<Command>& commands) {
  for (bool hasStarted = true; hasStarted;) {
    hasStarted = false;
    for (const Task task : kTasks) {
      if (canStart(task, now)) {
        start(task, now);
        hasStarted = true;
      }
    }
  }
  while (const std::optional<Task> task = firstInQueue()) {
    const auto isWarm = [&](const Processor& one) { return one.isFree && one.last == *task; };
    auto found = std::find_if(m_processors.begin(), m_processors.end(), isWarm);
    if (found == m_processors.end()) {
      found = std::find_if(m_processors.begin(), m_processors.end(),
                           [](const Processor& one) { return one.isFree; });
    }
    if (found == m_processors.end()) {
      break;
    }
    give(*task, static_cast<std::size_t>(found - m_processors.begin()), now, commands);
    record(Event::Kind::Select, *task, now);
    Entry& entry = m_tasks[indexOf(*task)];
    if (entry.held) {
      // Its work was done while it waited: it needs the processor for nothing more.
      const StepDone done = *std::exchange(entry.held, std::nullopt);
      commands.pop_back();
      finish(*task, done, now);
      advance(now, commands);
      return;
    }
  }
  if (m_tasks[indexOf(Task::Position)].state != State::Ready) {
    return;
  }
  std::optional<Task> last;
  for (const Task task : kTasks) {
    if (task != Task::Position && m_tasks[indexOf(task)].state == State::Running &&
        (!last || goesBefore(*last, task))) {
      last = task;
    }
  }
  RIVULET_ASSERT(last.has_value());
  Entry& victim = m_tasks[indexOf(*last)];
  victim.state = State::Ready;
  victim.isPreempted = true;
  victim.waitsSince = now;
  victim.busy += now - victim.runsSince;
  ++victim.record.preemptions;
  commands.push_back({Command::Kind::Suspend, *last});
  give(Task::Position, victim.processor, now, commands);
  record(Event::Kind::Preempt, Task::Position, now, last);
}

base::Result<void> Dispatcher::complete(Task task, const StepDone& done, base::Instant now) {
  Entry& entry = m_tasks[indexOf(task)];
  const bool isHeld = entry.state == State::Ready && entry.isPreempted && !entry.held;
  if (entry.state != State::Running && !isHeld) {
    return base::fail(PipelineError::TaskBroken,
                      fmt::format("The task {} ended a step that it had not begun. End all tasks "
                                  "of the pipeline and start it again.",
                                  nameOf(task)));
  }
  if (isHeld) {
    entry.held = done;
  } else {
    finish(task, done, now);
  }
  return {};
}

void Dispatcher::finish(Task task, const StepDone& done, base::Instant now) {
  const std::size_t index = indexOf(task);
  Entry& entry = m_tasks[index];
  entry.busy += now - entry.runsSince;
  m_processors[entry.processor].isFree = true;
  if (done.made && index < kBufferCount) {
    ++m_outlook.levels[index];
    ++m_outlook.made[index];
  }
  const base::Duration response = now - entry.readySince;
  TaskRecord& kept = entry.record;
  kept.responseMin = kept.count == 0 ? response : std::min(kept.responseMin, response);
  kept.responseMax = std::max(kept.responseMax, response);
  kept.responseSum += response;
  kept.busy += entry.busy;
  ++kept.count;
  m_outlook.meanTimes[index] = kept.busy / static_cast<base::Duration::rep>(kept.count);
  entry.state = State::Waiting;
  entry.need = done.next;
  entry.waitsSince = now;
  entry.availableAt = availableAfter(task, now, m_options);
  if (task == Task::Position) {
    kept.late += response > m_options.positionCycle ? 1U : 0U;
  }
  record(Event::Kind::Complete, task, now, {}, false, done.made);
}

void Dispatcher::inputArrived() {
  Entry& receive = m_tasks[indexOf(Task::Receive)];
  if (receive.need == Need::Input) {
    receive.need = Need::Nothing;
  }
}

std::optional<base::Instant> Dispatcher::nextRelease(base::Instant now) const {
  std::optional<base::Instant> next;
  for (const Entry& entry : m_tasks) {
    if (entry.state == State::Waiting && entry.need != Need::Ended && entry.availableAt > now &&
        (!next || entry.availableAt < *next)) {
      next = entry.availableAt;
    }
  }
  return next;
}

std::optional<base::Instant> Dispatcher::certainRelease() const {
  const Entry& position = m_tasks[indexOf(Task::Position)];
  if (position.state != State::Waiting || position.need != Need::Data ||
      m_outlook.levels.back() == 0) {
    return std::nullopt;
  }
  return position.availableAt;
}

bool Dispatcher::hasEnded() const {
  const Entry& position = m_tasks[indexOf(Task::Position)];
  return position.state == State::Waiting && position.need == Need::Ended;
}

bool Dispatcher::isRunning(Task task) const {
  return m_tasks[indexOf(task)].state == State::Running;
}

bool Dispatcher::isUnderWay(Task task) const {
  const Entry& entry = m_tasks[indexOf(task)];
  return entry.state == State::Running || (entry.state == State::Ready && entry.isPreempted);
}

}  // namespace rivulet::pipeline
