// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/tasks/look_ahead.h"

#include <cmath>
#include <utility>

#include "pipeline/machine_of.h"
#include "pipeline/tasks/transfer.h"

namespace rivulet::pipeline {

LookAheadTask::LookAheadTask(const machine::MachineConfig& config, RingReader<RoughBlock> in,
                             RingWriter<CyclePlace> out)
    : m_config(pipelineMachine(config)),
      m_in(in),
      m_out(out),
      m_equipment(m_config),
      m_planner(m_config, config.start().mm, config.start().deg) {
  m_planner.setAuxiliaryRun(*this);
}

bool LookAheadTask::wantsBlock() const {
  return !m_isLastHere && !m_stops && m_planner.blockCount() < m_config.bufferedBlocksMax;
}

Need LookAheadTask::need() const {
  if (m_hasEnded) {
    return Need::Ended;
  }
  return wantsBlock() ? Need::Data : Need::Nothing;
}

base::Result<StepDone> LookAheadTask::step() {
  if (wantsBlock()) {
    const auto block = take(m_in);
    if (!block) {
      return base::fail(block.error());
    }
    append(*block);
    if (wantsBlock()) {
      return StepDone{false, need()};
    }
  }
  return makeCycle();
}

void LookAheadTask::append(const RoughBlock& block) {
  const BlockHead& head = block.head;
  switch (head.kind) {
    case BlockKind::Motion:
      m_planner.append(block.motion);
      break;
    case BlockKind::Dwell:
      m_planner.append(machine::PreparedDwell{head.line, head.dwell});
      break;
    case BlockKind::Action:
      m_actions.line = head.line;
      m_actions.zeroMm = head.zeroMm;
      if (head.hasAuxiliary) {
        machine::MachineAction action;
        action.kind = head.auxiliary.kind;
        action.value = head.auxiliary.value;
        action.tool.number = head.auxiliary.tool;
        action.tool.name = head.auxiliary.toolName.view();
        m_actions.actions.push_back(std::move(action));
      }
      if (!head.continues) {
        m_planner.append(std::exchange(m_actions, {}));
      }
      break;
    case BlockKind::Stop:
      m_stops = m_planner.blockCount() > 0;
      break;
    case BlockKind::End:
    case BlockKind::Alarm:
      m_last = head;
      m_isLastHere = true;
      break;
  }
}

double LookAheadTask::begin(const machine::PreparedActions& actions, base::Instant at) {
  for (const machine::MachineAction& action : actions.actions) {
    m_begun.push_back({action.kind, action.value, action.tool.number,
                       decltype(Auxiliary::toolName)(action.tool.name), actions.line});
  }
  m_events.clear();
  return m_equipment.carryOut(actions, at, m_events);
}

base::Result<StepDone> LookAheadTask::makeCycle() {
  CyclePlace item;
  if (m_planner.blockCount() > 0) {
    m_executed.clear();
    m_planner.step(m_now += m_config.interpolationCycle, m_executed);
    m_stops = m_stops && m_planner.blockCount() > 0;
  } else if (m_begun.empty()) {
    item.head.kind = m_last.kind == BlockKind::Alarm ? CycleKind::Alarm : CycleKind::End;
    item.head.alarm = m_last.alarm;
    m_hasEnded = true;
  }
  item.head.cycle = ++m_cycle;
  item.head.line = m_hasEnded ? m_last.line : m_planner.line();
  item.head.speedMmPerS = m_planner.speedMmPerS();
  item.head.zeroMm = m_planner.zeroMm();
  item.place = m_planner.place();
  while (!m_begun.empty() && item.head.auxiliaryCount < kAuxiliariesPerCycle) {
    item.head.auxiliaries[item.head.auxiliaryCount++] = m_begun.front();
    m_begun.pop_front();
  }
  if (auto given = give(m_out, item); !given) {
    return base::fail(given.error());
  }
  return StepDone{true, need()};
}

}  // namespace rivulet::pipeline
