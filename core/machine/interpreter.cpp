// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"

namespace rivulet::machine {

namespace {

/// Programs within programs.
constexpr std::size_t kLevelsMax = 12;
constexpr double kMmPerInch = 25.4;
constexpr double kIndexMax = 1e6;
/// G0 of rotary axes alone: only their own limits bound it.
constexpr double kRapidDegPerS = 1e6;

template <class... Callables>
struct Overload : Callables... {
  using Callables::operator()...;
};
template <class... Callables>
Overload(Callables...) -> Overload<Callables...>;

/// How often, from P= or P5; once where nothing is said.
int roundsOf(double times) {
  return static_cast<int>(std::clamp(std::round(times), 0.0, 9999.0));
}

}  // namespace

Interpreter::Interpreter(std::shared_ptr<const NcProgram> program, RParameters& parameters,
                         const InterpreterOptions& options)
    : m_parameters(parameters),
      m_mainRun(options.mainRun),
      m_library(options.library),
      m_endMm(options.startMm),
      m_programmedMm(options.startMm),
      m_endDeg(options.startDeg),
      m_rotaryAxes(options.rotaryAxes),
      m_feedMmPerS(options.feedMmPerS),
      m_feedDegPerS(options.feedMmPerS),
      m_rapidMmPerS(options.rapidMmPerS),
      m_roundingMm(options.roundingMm),
      m_dynamics(options.dynamics) {
  if (options.cacheUntilStopre) {
    m_cache = m_parameters.values();
  }
  enter(std::move(program), {});
}

void Interpreter::enter(std::shared_ptr<const NcProgram> program,
                        const std::vector<double>& arguments) {
  Level level;
  level.variables.assign(static_cast<std::size_t>(program->slotCount()), 0.0);
  level.arguments = arguments;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    level.variables[static_cast<std::size_t>(program->parameters()[i])] = arguments[i];
  }
  level.program = std::move(program);
  m_levels.push_back(std::move(level));
}

std::optional<double> Interpreter::View::value(int index) const {
  if (!m_owner.m_parameters.has(index)) {
    return std::nullopt;
  }
  return m_owner.m_cache.empty() ? m_owner.m_parameters.value(index)
                                 : m_owner.m_cache[static_cast<std::size_t>(index)];
}

std::optional<double> Interpreter::View::local(int slot, int element) const {
  const Level& level = m_owner.m_levels.back();
  const auto place = static_cast<std::size_t>(slot) + static_cast<std::size_t>(element);
  if (element < 0 || (element > 0 && element >= level.program->elementsOf(slot)) ||
      place >= level.variables.size()) {
    return std::nullopt;
  }
  return level.variables[place];
}

std::optional<double> Interpreter::View::system(SystemVariable variable, int index) const {
  return m_owner.m_mainRun == nullptr ? std::nullopt
                                      : m_owner.m_mainRun->systemValue(variable, index);
}

void Interpreter::refresh() {
  m_hasStopped = true;
  if (!m_cache.empty()) {
    m_cache = m_parameters.values();
  }
}

