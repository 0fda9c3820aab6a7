// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/machine.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/contract.h"
#include "base/random.h"
#include "base/text.h"
#include "machine/equipment.h"
#include "machine/path_planner.h"
#include "machine/prerun.h"
#include "machine/r_parameters.h"
#include "machine/servo_model.h"
#include "machine/sync_action.h"
#include "nc/syntax/programs.h"

namespace rivulet::machine {

namespace {

using base::Duration;
using base::Instant;
using base::Result;

constexpr std::size_t kProgramBytesMax = 16u << 20;  // as the control's file methods
constexpr double kSettledMm = 1e-6;
constexpr double kSettledDeg = 1e-6;
constexpr base::RotarySet kAllRotary{true, true, true};
/// Speed of $AA_OFF (MD32070 of the control; assumed).
constexpr double kOffsetMmPerS = 50.0;
/// Bits of MD36750.
constexpr int kOffsetAddsUp = 1;
constexpr int kOffsetStays = 2;

// Streams of the seed: each kind of random number has its own, so that they are independent of each
// other.
constexpr std::uint64_t kStandstillStream = 1;
constexpr std::uint64_t kAccessStream = 2;

/// Samples that were taken are forgotten when there are this many, or half of what the trace can
/// hold, except the newer half of them.
constexpr std::size_t kTakenSamplesMax = 120'000;

}  // namespace

class Machine::Impl final : public MainRun, public AuxiliaryRun {
 public:
  Impl(MachineConfig configuration, std::uint64_t seed)
      : m_config(std::move(configuration)),
        m_standstillRandom(base::Random(seed).fork(kStandstillStream)),
        m_accessRandom(base::Random(seed).fork(kAccessStream)),
        m_parameters(m_config.rParameterCount),
        m_planner(m_config, m_config.start().mm, m_config.start().deg),
        m_prerun(m_config, m_syncActions),
        m_servo(m_config, m_config.start()),
        m_equipment(m_config) {
    m_planner.setAuxiliaryRun(*this);
    m_trace.cycle = m_config.interpolationCycle;
    m_planner.setZero(m_config.workOffsetMm(kNoWorkOffsetKey));
    m_trace.rotaryAxes = m_config.rotarySet();
  }

  void advance(Instant until) {
    for (;;) {
      const std::optional<Instant> prerunAt = m_prerun.nextEvent();
      std::optional<Instant> tickAt;
      if (needsTicks()) {
        tickAt = nextBoundary();
      }
      // At the same moment the main run goes first: a value from outside is visible to the block
      // that is interpreted at the boundary.
      if (tickAt && *tickAt <= until && (!prerunAt || *tickAt <= *prerunAt)) {
        m_now = *tickAt;
        tick();
      } else if (prerunAt && *prerunAt <= until) {
        m_now = std::max(m_now, *prerunAt);
        m_prerun.handle(m_now, m_planner);
        afterPrerun();
      } else {
        break;
      }
    }
    m_now = std::max(m_now, until);
  }

  [[nodiscard]] MachineState state() const {
    MachineState state;
    state.channel = m_channel;
    state.program = m_programStatus;
    state.zeroMm = m_planner.zeroMm();
    state.actualMm = m_servo.actualMm() - state.zeroMm;
    state.commandMm = commandMm() - state.zeroMm;
    state.overlayMm = m_offsetMm;
    state.distanceToGoMm = m_planner.distanceToGoMm();
    state.actualDeg = m_servo.actualDeg();
    state.commandDeg = m_planner.commandDeg();
    state.distanceToGoDeg = m_planner.distanceToGoDeg();
    state.feedMmPerS = m_planner.speedMmPerS();
    state.feedCommandMmPerS = m_planner.feedCommandMmPerS();
    state.line = m_planner.line().value;
    state.bufferedBlocks = m_planner.blockCount();
    state.alarm = m_alarm.number;
    state.alarmText = m_alarm.text;
    state.programName = m_selected;
    state.message = m_prerun.message();
    state.waitsForStart = m_waitsForStart;
    state.equipment = m_equipment.state(m_now);
    return state;
  }

