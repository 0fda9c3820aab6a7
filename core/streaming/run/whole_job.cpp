// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/whole_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/units.h"
#include "opcua/await.h"
#include "opcua/forwarding_link.h"
#include "streaming/control/control_alarm.h"
#include "streaming/run/equipment_watch.h"
#include "streaming/run/hosted_run.h"
#include "streaming/run/job.h"
#include "streaming/run/job_trace.h"
#include "streaming/start/program_transfer.h"
#include "templates/continuation.h"
#include "templates/lint/lint.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using opcua::Variable;
using opcua::VariableKind;
using templates::JobProtocol;
using templates::WindowProtocol;

/// Where the axes stand and where they should are this close: servo and exact stop.
constexpr double kStartToleranceMm = 0.05;
constexpr Duration kPartPoll = std::chrono::milliseconds{20};
constexpr Duration kOrderPoll = std::chrono::milliseconds{4};
constexpr Duration kShowInterval = std::chrono::milliseconds{100};
/// Of tool and spindle: now they change.
constexpr Duration kEquipmentInterval = std::chrono::milliseconds{500};

/// Presents one stretch as if it were a program of its own: the channel is in reset before and
/// after it, and what prepares a program has been done. Everything else goes to the control.
class StretchLink final : public opcua::ForwardingLink, public opcua::Control {
 public:
  StretchLink(opcua::Link& link, opcua::Control& control, const templates::JobLoop& loop,
              double call)
      : ForwardingLink(link),
        m_control(control),
        m_state{opcua::rParameter(loop.callCell), opcua::rParameter(loop.cells.state)},
        m_call(call),
        m_end{opcua::rParameter(loop.cells.endCell), static_cast<double>(loop.cells.endValue)},
        m_beat{opcua::rParameter(loop.cells.heartbeat), 0.5} {}

  base::RequestId read(std::span<const Variable> variables, Duration deadline,
                       opcua::Grouping grouping) override {
    const auto status = std::find_if(variables.begin(), variables.end(), isStatus);
    std::vector<Variable> all(variables.begin(), variables.end());
    if (status == variables.end()) {
      const base::RequestId id = m_link.read(variables, deadline, grouping);
      m_reads.push_back({id, std::move(all), std::nullopt});
      return id;
    }
    const auto at = static_cast<std::size_t>(status - variables.begin());
    all.insert(all.end(), m_state.begin(), m_state.end());
    const base::RequestId id = m_link.read(all, deadline, opcua::Grouping::List);
    m_reads.push_back({id, std::move(all), at});
    return id;
  }
  base::RequestId write(std::span<const opcua::Assignment> assignments, Duration deadline,
                        opcua::Grouping grouping) override {
    // What a run clears before its start has been cleared by the loop.
    return m_isStarted ? m_link.write(assignments, deadline, grouping)
                       : m_link.write({&m_beat, 1}, deadline, opcua::Grouping::List);
  }
  std::optional<opcua::Event> wait(Instant until) override {
    std::optional<opcua::Event> event = m_link.wait(until);
    if (event) {
      translate(*event);
    }
    return event;
  }

  Result<void> uploadProgram(const std::string&, const std::string& text, bool) override {
    m_text = text;
    return {};
  }
  Result<std::string> downloadProgram(const std::string&) override { return m_text; }
  Result<void> selectProgram(const std::string&) override { return {}; }
  [[nodiscard]] bool isVirtualMachine() const override { return m_control.isVirtualMachine(); }
  /// The trace is that of the whole job.
  [[nodiscard]] opcua::Abilities abilities() const override { return {true, false}; }
  Result<void> cycleStart() override {
    m_isStarted = true;
    return {};
  }
  /// Ends the whole job.
  Result<void> reset() override { return opcua::writeNow(m_link, {&m_end, 1}, kSetupDeadline); }
  Result<trace::ControlTrace> fetchTrace() override { return m_control.fetchTrace(); }

 private:
  struct Read {
    base::RequestId id;
    std::vector<Variable> variables;
    std::optional<std::size_t> status;  ///< place of the channel's status; then the job's follow
  };

  static bool isStatus(const Variable& variable) {
    return variable.kind == VariableKind::ChannelStatus;
  }

  void translate(opcua::Event& event) {
    const auto read = std::find_if(m_reads.begin(), m_reads.end(),
                                   [&event](const Read& each) { return each.id == event.request; });
    if (read == m_reads.end()) {
      return;
    }
    if (event.kind == opcua::EventKind::ReadDone) {
      holdPlace(read->variables, event.readings);
    }
    if (event.kind == opcua::EventKind::ReadDone && read->status) {
      const opcua::Reading state = event.readings.back();
      const opcua::Reading call = event.readings[event.readings.size() - m_state.size()];
      event.readings.resize(event.readings.size() - m_state.size());
      const bool isRead = !call.status && !state.status;
      const bool runs = m_isStarted && call.number == m_call &&
                        state.number == static_cast<double>(templates::WindowState::Runs);
      if (isRead && !runs) {
        event.readings[*read->status].number = opcua::kChannelReset;
      }
    }
    m_reads.erase(read);
  }

