// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/program_variables.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/vec3.h"

namespace rivulet::gcode {

ProgramVariables::ProgramVariables(const nc::Semantics& semantics, PositionOf positionOf,
                                   MachinePositionOf machinePositionOf, KnownNumber knownNumber,
                                   std::function<bool()> countsInches)
    : Variables(semantics),
      m_positionOf(std::move(positionOf)),
      m_machinePositionOf(std::move(machinePositionOf)),
      m_knownNumber(std::move(knownNumber)),
      m_countsInches(std::move(countsInches)) {
}

nc::Expected<nc::Value> ProgramVariables::system(std::string_view name,
                                                 std::span<const nc::Value> indices) const {
  const std::string axis = indices.size() == 1 ? nc::textOf(indices[0]) : std::string();
  const bool isInMachine = name == "$AA_IM";
  if (axis.size() == 1 && (isInMachine || name == "$AA_IW" || name == "$P_EP")) {
    if (const std::optional<double> known =
            isInMachine ? m_machinePositionOf(axis[0]) : m_positionOf(axis[0])) {
      noteChange();
      return *known;
    }
  }
  return nc::fail(nc::FaultCode::OnlyOnControl,
                  axis.empty() ? std::string(name) : fmt::format("{}[{}]", name, axis));
}

nc::Expected<void> ProgramVariables::setSystem(std::string_view name,
                                               std::span<const nc::Value> indices, double value) {
  m_setsControl = true;
  return Variables::setSystem(name, indices, value);
}

nc::Expected<nc::Value> ProgramVariables::variable(std::string_view name,
                                                   std::span<const int> indices) const {
  nc::Expected<nc::Value> value = Variables::variable(name, indices);
  if (!value && name.size() == 4 && name.substr(0, 2) == "<_") {
    if (const std::optional<double> known = m_positionOf(name[2])) {
      noteChange();
      return *known;
    }
  }
  return value;
}

nc::Expected<nc::Value> ProgramVariables::numbered(int number) const {
  if (semantics().kindOf(number) == nc::NumberKind::Control) {
    if (const std::optional<double> known = m_knownNumber(number)) {
      noteChange();
      return *known;
    }
  }
  return Variables::numbered(number);
}

}  // namespace rivulet::gcode
