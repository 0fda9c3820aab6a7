// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "linuxcnc/linuxcnc_control.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/contract.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "templates/linuxcnc_protocol.h"
#include "templates/target.h"
#include "templates/window_protocol.h"

namespace rivulet::linuxcnc {

namespace {

using templates::FeedCell;
using templates::LinuxCncProtocol;
using templates::WindowProtocol;

constexpr std::chrono::milliseconds kReadyWithin{10'000};
/// The helper gives up earlier.
constexpr std::chrono::milliseconds kAnswerWithin{15'000};
constexpr std::chrono::milliseconds kPollStep{10};
/// How long the last samples of a program are waited for after its end: `halsampler` hands them
/// over when it gets a processor. Less than a client waits for an answer.
constexpr std::chrono::seconds kSamplesLate{5};

/// States of LinuxCNC's interpreter (`interp_state`).
constexpr int kInterpreterIdle = 1;
constexpr int kInterpreterPaused = 3;
/// Kinds of reports that are errors: NML_ERROR and OPERATOR_ERROR.
constexpr std::array kErrorKinds{1, 11};
/// How long an error stays an alarm when no program is active any more: LinuxCNC only reports it,
/// and starts the next program all the same.
constexpr base::Duration kReportShown = std::chrono::seconds{2};
/// LinuxCNC's task, which feeds the axes, waits for a processor 2 % of the time where nothing else
/// runs. Above 50 % the axes were measured to stop and to leave the path.
constexpr double kWaitedShareMax = 0.2;
/// Less is no figure of the program, but of one moment.
constexpr double kWaitedMinS = 0.5;
/// The HAL holds the axes when nothing has changed for so long, where no client is watched: then
/// these are the signs of life of the bridge itself.
constexpr double kBridgeSilenceS = 1.0;
constexpr base::Duration kBridgeBeat = std::chrono::milliseconds{250};
/// `task_state` of a machine that is switched on.
constexpr int kSwitchedOn = 4;

/// Numbers of a line "state".
enum StateField {
  TaskState,
  InterpreterState,
  MotionLine,
  QueueLength,
  PathSpeed,
  ToolNumber,
  SpindleSpeed,
  Flood,
  Mist,
  Actual,
  Command = Actual + 6,
  Offset = Command + 6,
  ToGo = Offset + 6,
  StateFields = ToGo + 6,
};

/// What is before the next blank; `text` goes on after it.
std::string_view takeWord(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(std::min(word.size() + 1, text.size()));
  return word;
}

double numberOr0(std::string_view word) {
  return base::parseNumber(word).value_or(0.0);
}

/// A cell that only the program writes, by the output that carries it.
std::optional<WindowProtocol::Header> headerOf(std::size_t output) {
  switch (output) {
    case LinuxCncProtocol::Latched:
      return WindowProtocol::Latched;
    case LinuxCncProtocol::Executed:
      return WindowProtocol::Executed;
    case LinuxCncProtocol::Layout:
      return WindowProtocol::Layout;
    case LinuxCncProtocol::State:
      return WindowProtocol::State;
    case LinuxCncProtocol::Owner:
      return WindowProtocol::Owner;
    case LinuxCncProtocol::Call:
      return WindowProtocol::Asked;
    case LinuxCncProtocol::Block:
      return WindowProtocol::Client;
    default:
      return std::nullopt;
  }
}

/// Those that a program sets to 0 when it starts, and the loop of a job at each stretch; the layout
/// number comes last.
constexpr std::array kResetAtStart{WindowProtocol::Run,     WindowProtocol::Delivered,
                                   WindowProtocol::Latched, WindowProtocol::Executed,
                                   WindowProtocol::State,   WindowProtocol::Client,
                                   WindowProtocol::Owner};

}  // namespace

std::error_code make_error_code(LinuxCncError code) {
  static const base::NamedCategory category("linuxcnc");
  return {static_cast<int>(code), category};
}

base::Result<std::unique_ptr<LinuxCncControl>> LinuxCncControl::connect(
    const LinuxCncOptions& options) {
  auto helper = ChildProcess::start(
      {options.helper, std::to_string(options.cells), std::to_string(LinuxCncProtocol::Outputs)});
  if (!helper) {
    return base::fail(helper.error());
  }
  std::unique_ptr<LinuxCncControl> control(
      new LinuxCncControl(options, std::move(*helper), std::nullopt));
  if (auto ready = control->awaitReady(); !ready) {
    return base::fail(ready.error());
  }
  if (options.hasSampler) {
    // By lines: what it prints into a pipe would otherwise arrive in large pieces.
    auto sampler = ChildProcess::start({"stdbuf", "-oL", options.sampler, "-t"});
    if (!sampler) {
      return base::fail(sampler.error());
    }
    control->m_sampler.emplace(std::move(*sampler));
  }
  return control;
}

LinuxCncControl::LinuxCncControl(const LinuxCncOptions& options, ChildProcess helper,
                                 std::optional<ChildProcess> sampler)
    : m_options(options),
      m_helper(std::move(helper)),
      m_sampler(std::move(sampler)),
      m_cells(static_cast<std::size_t>(options.cells), 0.0) {
  m_facts.product = kProductName;
  m_facts.applicationUri = templates::kLinuxCncApplicationUri;
  m_facts.isVirtual = false;
  m_facts.abilities = {options.mayStart, options.hasSampler};
  m_facts.samplingMin = std::chrono::milliseconds{10};
  m_facts.arrays.count = true;
  m_facts.arrays.range = true;
  m_facts.arrays.charge = machine::ArrayCharge::Node;
}

base::Result<void> LinuxCncControl::awaitReady() {
  for (auto waited = std::chrono::milliseconds{}; !m_isReady && !m_failure; waited += kPollStep) {
    advance(m_now);
    if (!m_isReady && waited >= kReadyWithin) {
      return base::fail(LinuxCncError::NotRunning,
                        "The helper in LinuxCNC does not answer: look at LinuxCNC's messages.");
    }
    pollfd file{m_helper.output(), POLLIN, 0};
    ::poll(&file, 1, static_cast<int>(kPollStep.count()));
  }
  return m_failure ? base::Result<void>(tl::unexpected(*m_failure)) : base::Result<void>();
}

machine::MachineState LinuxCncControl::state() const {
  machine::MachineState state = m_state;
  const bool isActive = state.channel != machine::ChannelStatus::Reset;
  if (m_failure) {
    state.alarm = kErrorKinds.front();
    state.message = m_failure->message;
  } else if (!m_isSwitchedOn) {
    state.alarm = kErrorKinds.front();
    state.message = "LinuxCNC is not switched on.";
  } else if (isActive || m_now < m_reportedUntil) {
    state.alarm = m_reported;
  }
  state.alarmText = state.alarm != 0 ? state.message : std::string();
  return state;
}

bool LinuxCncControl::shows(std::string_view folder, std::string_view name) const {
  // No edges and no names of tools; the real speed of a spindle only where it has an encoder.
  // The feed that is commanded is known to the interpreter alone, ahead of the motion; work offsets
  // beyond G59 (G59.1) have no number here.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kMissing{
      {{"", "ncFktAct"},
       {"State", "actDNumber"},
       {"State", "actToolIdent"},
       {"State", "cmdFeedRateIpo"},
       {"Spindle", "actSpeed"},
       {"Spindle", "turnState"}}};
  return std::find(kMissing.begin(), kMissing.end(), std::pair(folder, name)) == kMissing.end();
}

void LinuxCncControl::advance(base::Instant until) {
  m_now = std::max(m_now, until);
  if (m_failure) {
    return;
  }
  while (const std::optional<std::string> line = m_helper.readLine()) {
    take(*line);
  }
  takeSamples();
  beat();
  if (m_helper.hasEnded()) {
    fail({LinuxCncError::NotRunning,
          "The helper in LinuxCNC has ended: start rivulet-linuxcnc again.",
          {}});
  }
}

void LinuxCncControl::take(const std::string& line) {
  std::string_view rest = line;
  const std::string_view kind = takeWord(rest);
  if (kind == "out") {
    takeOutputs(rest);
  } else if (kind == "line") {
    takeLine(static_cast<std::size_t>(std::max(numberOr0(rest), 0.0)));
  } else if (kind == "state") {
    takeState(rest);
  } else if (kind == "done" || kind == "failed") {
    m_answer = line;
  } else if (kind == "error") {
    const auto number = static_cast<int>(numberOr0(takeWord(rest)));
    m_state.message = rest;
    if (std::find(kErrorKinds.begin(), kErrorKinds.end(), number) != kErrorKinds.end()) {
      m_reported = number;
      m_reportedUntil = m_now + kReportShown;
    }
  } else if (kind == "acts") {
    takeActs(numberOr0(rest));
  } else if (kind == "ignored") {
    m_state.message = fmt::format(
        "No override acts: {}. Put the lines of docs/linuxcnc.md into the HAL file of the machine.",
        rest);
  } else if (kind == "waited") {
    takeWaited(numberOr0(rest));
  } else if (kind == "behind") {
    m_tracing.samplesBehind = static_cast<long long>(numberOr0(takeWord(rest)));
    m_tracing.isSamplerFull = numberOr0(rest) != 0.0;
  } else if (kind == "fatal") {
    fail({LinuxCncError::NotRunning, std::string(rest), {}});
  } else if (kind == "ready") {
    const double unitsPerMm = numberOr0(takeWord(rest));
    m_scale.mmPerUnit = unitsPerMm > 0.0 ? 1.0 / unitsPerMm : 1.0;
    m_scale.cycle = base::fromSeconds(numberOr0(takeWord(rest)));
    const auto axes = static_cast<unsigned>(numberOr0(takeWord(rest)));
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if ((axes >> (base::kAxisCount + axis) & 1U) != 0) {
        m_facts.rotaryAxes.push_back(axis);
      }
    }
    m_version = takeWord(rest);
    m_facts.name = fmt::format("{} (LinuxCNC {})", rest, m_version);
    m_isReady = true;
  }
}

void LinuxCncControl::fail(const base::Error& error) {
  m_failure = m_failure.value_or(error);
}

void LinuxCncControl::takeOutputs(std::string_view values) {
  std::vector<double> outputs;
  while (!values.empty()) {
    outputs.push_back(numberOr0(takeWord(values)));
  }
  if (outputs.size() != LinuxCncProtocol::Outputs) {
    return;
  }
  const double base = outputs[LinuxCncProtocol::Base];
  m_firstCell = static_cast<int>(std::clamp(base, 0.0, 1e6));
  const auto cellOf = [&](WindowProtocol::Header header) { return m_firstCell + header; };
  const bool fits = hasRParameter(m_firstCell + WindowProtocol::HeaderCells - 1);
  for (std::size_t output = 0; fits && output < outputs.size(); ++output) {
    const auto header = headerOf(output);
    const bool isClients =
        output == LinuxCncProtocol::Block && outputs[output] == LinuxCncProtocol::kNoBlock;
    if (header && !isClients && (m_outputs.empty() || outputs[output] != m_outputs[output])) {
      setCell(cellOf(*header), outputs[output]);
    }
  }
  const double start = outputs[LinuxCncProtocol::Start];
  if (fits && !m_outputs.empty() && start != m_outputs[LinuxCncProtocol::Start]) {
    for (const WindowProtocol::Header header : kResetAtStart) {
      setCell(cellOf(header), 0.0);
    }
    if (outputs[LinuxCncProtocol::Stretch] == 0.0) {
      setCell(cellOf(WindowProtocol::OverrideActs), 0.0);
      setCell(cellOf(WindowProtocol::Override), FeedCell::kProgrammed);
      readMarks();
      const double limitS = outputs[LinuxCncProtocol::SilenceLimit];
      tell(fmt::format("started {} {}", base::formatNumber(start),
                       base::formatNumber(limitS > 0.0 ? limitS : kBridgeSilenceS)));
    } else {
      tell(fmt::format("called {}", base::formatNumber(start)));
    }
  }
  m_outputs = std::move(outputs);
}

void LinuxCncControl::takeActs(double percent) {
  const int cell = m_firstCell + WindowProtocol::OverrideActs;
  if (hasRParameter(cell)) {
    setCell(cell, percent);
  }
}

/// What a client writes and the program does not read: the helper has it act.
void LinuxCncControl::takeFeedCells(int index, double before, double value) {
  if (index == m_firstCell + WindowProtocol::Override) {
    // Also for what is not a number.
    const bool mayMove = value >= FeedCell::kHold && value <= FeedCell::kMax;
    tell(fmt::format("override {}", base::formatNumber(mayMove ? value : FeedCell::kHold)));
  } else if (index == m_firstCell + WindowProtocol::Heartbeat &&
             (value > before || value < before) && watchesClient()) {
    tell("beat");
  }
}

bool LinuxCncControl::watchesClient() const {
  return !m_outputs.empty() && m_outputs[LinuxCncProtocol::SilenceLimit] > 0.0;
}

/// Where the client is not watched, this program is.
void LinuxCncControl::beat() {
  if (!m_outputs.empty() && !watchesClient() && m_now >= m_nextBeat) {
    m_nextBeat = m_now + kBridgeBeat;
    tell("beat");
  }
}

/// Which lines of the program that has been started move to the points of which window.
void LinuxCncControl::readMarks() {
  m_windowOfLine.clear();
  m_windows = 0;
  const auto text = base::readFile(m_programFile);
  std::string_view rest = text ? std::string_view(*text) : std::string_view();
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::string_view block = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(block.size() + 1, rest.size()));
    const std::size_t mark = block.find(LinuxCncProtocol::kMotionMark);
    if (mark == std::string_view::npos) {
      continue;
    }
    const std::string_view number =
        block.substr(mark + std::string_view(LinuxCncProtocol::kMotionMark).size());
    if (const std::optional<int> window = base::parseInteger(base::trim(number)); window) {
      m_windowOfLine[line] = *window;
      m_windows = std::max(m_windows, *window + 1);
    }
  }
}