  Instant beginRequest(AccessKind kind, Instant arrival) {
    m_serviceFreeAt =
        std::max(m_serviceFreeAt, arrival) +
        (kind == AccessKind::Read ? m_config.access.readOverhead : m_config.access.writeOverhead);
    return m_serviceFreeAt;
  }

  Instant serveNode() {
    const AccessCost& cost = m_config.access;
    const double drawn =
        m_accessRandom.normal() * static_cast<double>(cost.nodeTimeDeviation.count());
    const Duration nodeTime = cost.nodeTimeMean + Duration{std::llround(drawn)};
    m_serviceFreeAt += std::max(cost.nodeTimeMin, nodeTime);
    return m_serviceFreeAt;
  }

  Instant serveProgram(std::size_t bytes) {
    m_serviceFreeAt += m_config.access.programTime(bytes);
    return m_serviceFreeAt;
  }

  Result<void> storeProgram(const std::string& name, std::string text, bool overwrite) {
    if (text.size() > kProgramBytesMax) {
      return base::fail(MachineError::FileTooLarge,
                        "The program is larger than 16 MB, the limit of the control's file "
                        "methods. Split it.",
                        name);
    }
    const std::string key = base::toUpper(name);
    if (!overwrite && m_programs.contains(key)) {
      return base::fail(MachineError::FileExists,
                        "A program of this name is already on the control. Allow overwriting or "
                        "choose another name.",
                        name);
    }
    if (m_channel != ChannelStatus::Reset && key == m_selected) {
      return base::fail(MachineError::NotInReset,
                        "The program is active: it cannot be overwritten. Reset the channel.",
                        name);
    }
    m_programs[key] = std::move(text);
    return {};
  }

  Result<void> selectProgram(const std::string& name) {
    const std::string key = base::toUpper(name);
    if (!m_programs.contains(key)) {
      return base::fail(MachineError::ProgramMissing,
                        "There is no such program on the control. Transfer it first.", name);
    }
    if (m_channel != ChannelStatus::Reset) {
      return base::fail(MachineError::NotInReset,
                        "A program can be selected only while the channel is in reset.", name);
    }
    m_selected = key;
    return {};
  }

  Result<void> cycleStart() {
    if (m_waitsForStart) {
      m_waitsForStart = false;
      m_trace.events.back().to = m_now;
      m_planner.release();
      m_channel = ChannelStatus::Active;
      m_programStatus = ProgramStatus::Running;
      return {};
    }
    if (m_channel != ChannelStatus::Reset) {
      return base::fail(MachineError::NotInReset,
                        "The channel is not in reset. End the running program first.");
    }
    const auto program = m_programs.find(m_selected);
    if (program == m_programs.end()) {
      return base::fail(MachineError::NoProgramSelected,
                        "No program is selected. Select one first.");
    }
    m_alarm = {};
    m_channel = ChannelStatus::Active;
    m_programStatus = ProgramStatus::Running;
    m_trace.samples.clear();
    m_trace.blocks.clear();
    m_trace.events.clear();
    m_trace.truncated = false;
    m_record.forgotten = {m_record.forgotten.start + 1, 0, 0, 0};
    m_record.isFull = false;
    m_record.isOn = false;
    m_standstill.moved = false;
    m_standstill.holdUntil = m_now;
    InterpreterOptions options =
        interpreterOptions(m_config, {m_planner.endMm(), m_planner.endDeg()});
    options.mainRun = this;
    options.tool = m_equipment.tool();
    options.library = [this](const std::string& name) { return subprogram(name); };
    m_syncActions.clear();
    m_markers.fill(0.0);
    m_params.fill(0.0);
    m_timers.fill(-1.0);
    options.cacheUntilStopre = m_config.rRead == RParameterReading::CachedUntilStopre;
    m_prerun.start(
        std::make_unique<Interpreter>(nc::parseSinumerik(program->second), m_parameters, options),
        m_now);
    return {};
  }

  void reset() {
    m_prerun.stop();
    m_syncActions.clear();
    dropOffset();
    if ((m_channel == ChannelStatus::Active || m_waitsForStart) && m_planner.blockCount() > 0) {
      m_waitsForStart = false;
      m_channel = ChannelStatus::Active;
      m_planner.abort();
      m_resetting = true;  // the channel is in reset after the axes have stopped
      return;
    }
    enterReset();
  }

