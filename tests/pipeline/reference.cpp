// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/reference.h"

#include <fmt/format.h>

#include <variant>

#include "machine/equipment.h"
#include "machine/interpreter.h"
#include "machine/path_planner.h"
#include "machine/travel.h"
#include "nc/syntax/programs.h"
#include "pipeline/machine_of.h"

namespace rivulet::tests {

namespace {

std::string actionText(machine::MachineAction::Kind kind, double value, int tool,
                       base::LineNumber line) {
  return fmt::format("{} {} {} {}", static_cast<int>(kind), value, tool, line.value);
}

class Auxiliaries final : public machine::AuxiliaryRun {
 public:
  Auxiliaries(const machine::MachineConfig& config, Planned& planned)
      : m_equipment(config), m_planned(planned) {}
  double begin(const machine::PreparedActions& actions, base::Instant at) override {
    for (const machine::MachineAction& action : actions.actions) {
      m_planned.actions.push_back(
          actionText(action.kind, action.value, action.tool.number, actions.line));
    }
    std::vector<trace::ControlEvent> events;
    return m_equipment.carryOut(actions, at, events);
  }
  void dwell(base::LineNumber /*line*/, base::Instant /*at*/, double /*seconds*/) override {}

 private:
  machine::Equipment m_equipment;
  Planned& m_planned;
};

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

Planned planInProcess(const machine::MachineConfig& given, const std::string& text) {
  const machine::MachineConfig config = pipeline::pipelineMachine(given);
  Planned planned;
  Auxiliaries auxiliaries(config, planned);
  machine::RParameters parameters(config.rParameterCount);
  machine::Interpreter interpreter(nc::parseSinumerik(text), parameters,
                                   machine::interpreterOptions(config, config.start()));
  machine::PathPlanner planner(config, config.start().mm, config.start().deg);
  planner.setAuxiliaryRun(auxiliaries);
  bool hasEnded = false;
  base::Instant now{};
  std::vector<trace::ExecutedBlock> executed;
  const auto run = [&](bool untilItStands) {
    while (planner.blockCount() >= (untilItStands ? 1 : config.bufferedBlocksMax)) {
      planner.step(now += config.interpolationCycle, executed);
      planned.cycles.push_back(
          {planner.commandMm(), planner.commandDeg(), planner.speedMmPerS(), planner.line()});
    }
  };
  while (!hasEnded) {
    machine::Prepared prepared = interpreter.next();
    if (auto* motion = std::get_if<machine::PreparedMotion>(&prepared)) {
      if (const auto alarm = machine::travelAlarm(config, *motion)) {
        planned.alarm = alarm->number;
        planned.alarmText = alarm->text;
        break;
      }
      planner.append(*motion);
    } else if (auto* actions = std::get_if<machine::PreparedActions>(&prepared)) {
      planner.append(std::move(*actions));
    } else if (auto* dwell = std::get_if<machine::PreparedDwell>(&prepared)) {
      planner.append(*dwell);
    } else if (std::holds_alternative<machine::PreparedStopre>(prepared)) {
      interpreter.refresh();
      run(true);
    } else if (auto* alarm = std::get_if<machine::Alarm>(&prepared)) {
      planned.alarm = alarm->number;
      planned.alarmText = alarm->text;
      break;
    } else if (std::holds_alternative<machine::PreparedEnd>(prepared)) {
      hasEnded = true;
    }
    run(false);
  }
  run(true);
  return planned;
}

std::string firstDifference(const Planned& planned, const std::vector<pipeline::SetPoint>& points) {
  if (points.size() != planned.cycles.size() + 1) {
    return fmt::format("{} set points and the end instead of {}", points.size(),
                       planned.cycles.size());
  }
  std::vector<std::string> actions;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const pipeline::SetPoint& point = points[i];
    for (std::size_t action = 0; action < point.head.auxiliaryCount; ++action) {
      const pipeline::Auxiliary& one = point.head.auxiliaries[action];
      actions.push_back(actionText(one.kind, one.value, one.tool, one.line));
    }
    if (i == planned.cycles.size()) {
      break;
    }
    const Planned::Cycle& cycle = planned.cycles[i];
    bool isSame = sameBits(point.head.speedMmPerS, cycle.speed) && point.head.line == cycle.line;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      isSame = isSame && sameBits(point.positionMm[axis], cycle.mm[axis]) &&
               sameBits(point.positionDeg[axis], cycle.deg[axis]);
    }
    if (!isSame) {
      return fmt::format("set point {}", i + 1);
    }
  }
  if (actions != planned.actions) {
    return fmt::format("{} auxiliary functions instead of {}, or others", actions.size(),
                       planned.actions.size());
  }
  const pipeline::CycleHead& last = points.back().head;
  const auto expected =
      planned.alarmText.empty() ? pipeline::CycleKind::End : pipeline::CycleKind::Alarm;
  if (last.kind != expected || last.alarm.number != planned.alarm) {
    return "another end";
  }
  return {};
}

}  // namespace rivulet::tests
