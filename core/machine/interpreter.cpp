// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "machine/sync_action.h"

namespace rivulet::machine {

namespace {

constexpr int kEndPointError = 14040;
/// Difference of the radii at start and end that is let pass (MD21000).
constexpr double kCircleErrorMm = 0.01;
constexpr double kMmPerInch = 25.4;
/// G0 of rotary axes alone: only their own limits bound it.
constexpr double kRapidDegPerS = 1e6;

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
      m_endMm(options.startMm),
      m_endDeg(options.startDeg),
      m_rotaryAxes(options.rotaryAxes),
      m_feedMmPerS(options.feedMmPerS),
      m_feedDegPerS(options.feedMmPerS),
      m_rapidMmPerS(options.rapidMmPerS),
      m_roundingMm(options.roundingMm),
      m_dynamics(options.dynamics) {
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
          [&](const nc::Words& s) { return move(s, statement.place.line); },
          [&](const nc::Dwell& s) -> Prepared {
            const nc::Expected<double> seconds = m_values.number(s.seconds);
            if (!seconds) {
              return alarmOf(seconds.error());
            }
            return PreparedDwell{statement.place.line,
                                 base::fromSeconds(std::clamp(*seconds, 0.0, 1e6))};
          },
          [](const nc::PreprocessingStop&) -> Prepared { return PreparedStopre{}; },
          [this](const nc::Message& s) -> Prepared {
            if (!s.text) {
              return PreparedMessage{};
            }
            const nc::Expected<nc::Value> text =
                nc::evaluate(*s.text, m_values, m_values.semantics());
            return text ? Prepared(PreparedMessage{nc::textOf(*text)}) : alarmOf(text.error());
          },
          [this](const nc::FrameStatement& s) { return setFrame(s); },
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

// --- motion -----------------------------------------------------------------------------------

double Interpreter::unit() const {
  return m_inches ? kMmPerInch : 1.0;
}

std::optional<Alarm> Interpreter::modes(const MotionWords& words) {
  m_mode = words.mode.value_or(m_mode);
  m_plane = words.plane.value_or(m_plane);
  m_absolute = words.absolute.value_or(m_absolute);
  m_inches = words.inches.value_or(m_inches);
  m_dynamics = words.dynamics.value_or(m_dynamics);
  m_end = words.end.value_or(m_end);
  m_rounding = words.rounding.value_or(m_rounding);
  if (words.roundingMm) {
    m_adisMm = std::max(0.0, words.roundingMm->value);
  }
  if (words.feedMmPerMin) {
    const double feed = words.feedMmPerMin->value;
    if (!(feed > 0.0)) {
      return Alarm{14800, fmt::format("The programmed path speed {} is not positive.", feed)};
    }
    m_feedMmPerS = base::mmPerSFromMmPerMin(unit() * feed);
    m_feedDegPerS = feed / 60.0;  // deg/min, in inches too
  }
  return std::nullopt;
}

Prepared Interpreter::move(const nc::Words& words, base::LineNumber line) {
  const std::variant<MotionWords, Alarm> gathered =
      gather(words, [this](const nc::Expression& value) { return m_values.number(value); });
  if (const Alarm* alarm = std::get_if<Alarm>(&gathered)) {
    return *alarm;
  }
  const MotionWords& block = std::get<MotionWords>(gathered);
  if (std::optional<Alarm> alarm = modes(block)) {
    return *std::move(alarm);
  }
  const bool arcWords = block.isArc() || block.radius || block.openingAngle || block.through[0] ||
                        block.through[1] || block.through[2];
  bool turns = false;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    turns = turns || (block.rotary[axis] && m_rotaryAxes[axis]);
  }
  if (!block.axes[0] && !block.axes[1] && !block.axes[2] && !arcWords && !turns) {
    return PreparedNothing{};
  }
  // Where a word leads, from where its axis stands.
  const auto resolve = [this](const Coordinate& word, double from, double scale) {
    const bool absolute = word.reference == nc::Word::Reference::Modal
                              ? m_absolute
                              : word.reference == nc::Word::Reference::Absolute;
    return (absolute ? 0.0 : from) + scale * word.value;
  };
  const nc::Frame frame = block.suppressesFrame ? nc::Frame{} : m_frame;
  const base::Vec3 programmedFrom = frame.toProgrammed(m_endMm);
  base::Vec3 programmed = programmedFrom;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (block.axes[axis]) {
      const double origin = m_incrementFromMm[axis].value_or(programmedFrom[axis]);
      programmed.set(axis, resolve(*block.axes[axis], origin, unit()));
      m_incrementFromMm[axis].reset();
    }
  }
  base::RotaryDeg targetDeg = m_endDeg;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (block.rotary[axis] && m_rotaryAxes[axis]) {
      targetDeg[axis] = resolve(*block.rotary[axis], m_endDeg[axis], 1.0);
    }
  }
  PreparedMotion motion;
  if (m_mode != PathMode::Rapid && m_mode != PathMode::Line) {
    const auto arc = arcOf(block, frame, programmedFrom, programmed);
    if (const Alarm* problem = std::get_if<Alarm>(&arc)) {
      return *problem;
    }
    motion.arc = std::get<ArcPath>(arc);
  }
  base::Vec3 target = frame.toWorkpiece(programmed);
  for (std::size_t axis = 0; axis < base::kAxisCount && frame.isAligned(); ++axis) {
    if (programmed[axis] == programmedFrom[axis] && !block.axes[axis]) {
      target.set(axis, m_endMm[axis]);  // to the last bit
    }
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
  motion.end = block.exactStopOnce ? BlockEnd::ExactStop : m_end;
  motion.rounding = m_rounding;
  motion.roundingMm = m_rounding == RoundingKind::Distance ? m_adisMm : m_roundingMm;
  motion.dynamics = m_dynamics;
  return motion;
}

std::variant<ArcPath, Alarm> Interpreter::arcOf(const MotionWords& words, const nc::Frame& frame,
                                                base::Vec3 fromMm, base::Vec3& toMm) const {
  const auto placed = [&frame](ArcPath arc) -> std::variant<ArcPath, Alarm> {
    if (!frame.keepsCircles()) {
      return Alarm{kEndPointError, "A circle is no circle any more in a frame scaled unevenly."};
    }
    const base::Vec3 axis = frame.turned(arc.axis);
    arc.centreMm = frame.toWorkpiece(arc.centreMm);
    arc.axis = ((frame.mirrors() ? -1.0 : 1.0) / base::norm(axis)) * axis;
    return arc;
  };
  if (m_mode == PathMode::Through) {
    base::Vec3 through = fromMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.through[axis]) {
        const double value = unit() * words.through[axis]->value;
        through.set(axis, m_absolute ? value : through[axis] + value);
      }
    }
    const std::optional<ArcPath> arc = nc::arcThrough(fromMm, through, toMm);
    return arc ? placed(*arc)
               : Alarm{kEndPointError, "Circle end-point error: the three points lie on a line."};
  }
  nc::Arc arc;
  arc.startMm = fromMm;
  arc.endMm = toMm;
  arc.firstAxis = m_plane;
  arc.clockwise = m_mode == PathMode::Clockwise;
  arc.turns = words.fullTurns
                  ? static_cast<int>(std::clamp(std::round(words.fullTurns->value), 0.0, 999.0))
                  : 0;
  nc::ArcWords given;
  given.endIsGiven = words.axes[m_plane] || words.axes[(m_plane + 1) % base::kAxisCount];
  if (words.radius) {
    given.radius = unit() * words.radius->value;
  } else if (words.openingAngle) {
    given.degrees = words.openingAngle->value;
  }
  for (const std::size_t axis : {m_plane, (m_plane + 1) % base::kAxisCount}) {
    // I J K count from the start point, whatever G90 and G91 say; one of two may be left out.
    if (words.isArc() && !words.radius) {
      const Coordinate word = words.centre[axis].value_or(Coordinate{});
      given.centre[axis] = unit() * word.value;
      given.centreIsAbsolute[axis] = word.reference == nc::Word::Reference::Absolute;
    }
  }
  const nc::ResolvedArc resolved = nc::resolveArc(arc, given, kCircleErrorMm);
  if (resolved.problem != nc::ArcProblem::None) {
    return Alarm{kEndPointError,
                 fmt::format("Circle end-point error: {}.", nc::describe(resolved.problem))};
  }
  toMm = resolved.arc.endMm;
  return placed(nc::inSpace(resolved.arc));
}