/// The axes have begun a block of a window: all windows before it have been executed. The count
/// goes on from what is known, so that windows without motion do no harm.
void LinuxCncControl::takeLine(std::size_t line) {
  const auto found = m_windowOfLine.find(line);
  if (found == m_windowOfLine.end() ||
      !hasRParameter(m_firstCell + WindowProtocol::HeaderCells - 1)) {
    return;
  }
  const int latchedCell = m_firstCell + WindowProtocol::Latched;
  const auto latched = static_cast<long long>(rParameter(latchedCell));
  const long long ahead = (found->second + 1 - latched) % m_windows;
  const long long now = latched + (ahead + m_windows) % m_windows;
  setCell(latchedCell, static_cast<double>(now));
  const int executedCell = m_firstCell + WindowProtocol::Executed;
  setCell(executedCell, std::max(rParameter(executedCell), static_cast<double>(now - 1)));
}

void LinuxCncControl::takeState(std::string_view text) {
  std::array<double, StateFields> numbers{};
  for (double& number : numbers) {
    number = numberOr0(takeWord(text));
  }
  takeWord(text);  // the stroke before the file
  const auto millimetres = [&](std::size_t field) {
    return m_scale.mmPerUnit * base::Vec3{numbers[field], numbers[field + 1], numbers[field + 2]};
  };
  const auto degrees = [&](std::size_t field) {
    // The axes of a state are A, B, C whichever of them there are.
    return base::RotaryDeg{numbers[field + 3], numbers[field + 4], numbers[field + 5]};
  };
  const auto interpreter = static_cast<int>(numbers[InterpreterState]);
  const bool wasActive = m_state.channel != machine::ChannelStatus::Reset;
  const bool isActive = interpreter != kInterpreterIdle;
  m_isSwitchedOn = static_cast<int>(numbers[TaskState]) == kSwitchedOn;
  if (isActive && !wasActive) {
    m_reported = 0;
    m_state.message.clear();
    m_waitedBeforeS = m_waitedS;
    m_activeSince = m_now;
    m_tracing.trace = {};
    m_tracing.trace.cycle = m_scale.cycle;
    m_tracing.trace.truncated = !m_hasState;  // it was active before we came
    m_tracing.isOn = true;
    m_tracing.isEnding = false;
  } else if (!isActive && wasActive) {
    endTrace();
    m_reportedUntil = m_now + kReportShown;
  }
  m_hasState = true;
  const bool isPaused = interpreter == kInterpreterPaused;
  m_state.channel = !isActive  ? machine::ChannelStatus::Reset
                    : isPaused ? machine::ChannelStatus::Interrupted
                               : machine::ChannelStatus::Active;
  m_state.program = !isActive  ? machine::ProgramStatus::Aborted
                    : isPaused ? machine::ProgramStatus::Stopped
                               : machine::ProgramStatus::Running;
  m_state.waitsForStart = isPaused;
  m_state.zeroMm = millimetres(Offset);
  m_state.actualMm = millimetres(Actual) - m_state.zeroMm;
  m_state.commandMm = millimetres(Command) - m_state.zeroMm;
  m_state.distanceToGoMm = millimetres(ToGo);
  m_state.actualDeg = degrees(Actual);
  m_state.commandDeg = degrees(Command);
  m_state.distanceToGoDeg = degrees(ToGo);
  const base::RotaryDeg offset = degrees(Offset);
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    m_state.actualDeg[axis] -= offset[axis];
    m_state.commandDeg[axis] -= offset[axis];
  }
  m_scale.zeroMm = m_state.zeroMm;
  m_state.feedMmPerS = numbers[PathSpeed] * m_scale.mmPerUnit;
  m_state.line = static_cast<unsigned>(std::max(numbers[MotionLine], 0.0));
  m_state.bufferedBlocks = static_cast<int>(numbers[QueueLength]);
  m_state.equipment.tool = static_cast<int>(numbers[ToolNumber]);
  m_state.equipment.spindleCommandPerMin = numbers[SpindleSpeed];
  m_state.equipment.flood = numbers[Flood] != 0.0;
  m_state.equipment.mist = numbers[Mist] != 0.0;
  if (m_programFile != text) {
    // The start of a program may be seen before its file.
    m_programFile = text;
    readMarks();
  }
  m_state.programName = std::filesystem::path(text).filename().string();
}

