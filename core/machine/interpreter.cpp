// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "machine/sync_action.h"
#include "nc/syntax/language.h"

namespace rivulet::machine {

namespace {

/// Difference of the radii at start and end that is let pass (MD21000).
constexpr double kCircleErrorMm = 0.01;

nc::ExecutorOptions executorOptions(const InterpreterOptions& options) {
  return {.arcRadiusToleranceMm = kCircleErrorMm,
          .rotaryAxes = options.rotaryAxes,
          .refusesFurtherAxes = false,
          .knowsMachineCoordinates = true,
          .knowsWorkOffsets = true};
}

/// True if the words move nothing and change no mode of the path: spindle, tool, coolant, and what
/// says something of the program.
bool isWithoutEffect(const nc::Words& words) {
  return std::all_of(words.tokens.begin(), words.tokens.end(), [](const nc::Token& token) {
    return token.address != 0
               ? std::string_view("MSTDHUVW").find(token.address) != std::string_view::npos
               : nc::nameEffect(nc::Dialect::Sinumerik, base::toUpper(nc::tokenName(token))) ==
                     nc::NameEffect::None;
  });
}

template <class... Callables>
struct Overload : Callables... {
  using Callables::operator()...;
};
template <class... Callables>
Overload(Callables...) -> Overload<Callables...>;

}  // namespace

// --- values -----------------------------------------------------------------------------------

Interpreter::Values::Values(RParameters& parameters, const InterpreterOptions& options)
    : Variables(nc::sinumerikSemantics()), m_parameters(parameters), m_mainRun(options.mainRun) {
  if (options.cacheUntilStopre) {
    m_cache = m_parameters.values();
  }
}

nc::Expected<double> Interpreter::Values::r(int index) const {
  if (!m_parameters.has(index)) {
    return nc::fail(nc::FaultCode::NoSuchR, fmt::format("{}", index));
  }
  return m_cache.empty() ? m_parameters.value(index) : m_cache[static_cast<std::size_t>(index)];
}

nc::Expected<double> Interpreter::Values::mainR(int index) const {
  return r(index);
}

nc::Expected<nc::Value> Interpreter::Values::system(std::string_view name,
                                                    std::span<const nc::Value> indices) const {
  return m_mainRun == nullptr ? ValueSource::system(name, indices)
                              : systemValue(*m_mainRun, name, indices);
}

nc::Expected<void> Interpreter::Values::setR(int index, double value) {
  if (!m_parameters.has(index)) {
    return nc::fail(nc::FaultCode::NoSuchR, fmt::format("{}", index));
  }
  if (std::isnan(value)) {
    return {};  // the fault that left no value ends the program
  }
  m_parameters.set(index, value);
  if (!m_cache.empty()) {
    m_cache[static_cast<std::size_t>(index)] = value;
  }
  return {};
}

void Interpreter::Values::refresh() {
  if (!m_cache.empty()) {
    m_cache = m_parameters.values();
  }
}

// --- statement by statement -------------------------------------------------------------------

Interpreter::Interpreter(std::shared_ptr<const nc::Tree> program, RParameters& parameters,
                         const InterpreterOptions& options)
    : m_values(parameters, options),
      m_flow(std::move(program), m_values, options.library),
      m_motions({options.startMm, options.rapidMmPerS, options.roundingMm}, m_alarms),
      m_executorOptions(executorOptions(options)),
      m_executor(nc::languageOf(nc::Dialect::Sinumerik), m_executorOptions, m_values,
                 {m_motions, m_alarms, m_observer}) {
  nc::ModalState& state = m_executor.state();
  state.motion = nc::Motion::Line;  // reset default
  state.feedMmPerS = options.feedMmPerS;
  state.feedDegPerS = options.feedMmPerS;
  state.dynamics = options.dynamics;
  m_executor.start().programmedMm = options.startMm;
  m_executor.start().rotaryDeg = options.startDeg;
}

void Interpreter::refresh() {
  m_hasStopped = true;
  m_values.refresh();
}

Prepared Interpreter::next() {
  const auto isSilent = [](const nc::Statement& statement) {
    const auto* const words = std::get_if<nc::Words>(&statement.what);
    return words != nullptr && isWithoutEffect(*words);
  };
  // A block may hold several statements (R1=0 R2=0 G1 X5): those that neither move nor jump are
  // executed together with what follows them in the same block.
  for (;;) {
    const nc::Statement* const statement = m_flow.due();
    if (statement == nullptr) {
      return m_flow.depth() > 1 ? leave()  // a subprogram may end without M17
                                : Alarm{12080, "The program has no end (M30 or M17 is missing)."};
    }
    if (isSilent(*statement)) {
      m_flow.step();
      Prepared prepared = execute(*statement);
      if (std::holds_alternative<Alarm>(prepared)) {
        return prepared;
      }
      continue;
    }
    if (statement->readsMainRun && !m_hasStopped) {
      return PreparedStopre{};  // implicit: the value belongs to the moment the axes stand
    }
    m_hasStopped = false;
    m_flow.step();
    Prepared prepared = execute(*statement);
    while (m_flow.continuesBlock() && isSilent(*m_flow.due())) {
      m_flow.step();
    }
    const auto* const nothing = std::get_if<PreparedNothing>(&prepared);
    if (nothing == nullptr || nothing->jumped || !m_flow.continuesBlock()) {
      return prepared;
    }
  }
}

Prepared Interpreter::execute(const nc::Statement& statement) {
  return std::visit(
      Overload{
          [&](const nc::Words& s) { return executeWords(s, statement.place.line); },
          [](const nc::PreprocessingStop&) -> Prepared { return PreparedStopre{}; },
          [this](const nc::Message& s) -> Prepared {
            if (!s.text) {
              return PreparedMessage{};
            }
            const nc::Expected<nc::Value> text =
                nc::evaluate(*s.text, m_values, m_values.semantics());
            return text ? Prepared(PreparedMessage{nc::textOf(*text)}) : alarmOf(text.error());
          },
          [this](const nc::Synchronized& s) -> Prepared {
            nc::Expected<SyncAction> action = frozen(s, m_values);
            if (!action) {
              return alarmOf(action.error());
            }
            return PreparedSync{std::make_shared<const SyncAction>(std::move(*action))};
          },
          [this](const nc::Cancel& s) -> Prepared {
            const nc::Expected<double> id = m_values.number(s.id);
            if (!id) {
              return alarmOf(id.error());
            }
            return PreparedCancel{static_cast<int>(std::lround(std::clamp(*id, 0.0, 255.0)))};
          },
          [this](const nc::Return&) { return leave(); },
          [](const nc::End&) -> Prepared { return PreparedEnd{}; },
          [](const nc::Faulty& s) -> Prepared { return alarmOf(s.fault); },
          [&](const auto&) -> Prepared {
            const nc::Expected<bool> jumped = m_flow.execute(statement);
            return jumped ? Prepared(PreparedNothing{*jumped}) : alarmOf(jumped.error());
          },
      },
      statement.what);
}

Prepared Interpreter::leave() {
  return m_flow.leave() ? Prepared(PreparedNothing{true}) : PreparedEnd{};
}

// --- words ------------------------------------------------------------------------------------

Prepared Interpreter::executeWords(const nc::Words& words, base::LineNumber line) {
  nc::BlockWords block;
  block.line = line;
  for (const nc::Token& token : words.tokens) {
    m_executor.read(token, block);
  }
  m_executor.execute(block);
  Prepared prepared = m_motions.take(m_executor.state());
  if (std::optional<Alarm> alarm = m_alarms.take()) {
    return *std::move(alarm);
  }
  return prepared;
}

}  // namespace rivulet::machine
