// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/conformance.h"

#include <fmt/format.h>

#include <functional>
#include <string_view>
#include <vector>

#include "petri/net_file.h"
#include "petri/simulator.h"
#include "pipeline/error.h"

namespace rivulet::pipeline {

namespace {

/// Pages of the tasks in the net.
constexpr std::array<std::string_view, kTaskCount> kPages{
    "Top.CNC.Receive", "Top.CNC.Interpreter",       "Top.CNC.RoughInterpolation",
    "Top.CNC.AccDec",  "Top.CNC.FineInterpolation", "Top.CNC.Position"};

std::string_view wordOf(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::Start:
      return "starts";
    case Event::Kind::Select:
      return "gets a processor";
    case Event::Kind::Preempt:
      return "preempts";
    case Event::Kind::Complete:
      break;
  }
  return "completes";
}

class Replay {
 public:
  Replay(const petri::Net& net, std::span<const Event> events)
      : m_net(net),
        m_events(events),
        m_simulator(net),
        m_insert(net.transitionOf("Top.SCHED.insert")),
        m_select(net.transitionOf("Top.SCHED.select")),
        m_preempt(net.transitionOf("Top.SCHED.preempt")),
        m_running(net.placeOf("Top.SCHED.Running")),
        m_timeoutPlace(net.placeOf("Top.CNC.Position.timeout")),
        m_id(net.offsetOf(net.places[m_running].colour, "ID")) {
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      const std::string page(kPages[i]);
      const bool isPosition = i == indexOf(Task::Position);
      m_starts[i] = net.transitionOf(page + (isPosition ? ".datacheck" : ".start"));
      m_completes[i] = net.transitionOf(page + ".complete");
      m_records[i] = net.placeOf(page + ".record");
      fire(net.transitionOf(page + ".init"), 0);
    }
    for (std::size_t i = 0; i < kBufferCount; ++i) {
      m_buffers[i] = net.placeOf(fmt::format("B{}", i + 1));
    }
    m_simulator.setRecorder([this](const petri::Recorded& recorded) {
      if (recorded.place == m_timeoutPlace) {
        m_late += static_cast<std::uint64_t>((*recorded.value)[0]);
      }
    });
  }

  Conformance run() {
    Conformance result;
    findMakers();
    for (std::size_t i = 0; i < m_events.size() && !result.violation; ++i) {
      result.violation = replay(i);
      result.events += result.violation ? 0U : 1U;
    }
    takeRecords(result.records);
    return result;
  }

 private:
  using Accepts = std::function<bool(const petri::Evaluator::Frame&)>;

  bool fire(
      std::size_t transition, petri::Word time,
      const Accepts& accepts = [](const auto&) { return true; }) {
    return m_simulator.fire(transition, time, accepts);
  }

  /// Accepts only a token of this task, taken from `place`.
  [[nodiscard]] Accepts isTask(std::size_t transition, std::size_t place, Task task) const {
    for (const petri::InputArc& arc : m_net.transitions[transition].inputs) {
      if (arc.place == place && arc.binds) {
        const bool isNumber = m_net.places[place].colour == petri::kInt;
        return [variable = arc.variable, offset = isNumber ? 0 : m_id, id = idOf(task)](
                   const petri::Evaluator::Frame& frame) { return frame[variable][offset] == id; };
      }
    }
    return [](const auto&) { return false; };
  }

  [[nodiscard]] static petri::Word idOf(Task task) {
    return static_cast<petri::Word>(indexOf(task)) + 1;
  }

  /// Whether the step that an event starts will make an item: said by the event that completes it.
  void findMakers() {
    m_makes.assign(m_events.size(), std::nullopt);
    std::array<std::size_t, kTaskCount> started{};
    for (std::size_t i = 0; i < m_events.size(); ++i) {
      const std::size_t task = indexOf(m_events[i].task);
      if (m_events[i].kind == Event::Kind::Start) {
        started[task] = i;
      } else if (m_events[i].kind == Event::Kind::Complete) {
        m_makes[started[task]] = m_events[i].made;
      }
    }
  }

  [[nodiscard]] std::optional<std::string> replay(std::size_t index) {
    const Event& event = m_events[index];
    const petri::Word time = event.at.time_since_epoch().count();
    const auto complain = [&](const std::string& what) {
      return fmt::format("Event {} at {:.6f} s, {} {}: {}.", index + 1, base::toSeconds(event.at),
                         nameOf(event.task), wordOf(event.kind), what);
    };
    if (time < m_simulator.now()) {
      return complain("it lies before the event before it");
    }
    if (time > m_simulator.now()) {
      if (const char* const due = whatIsDue()) {
        return complain(fmt::format("before it, {}", due));
      }
    }
    if (!fireEvent(index, time)) {
      return complain("the net does not allow it");
    }
    if (event.kind == Event::Kind::Select || event.kind == Event::Kind::Preempt) {
      const petri::Word given = m_simulator.marking()[m_running].back().value[m_id];
      if (given != idOf(event.task)) {
        return complain(fmt::format("the net gives the processor to {}",
                                    kTaskNames[static_cast<std::size_t>(given - 1)]));
      }
    }
    for (std::size_t i = 0; i < kBufferCount; ++i) {
      const petri::Word level = m_simulator.marking()[m_buffers[i]].front().value[0];
      if (level != event.levels[i]) {
        return complain(fmt::format("B{} is said to hold {}; in the net it holds {}", i + 1,
                                    event.levels[i], level));
      }
    }
    return std::nullopt;
  }