/// Says it while the program runs and after it, unless LinuxCNC itself has something to say.
void LinuxCncControl::takeWaited(double seconds) {
  m_waitedS = seconds;
  const double waitedS = m_waitedS - m_waitedBeforeS;
  const double programS = base::toSeconds(m_now - m_activeSince);
  if (m_state.channel == machine::ChannelStatus::Reset || waitedS < kWaitedMinS ||
      waitedS < kWaitedShareMax * programS || (m_reported != 0 && !m_state.message.empty())) {
    return;
  }
  m_state.message = fmt::format(
      "LinuxCNC has waited {:.1f} s for a processor during this program, which stops the axes and "
      "may take them off the path. End other programs on its computer or give LinuxCNC priority.",
      waitedS);
}

/// The program has ended: the trace is whole when the last sample of it has arrived. What has not
/// been taken from the sampler when the helper looked comes after what is here, and so does the one
/// that `halsampler` may have had in its hands. They are counted, because numbers are left out when
/// the sampler is full.
void LinuxCncControl::endTrace() {
  takeSamples();
  m_tracing.isEnding = m_tracing.isOn;
  m_tracing.samplesLeft = m_tracing.samplesBehind + 1;
  m_tracing.end = m_now + kSamplesLate;
  if (m_tracing.isOn && m_tracing.isSamplerFull) {
    giveUpTrace();
  }
}