  trace::TracePiece takeTrace(const trace::TracePosition& from) {
    if (from.start == m_record.forgotten.start) {
      forgetTaken(from);
    }
    trace::TracePiece piece = trace::cutPiece(m_trace, m_record.forgotten, from);
    piece.records.truncated = piece.records.truncated || m_record.isFull;
    if (m_channel != ChannelStatus::Reset && !piece.records.events.empty() &&
        piece.next.events == m_record.forgotten.events + m_trace.events.size()) {
      piece.records.events.pop_back();
      --piece.next.events;
    }
    return piece;
  }

  MachineConfig m_config;
  base::Random m_standstillRandom;
  base::Random m_accessRandom;
  RParameters m_parameters;
  PathPlanner m_planner;
  SyncActions m_syncActions;  // before the pre-run, which adds actions to it
  Prerun m_prerun;
  ServoModel m_servo;
  Equipment m_equipment;
  trace::ControlTrace m_trace;
  struct Recording {
    trace::TracePosition forgotten;  ///< where `m_trace` begins
    bool isFull = false;
    bool isOn = false;
  };
  Recording m_record;
  std::map<std::string, std::string> m_programs;
  std::string m_selected;
  Instant m_now{};

 private:
  [[nodiscard]] bool needsTicks() const {
    return m_channel == ChannelStatus::Active || m_waitsForStart || m_parameters.hasPending() ||
           !m_standstill.settled || !m_syncActions.isEmpty() || m_offsetMm != m_offsetWantedMm;
  }

  /// Set point of the axes: the path plus the overlay.
  [[nodiscard]] base::Vec3 commandMm() const { return m_planner.commandMm() + m_offsetMm; }

  /// "NAME", as NAME.SPF or NAME.MPF on the control.
  [[nodiscard]] std::shared_ptr<const nc::Tree> subprogram(const std::string& name) const {
    for (const char* ending : {"", ".SPF", ".MPF"}) {
      const auto found = m_programs.find(name + ending);
      if (found != m_programs.end()) {
        return nc::parseSinumerik(found->second);
      }
    }
    return nullptr;
  }

  // --- AuxiliaryRun -----------------------------------------------------------------------
  [[nodiscard]] double begin(const PreparedActions& actions, Instant at) override {
    const double seconds = m_equipment.carryOut(actions, at, m_trace.events);
    m_waitsForStart = std::isinf(seconds);
    return seconds;
  }

  void dwell(base::LineNumber line, Instant at, double seconds) override {
    const bool continues = m_blocksAtDwell == m_blockCount;
    m_blocksAtDwell = m_blockCount;
    m_equipment.recordDwell(line, at, seconds, continues, m_trace.events);
  }

  // --- MainRun ----------------------------------------------------------------------------
  [[nodiscard]] std::optional<double> systemValue(SystemVariable variable,
                                                  int index) const override {
    const auto element = static_cast<std::size_t>(index);
    const bool isAxis = index >= 0 && element < base::kAxisCount;
    const bool isElement = index >= 0 && index < kSystemElements;
    switch (variable) {
      case SystemVariable::AaIm:
        return isAxis ? std::optional(commandMm()[element]) : std::nullopt;
      case SystemVariable::AaIw:
        return isAxis ? std::optional(m_planner.commandMm()[element] - m_planner.zeroMm()[element])
                      : std::nullopt;
      case SystemVariable::AaDtew:
        return isAxis ? std::optional(m_planner.distanceToGoMm()[element]) : std::nullopt;
      case SystemVariable::MaAaOffMode:
        return isAxis ? std::optional<double>(m_config.overlay.mode) : std::nullopt;
      case SystemVariable::SaAaOffLimit:
        return isAxis ? std::optional(m_config.overlay.mostMm) : std::nullopt;
      case SystemVariable::AaOff:
      case SystemVariable::AaOffVal:
        return isAxis ? std::optional(m_offsetMm[element]) : std::nullopt;
      case SystemVariable::AcDtew:
        return m_planner.pathToGoMm();
      case SystemVariable::AcPathn:
        return m_planner.pathShare();
      case SystemVariable::AcOvr:
        return m_overridePercent;
      case SystemVariable::AcTimer:
        return isElement ? std::optional(m_timers[element]) : std::nullopt;
      case SystemVariable::AcMarker:
        return isElement ? std::optional(m_markers[element]) : std::nullopt;
      case SystemVariable::AcParam:
        return isElement ? std::optional(m_params[element]) : std::nullopt;
      case SystemVariable::AcIpoBuf:
        return m_planner.blockCount();
    }
    return std::nullopt;
  }

