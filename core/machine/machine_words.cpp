// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/machine_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rivulet::machine {

namespace {

constexpr int kNoSuchTool = 17190;
constexpr int kNoSuchEdge = 17180;
constexpr int kChangesTool = 6;

int rounded(double value) {
  return static_cast<int>(std::lround(std::clamp(value, -1.0, 1e8)));
}

}  // namespace

void MachineWords::apply(const BlockMachineWords& words, bool isDwell, nc::ModalState& state) {
  m_actions = {};
  const bool changes = std::find(words.functions.begin(), words.functions.end(), kChangesTool) !=
                       words.functions.end();
  if (m_machine != nullptr && m_machine->tools) {
    applyTool(words, changes);
    if (words.edge) {
      applyEdge(words);
    }
    state.toolLengthMm =
        m_inSpindle.hasEdge(m_edge)
            ? m_inSpindle.edges[static_cast<std::size_t>(m_edge) - 1].lengthMm + m_lengthOffsetMm
            : 0.0;
  }
  if (m_machine != nullptr && m_machine->spindle && !isDwell) {
    applySpindle(words, state);
  }
  for (const int number : words.functions) {
    applyFunction(number);
  }
}

double MachineWords::radiusMm() const {
  return m_inSpindle.hasEdge(m_edge)
             ? m_inSpindle.edges[static_cast<std::size_t>(m_edge) - 1].radiusMm
             : 0.0;
}

void MachineWords::applyTool(const BlockMachineWords& words, bool changes) {
  if (words.tool || words.toolName) {
    std::optional<Tool> tool = find(words);
    if (!tool) {
      m_alarms.raise(
          {kNoSuchTool,
           fmt::format("Line {}: tool {} is not in the tool table.", words.line.value,
                       words.toolName ? *words.toolName : fmt::format("T{}", *words.tool))});
      return;
    }
    m_next = *std::move(tool);
    m_actions.before.push_back({Kind::SelectTool, 0.0, m_next});
  }
  if (changes) {
    m_inSpindle = m_next;
    m_actions.before.push_back({Kind::ChangeTool, 0.0, m_inSpindle});
    // D1 holds after a tool change (MD20270).
    m_edge = m_inSpindle.exists() ? 1 : 0;
    m_actions.before.push_back({Kind::SelectEdge, static_cast<double>(m_edge), {}});
  }
}

std::optional<Tool> MachineWords::find(const BlockMachineWords& words) {
  const ToolTable& table = *m_machine->tools;
  const int number = words.toolName ? 0 : rounded(*words.tool);
  if (!words.toolName && number == 0) {
    return Tool{};
  }
  std::optional<Tool> tool = words.toolName ? table.find(*words.toolName) : table.find(number);
  if (!tool && table.acceptsMissing) {
    tool = Tool{number, words.toolName.value_or(""), {}, true};
  }
  return tool;
}

void MachineWords::applyEdge(const BlockMachineWords& words) {
  const int edge = rounded(*words.edge);
  const bool exists =
      edge == 0 || !m_inSpindle.exists() || m_inSpindle.isAssumed || m_inSpindle.hasEdge(edge);
  if (!exists) {
    m_alarms.raise(
        {kNoSuchEdge, fmt::format("Line {}: tool {} has no cutting edge D{}.", words.line.value,
                                  m_inSpindle.name.empty() ? fmt::format("T{}", m_inSpindle.number)
                                                           : m_inSpindle.name,
                                  *words.edge)});
    return;
  }
  m_edge = edge;
  m_actions.before.push_back({Kind::SelectEdge, static_cast<double>(edge), {}});
}

/// The control reduces a speed that is too great and reports no alarm.
void MachineWords::applySpindle(const BlockMachineWords& words, nc::ModalState& state) {
  if (words.speedPerMin) {
    state.spindlePerMin = std::min(*words.speedPerMin, m_machine->spindle->speedPerMinMax);
    m_actions.before.push_back({Kind::SpindleSpeed, *words.speedPerMin, {}});
  }
  for (const int number : words.functions) {
    if (number >= 3 && number <= 5) {
      m_actions.before.push_back({Kind::SpindleTurn,
                                  number == 5   ? 0.0
                                  : number == 3 ? 1.0
                                                : -1.0,
                                  {}});
    } else if (number == 19) {
      m_actions.before.push_back({Kind::SpindleTurn, 0.0, {}});
    }
  }
}

void MachineWords::applyFunction(int number) {
  const bool stops = m_machine != nullptr && ((number == 0 && m_machine->programStop) ||
                                              (number == 1 && m_machine->optionalStop));
  if (stops) {
    m_actions.after.push_back({Kind::Stop, static_cast<double>(number), {}});
  } else if (number >= 7 && number <= 9 && m_machine != nullptr && m_machine->coolantTime) {
    m_actions.before.push_back({Kind::Coolant, static_cast<double>(number), {}});
  }
}

MachineWords::Actions MachineWords::take(const nc::ModalState& state) {
  Actions actions = std::exchange(m_actions, {});
  const int offset = state.workOffset < 0 ? kNoWorkOffset : state.workOffset / 10;
  const bool hasOffsets = m_machine != nullptr && !m_machine->workOffsetsMm.empty();
  // In another plane the length acts on another axis: the place of the workpiece moves as well.
  const bool turnsLength = m_edge > 0 && state.planeFirstAxis != m_planeFirstAxis;
  m_planeFirstAxis = state.planeFirstAxis;
  if (hasOffsets && (offset != m_workOffset || turnsLength)) {
    m_workOffset = offset;
    actions.before.insert(actions.before.begin(),
                          {Kind::WorkOffset, static_cast<double>(offset), {}});
  }
  return actions;
}

}  // namespace rivulet::machine
