// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/job_restart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.h"
#include "job/main_program.h"
#include "machine/dry_run.h"
#include "nc/syntax/language.h"
#include "nc/syntax/lexer.h"

namespace rivulet::forecast {

namespace {

using base::Result;
using job::NativeReason;
using streaming::StreamError;

/// From above down to the place where the job goes on, mm/min.
constexpr int kApproachFeed = 500;

/// The state in which a part begins.
Result<machine::DryRun> stateAt(const job::Plan& plan, machine::MachineConfig machine,
                                std::size_t part) {
  // Words for what the machine lacks have no effect, but they count here.
  if (!machine.tools) {
    machine.tools.emplace();
  }
  if (!machine.spindle) {
    machine.spindle.emplace();
  }
  machine.spindle->speedPerMinMax = std::numeric_limits<double>::max();
  machine.coolantTime = machine.coolantTime.value_or(base::Duration{});
  const job::Outline outline = job::outlineOf(plan, part);
  machine::DryRun run = machine::dryRun(machine, outline.text, {machine.start(), {}});
  if (!run.isComplete) {
    const base::LineNumber line = run.findings.back().line;
    return base::fail(
        StreamError::CannotResume,
        fmt::format("The state before this place is not known: only the control knows "
                    "what line {} does. Start from the beginning.",
                    outline.lines[line.value - 1].line.value),
        plan.program.name);
  }
  return run;
}

/// Has an M or H function whose effect outlasts its block and that is not established again: gears
/// and what is the machine builder's. Spindle, tool and coolant are; stops and ends leave nothing.
bool leavesUnknownState(const std::string& text) {
  static constexpr std::array<int, 12> kSettled{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 17, 30};
  const nc::Words words = nc::readWords(text, nc::languageOf(nc::Dialect::Sinumerik), {});
  return std::any_of(words.tokens.begin(), words.tokens.end(), [](const nc::Token& token) {
    if (token.kind != nc::TokenKind::Word || (token.address != 'M' && token.address != 'H')) {
      return false;
    }
    return token.address == 'H' || std::none_of(kSettled.begin(), kSettled.end(), [&](int settled) {
             return token.value == settled;
           });
  });
}

/// The program has placed every axis before the part: where they stand does not depend on where
/// they were at the start.
bool isPlacedBefore(const job::Plan& plan, std::size_t until) {
  std::array<bool, base::kAxisCount> isPlaced{};
  for (std::size_t part = 0; part < until; ++part) {
    const auto* const native = std::get_if<job::NativeBlock>(&plan.parts[part]);
    const job::Stretch* const stretch = std::get_if<job::Stretch>(&plan.parts[part]);
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (native != nullptr) {
        isPlaced[axis] = isPlaced[axis] || native->places[axis];
      } else if (stretch->pointCount > 0) {
        const std::size_t last = stretch->firstPoint + stretch->pointCount - 1;
        isPlaced[axis] =
            isPlaced[axis] || std::isfinite(plan.program.trajectory.points[last].positionMm[axis]);
      }
    }
  }
  return std::all_of(isPlaced.begin(), isPlaced.end(), [](bool placed) { return placed; });
}

/// The first part that moves; the number of parts: none does.
std::size_t firstMotionOf(const job::Plan& plan) {
  const auto first = std::find_if(plan.parts.begin(), plan.parts.end(), [](const job::Part& part) {
    const auto* const stretch = std::get_if<job::Stretch>(&part);
    return stretch != nullptr && stretch->number > 0;
  });
  return static_cast<std::size_t>(first - plan.parts.begin());
}

int firstStretchOf(const job::Plan& plan) {
  const std::size_t first = firstMotionOf(plan);
  return first < plan.parts.size() ? std::get<job::Stretch>(plan.parts[first]).number : 0;
}

/// A block before a part is there for it.
bool hasBefore(const job::Plan& plan, std::size_t part, NativeReason reason) {
  return std::any_of(plan.parts.begin(), plan.parts.begin() + static_cast<std::ptrdiff_t>(part),
                     [reason](const job::Part& each) {
                       const auto* const native = std::get_if<job::NativeBlock>(&each);
                       return native != nullptr && native->reason == reason;
                     });
}

class Restarter {
 public:
  Restarter(const job::Plan& plan, const machine::DryRun& state, const streaming::JobRest& rest)
      : m_plan(plan),
        m_state(state.equipment),
        m_rest(rest),
        m_moves(rest.resume.has_value() || hasMoved()) {
    m_restart.plan.program = plan.program;
    m_restart.plan.refusals = plan.refusals;
  }