  bool setSystemValue(SystemVariable variable, int index, double value) override {
    const auto element = static_cast<std::size_t>(index);
    const bool isElement = index >= 0 && index < kSystemElements;
    switch (variable) {
      case SystemVariable::AaOff:
        if (index < 0 || element >= base::kAxisCount) {
          return false;
        }
        value += (m_config.overlay.mode & kOffsetAddsUp) != 0 ? m_offsetWantedMm[element] : 0.0;
        m_offsetWantedMm.set(element,
                             std::clamp(value, -m_config.overlay.mostMm, m_config.overlay.mostMm));
        return true;
      case SystemVariable::AcOvr:
        if (value < 0.0) {
          return false;
        }
        m_overridePercent = value;
        return true;
      case SystemVariable::AcTimer:
        return isElement && (m_timers[element] = value, true);
      case SystemVariable::AcMarker:
        return isElement && (m_markers[element] = value, true);
      case SystemVariable::AcParam:
        return isElement && (m_params[element] = value, true);
      default:
        return false;
    }
  }

  [[nodiscard]] std::optional<double> rValue(int index) const override {
    return m_parameters.has(index) ? std::optional(m_parameters.value(index)) : std::nullopt;
  }

  bool setRValue(int index, double value) override {
    return m_parameters.has(index) && (m_parameters.set(index, value), true);
  }

  /// Synchronized actions of this cycle; then the overlay moves.
  void runSyncActions() {
    const double cycleS = base::toSeconds(m_config.interpolationCycle);
    if (!m_syncActions.isEmpty()) {
      for (double& timer : m_timers) {
        timer += timer >= 0.0 ? cycleS : 0.0;
      }
      m_overridePercent = 100.0;  // holds only if it is written in every cycle
      if (std::optional<Alarm> alarm = m_syncActions.run(*this, m_planner.blocksFinished())) {
        m_alarm = *std::move(alarm);
      }
      m_planner.setOverride(m_overridePercent / 100.0);
    } else if (m_overridePercent != 100.0) {
      m_overridePercent = 100.0;
      m_planner.setOverride(1.0);
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double step = kOffsetMmPerS * cycleS;
      const double way = m_offsetWantedMm[axis] - m_offsetMm[axis];
      m_offsetMm.set(axis, m_offsetMm[axis] + std::clamp(way, -step, step));
    }
  }

  void dropOffset() {
    if ((m_config.overlay.mode & kOffsetStays) == 0) {
      m_offsetWantedMm = {};
    }
  }

  [[nodiscard]] Instant nextBoundary() const {
    const Duration::rep cycle = m_config.interpolationCycle.count();
    return Instant{Duration{(m_now.time_since_epoch().count() / cycle + 1) * cycle}};
  }

  /// One interpolation boundary.
  void tick() {
    m_parameters.applyPending();
    const base::Vec3 before = commandMm();
    const base::RotaryDeg beforeDeg = m_planner.commandDeg();
    runSyncActions();
    if (m_channel == ChannelStatus::Active) {
      moveAxes();
      if (m_waitsForStart) {
        m_channel = ChannelStatus::Interrupted;
        m_programStatus = ProgramStatus::Stopped;
      }
    }
    const base::Vec3 actual = m_servo.follow(before, commandMm());
    const base::RotaryDeg actualDeg = m_servo.followDeg(beforeDeg, m_planner.commandDeg());
    m_standstill.settled =
        base::distance(actual, commandMm()) < kSettledMm &&
        base::differenceDeg(actualDeg, m_planner.commandDeg(), kAllRotary) < kSettledDeg;
    record(actual, actualDeg);
    if (m_channel == ChannelStatus::Active) {
      if (m_resetting && m_planner.blockCount() == 0) {
        enterReset();
      } else {
        m_prerun.mainRunAdvanced(m_now, m_planner);
        afterPrerun();
      }
    }
  }