void LinuxCncControl::takeSamples() {
  if (!m_sampler) {
    return;
  }
  while (const std::optional<std::string> line = m_sampler->readLine()) {
    const bool isOfEnded = m_tracing.samplesLeft > 0;
    m_tracing.samplesLeft -= isOfEnded && !isOverrun(*line) ? 1 : 0;
    if (!m_tracing.isOn || (isOfEnded && !m_tracing.isEnding)) {
      continue;  // no program, or the rest of the one before, which nobody has waited for
    }
    const auto count = static_cast<base::Duration::rep>(m_tracing.trace.samples.size());
    if (m_scale.cycle * count >= m_options.traceMax) {
      m_tracing.trace.truncated = true;
    } else if (!addSample(m_tracing.trace, *line, m_scale)) {
      m_tracing.trace.truncated = true;
    }
    if (m_tracing.isEnding && m_tracing.samplesLeft == 0) {
      m_tracing.isOn = m_tracing.isEnding = false;
    }
  }
  if (m_sampler->hasEnded() && m_tracing.isOn) {
    m_tracing.trace.truncated = true;
  }
  if (m_tracing.isEnding && m_now > m_tracing.end) {
    giveUpTrace();
  }
}

/// Its end is missing.
void LinuxCncControl::giveUpTrace() {
  m_tracing.trace.truncated = true;
  m_tracing.isOn = m_tracing.isEnding = false;
}

