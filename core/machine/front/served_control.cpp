// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/served_control.h"

#include "base/units.h"
#include "trace/control_trace.h"

namespace rivulet::machine {

ServedMachine::ServedMachine(Machine& machine) : m_machine(machine) {
  const MachineConfig& config = machine.config();
  m_facts.name = config.name;
  m_facts.product = kProductName;
  m_facts.applicationUri = kApplicationUri;
  m_facts.abilities = {true, true};
  m_facts.tracePieces = true;
  for (int axis = static_cast<int>(base::kAxisCount); config.rotaryAt(axis); ++axis) {
    m_facts.rotaryAxes.push_back(*config.rotaryAt(axis));
  }
  m_facts.samplingMin = config.access.samplingMin;
  m_facts.arrays = config.access.arrays;
  m_facts.users = config.users;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_facts.travel[axis] = {config.axes[axis].positionMmMin, config.axes[axis].positionMmMax};
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (const auto& limits = config.rotaryAxes[axis]) {
      m_facts.travel[base::kAxisCount + axis] = {limits->positionDegMin, limits->positionDegMax};
    }
  }
  m_facts.feedMmPerMin = {0.0, base::mmPerMinFromMmPerS(config.feedMmPerSMax())};
  if (config.spindle) {
    m_facts.spindlePerMin = {0.0, config.spindle->speedPerMinMax};
  }
}

bool ServedMachine::shows(std::string_view folder, std::string_view name) const {
  const MachineConfig& config = m_machine.config();
  if (folder == "Spindle") {
    return config.spindle.has_value();
  }
  if (name == "actTNumber" || name == "actDNumber" || name == "actToolIdent") {
    return config.tools.has_value();
  }
  return name != "acAuxfuMValue" || config.coolantTime.has_value();
}

base::Duration ServedMachine::programTime(std::size_t bytes) const {
  const AccessCost& cost = m_machine.config().access;
  return cost.writeOverhead + cost.programTime(bytes);
}

std::string ServedMachine::traceText() {
  return trace::printControlTrace(m_machine.trace());
}

}  // namespace rivulet::machine
