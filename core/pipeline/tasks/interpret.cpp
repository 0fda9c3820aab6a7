// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/tasks/interpret.h"

#include <utility>
#include <variant>

#include "base/budget.h"
#include "machine/travel.h"
#include "nc/syntax/programs.h"
#include "pipeline/machine_of.h"
#include "pipeline/tasks/transfer.h"

namespace rivulet::pipeline {

namespace {

constexpr base::Budget kBudget;
/// Blocks in one step that move nothing: a program that jumps back for ever stops nobody else.
constexpr int kSilentBlocksMax = 1000;

NcBlock blockOf(BlockKind kind, base::LineNumber line) {
  NcBlock block;
  block.head.kind = kind;
  block.head.line = line;
  return block;
}

}  // namespace

InterpretTask::InterpretTask(const machine::MachineConfig& config, RingReader<ProgramText> in,
                             RingWriter<NcBlock> out)
    : m_config(pipelineMachine(config)),
      m_in(in),
      m_out(out),
      m_parameters(config.rParameterCount) {
}

Need InterpretTask::need() const {
  if (!m_interpreter) {
    return Need::Data;
  }
  return m_hasEnded && m_due.empty() ? Need::Ended : Need::Nothing;
}

base::Result<StepDone> InterpretTask::step() {
  if (!m_interpreter) {
    return collect();
  }
  for (int i = 0; i < kSilentBlocksMax && m_due.empty() && !m_hasEnded; ++i) {
    interpretNext();
  }
  if (m_due.empty()) {
    return StepDone{false, need()};
  }
  if (auto given = give(m_out, m_due.front()); !given) {
    return base::fail(given.error());
  }
  m_due.pop_front();
  return StepDone{true, need()};
}

base::Result<StepDone> InterpretTask::collect() {
  const auto item = take(m_in);
  if (!item) {
    return base::fail(item.error());
  }
  m_text += item->text.view();
  if (auto fits = kBudget.require(static_cast<double>(m_text.capacity()), "The program"); !fits) {
    return base::fail(fits.error());
  }
  if (item->endsProgram) {
    const base::Budget left = kBudget.without(m_text.capacity());
    m_interpreter.emplace(nc::parseSinumerik(std::move(m_text), left), m_parameters,
                          machine::interpreterOptions(m_config, m_config.start()));
  }
  return StepDone{false, need()};
}

void InterpretTask::addAlarm(const machine::Alarm& alarm) {
  NcBlock block = blockOf(BlockKind::Alarm, m_interpreter->line());
  block.head.alarm.number = alarm.number;
  block.head.alarm.text = decltype(block.head.alarm.text)(alarm.text);
  m_due.push_back(block);
  m_hasEnded = true;
}

void InterpretTask::interpretNext() {
  add(m_interpreter->next());
}

void InterpretTask::add(const machine::Prepared& prepared) {
  const base::LineNumber line = m_interpreter->line();
  if (const auto* motion = std::get_if<machine::PreparedMotion>(&prepared)) {
    if (const auto alarm = machine::travelAlarm(m_config, *motion)) {
      addAlarm(*alarm);
      return;
    }
    NcBlock block = blockOf(BlockKind::Motion, motion->line);
    block.motion = *motion;
    m_due.push_back(block);
  } else if (const auto* dwell = std::get_if<machine::PreparedDwell>(&prepared)) {
    NcBlock block = blockOf(BlockKind::Dwell, dwell->line);
    block.head.dwell = dwell->duration;
    m_due.push_back(block);
  } else if (const auto* actions = std::get_if<machine::PreparedActions>(&prepared)) {
    NcBlock block = blockOf(BlockKind::Action, actions->line);
    block.head.zeroMm = actions->zeroMm;
    for (const machine::MachineAction& action : actions->actions) {
      block.head.hasAuxiliary = true;
      block.head.continues = &action != &actions->actions.back();
      block.head.auxiliary = {action.kind, action.value, action.tool.number,
                              decltype(Auxiliary::toolName)(action.tool.name), actions->line};
      m_due.push_back(block);
    }
    if (actions->actions.empty()) {
      m_due.push_back(block);
    }
  } else if (const auto* alarm = std::get_if<machine::Alarm>(&prepared)) {
    addAlarm(*alarm);
  } else if (std::holds_alternative<machine::PreparedSync>(prepared) ||
             std::holds_alternative<machine::PreparedCancel>(prepared)) {
    addAlarm({0, "Line " + std::to_string(line.value) +
                     " has a synchronized action, which this pipeline does not execute. Remove it, "
                     "or run the program on rivulet-machine."});
  } else if (std::holds_alternative<machine::PreparedStopre>(prepared)) {
    m_interpreter->refresh();
    m_due.push_back(blockOf(BlockKind::Stop, line));
  } else if (const auto* nothing = std::get_if<machine::PreparedNothing>(&prepared)) {
    if (nothing->jumped && m_config.jumpStops) {
      m_due.push_back(blockOf(BlockKind::Stop, line));
    }
  } else if (std::holds_alternative<machine::PreparedEnd>(prepared)) {
    m_due.push_back(blockOf(BlockKind::End, line));
    m_hasEnded = true;
  }
}

}  // namespace rivulet::pipeline
