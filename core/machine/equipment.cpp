// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/equipment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rivulet::machine {

namespace {

using trace::ControlEvent;

}  // namespace

base::Duration Spindle::command(const SpindleConfig& config, double perMin, base::Instant at) {
  m_from = perMinAt(at);
  m_to = perMin;
  m_began = at;
  m_time = config.runUpTime(std::abs(m_to - m_from));
  return m_time;
}

double Spindle::perMinAt(base::Instant at) const {
  if (at >= m_began + m_time) {
    return m_to;
  }
  const double share = base::toSeconds(at - m_began) / base::toSeconds(m_time);
  return m_from + std::max(0.0, share) * (m_to - m_from);
}

double Equipment::carryOut(const PreparedActions& actions, base::Instant at,
                           std::vector<ControlEvent>& events) {
  // All speeds and directions of a block are one command of the spindle.
  const auto turns = [](const MachineAction& action) {
    return action.kind == MachineAction::Kind::SpindleSpeed ||
           action.kind == MachineAction::Kind::SpindleTurn;
  };
  const auto last = std::find_if(actions.actions.rbegin(), actions.actions.rend(), turns);
  base::Instant end = at;
  for (const MachineAction& action : actions.actions) {
    ControlEvent event;
    event.from = end;
    event.line = actions.line;
    event.name = action.tool.name;
    event.value = action.value;
    base::Duration time = carryOut(action, event);
    if (action.kind == MachineAction::Kind::Stop) {
      event.kind = ControlEvent::Kind::Stop;
      event.to = end;
      events.push_back(std::move(event));
      return std::numeric_limits<double>::infinity();
    }
    if (action.kind == MachineAction::Kind::SelectTool || (turns(action) && &action != &*last)) {
      continue;  // it shows later
    }
    if (turns(action)) {
      time = turnSpindle(event);
    }
    end += time;
    event.to = end;
    events.push_back(std::move(event));
  }
  return base::toSeconds(end - at);
}

base::Duration Equipment::carryOut(const MachineAction& action, ControlEvent& event) {
  using Kind = MachineAction::Kind;
  switch (action.kind) {
    case Kind::SelectTool:
      m_next = action.tool;
      break;
    case Kind::ChangeTool:
      return changeTool(action.tool, event);
    case Kind::SelectEdge:
      m_edge = static_cast<int>(action.value);
      event.kind = ControlEvent::Kind::Edge;
      break;
    case Kind::WorkOffset:
      m_workOffset = static_cast<int>(action.value);
      event.kind = ControlEvent::Kind::WorkOffset;
      break;
    case Kind::SpindleSpeed:
      m_programmedPerMin = action.value;
      break;
    case Kind::SpindleTurn:
      m_direction = action.value;
      break;
    case Kind::Coolant:
      m_flood = action.value == 8.0 || (m_flood && action.value != 9.0);
      m_mist = action.value == 7.0 || (m_mist && action.value != 9.0);
      event.kind = ControlEvent::Kind::Coolant;
      event.value = (m_flood ? 1.0 : 0.0) + (m_mist ? 2.0 : 0.0);
      return m_config.coolantTime.value_or(base::Duration{});
    case Kind::Stop:
      break;
  }
  return {};
}

/// The axes wait for the speed, but not for the standstill after M5.
base::Duration Equipment::turnSpindle(ControlEvent& event) {
  const double speed = std::min(m_programmedPerMin, m_config.spindle->speedPerMinMax);
  event.kind = ControlEvent::Kind::Spindle;
  event.value = m_direction * speed;
  event.name.clear();
  const base::Duration time = m_spindle.command(*m_config.spindle, event.value, event.from);
  return event.value == 0.0 ? base::Duration{} : time;
}

base::Duration Equipment::changeTool(const Tool& tool, ControlEvent& event) {
  event.kind = ControlEvent::Kind::ToolChange;
  event.value = tool.number;
  const bool isSame = tool.number == m_tool.number && tool.name == m_tool.name;
  m_tool = tool;
  if (isSame) {
    return {};
  }
  if (m_config.spindle) {
    m_direction = 0.0;
    static_cast<void>(m_spindle.command(*m_config.spindle, 0.0, event.from));
  }
  return m_config.tools->changeTime;
}

void Equipment::recordDwell(base::LineNumber line, base::Instant at, double seconds, bool continues,
                            std::vector<ControlEvent>& events) const {
  // A machine without these has no use for them; a loop that waits is one dwell.
  if (!m_config.spindle && !m_config.tools) {
    return;
  }
  const base::Instant end = at + base::fromSeconds(seconds);
  if (continues && !events.empty() && events.back().kind == ControlEvent::Kind::Dwell &&
      events.back().line == line) {
    events.back().to = end;
    return;
  }
  events.push_back({at, end, line, ControlEvent::Kind::Dwell, 0.0, {}});
}

void Equipment::endProgram(base::Instant at, std::vector<ControlEvent>& events) {
  if (m_config.spindle && m_spindle.commandPerMin() != 0.0) {
    static_cast<void>(m_spindle.command(*m_config.spindle, 0.0, at));
    events.push_back({at, at, {}, ControlEvent::Kind::Spindle, 0.0, {}});
  }
  if (m_flood || m_mist) {
    events.push_back({at, at, {}, ControlEvent::Kind::Coolant, 0.0, {}});
  }
  m_direction = 0.0;
  m_programmedPerMin = 0.0;
  m_flood = false;
  m_mist = false;
  m_edge = 0;
  m_workOffset = kNoWorkOffset;
}

EquipmentState Equipment::state(base::Instant at) const {
  EquipmentState state;
  state.tool = m_tool.number;
  state.toolName = m_tool.name;
  state.nextTool = m_next.number;
  state.nextToolName = m_next.name;
  state.edge = m_edge;
  state.spindlePerMin = m_spindle.perMinAt(at);
  state.spindleCommandPerMin = m_spindle.commandPerMin();
  state.programmedPerMin = m_programmedPerMin;
  state.spindleLimited = m_config.spindle && m_programmedPerMin > m_config.spindle->speedPerMinMax;
  state.flood = m_flood;
  state.mist = m_mist;
  state.workOffset = m_workOffset;
  return state;
}

}  // namespace rivulet::machine