  Restart make() {
    m_restart.rest = m_rest;
    if (m_rest.part == 0 && !m_rest.resume) {
      m_restart.plan = m_plan;
      return std::move(m_restart);
    }
    setOffset();
    rise();
    setTool();
    setModes();
    setSpindle();
    approach();
    for (std::size_t part = m_rest.part; part < m_plan.parts.size(); ++part) {
      m_restart.plan.parts.push_back(m_plan.parts[part]);
    }
    if (auto* const first = std::get_if<job::Stretch>(
            &m_restart.plan.parts[m_restart.plan.parts.size() - m_plan.parts.size() + m_rest.part]);
        first != nullptr && m_rest.toolMm) {
      first->startMm = *m_rest.toolMm;
    }
    return std::move(m_restart);
  }

 private:
  /// @param text     for the control
  /// @param checked  the same for a check; empty: the text itself
  void add(NativeReason reason, std::string text, const std::string& checked = {}) {
    job::NativeBlock block;
    block.place = placeOf(m_plan.parts[m_rest.part]);
    block.reason = reason;
    block.text = text;
    block.source = checked.empty() ? text : checked;
    block.isInserted = true;
    block.moves = reason == NativeReason::OtherMotion;
    block.places.fill(block.moves);
    m_restart.plan.parts.emplace_back(std::move(block));
    m_restart.steps.push_back(std::move(text));
  }

  static nc::Place placeOf(const job::Part& part) {
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    return native != nullptr ? native->place : std::get<job::Stretch>(part).blocks.front();
  }

  /// Over everything that the program streams: nothing is in the way there.
  [[nodiscard]] double safeMm() const {
    double safe = std::numeric_limits<double>::lowest();
    for (const gcode::TrajectoryPoint& point : m_plan.program.trajectory.points) {
      safe = std::isnan(point.positionMm.z) ? safe : std::max(safe, point.positionMm.z);
    }
    return safe;
  }

  [[nodiscard]] bool has(NativeReason reason) const {
    return hasBefore(m_plan, m_rest.part, reason);
  }

  /// A block before the part has moved an axis, or may have.
  [[nodiscard]] bool hasMoved() const {
    return std::any_of(
        m_plan.parts.begin(), m_plan.parts.begin() + static_cast<std::ptrdiff_t>(m_rest.part),
        [](const job::Part& part) {
          const auto* const native = std::get_if<job::NativeBlock>(&part);
          return native == nullptr ? std::get<job::Stretch>(part).number > 0
                                   : native->moves || native->reason < NativeReason::Tool;
        });
  }

  static std::string number(char axis, double mm) {
    return fmt::format("{}{}", axis, base::formatFixed(mm, 6));
  }

  void setOffset() {
    if (has(NativeReason::WorkOffset)) {
      add(NativeReason::WorkOffset, fmt::format("G{}", m_state.workOffset));
    }
    if (m_state.edge > 0) {
      add(NativeReason::Tool, fmt::format("D{}", m_state.edge));
    }
  }

  /// A tool that stands higher stays there. The control knows how long the tool in it is.
  void rise() {
    if (safeMm() == std::numeric_limits<double>::lowest() || !m_moves) {
      return;  // the program streams no height
    }
    const std::string height = base::formatFixed(safeMm(), 6);
    add(NativeReason::OtherMotion, fmt::format("G0 G90 Z=MAXVAL($AA_IW[Z],{})", height),
        "G0 G90 Z" + height);
  }