  /// Axes that have arrived still settle by some nanometres. Until the start they stand where they
  /// were first seen: what is streamed is what was checked, recorded and is judged.
  void holdPlace(const std::vector<Variable>& variables, std::vector<opcua::Reading>& readings) {
    for (std::size_t i = 0; !m_isStarted && i < std::min(variables.size(), readings.size()); ++i) {
      if (variables[i].kind == VariableKind::ActualPosition && !readings[i].status) {
        readings[i].number =
            m_place.try_emplace(variables[i].index, readings[i].number).first->second;
      }
    }
  }

  opcua::Control& m_control;
  std::map<int, double> m_place;  ///< of the axes, by their index
  std::array<Variable, 2> m_state;
  double m_call;
  opcua::Assignment m_end;
  opcua::Assignment m_beat;
  std::string m_text;
  std::vector<Read> m_reads;
  bool m_isStarted = false;
};

/// Keeps what a stretch has executed with the name of whoever has started the job: the stretch has
/// none, because it claims nothing.
class StretchKeeper final : public CheckpointKeeper {
 public:
  StretchKeeper(CheckpointKeeper& keeper, RunOrigin origin)
      : m_keeper(keeper), m_origin(std::move(origin)) {}
  Result<void> keep(const Checkpoint& checkpoint, const RunSettings& settings,
                    std::span<const gcode::StreamPoint> points) override {
    RunSettings named = settings;
    named.origin = m_origin;
    return m_keeper.keep(checkpoint, named, points);
  }

 private:
  CheckpointKeeper& m_keeper;
  RunOrigin m_origin;
};

class WholeJob : public HostedRun {
 public:
  WholeJob(opcua::Link& link, opcua::Control& control, const job::Plan& plan,
           const job::JobPrograms& programs, const RunSettings& settings, RunOrders& orders,
           WholeJobSink& sink, const WholeJobOptions& options)
      : HostedRun(link, control, programs.loop, settings, orders, sink, options.writer),
        m_plan(plan),
        m_sink(sink),
        m_options(options),
        m_programs(programs) {
    for (std::size_t part = 0; part < plan.parts.size(); ++part) {
      const auto* const stretch = std::get_if<job::Stretch>(&plan.parts[part]);
      if (stretch == nullptr) {
        m_natives.push_back(part);
      } else if (stretch->number > 0) {
        m_stretches.push_back(stretch);
      }
    }
    m_report.partTimes.resize(plan.parts.size());
  }

  WholeJobReport run() {
    Result<void> result;
    for (const auto step : {&WholeJob::prepare, &WholeJob::claimCells, &WholeJob::transfer,
                            &WholeJob::start, &WholeJob::greet, &WholeJob::goThrough}) {
      if (result && !m_isCancelled) {
        result = (this->*step)();
      }
    }
    if (m_isCancelled) {
      m_isOver = true;
      m_report.outcome = Outcome::Stopped;
    }
    if (!result) {
      m_report.outcome = Outcome::Failed;
      m_report.error = result.error();
      if (m_isNative && m_report.error.code == opcua::LinkError::ConnectionLost) {
        m_report.error.message +=
            ' ' + describeUnattended(m_plan, m_due, m_report.reached.stretch, m_options.expected);
      }
      if (m_isStarted && !m_isOver && m_report.error.code != opcua::LinkError::ConnectionLost) {
        (void)writeRun(WindowProtocol::kEnd);  // else the control waits until it ends by itself
      }
    }
    judge();
    endRecording();
    if (m_report.error.code != opcua::LinkError::ConnectionLost) {
      m_claim.release();
    }
    publish(endState(m_report.outcome), "");
    return std::move(m_report);
  }

 private:
  struct State {
    bool isReset = false;
    bool isInterrupted = false;
    double call = 0.0;
    double native = 0.0;  ///< of the block cell
  };

  /// The stretches by the control's trace. Programs on the control have lines of their own.
  void judge() {
    for (const StretchReport& stretch : m_report.stretches) {
      m_report.pauses.insert(m_report.pauses.end(), stretch.run.pauses.begin(),
                             stretch.run.pauses.end());
    }
    m_report.access = m_ledger.statistics();
    m_report.feed = m_feed.events(m_link.now());
    m_report.factor = m_feed.factors();
    if (!m_trace || m_report.error.code == opcua::LinkError::ConnectionLost) {
      return;
    }
    publish(m_isStopped ? RunState::Stopping : RunState::Running, "trace");
    if (const Result<void> fetched = fetchRest(m_control, *m_trace); !fetched) {
      remark("the control's trace could not be fetched: " + fetched.error().text());
      return;
    }
    TraceFindings found = m_trace->finish();
    m_report.controlTrace = std::move(found.kept);
    if (!found.isWhole) {
      remark("the control's trace is incomplete: the job is not judged");
      return;
    }
    m_report.tools = m_trace->tools();
    if (hasPrograms()) {
      return;
    }
    m_report.integrity = std::move(found.integrity);
    if (m_report.integrity.judged) {
      m_report.pauses = std::move(found.pauses);
      m_report.holds = takeHolds(m_report.pauses, m_report.feed);
    }
  }

