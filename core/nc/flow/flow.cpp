// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/flow/flow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"

namespace rivulet::nc {

namespace {

/// Program levels of the control: NC Programming 12/2019 (6FC5398-2EP40-0BA0), 3.2.1.3.
constexpr std::size_t kLevelsMax = 16;
constexpr double kRoundsMax = 9999.0;

}  // namespace

Flow::Flow(std::shared_ptr<const Tree> program, Variables& variables, Library library)
    : m_variables(variables), m_library(std::move(library)) {
  Level main;
  main.program = std::move(program);
  m_levels.push_back(std::move(main));
}

const Statement* Flow::due() const {
  const Level& level = m_levels.back();
  return level.next < level.program->statements.size() ? &level.program->statements[level.next]
                                                       : nullptr;
}

void Flow::step() {
  Level& at = level();
  m_stepped = at.next++;
  m_moved = false;
  while (!at.ranges.empty() && at.next == at.ranges.back().end) {
    Range& range = at.ranges.back();
    m_moved = true;
    if (range.left-- > 0) {
      at.next = range.begin;
      break;
    }
    at.next = range.back;
    at.ranges.pop_back();
  }
}

bool Flow::continuesBlock() const {
  const Statement* const next = due();
  return !m_moved && next != nullptr && !next->beginsBlock;
}

void Flow::goTo(std::size_t target) {
  Level& at = level();
  at.next = target;
  m_moved = true;
  // A jump out of what is repeated ends the repetition.
  while (!at.ranges.empty() && (target < at.ranges.back().begin || target > at.ranges.back().end)) {
    at.ranges.pop_back();
  }
}

Expected<bool> Flow::holds(const std::optional<Expression>& condition) const {
  if (!condition) {
    return true;
  }
  const Expected<double> value = m_variables.number(*condition);
  return value ? Expected<bool>(*value != 0.0) : fail(value.error());
}

Expected<int> Flow::rounds(const std::optional<Expression>& times) const {
  const Expected<double> value = times ? m_variables.number(*times) : Expected<double>(1.0);
  return value ? Expected<int>(static_cast<int>(std::clamp(std::round(*value), 0.0, kRoundsMax)))
               : fail(value.error());
}

Expected<bool> Flow::execute(const Statement& statement) {
  const auto done = [](const Expected<void>& result) {
    return result ? Expected<bool>(false) : fail(result.error());
  };
  if (const auto* assignment = std::get_if<Assignment>(&statement.what)) {
    return done(m_variables.assign(*assignment));
  }
  if (const auto* definition = std::get_if<Definition>(&statement.what)) {
    return done(m_variables.define(*definition));
  }
  if (const auto* branch = std::get_if<Branch>(&statement.what)) {
    const Expected<bool> stays = branch->condition ? holds(branch->condition) : Expected<bool>(false);
    if (stays && !*stays) {
      goTo(branch->target);
    }
    return stays ? Expected<bool>(!*stays) : stays;
  }
  if (const auto* to = std::get_if<Jump>(&statement.what)) {
    return jump(*to);
  }
  if (const auto* again = std::get_if<RepeatLabel>(&statement.what)) {
    return repeat(*again);
  }
  if (const auto* subprogram = std::get_if<Call>(&statement.what)) {
    return call(*subprogram);
  }
  return false;
}

Expected<bool> Flow::jump(const Jump& jump) {
  const Expected<bool> goes = holds(jump.condition);
  if (!goes || !*goes) {
    return goes;
  }
  const Tree& program = *level().program;
  std::optional<std::size_t> target = program.find(jump.label, jump.direction, m_stepped);
  if (!target) {
    // The label may be the text in a variable.
    const Expected<Value> text = m_variables.variable(jump.label, {});
    if (text && std::holds_alternative<std::string>(*text)) {
      target = program.find(base::toUpper(std::get<std::string>(*text)), jump.direction, m_stepped);
    }
  }
  if (!target) {
    return jump.direction == JumpDirection::ForwardNoAlarm
               ? Expected<bool>(false)
               : fail(FaultCode::TargetMissing, jump.label);
  }
  goTo(*target);
  return true;
}

Expected<bool> Flow::repeat(const RepeatLabel& repeat) {
  const std::size_t at = m_stepped;
  const Tree& program = *level().program;
  std::optional<std::size_t> begin = program.find(repeat.label, JumpDirection::Backward, at);
  if (!begin) {
    begin = program.find(repeat.label, JumpDirection::Forward, at);
  }
  if (!begin) {
    return fail(FaultCode::TargetMissing, repeat.label);
  }
  const bool toHere = repeat.endLabel.empty() && !repeat.isBlockOnly;
  auto round = level().repeats.find(at);
  if (!toHere || round == level().repeats.end()) {
    const Expected<int> times = rounds(repeat.times);
    if (!times) {
      return fail(times.error());
    }
    if (!toHere) {
      const std::optional<std::size_t> last =
          repeat.isBlockOnly ? begin
                             : program.find(repeat.endLabel, JumpDirection::Forward, *begin);
      if (!last) {
        return fail(FaultCode::TargetMissing, repeat.endLabel);
      }
      if (*times == 0) {
        return false;
      }
      level().ranges.push_back({*begin, program.nextBlock(*last), at + 1, *times - 1});
      goTo(*begin);
      return true;
    }
    round = level().repeats.emplace(at, *times).first;
  }
  if (round->second-- == 0) {
    level().repeats.erase(round);
    return false;
  }
  goTo(*begin);
  return true;
}

Expected<bool> Flow::call(const Call& call) {
  if (m_levels.size() == kLevelsMax) {
    return fail(FaultCode::CallsTooDeep);
  }
  const Expected<int> times = rounds(call.times);
  if (!times) {
    return fail(times.error());
  }
  std::string name = call.name;
  if (call.computed) {
    const Expected<Value> text = evaluate(*call.computed, m_variables, m_variables.semantics());
    if (!text) {
      return fail(text.error());
    }
    name = base::toUpper(textOf(*text));
  }
  std::shared_ptr<const Tree> program = m_library ? m_library(name) : nullptr;
  if (!program) {
    return fail(call.isPlainName ? FaultCode::NeitherNameNorProgram : FaultCode::SubprogramMissing,
                name);
  }
  Expected<Scope> scope = m_variables.passed(program->parameters, call.arguments);
  if (!scope) {
    return fail(scope.error());
  }
  if (*times == 0) {
    return false;
  }
  enter(std::move(program), std::move(*scope), *times - 1);
  return true;
}

void Flow::enter(std::shared_ptr<const Tree> program, Scope scope, int callsLeft) {
  Level entered;
  entered.program = std::move(program);
  entered.callsLeft = callsLeft;
  m_variables.enter(scope);
  entered.scope = std::move(scope);
  m_levels.push_back(std::move(entered));
  m_moved = true;
}

bool Flow::leave() {
  if (m_levels.size() == 1) {
    return false;
  }
  Level left = std::move(m_levels.back());
  m_levels.pop_back();
  m_variables.leave();
  m_moved = true;
  if (left.callsLeft > 0) {
    enter(std::move(left.program), std::move(left.scope), left.callsLeft - 1);
  }
  return true;
}

}  // namespace rivulet::nc