Prepared Interpreter::setFrame(const nc::FrameStatement& statement) {
  const bool isAdditive = statement.name[0] == 'A';
  const std::string_view kind = std::string_view(statement.name).substr(isAdditive ? 1 : 0);
  std::array<std::optional<double>, base::kAxisCount> given;
  std::optional<double> inPlane;
  for (const nc::Word& word : statement.words) {
    const nc::Expected<double> value = m_values.number(*word.value);
    if (!value) {
      return alarmOf(value.error());
    }
    const std::size_t axis = std::string_view("XYZ").find(word.address);
    std::optional<double>* const target = word.address == "RPL"     ? &inPlane
                                          : axis < base::kAxisCount ? &given[axis]
                                                                    : nullptr;
    if (target != nullptr && *target) {
      return Alarm{12010, "An address is programmed more than once in the block."};
    }
    if (target != nullptr) {
      *target = *value;
    } else if (std::string_view("ABCUVW").find(word.address) == std::string_view::npos) {
      return Alarm{12550, fmt::format("{} takes no word {}.", statement.name, word.address)};
    }
  }
  // An absolute frame instruction takes the place of all that was programmed before.
  nc::Frame frame = isAdditive ? m_frame : nc::Frame{};
  base::Vec3 offset;
  base::Vec3 factors{1.0, 1.0, 1.0};
  // About Z, then the turned Y, then the turned X.
  for (std::size_t axis = base::kAxisCount; axis-- > 0;) {
    if (!given[axis]) {
      continue;
    }
    offset.set(axis, unit() * *given[axis]);
    factors.set(axis, kind == "MIRROR" ? -1.0 : *given[axis]);
    if (kind == "ROT") {
      frame.rotate(axis, *given[axis]);
    } else if (factors[axis] == 0.0) {
      factors.set(axis, 1.0);
      if (kind == "SCALE") {
        return Alarm{12550, "A scale factor is 0."};
      }
    }
  }
  if (kind == "TRANS" && !statement.words.empty()) {
    frame.translate(offset);
  } else if (kind == "ROT" && inPlane) {
    frame.rotate((m_plane + 2) % base::kAxisCount, *inPlane);
  } else if ((kind == "SCALE" || kind == "MIRROR") && !statement.words.empty()) {
    frame.scale(factors);
  }
  const base::Vec3 before = m_frame.toProgrammed(m_endMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_incrementFromMm[axis] = m_incrementFromMm[axis].value_or(before[axis]);
  }
  m_frame = frame;
  return PreparedNothing{};
}

}  // namespace rivulet::machine