Prepared Interpreter::next() {
  // A block may hold several statements (R1=0 R2=0 G1 X5): those that neither move nor jump are
  // executed together with what follows them in the same block.
  for (;;) {
    const std::vector<Statement>& statements = level().program->statements();
    if (level().next >= statements.size()) {
      if (m_levels.size() > 1) {
        return leave();  // a subprogram may end without M17
      }
      return Alarm{12080, "The program has no end (M30 or M17 is missing)."};
    }
    const std::size_t at = level().next;
    if (statements[at].readsMainRun && !m_hasStopped) {
      return PreparedStopre{};  // implicit: the value belongs to the moment the axes stand
    }
    m_hasStopped = false;
    ++level().next;
    const std::size_t depth = m_levels.size();
    Prepared prepared = execute(statements[at]);
    if (m_levels.size() != depth) {
      return prepared;
    }
    const bool goesOn = level().next == at + 1 && level().next < statements.size() &&
                        !statements[level().next].beginsBlock &&
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
          [this](const LocalAssignStatement& s) { return assignLocal(s); },
          [this](const FillStatement& s) { return fill(s); },
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
          [this](const RepeatStatement& s) { return repeat(s); },
          [this](const CallStatement& s) { return call(s); },
          [this](const FrameStatement& s) { return setFrame(s); },
          [this](const SyncStatement& s) { return synchronize(s); },
          [this](const CancelStatement& s) -> Prepared {
            Alarm alarm;
            const std::optional<double> id = s.id.evaluate(View(*this), alarm);
            if (!id) {
              return alarm;
            }
            return PreparedCancel{static_cast<int>(std::lround(std::clamp(*id, 0.0, 255.0)))};
          },
          [this](const ReturnStatement&) { return leave(); },
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
  if (std::abs(rounded) > kIndexMax || !m_parameters.has(static_cast<int>(rounded))) {
    return Alarm{17020, fmt::format("R[{}] does not exist.", *index)};
  }
  const int cell = static_cast<int>(rounded);
  m_parameters.set(cell, *value);
  if (!m_cache.empty()) {
    m_cache[static_cast<std::size_t>(cell)] = *value;
  }
  return PreparedNothing{};
}

Prepared Interpreter::assignLocal(const LocalAssignStatement& statement) {
  Alarm alarm;
  const View view(*this);
  double element = 0.0;
  if (statement.element) {
    const std::optional<double> index = statement.element->evaluate(view, alarm);
    if (!index) {
      return alarm;
    }
    element = std::round(*index);
    if (element < 0.0 || element >= level().program->elementsOf(statement.slot)) {
      return Alarm{17020, fmt::format("The array has no element {}.", *index)};
    }
  }
  const std::optional<double> value = statement.value.evaluate(view, alarm);
  if (!value) {
    return alarm;
  }
  level().variables[static_cast<std::size_t>(statement.slot) + static_cast<std::size_t>(element)] =
      level().program->isInteger(statement.slot) ? std::round(*value) : *value;
  return PreparedNothing{};
}

Prepared Interpreter::fill(const FillStatement& statement) {
  Alarm alarm;
  const auto elements = static_cast<std::size_t>(level().program->elementsOf(statement.slot));
  if (statement.values.size() > elements) {
    return Alarm{17020, "The array has fewer elements than values are given."};
  }
  for (std::size_t i = 0; i < elements; ++i) {
    const std::size_t from = statement.repeats ? 0 : i;
    if (from >= statement.values.size()) {
      break;
    }
    if (const auto& expression = statement.values[from]) {
      const std::optional<double> value = expression->evaluate(View(*this), alarm);
      if (!value) {
        return alarm;
      }
      level().variables[static_cast<std::size_t>(statement.slot) + i] =
          level().program->isInteger(statement.slot) ? std::round(*value) : *value;
    }
  }
  return PreparedNothing{};
}

std::optional<Alarm> Interpreter::modes(const MotionStatement& statement) {
  Alarm alarm;
  m_mode = statement.mode.value_or(m_mode);
  m_plane = statement.plane.value_or(m_plane);
  m_absolute = statement.absolute.value_or(m_absolute);
  m_inches = statement.inches.value_or(m_inches);
  m_dynamics = statement.dynamics.value_or(m_dynamics);
  m_end = statement.end.value_or(m_end);
  m_rounding = statement.rounding.value_or(m_rounding);
  if (statement.roundingMm) {
    const std::optional<double> distance = statement.roundingMm->evaluate(View(*this), alarm);
    if (!distance) {
      return alarm;
    }
    m_adisMm = std::max(0.0, *distance);
  }
  if (statement.feedMmPerMin) {
    const std::optional<double> feed = statement.feedMmPerMin->evaluate(View(*this), alarm);
    if (!feed) {
      return alarm;
    }
    if (!(*feed > 0.0)) {
      return Alarm{14800, fmt::format("The programmed path speed {} is not positive.", *feed)};
    }
    m_feedMmPerS = base::mmPerSFromMmPerMin(m_inches ? kMmPerInch * *feed : *feed);
    m_feedDegPerS = *feed / 60.0;  // deg/min, in inches too
  }
  return std::nullopt;
}

Prepared Interpreter::move(const MotionStatement& statement, base::LineNumber line) {
  if (std::optional<Alarm> alarm = modes(statement)) {
    return *std::move(alarm);
  }
  const bool arcWords = statement.isArc() || statement.radius || statement.openingAngle ||
                        statement.through[0] || statement.through[1] || statement.through[2];
  bool turns = false;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    turns = turns || (statement.rotary[axis] && m_rotaryAxes[axis]);
  }
  if (!statement.axes[0] && !statement.axes[1] && !statement.axes[2] && !arcWords && !turns) {
    return PreparedNothing{};
  }
  Alarm alarm;
  const double unit = m_inches ? kMmPerInch : 1.0;
  // Where a word leads, from where its axis stands. Nothing: `alarm` says why.
  const auto resolve = [&](const Coordinate& word, double from, double scale) {
    const std::optional<double> value = word.value.evaluate(View(*this), alarm);
    const bool absolute = word.reference == Coordinate::Reference::Modal
                              ? m_absolute
                              : word.reference == Coordinate::Reference::Absolute;
    return value ? std::optional(absolute ? scale * *value : from + scale * *value) : std::nullopt;
  };
  const base::Vec3 programmedFrom = m_programmedMm;
  base::Vec3 target = m_endMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!statement.axes[axis]) {
      continue;
    }
    const std::optional<double> programmed =
        resolve(*statement.axes[axis], m_programmedMm[axis], unit);
    if (!programmed) {
      return alarm;
    }
    m_programmedMm.set(axis, *programmed);
    target.set(axis, m_programmedMm[axis] + m_translationMm[axis]);
  }
  if (m_isRotated) {
    target = rotated(m_programmedMm) + m_translationMm;  // every axis may have to move
  }
  base::RotaryDeg targetDeg = m_endDeg;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (!statement.rotary[axis] || !m_rotaryAxes[axis]) {
      continue;
    }
    const std::optional<double> degrees = resolve(*statement.rotary[axis], m_endDeg[axis], 1.0);
    if (!degrees) {
      return alarm;
    }
    targetDeg[axis] = *degrees;
  }
  const base::Vec3 from = m_endMm;
  PreparedMotion motion;
  if (m_mode != PathMode::Rapid && m_mode != PathMode::Line) {
    const auto arc = arcOf(statement, from, target, programmedFrom);
    if (const Alarm* problem = std::get_if<Alarm>(&arc)) {
      return *problem;
    }
    motion.arc = std::get<ArcPath>(arc);
  }
  if (m_mode != PathMode::Rapid && m_feedMmPerS <= 0.0) {
    return Alarm{10860, "No feed is programmed."};
  }
  m_endMm = target;
  m_endDeg = targetDeg;
  motion.line = line;
  motion.targetMm = target;
  motion.targetDeg = targetDeg;
  motion.feedDegPerS = m_mode == PathMode::Rapid ? kRapidDegPerS : m_feedDegPerS;
  motion.feedMmPerS = m_mode == PathMode::Rapid ? m_rapidMmPerS : m_feedMmPerS;
  motion.end = statement.exactStopOnce ? BlockEnd::ExactStop : m_end;
  motion.rounding = m_rounding;
  motion.roundingMm = m_rounding == RoundingKind::Distance ? m_adisMm : m_roundingMm;
  motion.dynamics = m_dynamics;
  return motion;
}