void LinuxCncControl::tell(std::string_view line) {
  if (m_failure) {
    return;
  }
  if (const auto written = m_helper.write(line); !written) {
    fail(written.error());
  }
}

void LinuxCncControl::setCell(int index, double value) {
  m_cells[static_cast<std::size_t>(index)] = value;
  tell(fmt::format("set {} {}", index, base::formatNumber(value)));
}

bool LinuxCncControl::hasRParameter(int index) const {
  return index >= 0 && static_cast<std::size_t>(index) < m_cells.size();
}

double LinuxCncControl::rParameter(int index) const {
  RIVULET_ASSERT(hasRParameter(index));
  return m_cells[static_cast<std::size_t>(index)];
}

void LinuxCncControl::writeRParameter(int index, double value) {
  RIVULET_ASSERT(hasRParameter(index));
  const double before = rParameter(index);
  setCell(index, value);
  takeFeedCells(index, before, value);
}

std::filesystem::path LinuxCncControl::pathOf(const std::string& name) const {
  return m_options.programs / base::toUpper(name);
}

base::Result<void> LinuxCncControl::storeProgram(const std::string& name, std::string text,
                                                 bool overwrite) {
  const std::filesystem::path path = pathOf(name);
  std::error_code status;
  if (name.empty() || name.front() == '.' || name.find('/') != std::string::npos) {
    return base::fail(LinuxCncError::BadProgramName, "This is no name of a program.", name);
  }
  if (!overwrite && std::filesystem::exists(path, status)) {
    return base::fail(machine::MachineError::FileExists, "The program exists already.", name);
  }
  // The file is replaced, so that LinuxCNC may still have the earlier one open.
  return base::writeFile(path, text);
}