  /// They have lines of their own: which block is streamed cannot be told.
  [[nodiscard]] bool hasPrograms() const {
    return std::any_of(m_natives.begin(), m_natives.end(), [this](auto part) {
      return std::get<job::NativeBlock>(m_plan.parts[part]).reason == job::NativeReason::Subprogram;
    });
  }

  /// While the control executes its own blocks, there is time for the next piece of its trace. What
  /// was not answered is fetched later.
  void takeTrace() {
    if (!m_fetch.lateness(m_link.now())) {
      return;
    }
    opcua::Link& link = m_claim.link();
    m_fetch.ask(link, m_settings.setupDeadline);
    if (const auto id = m_fetch.pending()) {
      const Result<opcua::Event> event = opcua::awaitAnswer(link, *id, m_settings.setupDeadline);
      m_fetch.answered(event ? &*event : nullptr, m_link.now());
    }
  }

  void endRecording() {
    if (m_options.writer == nullptr || !m_isRecording) {
      return;
    }
    Counters counters;
    for (const StretchReport& stretch : m_report.stretches) {
      counters.sent += stretch.run.counters.sent;
      counters.accepted += stretch.run.counters.accepted;
      counters.executed += stretch.run.counters.executed;
    }
    for (const job::Stretch* stretch : m_stretches) {
      counters.total += stretch->pointCount;
    }
    m_options.writer->end({std::string(outcomeName(m_report.outcome)), counters.sent,
                           counters.accepted, counters.executed, counters.total,
                           m_report.times.total(),
                           m_report.error.code ? m_report.error.text() : std::string()});
  }

  void startRecording() {
    if (m_options.writer != nullptr) {
      RunSettings settings = m_settings;
      settings.runNumber = m_firstRun;
      trace::RunStart start = runStartOf(m_options.start, settings, m_plan.program);
      start.continuations = templates::continuationsOf(m_flexible.text);
      m_options.writer->start(start);
      m_isRecording = true;
    }
  }

  /// In the recording alone.
  void remark(std::string text) {
    if (m_options.writer != nullptr) {
      m_options.writer->note({m_link.now(), std::move(text)});
    }
  }

