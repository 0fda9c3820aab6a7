// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "machine/sync_action.h"
#include "nc/syntax/language.h"

namespace rivulet::machine {

namespace {

/// Difference of the radii at start and end that is let pass (MD21000).
constexpr double kCircleErrorMm = 0.01;
/// G41 and G42 without a tool.
constexpr int kNoToolRadius = 10750;
/// For what this machine does not make.
constexpr int kNotMade = 12550;

nc::ExecutorOptions executorOptions(const InterpreterOptions& options) {
  nc::ExecutorOptions made{.arcRadiusToleranceMm = kCircleErrorMm,
                           .rotaryAxes = options.rotaryAxes,
                           .refusesFurtherAxes = false,
                           .knowsMachineCoordinates = true,
                           .knowsWorkOffsets = true};
  if (options.machine != nullptr) {
    made.workOffsetsMm = options.machine->workOffsetsMm;
    made.fixedPointsMm = options.machine->fixedPointsMm;
    made.compensatesRadius = options.machine->tools.has_value();
    if (options.machine->spindle) {
      made.spindlePerMinMax = options.machine->spindle->speedPerMinMax;
    }
  }
  return made;
}

/// True if the words move nothing and change no mode of the path: spindle, tool, coolant, and what
/// says something of the program. What they do on the machine is prepared all the same.
bool isWithoutEffect(const nc::Words& words) {
  return std::all_of(words.tokens.begin(), words.tokens.end(), [](const nc::Token& token) {
    return token.address != 0
               ? std::string_view("MSTDHUVW").find(token.address) != std::string_view::npos
               : nc::nameEffect(nc::Dialect::Sinumerik, base::toUpper(nc::tokenName(token))) ==
                     nc::NameEffect::None;
  });
}

/// CYCLE800 swivels a plane; without arguments it swivels it back.
bool swivels(const nc::Call& call) {
  return call.name == "CYCLE800";
}
bool swivelsBack(const nc::Call& call) {
  return std::none_of(call.arguments.begin(), call.arguments.end(),
                      [](const auto& argument) { return argument.has_value(); });
}

/// ASPLINE and CSPLINE go through the points that are programmed. How the control bends the way
/// between them is not modelled: this machine goes straight.
bool isSplineThroughPoints(std::string_view name) {
  return name == "ASPLINE" || name == "CSPLINE";
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
  if (options.machine != nullptr) {
    m_offsetsMm = options.machine->workOffsetsMm;
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
  if (base::toUpper(name) == "$P_TOOLR") {
    return nc::Value(m_toolRadiusMm);
  }
  const auto* const number = indices.empty() ? nullptr : std::get_if<double>(&indices.front());
  if (base::toUpper(name) == "$P_TOOLL" && number != nullptr && *number == 1.0) {
    return nc::Value(m_toolLengthMm);
  }
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

/// $P_UIFR[1,X,TR]: the offset of G54. It holds from the next G54 on. Rotary axes and turns have
/// none here.
nc::Expected<void> Interpreter::Values::setSystem(std::string_view name,
                                                  std::span<const nc::Value> indices,
                                                  double value) {
  const auto text = [&](std::size_t index) {
    return index < indices.size() ? base::toUpper(nc::textOf(indices[index])) : std::string();
  };
  const std::optional<int> number = base::parseInteger(text(0));
  constexpr int kLast = 99;
  if (base::toUpper(name) != "$P_UIFR" || indices.size() != 3 || !number || *number < 0 ||
      *number > kLast) {
    return Variables::setSystem(name, indices, value);
  }
  const std::string axis = text(1);
  const std::size_t at = axis.size() == 1 ? std::string_view("XYZ").find(axis) : axis.npos;
  if (at >= base::kAxisCount || text(2) != "TR") {
    return value == 0.0 ? nc::Expected<void>() : Variables::setSystem(name, indices, value);
  }
  constexpr int kSimple = 4;  // G54 to G57
  const int key = *number == 0         ? kNoWorkOffsetKey
                  : *number <= kSimple ? 530 + 10 * *number
                                       : 5000 + 10 * *number;
  m_offsetsMm[key].set(at, value);
  m_hasNewOffsets = true;
  return {};
}

std::optional<std::map<int, base::Vec3>> Interpreter::Values::takeOffsets() {
  return std::exchange(m_hasNewOffsets, false) ? std::optional(m_offsetsMm) : std::nullopt;
}

void Interpreter::Values::refresh() {
  if (!m_cache.empty()) {
    m_cache = m_parameters.values();
  }
}

InterpreterOptions interpreterOptions(const MachineConfig& config,
                                      const base::AxisPosition& start) {
  InterpreterOptions options;
  options.startMm = start.mm;
  options.startDeg = start.deg;
  options.rotaryAxes = config.rotarySet();
  options.rapidMmPerS = config.rapidMmPerS;
  options.feedMmPerS = config.defaultFeedMmPerS;
  options.roundingMm = config.roundingMm;
  options.dynamics = config.resetDynamics;
  options.machine = &config;
  if (config.tools) {
    options.tool = config.tools->inSpindle;
  }
  return options;
}

// --- statement by statement -------------------------------------------------------------------

Interpreter::Interpreter(std::shared_ptr<const nc::Tree> program, RParameters& parameters,
                         const InterpreterOptions& options)
    : m_values(parameters, options),
      m_flow(std::move(program), m_values, options.library, this),
      m_motions({options.startMm, options.rapidMmPerS, options.roundingMm}, m_alarms),
      m_executorOptions(executorOptions(options)),
      m_executor(nc::languageOf(nc::Dialect::Sinumerik), m_executorOptions, m_values,
                 {m_motions, m_alarms, m_observer}),
      m_machineWords(options.machine, options.tool, m_alarms),
      m_corners(options.startMm),
      m_compensation(options.startMm),
      m_library(options.library) {
  nc::ModalState& state = m_executor.state();
  state.motion = nc::Motion::Line;  // reset default
  state.feedMmPerS = options.feedMmPerS;
  state.feedDegPerS = options.feedMmPerS;
  state.dynamics = options.dynamics;
  if (options.machine != nullptr) {
    state.workOffset = kNoWorkOffsetKey;
    state.workOffsetMm = options.machine->workOffsetMm(kNoWorkOffsetKey);
  }
  m_executor.start().programmedMm = options.startMm - state.workOffsetMm;
  m_executor.start().zeroMm = state.workOffsetMm;
  m_executor.start().rotaryDeg = options.startDeg;
}

void Interpreter::refresh() {
  m_hasStopped = true;
  m_values.refresh();
}

Prepared Interpreter::next() {
  const auto due = [this] {
    Prepared prepared = std::move(m_due.front());
    m_due.pop_front();
    return prepared;
  };
  if (!m_due.empty()) {
    return due();
  }
  Prepared prepared = nextBlock();
  const bool ends = std::holds_alternative<PreparedStopre>(prepared) ||
                    std::holds_alternative<PreparedEnd>(prepared) ||
                    std::holds_alternative<Alarm>(prepared);
  if (!ends || (!m_compensation.isActive() && !m_corners.isActive())) {
    return prepared;
  }
  // The axes go to the end of what was held back before they stand.
  finishPath();
  m_due.push_back(std::move(prepared));
  return due();
}

Prepared Interpreter::nextBlock() {
  if (!m_steps.empty()) {
    return nextStep();
  }
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
      if (!std::holds_alternative<PreparedNothing>(prepared)) {
        return prepared;  // an alarm, or what the machine does
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
    if (nothing == nullptr || nothing->jumped || !m_steps.empty() || !m_flow.continuesBlock()) {
      return prepared;
    }
  }
}

Prepared Interpreter::execute(const nc::Statement& statement) {
  m_line = statement.place.line;
  m_values.setTool(m_machineWords.hasEdge() ? m_machineWords.radiusMm() : 0.0,
                   m_executor.state().toolLengthMm);
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
          [&](const nc::Call& s) -> Prepared {
            if (isCycle(s)) {
              return callCycle(s, statement.place.line);
            }
            if (swivels(s)) {
              return swivel(s, statement.place.line);
            }
            const nc::Expected<bool> jumped = m_flow.execute(statement);
            return jumped ? Prepared(PreparedNothing{*jumped}) : alarmOf(jumped.error());
          },
          [this](const nc::RepeatedCall& s) { return setModalCall(s); },
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

/// X, Y and Z are those of the swivelled plane from here on, as with TRAORI those of the tip: how
/// the axes of the machine get there is not modelled, and its rotary axes stand.
Prepared Interpreter::swivel(const nc::Call& call, base::LineNumber line) const {
  const base::RotarySet& rotary = m_executorOptions.rotaryAxes;
  const bool canSwivel = std::find(rotary.begin(), rotary.end(), true) != rotary.end();
  return canSwivel || swivelsBack(call)
             ? Prepared(PreparedNothing{})
             : Alarm{kNotMade, fmt::format("Line {}: this machine has no rotary axes for CYCLE800.",
                                           line.value)};
}

Prepared Interpreter::leave() {
  const bool left = m_flow.leave();
  m_modalDepth = m_flow.depth() > m_modalDepth ? m_modalDepth : 0;
  return left ? Prepared(PreparedNothing{true}) : PreparedEnd{};
}

// --- cycles -----------------------------------------------------------------------------------

/// A program of this name on the control comes first, as cycles of the user do.
bool Interpreter::isCycle(const nc::Call& call) const {
  return (nc::isDrillingCycle(call.name) || nc::isHolePattern(call.name) ||
          nc::isMillingCycle(call.name)) &&
         !(m_library && m_library(call.name));
}

nc::Expected<Interpreter::CycleCall> Interpreter::evaluated(const nc::Call& call) const {
  CycleCall made{call.name, {}};
  for (const std::optional<nc::Expression>& argument : call.arguments) {
    // Texts (the name of a contour, _HIDE of CYCLE801) move nothing.
    const bool isNumber = argument && argument->op != nc::Op::Text;
    const nc::Expected<double> value = isNumber ? m_values.number(*argument) : 0.0;
    if (!value) {
      return nc::fail(value.error());
    }
    made.arguments.push_back(isNumber ? std::optional(*value) : std::nullopt);
  }
  return made;
}

Prepared Interpreter::setModalCall(const nc::RepeatedCall& call) {
  m_modalCycle.reset();
  m_modalCall.reset();
  if (call.call && nc::isDrillingCycle(call.call->name) && isCycle(*call.call)) {
    nc::Expected<CycleCall> cycle = evaluated(*call.call);
    if (!cycle) {
      return alarmOf(cycle.error());
    }
    m_modalCycle = *std::move(cycle);
  } else {
    m_modalCall = call.call;
  }
  return PreparedNothing{};
}

Prepared Interpreter::callCycle(const nc::Call& call, base::LineNumber line) {
  constexpr int kNoDrillingCycle = 62100;
  const nc::Expected<CycleCall> cycle = evaluated(call);
  if (!cycle) {
    return alarmOf(cycle.error());
  }
  m_cycleLine = line;
  const base::Vec3 placeMm = m_executor.start().programmedMm;
  std::optional<Alarm> alarm;
  if (!nc::isHolePattern(cycle->name)) {
    alarm = addSteps(*cycle, placeMm);
  } else if (!m_modalCycle) {
    alarm = Alarm{kNoDrillingCycle,
                  fmt::format("Line {}: no drilling cycle is active for {}. Write MCALL with "
                              "a cycle before it.",
                              line.value, cycle->name)};
  } else {
    base::Vec3 fromMm = placeMm;
    for (const base::Vec3 hole : nc::holesOf(cycle->name, cycle->arguments, cycleStart(placeMm))) {
      base::Vec3 aboveMm = hole;
      const std::size_t third = m_executor.state().planeThirdAxis();
      aboveMm.set(third, fromMm[third]);
      m_steps.push_back({.kind = nc::CycleStep::Kind::Rapid, .toMm = aboveMm});
      alarm = alarm ? alarm : addSteps(*m_modalCycle, aboveMm);
      const auto last = std::find_if(m_steps.rbegin(), m_steps.rend(), nc::moves);
      fromMm = last->toMm;
    }
  }
  return alarm ? Prepared(*std::move(alarm)) : PreparedNothing{};
}

/// After a block that has moved the axes.
Prepared Interpreter::callModally(base::LineNumber line) {
  m_cycleLine = line;
  if (m_modalCycle) {
    std::optional<Alarm> alarm = addSteps(*m_modalCycle, m_executor.start().programmedMm);
    return alarm ? Prepared(*std::move(alarm)) : PreparedNothing{};
  }
  if (!m_modalCall || m_modalDepth > 0) {
    return PreparedNothing{};
  }
  nc::Statement statement;
  statement.what = *m_modalCall;
  const std::size_t depth = m_flow.depth();
  const nc::Expected<bool> called = m_flow.execute(statement);
  m_modalDepth = called && *called ? depth : 0;
  return called ? Prepared(PreparedNothing{*called}) : alarmOf(called.error());
}

nc::CycleStart Interpreter::cycleStart(base::Vec3 placeMm) {
  const nc::ModalState& state = m_executor.state();
  return {placeMm, state.planeFirstAxis, state.lengthFactor, state.spindlePerMin,
          m_machineWords.hasEdge() ? m_machineWords.radiusMm() : 0.0};
}

std::optional<Alarm> Interpreter::addSteps(const CycleCall& call, base::Vec3 placeMm) {
  constexpr int kCompensationActive = 61815;
  if (m_executor.state().compensationSide != 0) {
    return Alarm{kCompensationActive, fmt::format("Line {}: G40 must be active before {}.",
                                                  m_cycleLine.value, call.name)};
  }
  const nc::CycleStart start = cycleStart(placeMm);
  const auto steps = nc::isMillingCycle(call.name)
                         ? nc::expandMilling(call.name, call.arguments, start)
                         : nc::expandCycle(call.name, call.arguments, start);
  if (!steps) {
    return Alarm{steps.error().alarm,
                 fmt::format("Line {}: the parameter {} of {} does not fit the others.",
                             m_cycleLine.value, steps.error().parameter, call.name)};
  }
  m_steps.insert(m_steps.end(), steps->begin(), steps->end());
  return std::nullopt;
}

Prepared Interpreter::nextStep() {
  const nc::CycleStep step = m_steps.front();
  m_steps.pop_front();
  using Kind = nc::CycleStep::Kind;
  switch (step.kind) {
    case Kind::Rapid:
      m_executor.moveTo(step.toMm, std::nullopt, m_cycleLine);
      break;
    case Kind::Feed:
      m_executor.moveTo(
          step.toMm,
          step.feedMmPerS > 0.0 ? step.feedMmPerS : step.feedFactor * m_executor.feedMmPerS(),
          m_cycleLine);
      break;
    case Kind::Dwell:
      return PreparedDwell{m_cycleLine, base::fromSeconds(step.seconds)};
    case Kind::Spindle: {
      BlockMachineWords words;
      words.functions.push_back(step.function);
      if (step.spindlePerMin > 0.0) {
        words.speedPerMin = step.spindlePerMin;
      }
      m_machineWords.apply(words, false, m_executor.state());
      break;
    }
  }
  Prepared prepared = m_motions.take(m_executor.state());
  if (std::optional<Alarm> alarm = m_alarms.take()) {
    return *std::move(alarm);
  }
  return inOrder(std::move(prepared), m_cycleLine);
}

// --- words ------------------------------------------------------------------------------------

Prepared Interpreter::executeWords(const nc::Words& words, base::LineNumber line) {
  nc::BlockWords block;
  block.line = line;
  m_corner.reset();
  for (const nc::Token& token : words.tokens) {
    if (!readValue(token)) {
      m_executor.read(token, block);
    }
  }
  selectWorkOffset(words);
  const BlockMachineWords machineWords = m_motions.takeWords();
  m_machineWords.apply(machineWords, block.dwell, m_executor.state());
  m_executor.execute(block);
  if (!m_corner && m_roundingMm > 0.0 && m_executor.state().motion != nc::Motion::Rapid) {
    m_corner = ContourCorner{ContourCorner::Kind::Radius, m_roundingMm};
  }
  Prepared prepared = m_motions.take(m_executor.state());
  if (std::optional<Alarm> alarm = m_alarms.take()) {
    return *std::move(alarm);
  }
  const base::RotarySet& rotary = m_executorOptions.rotaryAxes;
  if (!m_executor.state().tipWord.empty() &&
      std::find(rotary.begin(), rotary.end(), true) == rotary.end()) {
    return Alarm{kNotMade,
                 fmt::format("Line {}: this machine has no rotary axes for TRAORI.", line.value)};
  }
  if (block.g.compensationMode != nullptr &&
      block.g.compensationMode->function != nc::G::CompensationOff && !m_machineWords.hasEdge()) {
    return Alarm{kNoToolRadius, fmt::format("Line {}: the tool radius is to be compensated, but no "
                                            "tool or edge is active.",
                                            line.value)};
  }
  const bool moves = std::holds_alternative<PreparedMotion>(prepared);
  Prepared first = inOrder(std::move(prepared), line);
  if (moves && (m_modalCycle || m_modalCall)) {
    Prepared called = callModally(line);
    if (std::holds_alternative<Alarm>(called)) {
      m_due.push_back(std::move(called));
    }
  }
  return first;
}

/// A work offset that has been changed holds from the next G54 and the like on.
void Interpreter::selectWorkOffset(const nc::Words& words) {
  const bool selects =
      std::any_of(words.tokens.begin(), words.tokens.end(), [](const nc::Token& token) {
        const double key = token.value * 10.0;
        return token.address == 'G' && key >= 0.0 && key < static_cast<double>(nc::kGKeys) &&
               nc::gTable(nc::Dialect::Sinumerik)[static_cast<std::size_t>(key)] ==
                   nc::GEffect::WorkOffset;
      });
  if (!selects) {
    return;
  }
  if (auto offsetsMm = m_values.takeOffsets()) {
    m_executorOptions.workOffsetsMm = *std::move(offsetsMm);
    m_machineWords.workOffsetsChanged();
  }
}

/// What the machine does before the motion, the motion, and a stop after it.
Prepared Interpreter::inOrder(Prepared prepared, base::LineNumber line) {
  MachineWords::Actions actions = m_machineWords.take(m_executor.state());
  const auto act = [&](std::vector<MachineAction> made) {
    if (!made.empty()) {
      append(PreparedActions{line, std::move(made), m_executor.state().zeroMm()});
    }
  };
  act(std::move(actions.before));
  if (!std::holds_alternative<PreparedNothing>(prepared)) {
    append(std::move(prepared));
  }
  act(std::move(actions.after));
  if (m_due.empty()) {
    return PreparedNothing{};
  }
  Prepared first = std::move(m_due.front());
  m_due.pop_front();
  return first;
}

/// RND, RNDM, CHF, CHR, OFFN and TOFFL, ASPLINE and CSPLINE. @return false: another word
bool Interpreter::readValue(const nc::Token& token) {
  if (token.kind == nc::TokenKind::Name && isSplineThroughPoints(base::toUpper(token.text))) {
    m_executor.state().motion = nc::Motion::Line;
    return true;
  }
  const bool isNamed =
      token.kind == nc::TokenKind::NamedValue || token.kind == nc::TokenKind::Assignment;
  const std::string name = isNamed ? base::toUpper(nc::tokenName(token)) : std::string();
  const bool isModal = name == "RNDM";
  const bool isOffset = name == "TOFFL";
  const bool isAllowance = name == "OFFN" || isOffset;
  if (!isModal && !isAllowance && name != "RND" && name != "CHF" && name != "CHR") {
    return false;
  }
  const nc::Expression* const calculated = token.calculated();
  const nc::Expected<double> value =
      calculated != nullptr ? m_values.number(*calculated) : nc::Expected<double>(token.value);
  if (!value || !(*value >= 0.0 || isAllowance)) {
    m_alarms.raise(value ? Alarm{kNotMade, name + " must not be negative."}
                         : alarmOf(value.error()));
    return true;
  }
  const double mm = *value * m_executor.state().lengthFactor;
  if (isOffset) {
    m_machineWords.setLengthOffset(mm);
  } else if (isAllowance) {
    m_allowanceMm = mm;
  } else if (isModal) {
    m_roundingMm = mm;
  } else {
    m_corner = ContourCorner{name == "RND"   ? ContourCorner::Kind::Radius
                             : name == "CHF" ? ContourCorner::Kind::Chamfer
                                             : ContourCorner::Kind::Cut,
                             mm};
  }
  return true;
}

/// What is held back at a corner or beside the path, to its end.
void Interpreter::finishPath() {
  std::deque<Prepared> ready;
  m_corners.finish(ready);
  for (Prepared& each : ready) {
    compensate(std::move(each));
  }
  m_compensation.finish(m_due);
}

base::Vec3 Interpreter::planeNormal() {
  const nc::ModalState& state = m_executor.state();
  const nc::Frame& frame = m_executor.start().frame;
  base::Vec3 first;
  base::Vec3 second;
  first.set(state.planeFirstAxis, 1.0);
  second.set(state.planeSecondAxis(), 1.0);
  return base::cross(frame.turned(first), frame.turned(second));
}

/// To what is due, with the corner at its end.
void Interpreter::append(Prepared prepared) {
  const bool moves = std::holds_alternative<PreparedMotion>(prepared);
  const std::optional<ContourCorner> corner =
      moves ? std::exchange(m_corner, std::nullopt) : std::nullopt;
  if (!corner && !m_corners.isActive()) {
    m_corners.pass(prepared);
    compensate(std::move(prepared));
    return;
  }
  const nc::ModalState& state = m_executor.state();
  const base::Vec3 normal = planeNormal();
  std::deque<Prepared> ready;
  std::optional<Alarm> alarm =
      m_corners.add(std::move(prepared), corner, state.planeFirstAxis, ready);
  if (std::abs(normal[state.planeThirdAxis()]) < (1.0 - 1e-9) * base::norm(normal)) {
    alarm = Alarm{kNotMade, "Corners are rounded and chamfered in a plane of the machine only."};
  }
  for (Prepared& each : ready) {
    compensate(std::move(each));
  }
  if (alarm) {
    finishPath();
    m_due.emplace_back(*std::move(alarm));
  }
}

/// Beside the path if the radius of the tool is compensated.
void Interpreter::compensate(Prepared prepared) {
  const nc::ModalState& state = m_executor.state();
  if (state.compensationSide == 0 && !m_compensation.isActive()) {
    m_compensation.pass(prepared);
    m_due.push_back(std::move(prepared));
    return;
  }
  // A mirrored contour has the tool on its other side.
  const base::Vec3 normal = planeNormal();
  const double across = normal[state.planeThirdAxis()];
  const Compensation wanted{across < 0.0 ? -state.compensationSide : state.compensationSide,
                            m_machineWords.radiusMm() + m_allowanceMm, state.planeFirstAxis,
                            state.goesAroundStart, state.cornersIntersect};
  std::optional<Alarm> alarm;
  if (std::abs(across) < (1.0 - 1e-9) * base::norm(normal)) {
    alarm = Alarm{kNotMade, "The tool radius is compensated in a plane of the machine only."};
  } else {
    alarm = m_compensation.add(std::move(prepared), wanted, m_due);
  }
  if (alarm) {
    m_compensation.finish(m_due);
    m_due.emplace_back(*std::move(alarm));
  }
}

}  // namespace rivulet::machine