std::variant<ArcPath, Alarm> Interpreter::arcOf(const MotionStatement& statement, base::Vec3 fromMm,
                                                base::Vec3 toMm, base::Vec3 programmedFromMm) {
  Alarm alarm;
  const View view(*this);
  const double unit = m_inches ? kMmPerInch : 1.0;
  if (m_mode == PathMode::Through) {
    base::Vec3 through = programmedFromMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (statement.through[axis]) {
        const std::optional<double> value = statement.through[axis]->evaluate(view, alarm);
        if (!value) {
          return alarm;
        }
        through.set(axis, m_absolute ? unit * *value : through[axis] + unit * *value);
      }
    }
    return arcThrough(fromMm, rotated(through) + m_translationMm, toMm);
  }
  ArcEnds ends{fromMm, toMm, m_plane, m_mode == PathMode::Clockwise, 0};
  if (m_isRotated && m_plane != Plane::XY) {
    return Alarm{12550, "Arcs outside G17 cannot be programmed in a rotated frame here."};
  }
  if (statement.fullTurns) {
    const std::optional<double> turns = statement.fullTurns->evaluate(view, alarm);
    if (!turns) {
      return alarm;
    }
    ends.fullTurns = static_cast<int>(std::clamp(std::round(*turns), 0.0, 999.0));
  }
  if (statement.radius || statement.openingAngle) {
    const auto& word = statement.radius ? statement.radius : statement.openingAngle;
    const std::optional<double> value = word->evaluate(view, alarm);
    if (!value) {
      return alarm;
    }
    return statement.radius ? arcWithRadius(ends, unit * *value) : arcWithAngle(ends, *value);
  }
  if (!statement.isArc()) {
    return Alarm{14040, "The circle has neither centre nor radius."};
  }
  base::Vec3 offset{};
  base::Vec3 centre = fromMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!statement.centre[axis]) {
      continue;
    }
    const std::optional<double> value = statement.centre[axis]->value.evaluate(view, alarm);
    if (!value) {
      return alarm;
    }
    // I J K count from the start point, whatever G90 and G91 say.
    if (statement.centre[axis]->reference == Coordinate::Reference::Absolute) {
      offset.set(axis, unit * *value - programmedFromMm[axis]);
    } else {
      offset.set(axis, unit * *value);
    }
  }
  // What lies across the plane is no part of the centre.
  const base::Vec3 normal = normalOf(m_plane);
  const base::Vec3 inPlane = offset - base::dot(offset, normal) * normal;
  return arcAboutCentre(ends, centre + rotated(inPlane));
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
      level().program->findLabel(statement.label, statement.direction, level().next - 1);
  if (!target) {
    if (statement.direction == JumpDirection::ForwardNoAlarm) {
      return PreparedNothing{};
    }
    return Alarm{14080, fmt::format("The jump destination {} was not found.", statement.label)};
  }
  level().next = *target;
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
  level().next = statement.target;
  return PreparedNothing{true};
}