  void moveAxes() {
    // The cycle that ends now may move if it began after the standstill, rounded to the nearest
    // cycle, so that the standstill is right on average.
    const Instant began = m_now - m_config.interpolationCycle;
    if (m_planner.blockCount() == 0 ||
        began + m_config.interpolationCycle / 2 < m_standstill.holdUntil) {
      if (m_resetting) {
        m_planner.step(m_now, m_trace.blocks);  // at standstill: forgets what is buffered
      }
      return;
    }
    const std::size_t executedBefore = m_trace.blocks.size();
    m_planner.step(m_now, m_trace.blocks);
    if (m_planner.speedMmPerS() > 0.0) {
      m_standstill.moved = true;
      m_record.isOn = true;
    }
    for (std::size_t i = executedBefore; i < m_trace.blocks.size(); ++i) {
      if (m_trace.blocks[i].moves()) {
        m_standstill.moved = true;
        m_record.isOn = true;
        m_standstill.stoodAt = m_trace.blocks[i].to;
      }
    }
    m_blockCount += m_trace.blocks.size() - executedBefore;
    if (m_record.isFull) {
      m_trace.blocks.resize(executedBefore);
    }
  }

  /// Consequences of the pre-run's present state.
  void afterPrerun() {
    if (m_prerun.takeStandstill() && m_standstill.moved) {
      const double drawn =
          m_standstillRandom.normal() * static_cast<double>(m_config.standstillDeviation.count());
      const Duration standstill = m_config.standstillMean + Duration{std::llround(drawn)};
      m_standstill.holdUntil = m_standstill.stoodAt + std::max(Duration{0}, standstill);
      m_standstill.moved = false;
    }
    if (m_prerun.hasEnded()) {
      m_prerun.stop();
      enterReset();
    } else if (m_prerun.alarm() && m_channel == ChannelStatus::Active) {
      m_alarm = *m_prerun.alarm();
      m_channel = ChannelStatus::Interrupted;
      m_programStatus = ProgramStatus::Stopped;
    }
  }

  void enterReset() {
    m_alarm = {};
    m_planner.setZero(m_config.workOffsetMm(kNoWorkOffsetKey));
    m_equipment.endProgram(m_now, m_trace.events);
    m_syncActions.endProgram();
    dropOffset();
    m_resetting = false;
    m_channel = ChannelStatus::Reset;
    m_programStatus = ProgramStatus::Aborted;
    m_record.isOn = false;
  }

  [[nodiscard]] std::size_t samplesMax() const {
    return static_cast<std::size_t>(m_config.traceLimit / m_config.interpolationCycle);
  }

  void forgetTaken(const trace::TracePosition& taken) {
    const std::size_t takenMax = std::min(kTakenSamplesMax, samplesMax() / 2);
    if (taken.samples <= m_record.forgotten.samples + takenMax ||
        taken.samples > m_record.forgotten.samples + m_trace.samples.size()) {
      return;
    }
    const std::size_t samples = taken.samples - m_record.forgotten.samples - takenMax / 2 - 1;
    const Instant until = m_trace.samples[samples].at;
    const auto forget = [until](auto& records, std::uint64_t& forgotten, std::uint64_t takenCount) {
      std::size_t count = 0;
      while (forgotten + count < takenCount && count + 1 < records.size() &&
             records[count].to < until) {
        ++count;
      }
      records.erase(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(count));
      forgotten += count;
    };
    forget(m_trace.blocks, m_record.forgotten.blocks, taken.blocks);
    forget(m_trace.events, m_record.forgotten.events, taken.events);
    m_trace.samples.erase(m_trace.samples.begin(),
                          m_trace.samples.begin() + static_cast<std::ptrdiff_t>(samples));
    m_record.forgotten.samples += samples;
    m_trace.truncated = true;
  }

