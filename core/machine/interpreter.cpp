// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace rivulet::machine {

namespace {

template <class... Callables>
struct Overload : Callables... {
  using Callables::operator()...;
};
template <class... Callables>
Overload(Callables...) -> Overload<Callables...>;

}  // namespace

Interpreter::Interpreter(std::shared_ptr<const NcProgram> program, RParameters& parameters,
                         const InterpreterOptions& options)
    : m_program(std::move(program)),
      m_parameters(parameters),
      m_endMm(options.startMm),
      m_rapidMmPerS(options.rapidMmPerS),
      m_roundingMm(options.roundingMm),
      m_dynamics(options.dynamics) {
  if (options.cacheUntilStopre) {
    m_cache = m_parameters.values();
  }
}

std::optional<double> Interpreter::View::value(int index) const {
  if (!m_owner.m_parameters.has(index)) {
    return std::nullopt;
  }
  return m_owner.m_cache.empty() ? m_owner.m_parameters.value(index)
                                 : m_owner.m_cache[static_cast<std::size_t>(index)];
}

void Interpreter::refresh() {
  if (!m_cache.empty()) {
    m_cache = m_parameters.values();
  }
}

Prepared Interpreter::next() {
  const std::vector<Statement>& statements = m_program->statements();
  // A block may hold several statements (R1=0 R2=0 G1 X5): those that neither move nor jump are
  // executed together with what follows them in the same block.
  for (;;) {
    if (m_next >= statements.size()) {
      return Alarm{12080, "The program has no end (M30 or M17 is missing)."};
    }
    const std::size_t at = m_next++;
    Prepared prepared = execute(statements[at]);
    const bool goesOn = m_next == at + 1 && m_next < statements.size() &&
                        !statements[m_next].beginsBlock &&
                        std::holds_alternative<PreparedNothing>(prepared);
    if (!goesOn) {
      return prepared;
    }
  }
}

Prepared Interpreter::execute(const Statement& statement) {
  return std::visit(
      Overload{
          [this](const AssignStatement& s) { return assign(s); },
          [&](const MotionStatement& s) { return move(s, statement.line); },
          [&](const DwellStatement& s) -> Prepared {
            Alarm alarm;
            const std::optional<double> seconds = s.seconds.evaluate(View(*this), alarm);
            if (!seconds) {
              return alarm;
            }
            return PreparedDwell{statement.line, base::fromSeconds(std::clamp(*seconds, 0.0, 1e6))};
          },
          [](const StopreStatement&) -> Prepared { return PreparedStopre{}; },
          [](const MessageStatement& s) -> Prepared { return PreparedMessage{s.text}; },
          [this](const JumpStatement& s) { return jump(s); },
          [this](const BranchStatement& s) { return branch(s); },
          [](const EndStatement&) -> Prepared { return PreparedEnd{}; },
          [](const AlarmStatement& s) -> Prepared { return s.alarm; },
      },
      statement.what);
}

Prepared Interpreter::assign(const AssignStatement& statement) {
  Alarm alarm;
  const View view(*this);
  const std::optional<double> index = statement.index.evaluate(view, alarm);
  const std::optional<double> value = index ? statement.value.evaluate(view, alarm) : std::nullopt;
  if (!value) {
    return alarm;
  }
  const double rounded = std::round(*index);
  if (std::abs(rounded) > 1e6 || !m_parameters.has(static_cast<int>(rounded))) {
    return Alarm{17020, fmt::format("R[{}] does not exist.", *index)};
  }
  const int cell = static_cast<int>(rounded);
  m_parameters.set(cell, *value);
  if (!m_cache.empty()) {
    m_cache[static_cast<std::size_t>(cell)] = *value;
  }
  return PreparedNothing{};
}

Prepared Interpreter::move(const MotionStatement& statement, base::LineNumber line) {
  Alarm alarm;
  const View view(*this);
  m_rapid = statement.rapid.value_or(m_rapid);
  m_absolute = statement.absolute.value_or(m_absolute);
  m_exactStop = statement.exactStop.value_or(m_exactStop);
  if (statement.feedMmPerMin) {
    const std::optional<double> feed = statement.feedMmPerMin->evaluate(view, alarm);
    if (!feed) {
      return alarm;
    }
    if (!(*feed > 0.0)) {
      return Alarm{14800, fmt::format("The programmed path speed {} is not positive.", *feed)};
    }
    m_feedMmPerS = base::mmPerSFromMmPerMin(*feed);
  }
  if (!statement.moves()) {
    return PreparedNothing{};
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!statement.axes[axis]) {
      continue;
    }
    const std::optional<double> value = statement.axes[axis]->evaluate(view, alarm);
    if (!value) {
      return alarm;
    }
    m_endMm.set(axis, m_absolute ? *value : m_endMm[axis] + *value);
  }
  if (!m_rapid && m_feedMmPerS <= 0.0) {
    return Alarm{10860, "No feed is programmed."};
  }
  PreparedMotion motion;
  motion.line = line;
  motion.targetMm = m_endMm;
  motion.feedMmPerS = m_rapid ? m_rapidMmPerS : m_feedMmPerS;
  motion.end = m_exactStop || statement.exactStopOnce ? BlockEnd::ExactStop : BlockEnd::Rounded;
  motion.roundingMm = m_roundingMm;
  motion.dynamics = m_dynamics;
  return motion;
}

Prepared Interpreter::jump(const JumpStatement& statement) {
  if (statement.condition) {
    Alarm alarm;
    const std::optional<double> condition = statement.condition->evaluate(View(*this), alarm);
    if (!condition) {
      return alarm;
    }
    if (*condition == 0.0) {
      return PreparedNothing{};
    }
  }
  const std::optional<std::size_t> target =
      m_program->findLabel(statement.label, statement.direction, m_next - 1);
  if (!target) {
    if (statement.direction == JumpDirection::ForwardNoAlarm) {
      return PreparedNothing{};
    }
    return Alarm{14080, fmt::format("The jump destination {} was not found.", statement.label)};
  }
  m_next = *target;
  return PreparedNothing{true};
}

Prepared Interpreter::branch(const BranchStatement& statement) {
  if (statement.condition) {
    Alarm alarm;
    const std::optional<double> condition = statement.condition->evaluate(View(*this), alarm);
    if (!condition) {
      return alarm;
    }
    if (*condition != 0.0) {
      return PreparedNothing{};
    }
  }
  m_next = statement.target;
  return PreparedNothing{true};
}

}  // namespace rivulet::machine