Prepared Interpreter::repeat(const RepeatStatement& statement) {
  const std::size_t at = level().next - 1;
  auto round = level().repeats.find(at);
  if (round == level().repeats.end()) {
    double times = 1.0;
    if (statement.times) {
      Alarm alarm;
      const std::optional<double> value = statement.times->evaluate(View(*this), alarm);
      if (!value) {
        return alarm;
      }
      times = *value;
    }
    round = level().repeats.emplace(at, roundsOf(times)).first;
  }
  if (round->second-- == 0) {
    level().repeats.erase(round);
    return PreparedNothing{};
  }
  const std::optional<std::size_t> target =
      level().program->findLabel(statement.label, JumpDirection::Backward, at);
  if (!target) {
    return Alarm{14080,
                 fmt::format("The label {} of REPEAT was not found before it.", statement.label)};
  }
  level().next = *target;
  return PreparedNothing{true};
}

Prepared Interpreter::call(const CallStatement& statement) {
  if (m_levels.size() == kLevelsMax) {
    return Alarm{14011, "Programs call each other too deep."};
  }
  Alarm alarm;
  int rounds = 1;
  if (statement.times) {
    const std::optional<double> times = statement.times->evaluate(View(*this), alarm);
    if (!times) {
      return alarm;
    }
    rounds = roundsOf(*times);
  }
  std::vector<double> arguments;
  for (const Expression& argument : statement.arguments) {
    const std::optional<double> value = argument.evaluate(View(*this), alarm);
    if (!value) {
      return alarm;
    }
    arguments.push_back(*value);
  }
  const std::shared_ptr<const NcProgram> program = m_library ? m_library(statement.name) : nullptr;
  if (!program && statement.isPlainName) {
    return Alarm{12550, fmt::format("The name \"{}\" is not defined, and there is no program of "
                                    "this name.",
                                    statement.name)};
  }
  if (!program) {
    return Alarm{14011, fmt::format("The program {} does not exist.", statement.name)};
  }
  if (arguments.size() > program->parameters().size()) {
    return Alarm{12150,
                 fmt::format("{} takes {} values.", statement.name, program->parameters().size())};
  }
  if (rounds == 0) {
    return PreparedNothing{};
  }
  enter(program, arguments);
  level().callsLeft = rounds - 1;
  return PreparedNothing{true};
}