  static std::string toolWord(int number, const std::string& name) {
    return name.empty() || number > 0 ? fmt::format("T{}", number) : fmt::format("T=\"{}\"", name);
  }

  void setTool() {
    if (!has(NativeReason::Tool)) {
      return;
    }
    const bool isIn = m_state.tool > 0 || !m_state.toolName.empty();
    if (isIn) {
      add(NativeReason::Tool, toolWord(m_state.tool, m_state.toolName) + " M6");
      add(NativeReason::Tool, fmt::format("D{}", m_state.edge));
      rise();  // it may be longer than the one before
    }
    const bool isNextOther =
        m_state.nextTool != m_state.tool || m_state.nextToolName != m_state.toolName;
    if (isNextOther && (m_state.nextTool > 0 || !m_state.nextToolName.empty())) {
      add(NativeReason::Tool, toolWord(m_state.nextTool, m_state.nextToolName));
    }
  }

  /// How the control moves holds until another block says otherwise; in their order.
  void setModes() {
    for (std::size_t part = 0; part < m_rest.part; ++part) {
      const auto* const native = std::get_if<job::NativeBlock>(&m_plan.parts[part]);
      if (native == nullptr || native->text.empty()) {
        continue;
      }
      if (native->reason == NativeReason::Mode) {
        add(NativeReason::Mode, native->text);
      } else if (native->reason == NativeReason::Other || leavesUnknownState(native->text)) {
        m_restart.notRestored.push_back(
            fmt::format("line {}: {}", native->place.line.value, native->source));
      }
    }
  }

  void setSpindle() {
    if (m_state.programmedPerMin > 0.0) {
      const double turns = m_state.spindleCommandPerMin;
      add(NativeReason::Spindle, fmt::format("S{:g}{}", m_state.programmedPerMin,
                                             turns > 0.0   ? " M3"
                                             : turns < 0.0 ? " M4"
                                                           : ""));
    }
  }

  void approach() {
    if (m_rest.toolMm && m_moves) {
      add(NativeReason::OtherMotion,
          "G0 G90 " + number('X', m_rest.toolMm->x) + ' ' + number('Y', m_rest.toolMm->y));
    }
    if (m_state.mist) {
      add(NativeReason::Coolant, "M7");
    }
    if (m_state.flood) {
      add(NativeReason::Coolant, "M8");
    }
    if (m_rest.toolMm && m_moves) {
      const double z = m_rest.toolMm->z;
      add(NativeReason::OtherMotion,
          z < safeMm() ? fmt::format("G1 G90 G94 {} F{}", number('Z', z), kApproachFeed)
                       : "G0 G90 " + number('Z', z));
    }
  }

  const job::Plan& m_plan;
  const machine::EquipmentState m_state;
  const streaming::JobRest& m_rest;
  bool m_moves;  ///< the tool has to be brought to its place
  Restart m_restart;
};

}  // namespace

Result<base::Vec3> zeroAt(const job::Plan& plan, const machine::MachineConfig& machine,
                          std::size_t part) {
  const Result<machine::DryRun> state = stateAt(plan, machine, part);
  return state ? Result<base::Vec3>(state->zeroMm) : base::fail(state.error());
}

Result<Restart> restartAt(const job::Plan& plan, const machine::MachineConfig& machine,
                          const streaming::JobRest& rest) {
  const Result<machine::DryRun> state = stateAt(plan, machine, rest.part);
  if (!state) {
    return base::fail(state.error());
  }
  return Restarter(plan, *state, rest).make();
}

streaming::JobRest restInSource(const Restart& job, const streaming::JobRest& rest) {
  const auto& parts = job.plan.parts;
  const auto inserted =
      static_cast<std::size_t>(std::find_if(parts.begin(), parts.end(),
                                            [](const job::Part& part) {
                                              const auto* const native =
                                                  std::get_if<job::NativeBlock>(&part);
                                              return native == nullptr || !native->isInserted;
                                            }) -
                               parts.begin());
  if (rest.part <= inserted && !rest.resume) {
    return job.rest;  // nothing of the source has been executed since
  }
  streaming::JobRest found = rest;
  found.part = rest.part - inserted + job.rest.part;
  return found;
}

