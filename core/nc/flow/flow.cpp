// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/flow/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "nc/limits.h"

namespace rivulet::nc {

Flow::Flow(std::shared_ptr<const Tree> program, Variables& variables, Library library,
           CallObserver* calls)
    : m_variables(variables), m_library(std::move(library)), m_calls(calls) {
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
  m_isStuck = false;
  while (!at.ranges.empty() && at.next == at.ranges.back().end) {
    Range& range = at.ranges.back();
    m_moved = true;
    ++m_rounds;
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
  if (target <= m_stepped) {
    std::uint64_t& before = at.jumpsBack[m_stepped];
    m_isStuck = before == changes();
    before = changes();
  }
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
  if (const auto* way = std::get_if<Branch>(&statement.what)) {
    return branch(*way);
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

Expected<bool> Flow::branch(const Branch& branch) {
  if (!branch.condition) {
    if (level().unknown.erase(branch.target) > 0) {
      return false;
    }
    goTo(branch.target);
    return true;
  }
  level().unknown.erase(m_stepped);
  const Expected<bool> stays = holds(branch.condition);
  if (!stays) {
    level().unknown.insert(m_stepped);
    return stays;
  }
  if (!*stays) {
    goTo(branch.target);
  }
  return !*stays;
}

Expected<bool> Flow::jump(const Jump& jump) {
  const Expected<bool> goes = holds(jump.condition);
  if (!goes || !*goes) {
    return goes;
  }
  const Tree& program = *level().program;
  std::string label = jump.label;
  if (jump.number) {
    const Expected<double> number = m_variables.number(*jump.number);
    if (!number) {
      return fail(number.error());
    }
    label = fmt::format("N{:.0f}", *number);
  }
  std::optional<std::size_t> target = program.find(label, jump.direction, m_stepped);
  if (!target && !jump.number) {
    // The label may be the text in a variable.
    const Expected<Value> text = m_variables.variable(jump.label, {});
    if (text && std::holds_alternative<std::string>(*text)) {
      target = program.find(base::toUpper(std::get<std::string>(*text)), jump.direction, m_stepped);
    }
  }
  if (!target) {
    return jump.direction == JumpDirection::ForwardNoAlarm ? Expected<bool>(false)
                                                           : fail(FaultCode::TargetMissing, label);
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
  ++m_rounds;
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
  if (call.isLocal) {
    const std::shared_ptr<const Tree> own = level().program;
    const auto begin = own->find(name, JumpDirection::ForwardThenBackward, m_stepped);
    if (!begin) {
      return fail(FaultCode::TargetMissing, name);
    }
    enter(own, *begin, std::nullopt, *times - 1);
    level().isLocal = true;
    return true;
  }
  std::shared_ptr<const Tree> program = m_library ? m_library(name) : nullptr;
  if (!program) {
    return fail(call.isPlainName ? FaultCode::NeitherNameNorProgram : FaultCode::SubprogramMissing,
                name);
  }
  Expected<std::optional<Scope>> scope = scopeOf(call, *program);
  if (!scope) {
    return fail(scope.error());
  }
  if (*times == 0) {
    return false;
  }
  enter(std::move(program), 0, std::move(*scope), *times - 1);
  level().keepsValues = call.keepsValues;
  return true;
}

Expected<std::optional<Scope>> Flow::scopeOf(const Call& call, const Tree& program) const {
  if (call.sharesVariables) {
    return std::optional<Scope>();
  }
  if (!call.isNumbered) {
    Expected<Scope> passed = m_variables.passed(program.parameters, call.arguments);
    return passed ? Expected<std::optional<Scope>>(std::move(*passed)) : fail(passed.error());
  }
  Scope scope;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    if (call.arguments[i]) {
      const Expected<double> value = m_variables.number(*call.arguments[i]);
      if (!value) {
        return fail(value.error());
      }
      scope.numbers[static_cast<int>(i + 1)] = *value;
    }
  }
  return std::optional(std::move(scope));
}

void Flow::enter(std::shared_ptr<const Tree> program, std::size_t begin, std::optional<Scope> scope,
                 int callsLeft) {
  Level entered;
  entered.begin = begin;
  entered.next = begin;
  entered.program = std::move(program);
  entered.callsLeft = callsLeft;
  if (scope) {
    m_variables.enter(*scope);
  }
  entered.scope = std::move(scope);
  m_levels.push_back(std::move(entered));
  m_moved = true;
  ++m_rounds;
  if (m_calls != nullptr) {
    m_calls->entered(*level().program);
  }
}

bool Flow::leaveProgram() {
  while (level().isLocal) {
    static_cast<void>(leave());
  }
  return leave();
}

bool Flow::leave() {
  return leave(true);
}

Expected<bool> Flow::leaveTo(const std::string& label, bool stays) {
  if (!stays) {
    static_cast<void>(leave(false));
  }
  const std::optional<std::size_t> target =
      level().program->find(label, JumpDirection::ForwardThenBackward, level().next);
  if (!target) {
    return fail(FaultCode::TargetMissing, label);
  }
  if (stays) {
    goTo(*target);
  } else {
    level().next = *target;
  }
  return true;
}

bool Flow::leave(bool again) {
  if (m_levels.size() == 1) {
    return false;
  }
  if (again && level().keepsValues && level().callsLeft > 0) {
    Level next;
    next.program = level().program;
    next.next = next.begin = level().begin;
    next.scope = std::move(level().scope);
    next.keepsValues = true;
    next.callsLeft = level().callsLeft - 1;
    level() = std::move(next);
    m_moved = true;
    ++m_rounds;
    return true;
  }
  Level left = std::move(m_levels.back());
  m_levels.pop_back();
  if (left.scope) {
    m_variables.leave();
  }
  m_moved = true;
  if (m_calls != nullptr) {
    m_calls->left();
  }
  if (again && left.callsLeft > 0) {
    enter(std::move(left.program), left.begin, std::move(left.scope), left.callsLeft - 1);
  }
  return true;
}

}  // namespace rivulet::nc