Prepared Interpreter::leave() {
  if (m_levels.size() == 1) {
    return PreparedEnd{};
  }
  Level left = std::move(m_levels.back());
  m_levels.pop_back();
  if (left.callsLeft > 0) {
    enter(left.program, left.arguments);
    level().callsLeft = left.callsLeft - 1;
  }
  return PreparedNothing{true};
}

base::Vec3 Interpreter::rotated(base::Vec3 vector) const {
  return vector.x * m_rotation[0] + vector.y * m_rotation[1] + vector.z * m_rotation[2];
}

Prepared Interpreter::setFrame(const FrameStatement& statement) {
  Alarm alarm;
  const View view(*this);
  base::Vec3 values{};
  std::size_t given = 0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (statement.axes[axis]) {
      const std::optional<double> value = statement.axes[axis]->evaluate(view, alarm);
      if (!value) {
        return alarm;
      }
      values.set(axis, *value);
      ++given;
    }
  }
  if (!statement.additive) {
    // An absolute frame instruction takes the place of all that was programmed before.
    m_rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    m_translationMm = {};
    m_isRotated = false;
  }
  if (statement.kind == FrameStatement::Kind::Translate) {
    m_translationMm = m_translationMm + rotated((m_inches ? kMmPerInch : 1.0) * values);
    return PreparedNothing{};
  }
  double degrees = values.z;
  if (statement.inPlane) {
    const std::optional<double> angle = statement.inPlane->evaluate(view, alarm);
    if (!angle) {
      return alarm;
    }
    degrees = *angle;
  }
  const bool aboutZ =
      statement.inPlane ? m_plane == Plane::XY : !statement.axes[0] && !statement.axes[1];
  if (!aboutZ || (statement.inPlane && given > 0)) {
    return Alarm{12550, "Frames are rotated about Z only here."};
  }
  if (degrees != 0.0) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const base::Vec3 x = std::cos(angle) * m_rotation[0] + std::sin(angle) * m_rotation[1];
    const base::Vec3 y = std::cos(angle) * m_rotation[1] - std::sin(angle) * m_rotation[0];
    m_rotation[0] = x;
    m_rotation[1] = y;
    m_isRotated = true;
  }
  return PreparedNothing{};
}

Prepared Interpreter::synchronize(const SyncStatement& statement) {
  auto action = std::make_shared<SyncAction>(statement.action);
  Alarm alarm;
  const View view(*this);
  bool frozen = !action->condition || action->condition->freeze(view, alarm);
  for (SyncAssignment& assignment : action->assignments) {
    frozen = frozen && assignment.index.freeze(view, alarm) && assignment.value.freeze(view, alarm);
  }
  if (!frozen) {
    return alarm;
  }
  return PreparedSync{std::move(action)};
}

}  // namespace rivulet::machine