  Result<void> prepare() {
    if (Result<void> sound = templates::requireSound(m_flexible); !sound) {
      return sound;
    }
    m_firstRun = m_settings.runNumber != 0 ? m_settings.runNumber
                                           : runNumberFrom(entropy(m_plan.program.hash));
    m_firstRun = 1 + (m_firstRun - 1) % (kRunNumberMax - JobProtocol::kStretchesMax);
    m_report.runNumber = m_firstRun;
    startRecording();
    const std::array<Variable, 2> watched{
        {{VariableKind::ChannelStatus, 0}, {VariableKind::Alarm, 0}}};
    const auto numbers = opcua::readNumbers(m_link, watched, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    if ((*numbers)[0] != opcua::kChannelReset) {
      return base::fail(m_claim.withName(channelBusy()));
    }
    return requireNoAlarm((*numbers)[1]);
  }

  Result<void> claimCells() { return claim(m_firstRun); }

  Result<void> transfer() {
    publish(RunState::Armed, "transfer");
    if (const auto access = chooseAccess(); !access) {
      return base::fail(access.error());
    }
    m_settings.access = AccessChoice::Fixed;  // of the stretches, too
    if (Result<void> done = renewClaim(); !done || m_isCancelled) {
      return done;
    }
    if (m_programs.loop.isOwnFile) {
      const auto loop =
          storeProgram(m_control, m_flexible.name, m_flexible.text, TransferWay::Link);
      if (!loop) {
        return base::fail(loop.error());
      }
    }
    const Result<ProgramTransfer> main =
        transferProgram(m_control, m_programs.mainName, m_programs.mainText, m_settings.transfer);
    if (!main) {
      return base::fail(main.error());
    }
    if (Result<void> kept = keep(false); !kept) {
      return kept;
    }
    // Programs take a while to be transferred, and nothing can be repeated meanwhile.
    return renewClaim();
  }

  /// From the first block on, what was executed is not known without the control's cells. A job of
  /// which this computer keeps less than that could be begun once more: it does not start.
  /// @param isGranted  the control may begin
  Result<void> keep(bool isGranted) {
    if (m_options.keeper == nullptr) {
      return {};
    }
    Checkpoint checkpoint;
    checkpoint.runNumber = m_firstRun;
    checkpoint.granted = isGranted;
    Result<void> kept = m_options.keeper->keep(checkpoint, m_settings, {});
    if (!kept) {
      kept.error().message =
          "The job cannot be kept on this computer, so it could not be resumed after a crash. "
          "Nothing has moved. " +
          kept.error().message;
    }
    return kept;
  }

  Result<void> start() {
    const Result<void> started =
        startProgram({m_programs.loop.callCell, m_cells.layout, m_cells.run}, "cycle-start");
    if (!started) {
      return started;
    }
    m_isStarted = true;
    if (m_control.abilities().keepsTrace) {
      m_trace.emplace(m_points, m_programs.loop, hasPrograms() ? nullptr : m_options.writer);
      m_fetch.begin(*m_trace, {});
    }
    return awaitStart(kPartPoll, [this]() -> Result<bool> {
      const Result<State> state = look();
      if (!state) {
        return base::fail(state.error());
      }
      if (state->call != call(0) && state->call != 0.0) {
        return base::fail(StreamError::WrongProgram,
                          "The control runs another job. Nothing was started: reset the control "
                          "and select the program.",
                          m_programs.mainName);
      }
      return state->call == call(0);
    });
  }

  /// The control obeys this client from here on.
  Result<void> greet() {
    const opcua::Assignment claim{opcua::rParameter(m_cells.client),
                                  static_cast<double>(m_firstRun)};
    const opcua::Assignment go{opcua::rParameter(m_cells.run),
                               static_cast<double>(WindowProtocol::kRun)};
    const std::array<Variable, 1> owner{opcua::rParameter(m_cells.owner)};
    const Instant until = m_link.now() + m_settings.stallDeadline;
    if (Result<void> done = opcua::writeNow(m_claim.link(), {&claim, 1}, m_settings.setupDeadline);
        !done) {
      return done;
    }
    for (;;) {
      const auto numbers = opcua::readNumbers(m_claim.link(), owner, m_settings.setupDeadline);
      if (!numbers) {
        return base::fail(numbers.error());
      }
      if ((*numbers)[0] == static_cast<double>(m_firstRun)) {
        break;
      }
      if ((*numbers)[0] != 0.0 || m_link.now() >= until) {
        return base::fail(StreamError::OtherClient,
                          "Another client is using the program on the control. Rivulet writes "
                          "nothing more: wait until the other client has finished, or reset the "
                          "control.");
      }
      pause(kPartPoll);
    }
    if (Result<void> tried = requireFeedCell(); !tried) {
      return tried;
    }
    if (Result<void> kept = keep(true); !kept) {
      return kept;
    }
    m_claim.release();
    m_lastGoOn = JobProtocol::goOn(0);
    m_isNative = true;
    return opcua::writeNow(m_link, {&go, 1}, m_settings.setupDeadline);
  }

  /// Native blocks and stretches by turns, until the control has ended the program.
  Result<void> goThrough() {
    std::size_t next = 0;
    m_sink.nativeBlocks(numberAt(next));
    m_accountedTo = m_link.now();
    while (!m_isOver) {
      const Result<State> state = look();
      if (!state) {
        return base::fail(state.error());
      }
      accountNative(*state, next);
      if (state->isReset) {
        return judgeEnd(next, state->native);
      }
      if (Result<void> shown = show(); !shown) {
        return shown;
      }
      takeTrace();
      if (Result<void> done = passStop(state->isInterrupted); !done) {
        return done;
      }
      if (m_held.isDue(m_isStopped, m_feed, m_orders, m_link.now())) {
        return leaveHeld();
      }
      if (next > 0 && state->call == call(m_stretches[next - 1]->number)) {
        if (Result<void> returns = awaitReturn(*m_stretches[next - 1], state->isInterrupted);
            !returns) {
          return returns;
        }
      }
      const bool isCalled =
          next < m_stretches.size() && state->call == call(m_stretches[next]->number);
      if (!isCalled) {
        for (const auto step : {&WholeJob::followOrders, &WholeJob::waitAttentively}) {
          if (Result<void> done = (this->*step)(); !done) {
            return done;
          }
        }
        continue;
      }
      if (Result<void> done = stream(*m_stretches[next]); !done) {
        if (done.error().code == job::JobError::PositionDiffers && hasEnded()) {
          continue;  // positions were those of another frame
        }
        return done;
      }
      ++next;
      m_sink.nativeBlocks(numberAt(next));
    }
    return {};
  }

  /// The loop has been permitted to return, and has not yet. What somebody has stopped or holds is
  /// waited for.
  Result<void> awaitReturn(const job::Stretch& stretch, bool isInterrupted) {
    if (isInterrupted || m_isHeld || m_isStopped || m_feed.holds()) {
      m_permittedAt = m_link.now();
    }
    if (m_link.now() < m_permittedAt + m_settings.stallDeadline) {
      return {};
    }
    return base::fail(
        StreamError::StreamStalled,
        fmt::format("The control did not go on after stretch {}. Reset it, and check its program.",
                    stretch.number));
  }

  /// Of a stretch. @param index  in `m_stretches`; after the last: one more than its number
  [[nodiscard]] int numberAt(std::size_t index) const {
    return index < m_stretches.size() ? m_stretches[index]->number
           : m_stretches.empty()      ? 1
                                      : m_stretches.back()->number + 1;
  }

  /// The time since the last look belongs to the native block that was due then.
  void accountNative(const State& state, std::size_t next) {
    const base::Duration passed = m_link.now() - m_accountedTo;
    m_accountedTo += passed;
    const int last = m_due;
    m_due = state.call < 0.0 && belongs(std::abs(state.native), next)
                ? static_cast<int>(std::abs(state.native))
                : m_due;
    if (last == 0) {
      m_report.times.handover += passed;
    } else {
      const std::size_t part = m_natives[static_cast<std::size_t>(last) - 1];
      const bool isTool =
          std::get<job::NativeBlock>(m_plan.parts[part]).reason == job::NativeReason::Tool;
      JobTimes times;
      (isTool ? times.toolChange : times.native) = passed;
      m_report.partTimes[part] += times;
      m_report.times += times;
    }
    if (m_due > 0) {
      const auto& block =
          std::get<job::NativeBlock>(m_plan.parts[m_natives[static_cast<std::size_t>(m_due) - 1]]);
      m_report.reached.native = m_due;
      m_report.reached.line = block.place.line;
      m_report.reached.file = block.file;
    }
  }

  /// The cell has another meaning before the control has cleared it.
  /// @param number  in the block cell  @param next  stretch that comes next, from 0
  [[nodiscard]] bool belongs(double number, std::size_t next) const {
    if (!(number >= 1.0) || number > static_cast<double>(m_natives.size()) ||
        number != std::floor(number)) {
      return false;
    }
    const std::size_t part = m_natives[static_cast<std::size_t>(number) - 1];
    const auto partOf = [this](std::size_t stretch) {
      return partOfStretch(*m_stretches[stretch]);
    };
    return (next == 0 || part > partOf(next - 1)) &&
           (next == m_stretches.size() || part < partOf(next));
  }

  [[nodiscard]] std::size_t partOfStretch(const job::Stretch& stretch) const {
    const auto is = [&stretch](const job::Part& part) {
      const auto* const each = std::get_if<job::Stretch>(&part);
      return each == &stretch;
    };
    return static_cast<std::size_t>(std::find_if(m_plan.parts.begin(), m_plan.parts.end(), is) -
                                    m_plan.parts.begin());
  }

  /// Tells the display which block is due and where the axes are. Nothing else needs the link now.
  Result<void> show() {
    if (m_due != m_shownDue) {
      m_shownDue = m_due;
      if (m_due > 0) {
        const auto& block = std::get<job::NativeBlock>(
            m_plan.parts[m_natives[static_cast<std::size_t>(m_due) - 1]]);
        remark(
            fmt::format("the control executes line {}: {}", block.place.line.value, block.source));
        m_sink.nativeBlock(block);
      }
    }
    if (m_link.now() < m_nextShown) {
      return {};
    }
    m_nextShown = m_link.now() + kShowInterval;
    const std::array<Variable, 4> shown{{{VariableKind::ActualPosition, 0},
                                         {VariableKind::ActualPosition, 1},
                                         {VariableKind::ActualPosition, 2},
                                         {VariableKind::PathFeed, 0}}};
    const auto numbers = opcua::readNumbers(m_claim.link(), shown, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    LiveUpdate update;
    update.state = m_isStopped                  ? RunState::Stopping
                   : m_isHeld || m_feed.holds() ? RunState::Holding
                                                : RunState::Running;
    update.waitingFor = "native-blocks";
    if (m_feed.exists()) {
      update.feed = m_feed.state();
    }
    update.at = m_link.now();
    update.sample = trace::LiveSample{};
    update.sample->at = update.at;
    update.sample->positionMm = base::Vec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    update.sample->feedMmPerS = base::mmPerSFromMmPerMin((*numbers)[3]);
    if (!m_equipment.variables().empty() && m_link.now() >= m_nextEquipment) {
      m_nextEquipment = m_link.now() + kEquipmentInterval;
      const auto readings =
          opcua::readNow(m_claim.link(), m_equipment.variables(), m_settings.setupDeadline);
      if (!readings) {
        return base::fail(readings.error());
      }
      update.equipment = m_equipment.take(*readings);
    }
    m_ledger.update(update);
    return {};
  }

  /// @param native  see `job::blockCell`
  Result<void> judgeEnd(std::size_t next, double native) {
    m_isOver = true;
    if (m_isStopped) {
      m_report.outcome = Outcome::Stopped;
      return {};
    }
    if (next < m_stretches.size()) {
      return base::fail(StreamError::EndedEarly,
                        fmt::format("The program on the control ended before stretch {} of {}.",
                                    m_stretches[next]->number, m_stretches.size()));
    }
    if (native != job::doneNumber(m_plan)) {
      return base::fail(StreamError::EndedEarly,
                        fmt::format("The program on the control ended before its last block, at "
                                    "line {}.",
                                    m_report.reached.line.value));
    }
    m_report.outcome = Outcome::Completed;
    return {};
  }

  /// The program stands at M0 or M1, where no command of the client reaches it.
  Result<void> passStop(bool isInterrupted) {
    const bool wasInterrupted = std::exchange(m_isInterrupted, isInterrupted);
    if (!isInterrupted) {
      return {};
    }
    if (m_isStopped) {
      return m_control.abilities().startsOnRequest
                 ? m_control.reset()
                 : base::fail(StreamError::StopNotConfirmed,
                              "The program waits for cycle start. Press reset at the control.");
    }
    const bool presses = !wasInterrupted && m_sink.waitsForCycleStart();
    return presses ? m_control.cycleStart() : Result<void>();
  }

  /// Stop and hold while native blocks are executed: they take effect at the next one.
  Result<void> followOrders() {
    if (m_isStopped) {
      return {};
    }
    if (m_orders.stopRequested(m_link.now())) {
      return end();
    }
    const bool holds = m_orders.holdRequested(m_link.now());
    if (holds == m_isHeld) {
      return {};
    }
    m_isHeld = holds;
    publish(holds ? RunState::Holding : RunState::Running, "native-blocks");
    return writeRun(holds ? WindowProtocol::kHold : m_lastGoOn);
  }

  /// Until it is time to look again. The feed cell does not wait for that.
  Result<void> waitAttentively() {
    const Instant until = m_link.now() + kPartPoll;
    do {
      if (Result<void> done = followFeed(); !done) {
        return done;
      }
      pause(std::min(kOrderPoll, until - m_link.now()));
    } while (m_link.now() < until);
    return {};
  }

  Result<void> end() {
    m_isStopped = true;
    publish(RunState::Stopping, "");
    return writeRun(WindowProtocol::kEnd);
  }

  Result<void> leaveHeld() {
    m_isOver = true;
    m_report.leftHeld = true;
    m_report.outcome = Outcome::Stopped;
    return {};
  }

  Result<void> writeRun(int value) {
    const opcua::Assignment run{opcua::rParameter(m_cells.run), static_cast<double>(value)};
    return opcua::writeNow(m_link, {&run, 1}, m_settings.setupDeadline);
  }

  Result<void> stream(const job::Stretch& stretch) {
    m_isNative = false;
    RunSettings settings = m_settings;
    settings.runNumber = JobProtocol::runNumber(m_firstRun, stretch.number);
    settings.origin = {};
    settings.resume = &stretch == m_stretches.front() ? m_options.resume : std::optional<Resume>();
    settings.transfer = TransferWay::Link;
    const gcode::Program program = programOf(m_plan, stretch);
    StretchLink link(m_link, m_control, m_programs.loop, call(stretch.number));
    const Result<Preflight> flight = preflight(link, program, settings);
    if (!flight) {
      return base::fail(flight.error());
    }
    if (Result<void> there = requireStart(stretch, flight->toolMm); !there) {
      return there;
    }
    remark(
        fmt::format("stretch {} begins, {} points", stretch.number, flight->points.points.size()));
    if (m_options.writer != nullptr) {
      m_options.writer->points(flight->points);
    }
    m_sink.stretchBegins(stretch, flight->toolMm);
    m_points.insert(m_points.end(), flight->points.points.begin(), flight->points.points.end());
    StretchReport report{stretch.number, flight->toolMm, flight->points.points, {}};
    std::optional<StretchKeeper> keeper;
    if (m_options.keeper != nullptr) {
      keeper.emplace(*m_options.keeper, m_settings.origin);
    }
    report.run =
        runJob(link, link, program, m_flexible, settings, m_orders, m_ledger,
               {nullptr, {}, keeper ? &*keeper : nullptr, m_trace ? &*m_trace : nullptr, &m_feed});
    const RunReport& run = m_report.stretches.emplace_back(std::move(report)).run;
    accountStretch(stretch, m_report.stretches.back());
    if (run.outcome == Outcome::Completed) {
      return goOn(stretch.number);
    }
    m_isStopped = run.outcome == Outcome::Stopped;
    if (run.error.code == opcua::LinkError::ConnectionLost) {
      return base::fail(run.error);
    }
    if (run.leftHeld) {
      return leaveHeld();
    }
    // The loop has ended the job itself, or does so now.
    if (Result<void> done = writeRun(WindowProtocol::kEnd); !done) {
      return done;
    }
    if (Result<void> done = awaitReset(); !done) {
      return done;
    }
    if (!m_isStopped) {
      return base::fail(run.error);
    }
    m_isOver = true;
    m_report.outcome = Outcome::Stopped;
    return {};
  }

  void accountStretch(const job::Stretch& stretch, const StretchReport& report) {
    const RunReport& run = report.run;
    JobTimes times;
    for (const trace::Pause& pause : run.pauses) {
      times.pauses += pause.duration;
    }
    times.pauses = std::min(times.pauses, run.duration);
    times.streamed = run.duration - times.pauses;
    times.handover = std::max(base::Duration{}, m_link.now() - m_accountedTo - run.duration);
    m_accountedTo = m_link.now();
    m_due = 0;
    m_report.partTimes[partOfStretch(stretch)] += times;
    m_report.times += times;
    m_report.reached = {stretch.number, run.counters.executed, run.counters.total, 0, {}, {}};
    if (run.counters.executed > 0 && run.counters.executed <= report.points.size()) {
      m_report.reached.line = report.points[run.counters.executed - 1].line;
    }
  }

  /// A tool that is elsewhere than the program says means another frame, offset or tool length.
  Result<void> requireStart(const job::Stretch& stretch, base::Vec3 toolMm) const {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (std::abs(toolMm[axis] - stretch.startMm[axis]) > kStartToleranceMm) {  // NaN: not known
        return base::fail(
            job::JobError::PositionDiffers,
            fmt::format("Before stretch {} (line {}) {} is at {:.3f} mm, but at {:.3f} mm by the "
                        "program: a frame or tool offset has changed. Nothing more was moved. "
                        "Check the blocks before that line.",
                        stretch.number, stretch.blocks.front().line.value, base::kAxisNames[axis],
                        toolMm[axis], stretch.startMm[axis]));
      }
    }
    return {};
  }

  Result<void> goOn(int stretch) {
    m_lastGoOn = JobProtocol::goOn(stretch);
    m_isHeld = false;
    m_isNative = true;
    m_permittedAt = m_link.now();
    return writeRun(m_lastGoOn);
  }

  Result<void> awaitReset() {
    const Instant from = m_link.now();
    const Duration lost = m_feed.lostTime(from);
    while (m_link.now() < from + m_settings.stopDeadline + m_feed.lostTime(m_link.now()) - lost) {
      const Result<State> state = look();
      if (!state || state->isReset) {
        return state ? Result<void>() : base::fail(state.error());
      }
      if (Result<void> done = waitAttentively(); !done) {
        return done;
      }
    }
    return base::fail(StreamError::StopNotConfirmed,
                      "The control did not end the job. Stop it at the control.");
  }

  [[nodiscard]] bool hasEnded() {
    const Result<State> state = look();
    return state && state->isReset;
  }

  Result<State> look() {
    const std::array<Variable, 4> watched{{{VariableKind::ChannelStatus, 0},
                                           {VariableKind::Alarm, 0},
                                           opcua::rParameter(m_programs.loop.callCell),
                                           opcua::rParameter(job::blockCell(m_programs.loop))}};
    const auto numbers = opcua::readNumbers(m_claim.link(), watched, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    if ((*numbers)[1] != 0.0) {
      return base::fail(alarm(static_cast<int>((*numbers)[1]), (*numbers)[2], (*numbers)[3]));
    }
    return State{(*numbers)[0] == opcua::kChannelReset, (*numbers)[0] == opcua::kChannelInterrupted,
                 (*numbers)[2], (*numbers)[3]};
  }

  /// With the block of the source program, if the control has told which one is due.
  [[nodiscard]] base::Error alarm(int number, double call, double block) const {
    const bool isNative = call < 0.0;  // a stretch has been executed
    if (!isNative || !(block >= 1.0) || block > static_cast<double>(m_natives.size())) {
      return base::makeError(
          StreamError::ControlAlarm,
          fmt::format("The control stopped with alarm {}. Clear it at the control.", number));
    }
    const auto& native =
        std::get<job::NativeBlock>(m_plan.parts[m_natives[static_cast<std::size_t>(block) - 1]]);
    return base::makeError(
        StreamError::ControlAlarm,
        fmt::format("The control stopped with alarm {} at line {} of {}: {}. Clear it at the "
                    "control.",
                    number, native.place.line.value,
                    native.file.empty() ? m_plan.program.name : native.file, native.source));
  }

  [[nodiscard]] double call(int stretch) const {
    return JobProtocol::callNumber(m_programs.number, stretch);
  }

  const job::Plan& m_plan;
  WholeJobSink& m_sink;
  const WholeJobOptions& m_options;
  const job::JobPrograms& m_programs;
  bool m_isRecording = false;
  std::vector<const job::Stretch*> m_stretches;
  std::vector<std::size_t> m_natives;  ///< parts that are native blocks, by their number less 1
  std::vector<gcode::StreamPoint> m_points;  ///< of the stretches that have begun
  std::optional<JobTrace> m_trace;
  TraceFetch m_fetch;
  int m_firstRun = 0;
  int m_lastGoOn = 0;
  Instant m_permittedAt{};  ///< to go on, or held since
  bool m_isStarted = false;
  bool m_isStopped = false;
  bool m_isHeld = false;
  bool m_isInterrupted = false;
  bool m_isNative = false;  ///< the control may execute blocks of its own
  Instant m_nextShown{};
  EquipmentWatch m_equipment;
  Instant m_nextEquipment{};
  int m_shownDue = 0;
  bool m_isOver = false;
  LeftHeld m_held;
  int m_due = 0;            ///< native block that was due at the last look, from 1; 0: none yet
  Instant m_accountedTo{};  ///< all time before is in the report
  WholeJobReport m_report;
};

}  // namespace

std::string describe(const JobPlace& place) {
  const std::string line = place.file.empty()
                               ? fmt::format("line {}", place.line.value)
                               : fmt::format("line {} of {}", place.line.value, place.file);
  if (place.native > 0) {
    return fmt::format("at the block for the control in {}{}", line,
                       place.stretch > 0 ? fmt::format(", after stretch {}", place.stretch) : "");
  }
  if (place.stretch == 0) {
    return "before anything was executed";
  }
  return fmt::format("in stretch {}, after {} of {} points{}", place.stretch, place.executed,
                     place.total, place.line.value > 0 ? ", at " + line : "");
}

std::string describeUnattended(const job::Plan& plan, int due, int stretch,
                               const std::vector<Duration>& expected) {
  int number = 0;
  int next = 0;
  bool moves = false;
  bool cycles = false;
  Duration lasts{};
  const job::NativeBlock* first = nullptr;
  const job::NativeBlock* last = nullptr;
  bool isAfter = stretch == 0;
  for (std::size_t part = 0; part < plan.parts.size() && next == 0; ++part) {
    const auto* const native = std::get_if<job::NativeBlock>(&plan.parts[part]);
    if (native == nullptr) {
      const int each = std::get<job::Stretch>(plan.parts[part]).number;
      next = isAfter ? each : 0;
      isAfter = isAfter || each == stretch;
      continue;
    }
    ++number;
    if (!isAfter || number < due) {
      continue;
    }
    first = first == nullptr ? native : first;
    last = native;
    cycles = cycles || native->reason == job::NativeReason::Cycle;
    moves = moves || native->moves || native->reason < job::NativeReason::Tool;
    lasts += part < expected.size() ? expected[part] : Duration{};
  }
  const std::string what =
      first == nullptr
          ? "the blocks that follow"
          : fmt::format("lines {} to {} ({}, {})", first->place.line.value, last->place.line.value,
                        !moves   ? "no axis moves"
                        : cycles ? "the axes move, drilling and other cycles included"
                                 : "the axes move",
                        expected.empty() ? std::string("how long is not known")
                                         : fmt::format("about {:.0f} s", base::toSeconds(lasts)));
  return fmt::format(
      "The control goes on by itself: it executes {}. {} Feed stop, reset and emergency stop at "
      "the "
      "control act as always.",
      what,
      next > 0
          ? fmt::format("At stretch {} it waits for a client, and ends the program if none comes.",
                        next)
          : "Then the program ends.");
}

gcode::Program programOf(const job::Plan& plan, const job::Stretch& stretch) {
  const auto slice = [&stretch](const auto& all) {
    using List = std::decay_t<decltype(all)>;
    if (all.empty()) {
      return List{};
    }
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(stretch.firstPoint);
    return List(begin, begin + static_cast<std::ptrdiff_t>(stretch.pointCount));
  };
  gcode::Program program;
  program.name = plan.program.name;
  program.hash = fmt::format("{}-{}", plan.program.hash, stretch.number);
  program.dialect = plan.program.dialect;
  program.trajectory.points = slice(plan.program.trajectory.points);
  program.trajectory.rotary = slice(plan.program.trajectory.rotary);
  program.trajectory.toolDirections = slice(plan.program.trajectory.toolDirections);
  return program;
}

WholeJobReport runWholeJob(opcua::Link& link, opcua::Control& control, const job::Plan& plan,
                           const job::JobPrograms& programs, const RunSettings& settings,
                           RunOrders& orders, WholeJobSink& sink, const WholeJobOptions& options) {
  return WholeJob(link, control, plan, programs, settings, orders, sink, options).run();
}

WholeJobReport runWholeJob(opcua::Link& link, opcua::Control& control, const job::Plan& plan,
                           const RunSettings& settings, RunOrders& orders, WholeJobSink& sink,
                           const WholeJobOptions& options) {
  const auto programs = job::makePrograms(plan, settings.parameters);
  if (!programs) {
    WholeJobReport report;
    report.error = programs.error();
    report.partTimes.resize(plan.parts.size());
    return report;
  }
  return runWholeJob(link, control, plan, *programs, settings, orders, sink, options);
}

}  // namespace rivulet::streaming