  void record(base::Vec3 actual, const base::RotaryDeg& actualDeg) {
    if (!m_record.isOn) {
      return;
    }
    if (m_trace.samples.size() >= samplesMax()) {
      m_record.isFull = true;
      m_trace.truncated = true;
      return;
    }
    const base::Vec3 zeroMm = m_planner.zeroMm();
    m_trace.samples.push_back({m_now, commandMm() - zeroMm, actual - zeroMm,
                               m_planner.speedMmPerS(), m_planner.line(), m_planner.commandDeg(),
                               actualDeg});
  }

  base::Vec3 m_offsetMm;        ///< overlay on the path ($AA_OFF)
  base::Vec3 m_offsetWantedMm;  ///< its target
  double m_overridePercent = 100.0;
  std::array<double, kSystemElements> m_timers{};
  std::array<double, kSystemElements> m_markers{};
  std::array<double, kSystemElements> m_params{};
  ChannelStatus m_channel = ChannelStatus::Reset;
  ProgramStatus m_programStatus = ProgramStatus::Aborted;
  Alarm m_alarm;
  bool m_resetting = false;
  bool m_waitsForStart = false;  ///< M0 or M1
  std::size_t m_blockCount = 0;  ///< executed so far
  std::size_t m_blocksAtDwell = 0;
  struct Standstill {
    bool moved = false;   ///< axes have moved since the last standstill began
    bool settled = true;  ///< actual position has reached the set point
    Instant holdUntil{};  ///< axes are held until then
    Instant stoodAt{};    ///< when the last motion ended
  };
  Standstill m_standstill;
  Instant m_serviceFreeAt{};
};

Machine::Machine(MachineConfig config, std::uint64_t seed)
    : m_impl(std::make_unique<Impl>(std::move(config), seed)) {
}

Machine::~Machine() = default;

const MachineConfig& Machine::config() const {
  return m_impl->m_config;
}

void Machine::advance(Instant until) {
  m_impl->advance(until);
}

Instant Machine::now() const {
  return m_impl->m_now;
}

MachineState Machine::state() const {
  return m_impl->state();
}

bool Machine::hasRParameter(int index) const {
  return m_impl->m_parameters.has(index);
}

double Machine::rParameter(int index) const {
  return m_impl->m_parameters.serviceValue(index);
}

double Machine::ncRParameter(int index) const {
  return m_impl->m_parameters.value(index);
}

void Machine::writeRParameter(int index, double value) {
  m_impl->m_parameters.setAtBoundary(index, value);
}

Instant Machine::beginRequest(AccessKind kind, Instant arrival) {
  return m_impl->beginRequest(kind, arrival);
}

Instant Machine::serveNode() {
  return m_impl->serveNode();
}

Instant Machine::serveProgram(std::size_t bytes) {
  return m_impl->serveProgram(bytes);
}

Result<void> Machine::storeProgram(const std::string& name, std::string text, bool overwrite) {
  return m_impl->storeProgram(name, std::move(text), overwrite);
}

Result<std::string> Machine::programText(const std::string& name) const {
  const auto found = m_impl->m_programs.find(base::toUpper(name));
  if (found == m_impl->m_programs.end()) {
    return base::fail(MachineError::ProgramMissing, "There is no such program on the control.",
                      name);
  }
  return found->second;
}

std::vector<std::string> Machine::programNames() const {
  std::vector<std::string> names;
  for (const auto& [name, text] : m_impl->m_programs) {
    names.push_back(name);
  }
  return names;
}

Result<void> Machine::selectProgram(const std::string& name) {
  return m_impl->selectProgram(name);
}

Result<void> Machine::cycleStart() {
  return m_impl->cycleStart();
}

void Machine::reset() {
  m_impl->reset();
}

trace::TracePiece Machine::takeTrace(const trace::TracePosition& from) {
  return m_impl->takeTrace(from);
}

const trace::ControlTrace& Machine::trace() const {
  return m_impl->m_trace;
}

}  // namespace rivulet::machine
