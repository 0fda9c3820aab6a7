// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/equipment_watch.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "base/whole_number.h"
#include "opcua/error.h"

namespace rivulet::streaming {

namespace {

using opcua::Reading;
using opcua::SpindleTurn;
using opcua::Variable;
using opcua::VariableKind;

/// A spindle this slow may be said to stand, and to turn.
constexpr double kStandsPerMin = 1.0;

std::optional<SpindleTurn> turnFrom(double number) {
  for (const SpindleTurn turn :
       {SpindleTurn::Clockwise, SpindleTurn::Counterclockwise, SpindleTurn::Stands}) {
    if (number == static_cast<double>(turn)) {
      return turn;
    }
  }
  return std::nullopt;
}

/// Off, if the group says so or has none yet; nothing for another M function.
std::optional<bool> isOn(double number, int on) {
  if (number == on) {
    return true;
  }
  return number == opcua::kCoolantOff || number < 0.0 ? std::optional(false) : std::nullopt;
}

constexpr int kNumberMax = 999'999'999;  // of a tool; -1: there is none

void takeOne(EquipmentSeen& seen, const Variable& variable, const Reading& reading) {
  switch (variable.kind) {
    case VariableKind::ToolNumber:
      seen.tool = base::wholeNumber(reading.number, -1, kNumberMax);
      break;
    case VariableKind::ToolName:
      seen.toolName = reading.text;
      break;
    case VariableKind::EdgeNumber:
      seen.edge = base::wholeNumber(reading.number, -1, kNumberMax);
      break;
    case VariableKind::GFunction:
      seen.workOffset = reading.text;
      break;
    case VariableKind::SpindleSpeed:
      seen.spindlePerMin = std::abs(reading.number);
      break;
    case VariableKind::SpindleSpeedSet:
      seen.spindleSetPerMin = std::abs(reading.number);
      break;
    case VariableKind::SpindleTurn:
      seen.turn = turnFrom(reading.number);
      break;
    case VariableKind::MFunction:
      (variable.index == opcua::kFloodGroup ? seen.flood : seen.mist) = isOn(
          reading.number, variable.index == opcua::kFloodGroup ? opcua::kFloodOn : opcua::kMistOn);
      break;
    default:
      break;
  }
}

}  // namespace

EquipmentWatch::EquipmentWatch()
    : m_variables{{VariableKind::ToolNumber, 0},
                  {VariableKind::ToolName, 0},
                  {VariableKind::EdgeNumber, 0},
                  {VariableKind::GFunction, opcua::kWorkOffsetGroup},
                  {VariableKind::SpindleSpeed, 0},
                  {VariableKind::SpindleSpeedSet, 0},
                  {VariableKind::SpindleTurn, 0},
                  {VariableKind::MFunction, opcua::kFloodGroup},
                  {VariableKind::MFunction, opcua::kMistGroup}} {
}

EquipmentSeen EquipmentWatch::take(std::span<const Reading> readings) {
  RIVULET_ASSERT(readings.size() == m_variables.size());
  EquipmentSeen seen;
  std::vector<Variable> served;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!readings[i].status) {
      takeOne(seen, m_variables[i], readings[i]);
    }
    if (readings[i].status != opcua::LinkError::VariableMissing) {
      served.push_back(m_variables[i]);
    }
  }
  m_variables = std::move(served);
  // The numbers of the directions are assumed: they are believed only where the speed agrees.
  if (seen.turn && seen.spindlePerMin &&
      (*seen.turn == SpindleTurn::Stands) != (*seen.spindlePerMin < kStandsPerMin)) {
    seen.turn.reset();
  }
  return seen;
}

}  // namespace rivulet::streaming