Result<Restart> restartAtStretch(const job::Plan& plan, const machine::MachineConfig& machine,
                                 int stretch) {
  const auto is = [stretch](const job::Part& part) {
    const auto* const each = std::get_if<job::Stretch>(&part);
    return each != nullptr && each->number == stretch && stretch > 0;
  };
  const auto found = std::find_if(plan.parts.begin(), plan.parts.end(), is);
  if (found == plan.parts.end()) {
    return base::fail(
        StreamError::CannotResume,
        fmt::format("There is no stretch {}: the program has {}.", stretch, plan.stretchCount()),
        plan.program.name);
  }
  streaming::JobRest rest;
  rest.part = static_cast<std::size_t>(found - plan.parts.begin());
  const auto& begins = std::get<job::Stretch>(*found);
  if (begins.startIsKnown()) {
    rest.toolMm = begins.startMm;
  } else if (rest.part > 0) {
    // Else the first points would begin where the tool happens to stand.
    const Result<machine::DryRun> state = stateAt(plan, machine, rest.part);
    if (!state) {
      return base::fail(state.error());
    }
    const bool isPlaced = isPlacedBefore(plan, rest.part);
    if (!isPlaced &&
        !base::isFinite(plan.program.trajectory.points[begins.firstPoint].positionMm)) {
      return base::fail(
          StreamError::CannotResume,
          fmt::format("Where the tool stands before stretch {} is not known. {}", stretch,
                      stretch == firstStretchOf(plan) ? "Start the job from its beginning."
                                                      : "Choose an earlier stretch."),
          plan.program.name);
    }
    if (isPlaced) {
      rest.toolMm = state->axesMm - state->zeroMm;
    }
  }
  return restartAt(plan, machine, rest);
}

SetUp setUpOf(const job::Plan& plan, const machine::MachineConfig& machine) {
  const std::size_t part = firstMotionOf(plan);
  SetUp wanted;
  const Result<machine::DryRun> state = stateAt(plan, machine, part);
  if (!state) {
    return wanted;
  }
  const machine::EquipmentState& equipment = state->equipment;
  if (hasBefore(plan, part, NativeReason::Tool) &&
      (equipment.tool > 0 || !equipment.toolName.empty())) {
    wanted.tool = equipment.tool > 0 ? std::to_string(equipment.tool) : equipment.toolName;
  }
  if (hasBefore(plan, part, NativeReason::WorkOffset)) {
    wanted.workOffset = fmt::format("G{}", equipment.workOffset);
  }
  if (hasBefore(plan, part, NativeReason::Spindle)) {
    wanted.perMin = equipment.spindleCommandPerMin;
  }
  return wanted;
}

SetUp missingOf(const SetUp& wanted, const streaming::EquipmentSeen& seen) {
  constexpr double kSameSpeed = 0.01;  // share: a spindle does not turn as exactly as it is told
  SetUp missing;
  const bool isSeen = seen.tool || seen.toolName;
  const bool isIn = (seen.tool && std::to_string(*seen.tool) == wanted.tool) ||
                    (seen.toolName && base::toUpper(*seen.toolName) == base::toUpper(wanted.tool));
  if (isSeen && !isIn && !wanted.tool.empty()) {
    missing.tool = wanted.tool;
  }
  if (!wanted.workOffset.empty() && seen.workOffset && *seen.workOffset != wanted.workOffset) {
    missing.workOffset = wanted.workOffset;
  }
  const std::optional<double>& actual =
      seen.spindleSetPerMin ? seen.spindleSetPerMin : seen.spindlePerMin;
  if (wanted.perMin && actual) {
    const double speed = std::abs(*wanted.perMin);
    const bool isSpeed = std::abs(*actual - speed) <= kSameSpeed * speed;
    const bool isTurn = !seen.turn || *seen.turn == opcua::turnOf(*wanted.perMin);
    if (!isSpeed || !isTurn) {
      missing.perMin = wanted.perMin;
    }
  }
  return missing;
}

}  // namespace rivulet::forecast