  /// What the net does before its time goes on; null: nothing.
  [[nodiscard]] const char* whatIsDue() {
    const petri::Word now = m_simulator.now();
    if (m_simulator.isEnabled(m_select, now)) {
      return "a task should have got the processor that is free";
    }
    if (m_simulator.isEnabled(m_preempt, now)) {
      return "position control should have preempted a task";
    }
    if (m_simulator.isEnabled(m_starts[indexOf(Task::Position)], now)) {
      return "position control should have started";
    }
    return nullptr;
  }

  [[nodiscard]] bool fireEvent(std::size_t index, petri::Word time) {
    const Event& event = m_events[index];
    const std::size_t task = indexOf(event.task);
    switch (event.kind) {
      case Event::Kind::Start:
        return fire(m_starts[task], time, amounts(index)) &&
               fire(m_insert, time, isTask(m_insert, m_net.placeOf("Top.IN"), event.task));
      case Event::Kind::Select:
        return fire(m_select, time);
      case Event::Kind::Preempt:
        return event.other && fire(m_preempt, time, isTask(m_preempt, m_running, *event.other));
      case Event::Kind::Complete:
        break;
    }
    const std::size_t isDone = m_net.transitionOf("Top.SCHED.isDone");
    const std::size_t complete = m_net.transitionOf("Top.SCHED.complete");
    const bool isPosition = event.task == Task::Position;
    return fire(isDone, time, isTask(isDone, m_running, event.task)) &&
           fire(complete, time, isTask(complete, m_running, event.task)) &&
           fire(m_completes[task], time) &&
           (!isPosition || fire(m_net.transitionOf("Top.CNC.Position.timecheck"), time));
  }

  /// Accepts what the step took and will make. The first and the last task have no choice.
  [[nodiscard]] Accepts amounts(std::size_t index) const {
    const Event& event = m_events[index];
    const std::size_t start = m_starts[indexOf(event.task)];
    const bool takesNothing = event.task == Task::Receive;
    for (const petri::InputArc& arc : m_net.transitions[start].inputs) {
      const petri::ColourId colour = m_net.places[arc.place].colour;
      if (arc.binds && m_net.colours[colour].name == "WORK") {
        return [variable = arc.variable, take = m_net.offsetOf(colour, "take"),
                make = m_net.offsetOf(colour, "make"), took = event.took,
                makes = m_makes[index]](const petri::Evaluator::Frame& frame) {
          return frame[variable][take] == (took ? 1 : 0) &&
                 (!makes || frame[variable][make] == (*makes ? 1 : 0));
        };
      }
    }
    return [isRight = event.took != takesNothing](const auto&) { return isRight; };
  }

  void takeRecords(std::array<TaskRecord, kTaskCount>& records) const {
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      const petri::ColourId trec = m_net.places[m_records[i]].colour;
      const petri::Words& value = m_simulator.marking()[m_records[i]].front().value;
      const auto field = [&](const char* name) { return value[m_net.offsetOf(trec, name)]; };
      records[i].count = static_cast<std::uint64_t>(field("cnt"));
      records[i].waitedData = base::Duration{field("ttwd")};
      records[i].waitedTurn = base::Duration{field("ttwc")};
      records[i].responseSum = base::Duration{field("rto")};
      records[i].responseMin = base::Duration{field("rmin")};
      records[i].responseMax = base::Duration{field("rmax")};
      records[i].preemptions = static_cast<std::uint64_t>(field("ppt"));
    }
    records[indexOf(Task::Position)].late = m_late;
  }

  const petri::Net& m_net;
  std::span<const Event> m_events;
  petri::Simulator m_simulator;
  std::size_t m_insert;
  std::size_t m_select;
  std::size_t m_preempt;
  std::size_t m_running;
  std::size_t m_timeoutPlace;
  std::size_t m_id;
  std::array<std::size_t, kTaskCount> m_starts{};
  std::array<std::size_t, kTaskCount> m_completes{};
  std::array<std::size_t, kTaskCount> m_records{};
  std::array<std::size_t, kBufferCount> m_buffers{};
  std::vector<std::optional<bool>> m_makes;
  std::uint64_t m_late = 0;
};

}  // namespace

base::Result<Conformance> checkConformance(std::span<const Event> events, PolicyKind policy,
                                           const DispatchOptions& options) {
  if (policy != PolicyKind::TaskDependency && policy != PolicyKind::DataFlow) {
    return base::fail(
        PipelineError::TaskBroken,
        fmt::format("The net of [P3] does not know the policy {}. Record the run with "
                    "task-dependency or data-flow.",
                    factsOf(policy).name));
  }
  // Steps take as long as they take: the net asks for no time of its own. It counts nanoseconds.
  const auto net = petri::loadNet("p3", {{"policy", policy == PolicyKind::DataFlow ? 1 : 0},
                                         {"processors", options.processors},
                                         {"capacity", options.capacity},
                                         {"execution", 0},
                                         {"position_execution", 0},
                                         {"position_cycle", options.positionCycle.count()},
                                         {"task_cycle", options.taskCycle.count()},
                                         {"any_amount", 1}});
  if (!net) {
    return base::fail(net.error());
  }
  return Replay(*net, events).run();
}

}  // namespace rivulet::pipeline