base::Result<std::string> LinuxCncControl::programText(const std::string& name) {
  std::error_code status;
  if (base::toUpper(name) == LinuxCncProtocol::kMachineFile) {
    const std::filesystem::path path = std::filesystem::absolute(pathOf(name), status);
    if (base::Result<void> described = ask("describe", path.string()); !described) {
      return base::fail(described.error());
    }
  }
  if (!std::filesystem::is_regular_file(pathOf(name), status)) {
    return base::fail(machine::MachineError::ProgramMissing, "There is no such program.", name);
  }
  return base::readFile(pathOf(name));
}

base::Result<void> LinuxCncControl::ask(std::string_view command, std::string_view argument) {
  const int question = ++m_question;
  m_answer.reset();
  tell(fmt::format("{} {}{}{}", command, question, argument.empty() ? "" : " ", argument));
  for (auto waited = std::chrono::milliseconds{}; waited < kAnswerWithin && !m_failure;
       waited += kPollStep) {
    advance(m_now);
    if (m_answer) {
      std::string_view rest = *m_answer;
      const bool isDone = takeWord(rest) == "done";
      if (base::parseInteger(takeWord(rest)) == question) {
        return isDone ? base::Result<void>()
                      : base::fail(LinuxCncError::Refused, std::string(rest));
      }
      m_answer.reset();
    }
    pollfd file{m_helper.output(), POLLIN, 0};
    ::poll(&file, 1, static_cast<int>(kPollStep.count()));
  }
  return m_failure ? base::Result<void>(tl::unexpected(*m_failure))
                   : base::fail(LinuxCncError::Refused, "LinuxCNC does not answer.");
}

base::Result<void> LinuxCncControl::selectProgram(const std::string& name) {
  std::error_code status;
  const std::filesystem::path path = std::filesystem::absolute(pathOf(name), status);
  if (!std::filesystem::is_regular_file(path, status)) {
    return base::fail(machine::MachineError::ProgramMissing, "There is no such program.", name);
  }
  if (m_state.channel != machine::ChannelStatus::Reset) {
    return base::fail(machine::MachineError::NotInReset, "A program is active.", name);
  }
  const base::Result<void> opened = ask("open", path.string());
  if (opened) {
    // Known before LinuxCNC's state is told again.
    m_programFile = path.string();
    m_state.programName = path.filename().string();
  }
  return opened;
}

base::Result<void> LinuxCncControl::cycleStart() {
  if (m_state.waitsForStart) {
    return ask("resume", {});
  }
  if (m_state.channel != machine::ChannelStatus::Reset) {
    return base::fail(machine::MachineError::NotInReset, "A program is active.");
  }
  if (m_state.programName.empty()) {
    return base::fail(machine::MachineError::NoProgramSelected, "No program is selected.");
  }
  return ask("run", {});
}

void LinuxCncControl::reset() {
  tell("abort");
}

std::string LinuxCncControl::traceText() {
  // A client asks as soon as it hears of the end of the program.
  const auto until = std::chrono::steady_clock::now() + kSamplesLate;
  while (m_tracing.isEnding && m_sampler && !m_sampler->hasEnded()) {
    if (std::chrono::steady_clock::now() >= until) {
      giveUpTrace();
      break;
    }
    pollfd file{m_sampler->output(), POLLIN, 0};
    ::poll(&file, 1, static_cast<int>(kPollStep.count()));
    advance(m_now);
  }
  return trace::printControlTrace(m_tracing.trace);
}

}  // namespace rivulet::linuxcnc
