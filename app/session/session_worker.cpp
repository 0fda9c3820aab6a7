// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/session_worker.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <span>
#include <vector>

#include "base/units.h"
#include "job/main_program.h"
#include "live/error.h"
#include "live/point_stream.h"
#include "opcua/await.h"
#include "opcua/machinery.h"
#include "platform/recording_file.h"
#include "run/travel.h"
#include "sources/open_source.h"
#include "streaming/recovery/job_resume.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job_count.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/template_proof.h"
#include "templates/flexible_program.h"
#include "trace/recording.h"

namespace rivulet::session {

using streaming::ActiveProgram;

namespace {

/// How often the control is read between runs.
constexpr std::chrono::milliseconds kWatchInterval{250};
constexpr std::chrono::seconds kWatchDeadline{2};
/// How often what a server describes of its machines is read, which takes about twenty requests.
constexpr std::chrono::seconds kDescriptionInterval{10};
constexpr std::chrono::milliseconds kProgressInterval{50};
/// How long the thread waits for room when the GUI is busy, per attempt.
constexpr std::chrono::milliseconds kRoomInterval{2};

std::vector<gcode::StreamPoint> pathOf(const gcode::Program& program,
                                       const streaming::RunReport& report) {
  const base::Vec3 startMm = report.checkpoint ? report.checkpoint->startMm : base::Vec3{};
  return gcode::streamPoints(program.trajectory, startMm).points;
}

std::optional<int> wholeNumber(const opcua::Reading& reading) {
  const auto value = reading.value();
  return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

std::optional<std::string> textOf(const opcua::Reading& reading) {
  return reading.status ? std::nullopt : std::optional(reading.text);
}

bool areRead(std::span<const opcua::Reading> readings) {
  return std::all_of(readings.begin(), readings.end(),
                     [](const opcua::Reading& one) { return one.value().has_value(); });
}

base::Error notConnected() {
  return base::makeError(opcua::LinkError::NotReachable,
                         "There is no connection to a control. Connect first.");
}

}  // namespace

/// Passes the reports of a run to the ring.
class SessionWorker::Sink final : public streaming::RunSink {
 public:
  explicit Sink(SessionWorker& worker) : m_worker(worker) {}
  void update(const streaming::LiveUpdate& update) override {
    const bool important = update.pause || update.state != m_state;
    m_state = update.state;
    if (m_worker.m_factor) {
      m_worker.m_factor->tell(update);
    }
    if (important) {
      m_worker.tell(update);
    } else {
      m_worker.tellIfRoom(update);
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note& note) override { m_worker.tell(note); }

 private:
  SessionWorker& m_worker;
  streaming::RunState m_state = streaming::RunState::Idle;
};

/// Passes the reports of a whole job to the ring, counted in all its points.
class SessionWorker::JobSink final : public streaming::WholeJobSink {
 public:
  /// @param program  main program of the job on the control
  JobSink(SessionWorker& worker, const streaming::JobCount& count, std::string program)
      : m_worker(worker), m_count(count), m_out(worker) {
    m_now.program = std::move(program);
  }

  void update(const streaming::LiveUpdate& update) override {
    using streaming::RunState;
    streaming::LiveUpdate shown = update;
    if (m_isInStretch) {
      shown.counters = m_count.inJob(m_now.stretch, update.counters);
      // Each stretch is a run to itself: its beginning and its end are not those of the job.
      shown.state = update.state == RunState::Armed || update.state == RunState::Done
                        ? RunState::Running
                    : update.state == RunState::Stopped || update.state == RunState::Aborted
                        ? RunState::Stopping
                        : update.state;
      shown.waitingFor = update.state == RunState::Armed ? std::string() : update.waitingFor;
      if (shown.wrong) {
        shown.wrong->point += m_count.before(m_now.stretch);
      }
    } else {
      const std::size_t before = m_count.before(m_now.stretch);
      shown.counters = {before, before, before, m_count.total()};
    }
    m_out.update(shown);
  }
  void access(const trace::Access& access) override { m_out.access(access); }
  void note(const trace::Note& note) override { m_out.note(note); }

  void nativeBlocks(int next) override {
    m_isInStretch = false;
    m_now = {next, true, {}, {}, false, m_now.program};
    m_worker.tell(m_now);
  }
  void nativeBlock(const job::NativeBlock& block) override {
    m_now.line = block.file.empty() ? block.place.line : base::LineNumber{};
    m_now.block = block.source;
    m_now.waitsForCycleStart = false;
    m_worker.tell(m_now);
  }
  void stretchBegins(const job::Stretch& stretch, base::Vec3 /*startMm*/) override {
    m_isInStretch = true;
    m_now = {stretch.number, false, {}, {}, false, m_now.program};
    m_worker.tell(m_now);
  }
  bool waitsForCycleStart() override {
    m_now.waitsForCycleStart = true;
    m_worker.tell(m_now);
    return false;  // somebody presses it at the control
  }

 private:
  SessionWorker& m_worker;
  const streaming::JobCount& m_count;
  Sink m_out;
  JobUpdate m_now;
  bool m_isInStretch = false;
};

/// Passes the reports of a run with a live source to the ring, and the points as they are taken.
class SessionWorker::LiveSink final : public streaming::RunSink {
 public:
  /// @param stream  outlives this object
  LiveSink(SessionWorker& worker, const live::PointStream& stream)
      : m_worker(worker), m_stream(stream), m_out(worker) {}
  /// Whoever hears of an executed point has been told where it is.
  void update(const streaming::LiveUpdate& update) override {
    tellPoints();
    m_out.update(update);
  }
  void access(const trace::Access& access) override { m_out.access(access); }
  void note(const trace::Note& note) override { m_out.note(note); }
  /// Those that are left, for the end of the run.
  void finish() {
    if (m_told < m_stream.points().size()) {
      m_worker.tell(next());
    }
  }

 private:
  /// What has no room in the ring goes with the next update.
  void tellPoints() {
    if (m_told < m_stream.points().size() && m_worker.tellIfRoom(next())) {
      m_told = m_stream.points().size();
    }
  }
  [[nodiscard]] LivePoints next() const {
    const std::vector<gcode::StreamPoint>& points = m_stream.points();
    return {m_told, std::make_shared<const std::vector<gcode::StreamPoint>>(
                        points.begin() + static_cast<std::ptrdiff_t>(m_told), points.end())};
  }

  SessionWorker& m_worker;
  const live::PointStream& m_stream;
  Sink m_out;
  std::size_t m_told = 0;
};

class SessionWorker::Requests final : public streaming::RunOrders {
 public:
  explicit Requests(SessionWorker& worker) : m_worker(worker) {}
  bool stopRequested(base::Instant) override {
    return m_worker.m_stopRun.load() || m_worker.m_quit.load();
  }
  base::Vec3 correctionMm(base::Instant) override {
    const std::lock_guard lock(m_worker.m_correctionMutex);
    return m_worker.m_correctionMm;
  }
  bool holdRequested(base::Instant) override { return m_worker.m_feed.holds.load(); }
  streaming::FeedOrder feed(base::Instant now) override {
    streaming::FeedOrder order{m_worker.m_feed.holds.load(), m_worker.m_feed.percent.load(),
                               std::nullopt, m_worker.m_feed.liftMm.load()};
    if (m_worker.m_factor) {
      // Whoever has ordered the end does not wait for a source.
      const bool ends = m_worker.m_stopRun.load() && m_worker.m_letsEnd.load();
      m_worker.m_factor->follow(order, m_worker.m_feed.goesOn.exchange(false) || ends, now);
    }
    return order;
  }
  bool letsEnd(base::Instant) override { return m_worker.m_letsEnd.load(); }
  bool leaves(base::Instant) override { return m_worker.m_quit.load() || m_worker.m_leaves.load(); }

 private:
  SessionWorker& m_worker;
};

SessionWorker::SessionWorker(opcua::Connector connector, report::MachineStore machines)
    : m_connector(std::move(connector)),
      m_machines(std::move(machines)),
      m_thread([this] { work(); }) {
}

SessionWorker::~SessionWorker() {
  m_quit.store(true);
  m_commandCount.release();
  m_thread.join();
}

bool SessionWorker::post(SessionCommand command) {
  if (std::holds_alternative<StartCommand>(command) ||
      std::holds_alternative<CalibrateCommand>(command) ||
      std::holds_alternative<CommissionCommand>(command)) {
    m_stopRun.store(false);
    m_letsEnd.store(true);
    m_leaves.store(false);
    correct({});
    m_feed.holds.store(false);
    m_feed.goesOn.store(false);
    m_feed.percent.store(templates::FeedCell::kProgrammed);
    m_feed.liftMm.store(0.0);
  }
  if (!m_commands.tryPush(std::move(command))) {
    return false;
  }
  m_commandCount.release();
  return true;
}

void SessionWorker::stopRun(bool letsEnd) {
  m_letsEnd.store(letsEnd);
  m_stopRun.store(true);
}

void SessionWorker::leaveRun() {
  stopRun(false);
  m_leaves.store(true);
}

void SessionWorker::correct(base::Vec3 valueMm) {
  const std::lock_guard lock(m_correctionMutex);
  m_correctionMm = valueMm;
}

void SessionWorker::holdRun(bool hold) {
  const bool didHold = m_feed.holds.exchange(hold);
  m_feed.goesOn.store(!hold && !didHold);
  if (!hold) {
    m_letsEnd.store(true);
  }
}

void SessionWorker::liftTool(double mm) {
  m_feed.liftMm.store(mm);
}

void SessionWorker::overrideRun(double percent) {
  m_feed.percent.store(percent);
}

std::optional<SessionEvent> SessionWorker::take() {
  return m_events->tryPop();
}

void SessionWorker::tell(SessionEvent event) {
  while (!m_events->tryPush(event)) {
    if (m_quit.load()) {
      return;
    }
    std::this_thread::sleep_for(kRoomInterval);
  }
}

bool SessionWorker::tellIfRoom(SessionEvent event) {
  const bool hasRoom = m_events->tryPush(std::move(event));
  if (!hasRoom) {
    m_lost.fetch_add(1);
  }
  return hasRoom;
}

void SessionWorker::work() {
  while (!m_quit.load()) {
    // Without a request within the interval, the control is read again.
    if (m_commandCount.try_acquire_for(kWatchInterval)) {
      const std::optional<SessionCommand> command = m_commands.tryPop();
      if (!command) {
        continue;
      }
      if (const auto* connectCommand = std::get_if<ConnectCommand>(&*command)) {
        connect(*connectCommand);
      } else if (std::holds_alternative<DisconnectCommand>(*command)) {
        disconnect();
      } else if (const auto* startCommand = std::get_if<StartCommand>(&*command)) {
        start(*startCommand);
      } else if (const auto* question = std::get_if<ResumeQuestion>(&*command)) {
        answer(*question);
      } else if (const auto* listenCommand = std::get_if<ListenCommand>(&*command)) {
        listen(listenCommand->address);
      } else if (const auto* endCommand = std::get_if<EndRunCommand>(&*command)) {
        endRun(*endCommand);
      } else if (const auto* calibrateCommand = std::get_if<CalibrateCommand>(&*command)) {
        calibrate(*calibrateCommand);
      } else if (const auto* commissionCommand = std::get_if<CommissionCommand>(&*command)) {
        commission(*commissionCommand);
      } else if (std::holds_alternative<RightsCommand>(*command)) {
        examineRights();
      }
    }
    watch();
  }
  m_connection = {};
}

void SessionWorker::connect(const ConnectCommand& command) {
  m_connection = {};
  tell(LinkChanged{LinkState::Connecting, {}, false, {}});
  opcua::Attempt attempt = m_connector(command.request);
  if (!attempt.connection) {
    tell(LinkChanged{LinkState::Disconnected,
                     attempt.connection.error(),
                     false,
                     {},
                     {},
                     std::move(attempt.question)});
    return;
  }
  m_connection = std::move(*attempt.connection);
  // A control that does not report any has none; if it is gone again, the next read notices it.
  m_axes = streaming::readControlAxes(*m_connection.link, kWatchDeadline)
               .value_or(streaming::ControlAxes{});
  m_request = command.request;
  // What was decided now is remembered, and is not to be decided again by a later connection.
  m_request.security.reset();
  m_request.fingerprint.clear();
  // A server that does not identify itself can be used all the same.
  m_server = m_connection.control->identity().value_or(opcua::ServerIdentity{});
  m_watch = {};
  m_equipment = {};
  m_nextEquipment = {};
  m_nextDescription = {};
  m_seen = {};
  m_looksForLeft = true;
  tell(LinkChanged{LinkState::Connected,
                   {},
                   m_connection.control->isVirtualMachine(),
                   m_server,
                   m_connection.security});
}

void SessionWorker::disconnect() {
  m_connection = {};
  tell(LinkChanged{LinkState::Disconnected, {}, false, {}});
}

void SessionWorker::watch() {
  if (!m_connection) {
    return;
  }
  const base::Result<void> looked = lookAtControl();
  if (!looked && looked.error().code == opcua::LinkError::ConnectionLost) {
    m_connection = {};
    tell(LinkChanged{LinkState::Lost, looked.error(), false, {}});
  }
}

base::Result<MachineSeen> SessionWorker::readControl() {
  using opcua::VariableKind;
  std::vector<opcua::Variable> watched{
      {VariableKind::ChannelStatus, 0},  {VariableKind::ProgramStatus, 0},
      {VariableKind::Alarm, 0},          {VariableKind::ProgramName, 0},
      {VariableKind::Message, 0},        {VariableKind::ActualPosition, 0},
      {VariableKind::ActualPosition, 1}, {VariableKind::ActualPosition, 2},
      {VariableKind::PathFeed, 0},
  };
  const std::size_t firstRotary = watched.size();
  std::vector<int> rotary;
  std::copy_if(m_axes.index.begin(), m_axes.index.end(), std::back_inserter(rotary),
               [](int axis) { return axis >= 0; });
  for (const int axis : rotary) {
    watched.push_back({VariableKind::ActualPosition, axis});
  }
  const std::size_t firstToGo = watched.size();
  for (int axis = 0; axis < static_cast<int>(base::kAxisCount); ++axis) {
    watched.push_back({VariableKind::DistanceToGo, axis});
  }
  for (const int axis : rotary) {
    watched.push_back({VariableKind::DistanceToGo, axis});
  }
  const std::size_t firstEquipment = watched.size();
  const bool readsEquipment = m_connection.link->now() >= m_nextEquipment;
  if (readsEquipment) {
    m_nextEquipment = m_connection.link->now() + streaming::EquipmentWatch::kInterval;
    watched.insert(watched.end(), m_equipment.variables().begin(), m_equipment.variables().end());
  }
  const auto readings = opcua::readNow(*m_connection.link, watched, kWatchDeadline);
  if (!readings) {
    return base::fail(readings.error());
  }
  MachineSeen seen;
  seen.channelStatus = wholeNumber((*readings)[0]);
  seen.programStatus = wholeNumber((*readings)[1]);
  seen.alarm = wholeNumber((*readings)[2]);
  seen.programName = textOf((*readings)[3]);
  seen.message = textOf((*readings)[4]);
  if (areRead(std::span(*readings).subspan(5, base::kAxisCount))) {
    seen.positionMm = {(*readings)[5].number, (*readings)[6].number, (*readings)[7].number};
  }
  if (const auto feed = (*readings)[8].value()) {
    seen.feedMmPerS = base::mmPerSFromMmPerMin(*feed);
  }
  seen.rotaryAxes = m_axes.set();
  const std::span toGo = std::span(*readings).subspan(firstToGo, firstEquipment - firstToGo);
  if (areRead(toGo)) {
    seen.toGoMm = {toGo[0].number, toGo[1].number, toGo[2].number};
  }
  std::size_t next = 0;
  base::RotaryDeg rotaryDeg{};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (seen.rotaryAxes[axis]) {
      rotaryDeg[axis] = (*readings)[firstRotary + next].number;
      seen.toGoDeg[axis] = toGo[base::kAxisCount + next].number;
      ++next;
    }
  }
  if (areRead(std::span(*readings).subspan(firstRotary, rotary.size()))) {
    seen.rotaryDeg = rotaryDeg;
  }
  if (readsEquipment) {
    seen.equipment = m_equipment.take(std::span(*readings).subspan(firstEquipment));
  }
  return seen;
}

base::Result<void> SessionWorker::lookAtControl() {
  auto seen = readControl();
  if (!seen) {
    return base::fail(seen.error());
  }
  auto described = readDescription();
  if (!described) {
    return base::fail(described.error());
  }
  seen->described = *std::move(described);
  tellIfRoom(*seen);
  return lookForRuns(seen->channelStatus != opcua::kChannelReset,
                     seen->positionMm && seen->rotaryDeg
                         ? std::optional(base::AxisPosition{*seen->positionMm, *seen->rotaryDeg})
                         : std::nullopt);
}

base::Result<SessionWorker::Described> SessionWorker::readDescription() {
  if (m_connection.browser == nullptr || m_connection.link->now() < m_nextDescription) {
    return Described();
  }
  auto machines = opcua::readMachines(*m_connection.browser);
  m_nextDescription = m_connection.link->now() + kDescriptionInterval;
  if (!machines) {
    return machines.error().code == opcua::LinkError::ConnectionLost
               ? base::Result<Described>(base::fail(machines.error()))
               : Described();
  }
  return std::make_shared<const std::vector<opcua::DescribedMachine>>(*std::move(machines));
}

base::Result<void> SessionWorker::lookForRuns(bool isBusy,
                                              const std::optional<base::AxisPosition>& tool) {
  std::optional<streaming::RunOnControl> found;
  if (isBusy) {
    constexpr int kFirstCell = templates::TemplateParameters{}.baseCell;
    const auto look = m_watch.look(*m_connection.link, *m_connection.control, kFirstCell);
    if (!look) {
      return base::fail(look.error());
    }
    found = *look;
  } else {
    m_watch = {};
  }
  const bool isChange = found.has_value() || m_seen.onControl || m_looksForLeft;
  takeFound(found);
  m_seen.ahead = ahead(tool);
  if (isChange) {
    tell(m_seen);
  }
  return {};
}

std::optional<streaming::MotionAhead> SessionWorker::ahead(
    const std::optional<base::AxisPosition>& tool) const {
  if (!m_seen.onControl || !m_seen.pointsAfter || !tool) {
    return std::nullopt;
  }
  const streaming::RunOnControl& run = m_seen.onControl->onControl;
  const std::vector<std::size_t>& after = *m_seen.pointsAfter;
  if (run.latched >= after.size() || run.executed > run.latched ||
      after[run.latched] > m_seenPoints.size()) {
    return std::nullopt;
  }
  const report::SavedRun& saved = *m_seen.onControl->saved;
  const auto placeOf = [&saved](const base::Vec3& mm, base::RotaryDeg deg) {
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      deg[axis] = saved.settings.parameters.rotaryAxes[axis] ? deg[axis] : 0.0;
    }
    return base::AxisPosition{mm, deg};
  };
  const std::size_t first = after[run.executed];
  const base::AxisPosition before =
      first > 0 ? placeOf(m_seenPoints[first - 1].positionMm, m_seenPoints[first - 1].rotaryDeg)
                : placeOf(saved.checkpoint.startMm, saved.checkpoint.startDeg);
  return streaming::motionAhead(before,
                                std::span(m_seenPoints).subspan(first, after[run.latched] - first),
                                placeOf(tool->mm, tool->deg), saved.settings.feedMmPerS);
}

void SessionWorker::takeFound(const std::optional<streaming::RunOnControl>& found) {
  if (!found) {
    if (m_seen.onControl || m_looksForLeft) {
      m_seen = {};
      m_seen.left = m_runs.leftOn(m_request.endpoint);
      const auto job = m_jobs.leftOn(m_request.endpoint);
      m_seen.isJob = job && (!m_seen.left || job->settings.origin.startedAtUtc >
                                                 m_seen.left->settings.origin.startedAtUtc);
      m_seen.left = m_seen.isJob ? job : m_seen.left;
      m_looksForLeft = false;
    }
    return;
  }
  const bool isSame = m_seen.onControl && m_seen.onControl->onControl.number == found->number;
  if (!isSame) {
    m_seen = {};
    m_seen.onControl.emplace();
    m_seen.onControl->saved =
        found->number != 0 ? m_runs.find(found->number) : m_runs.leftOn(m_request.endpoint);
    if (found->number == 0 && m_seen.onControl->saved &&
        m_seen.onControl->saved->checkpoint.granted) {
      m_seen.onControl->saved.reset();  // a program that waits for its first run is not that one's
    }
    if (found->job != 0) {
      m_seen.onControl->saved = m_jobs.findJob(*found);
    }
    m_seen.isJob = found->job != 0;
    if (m_seen.onControl->saved && !m_seen.isJob) {
      m_seen.pointsAfter = std::make_shared<const std::vector<std::size_t>>(
          report::pointsAfterWindows(m_runs, *m_seen.onControl->saved));
      m_seenPoints = m_runs.points(*m_seen.onControl->saved);
    }
  }
  m_seen.onControl->onControl = *found;
  m_seen.isClientKnown = m_watch.isClientKnown();
}

void SessionWorker::endRun(const EndRunCommand& command) {
  if (!m_connection) {
    tell(RunEnded{std::nullopt, notConnected(), false, !command.run});
    return;
  }
  const base::Instant from = m_connection.link->now();
  // What the machine does meanwhile is shown; a connection that is lost is noticed by the wait. A
  // block of the control may take minutes: the wait ends with the program, or when something else
  // is wanted.
  const auto goesOn = [this] {
    static_cast<void>(lookAtControl());
    return !m_quit.load() && m_commands.isEmpty();
  };
  if (command.run && command.holds) {
    const auto stopped = streaming::stopRun(*m_connection.link, *command.run, {}, goesOn);
    tell(stopped ? RunEnded{stopped->stoodAfter.value_or(m_connection.link->now() - from),
                            {},
                            !stopped->hasEnded}
                 : RunEnded{std::nullopt, stopped.error()});
    return;
  }
  const auto ended =
      command.run ? streaming::endRun(*m_connection.link, *command.run, {}, goesOn)
                  : streaming::stopByReset(*m_connection.link, *m_connection.control, goesOn);
  tell(ended ? RunEnded{m_connection.link->now() - from, {}, false, !command.run}
             : RunEnded{std::nullopt, ended.error(), false, !command.run});
}

bool SessionWorker::hasPassedCreditTest(const streaming::RunSettings& settings) const {
  if (!base::needsCommissioning(settings.parameters.method)) {
    return false;
  }
  if (settings.parameters.target == templates::TargetControl::LinuxCnc) {
    return true;  // its interpreter reads a pin when it passes the block, see docs/linuxcnc.md
  }
  const auto identity = m_connection.control->identity();
  if (!identity) {
    return false;
  }
  const auto test = m_machines.creditTest(m_request.endpoint, *identity);
  return test && streaming::requireCreditTest(*test, m_request.endpoint, *identity);
}

void SessionWorker::examineRights() {
  if (!m_connection) {
    tell(RightsSeen{std::nullopt, notConnected()});
    return;
  }
  auto report = opcua::examineRights(m_connection);
  tell(report ? RightsSeen{std::move(*report), {}} : RightsSeen{std::nullopt, report.error()});
}

void SessionWorker::answer(const ResumeQuestion& question) {
  if (!m_connection) {
    tell(ResumeFound{std::nullopt, nullptr, notConnected()});
    return;
  }
  if (question.plan) {
    auto job = askJob(question, ActiveProgram::Stays);
    tell(job ? ResumeFound{std::nullopt,
                           std::make_shared<const run::JobRestart>(*std::move(job)),
                           {}}
             : ResumeFound{std::nullopt, nullptr, job.error()});
    return;
  }
  const auto resume = run::askResume(*m_connection.link, *question.program, question.settings,
                                     question.checkpoint, ActiveProgram::Stays);
  tell(resume ? ResumeFound{*resume, nullptr, {}}
              : ResumeFound{std::nullopt, nullptr, resume.error()});
}

base::Result<run::JobRestart> SessionWorker::askJob(const ResumeQuestion& question,
                                                    ActiveProgram active) {
  if (!question.machine) {
    return base::fail(run::machineNotKnown());
  }
  return question.fromStretch > 0
             ? run::beginWith(question.fromStretch, *question.plan, *question.machine)
             : run::askJob(*m_connection.link, *question.plan, *question.machine, question.settings,
                           question.checkpoint, question.job, active);
}

base::Result<void> SessionWorker::askAgain(const StartCommand& command) {
  // First as it was asked: what is not as it was confirmed moves nothing. Then its program ends.
  for (const ActiveProgram active : {ActiveProgram::Stays, ActiveProgram::IsEnded}) {
    bool isSame = false;
    if (command.restart) {
      const auto job = askJob(*command.resumes, active);
      if (!job) {
        return base::fail(job.error());
      }
      isSame = run::isSame(*job, *command.restart);
    } else {
      const auto resume =
          run::askResume(*m_connection.link, *command.resumes->program, command.resumes->settings,
                         command.resumes->checkpoint, active);
      if (!resume) {
        return base::fail(resume.error());
      }
      isSame = command.settings.resume && run::isSame(*resume, *command.settings.resume);
    }
    if (!isSame) {
      return base::fail(run::changedSince());
    }
  }
  return {};
}

base::Result<void> SessionWorker::checkBefore(const StartCommand& command,
                                              const templates::FlexibleProgram& flexible,
                                              streaming::RunSink& sink) {
  if (m_proven != flexible.text) {
    streaming::LiveUpdate update;
    update.state = streaming::RunState::Armed;
    update.waitingFor = "proof";
    sink.update(update);
    if (base::Result<void> proven = streaming::requireProven(flexible); !proven) {
      return proven;
    }
    m_proven = flexible.text;
  }
  // The program of a run that is resumed ends with it: the travel is checked on an idle control.
  if (base::Result<void> asked = command.resumes ? askAgain(command) : base::Result<void>();
      !asked) {
    return asked;
  }
  return checkTravel(command);
}

base::Result<void> SessionWorker::checkTravel(const StartCommand& command) {
  if (command.plan) {
    return {};  // compared with the machine as a whole
  }
  std::vector<gcode::StreamPoint> points;
  if (command.live) {
    points.resize(2);
    points.front().positionMm = command.live->agreement.lowestMm;
    points.back().positionMm = command.live->agreement.highestMm;
  } else if (auto flight =
                 streaming::preflight(*m_connection.link, *command.program, command.settings)) {
    points = std::move(flight->points.points);
  } else {
    return {};  // the run says what stands in its way
  }
  const auto machine = run::machineOf(*m_connection.control, m_request.endpoint, m_machines);
  if (!machine) {
    return base::fail(machine.error());
  }
  const auto checked =
      run::checkTravel(*m_connection.link, *m_connection.control, *machine, points);
  if (!checked) {
    return base::fail(checked.error());
  }
  if (!checked->empty()) {
    tell(trace::Note{m_connection.link->now(), *checked});
  }
  return {};
}

SessionWorker::Done SessionWorker::runMotion(const StartCommand& command,
                                             const templates::FlexibleProgram& flexible,
                                             const streaming::RunSettings& settings,
                                             Requests& requests, run::RunRecord& record) {
  Sink sink(*this);
  Done done;
  done.report = streaming::runJob(*m_connection.link, *m_connection.control, *command.program,
                                  flexible, settings, requests, sink,
                                  {record.writer(), record.start(), record.keeper()});
  done.points = pathOf(*command.program, done.report);
  return done;
}

SessionWorker::Done SessionWorker::runWholeJob(const StartCommand& command,
                                               const streaming::RunSettings& settings,
                                               Requests& requests, run::RunRecord& record) {
  const auto programs = job::makePrograms(*command.plan, settings.parameters);
  if (!programs) {
    Done done;
    done.report.error = programs.error();
    done.report.programName = command.program->name;
    done.report.settings = settings;
    return done;
  }
  const auto resume = command.restart ? command.restart->resume : std::nullopt;
  const streaming::JobCount count(command.stretchStarts, command.points,
                                  resume ? command.restart->stretch : 0,
                                  resume ? resume->point : 0);
  JobSink sink(*this, count, programs->mainName);
  const streaming::WholeJobReport job = streaming::runWholeJob(
      *m_connection.link, *m_connection.control, *command.plan, *programs, settings, requests, sink,
      {resume, record.keeper(), record.writer(), record.start()});
  Done done{count.reportOf(job, settings, command.program->name), {}, job.times, job.tools};
  done.points = pathOf(*command.program, done.report);
  return done;
}

void SessionWorker::listen(const std::string& address) {
  m_source.reset();  // its sender hears the end, and its port is free again
  if (address.empty()) {
    return;
  }
  auto source = sources::openSource(address);
  if (!source) {
    tell(SourceOpened{address, {}, source.error()});
    return;
  }
  m_source = std::move(*source);
  tell(SourceOpened{address, m_source->name(), {}});
}

SessionWorker::Done SessionWorker::runLive(const StartCommand& command,
                                           const templates::FlexibleProgram& flexible,
                                           const streaming::RunSettings& settings,
                                           Requests& requests, run::RunRecord& record) {
  live::PointStream points(*m_source, command.live->agreement, command.live->limits);
  LiveSink sink(*this, points);
  Done done;
  done.report = streaming::runLive(*m_connection.link, *m_connection.control, command.program->name,
                                   points, flexible, settings, requests, sink,
                                   {record.writer(), record.start(), nullptr});
  sink.finish();
  done.points = points.points();
  return done;
}

run::RunFacts SessionWorker::factsOf(const StartCommand& command) {
  run::RunFacts facts;
  facts.kind = command.live   ? run::RunKind::Live
               : command.plan ? run::RunKind::WholeJob
                              : run::RunKind::Motion;
  facts.programName = command.program->name;
  facts.programHash = command.program->hash;
  facts.programFile = command.source.file;
  facts.reading = command.source.reading;
  facts.endpoint = m_request.endpoint;
  facts.startedAtUtc = command.startedAtUtc;
  if (command.plan) {
    // Of a plan that is no job, the start says so.
    const auto programs = job::makePrograms(*command.plan, command.settings.parameters);
    const int number = programs ? programs->number : 0;
    facts.job = command.restart ? command.restart->kept(number) : report::SavedJob{number, 0, {}};
  }
  facts.dryRunMm = command.dryRunMm;
  facts.drivenBack = command.drivenBack;
  facts.onCut = [this](const run::RecordingCut& cut) { tell(cut); };
  return facts;
}

void SessionWorker::start(const StartCommand& command) {
  if (!m_connection) {
    auto report = std::make_shared<streaming::RunReport>();
    report->error = notConnected();
    report->settings = command.settings;
    tell(RunFinished{std::move(report), {}});
    return;
  }
  Sink sink(*this);
  Requests requests(*this);
  const auto flexible = templates::makeProgram(command.settings.parameters);
  base::Result<void> clear =
      flexible ? checkBefore(command, *flexible, sink) : base::fail(flexible.error());
  if (clear && command.live && !m_source) {
    clear = base::fail(live::LiveError::NotOpened, "The live source is not open. Open it again.",
                       command.live->address);
  }
  if (clear && command.live) {
    clear = m_source->prepare();
  }
  if (auto factor = clear ? run::FactorFeed::open(command.settings) : base::fail(clear.error())) {
    m_factor = *std::move(factor);
  } else {
    clear = base::fail(factor.error());
  }
  run::RunRecord record(factsOf(command));
  clear = clear ? record.open() : clear;
  if (!clear) {
    m_factor.reset();
    auto report = std::make_shared<streaming::RunReport>();
    report->error = clear.error();
    report->settings = command.settings;
    tell(RunFinished{std::move(report), {}});
    return;
  }
  streaming::RunSettings settings = command.settings;
  settings.isCommissioned = hasPassedCreditTest(settings);
  settings.origin = report::thisUser();
  Done done = command.live   ? runLive(command, *flexible, settings, requests, record)
              : command.plan ? runWholeJob(command, settings, requests, record)
                             : runMotion(command, *flexible, settings, requests, record);
  if (m_factor) {
    m_factor->finish(streaming::outcomeName(done.report.outcome), done.report.factor);
    m_factor.reset();  // the sender hears the end
  }
  record.finish(done.report, {done.points, done.jobTimes, done.tools});
  m_seen = {};
  m_looksForLeft = true;
  if (done.report.error.code == opcua::LinkError::ConnectionLost) {
    // Told first: whoever hears of the end of the run knows that there is no connection.
    tell(LinkChanged{LinkState::Lost, done.report.error, false, {}});
    m_connection = {};
  }
  tell(RunFinished{std::make_shared<const streaming::RunReport>(std::move(done.report)),
                   record.isRecorded() ? record.recording() : std::string(), record.notRecorded(),
                   record.notKept(), done.jobTimes, done.tools, record.left(), record.cut()});
  if (command.live) {
    // For the next run, at the port that was taken.
    const bool isInput = command.live->address == "-";
    listen(isInput ? command.live->address : m_source->name());
  }
}

void SessionWorker::commission(const CommissionCommand& command) {
  CommissioningFinished finished{command.kind};
  const auto identity = m_connection
                            ? m_connection.control->identity()
                            : base::Result<opcua::ServerIdentity>(base::fail(notConnected()));
  if (!identity) {
    finished.error = identity.error();
    tell(std::move(finished));
    return;
  }
  streaming::FeedTestPlan plan;
  plan.firstCell = command.firstCell;
  plan.transfer = command.transfer;
  plan.move = command.move;
  opcua::Link& link = *m_connection.link;
  std::optional<streaming::CommissioningStep> told;
  base::Instant nextLook{};
  const auto progress = [&](streaming::CommissioningStep step) {
    if (told != step) {
      told = step;
      tell(CommissioningProgress{command.kind, step});
    }
    // An axis may move. What cannot be read is noticed by the test. The job of a test has accesses
    // of its own, and shows the place by them.
    if (command.kind != TestKind::Jobs && link.now() >= nextLook) {
      if (auto seen = readControl()) {
        tellIfRoom(*std::move(seen));
      }
      nextLook = link.now() + kWatchInterval;
    }
    return !m_stopRun.load() && !m_quit.load();
  };
  // What was found is stored, or why it was not is told.
  const auto keep = [&](auto result, auto& test) {
    if (!result) {
      finished.error = result.error();
      return;
    }
    test = {m_request.endpoint, *identity, command.startedAtUtc, RIVULET_VERSION,
            std::move(*result)};
    const base::Result<void> saved = m_machines.save(*test);
    finished.error = saved ? base::Error{} : saved.error();
  };
  if (command.kind == TestKind::Jobs) {
    streaming::JobTestPlan jobs;
    static_cast<streaming::CommissioningPlan&>(jobs) = plan;
    jobs.move = command.move.value_or(streaming::AirMove());
    jobs.blocks = command.blocks;
    MachineSeen shown = readControl().value_or(MachineSeen());
    const auto watch = [&](const streaming::LiveUpdate& update) {
      if (update.sample && update.sample->positionMm) {
        shown.channelStatus = opcua::kChannelActive;
        shown.positionMm = update.sample->positionMm;
        shown.feedMmPerS = update.sample->feedMmPerS;
        tellIfRoom(shown);
      }
    };
    keep(streaming::testJobs(link, *m_connection.control, jobs, {progress, {}, watch}),
         finished.jobs);
  } else if (command.kind == TestKind::FeedCell) {
    keep(streaming::testFeedCell(link, *m_connection.control, plan, progress), finished.feed);
  } else {
    keep(streaming::commission(link, *m_connection.control, plan, progress), finished.credit);
  }
  if (finished.error.code == opcua::LinkError::ConnectionLost) {
    tell(LinkChanged{LinkState::Lost, finished.error, false, {}});
    m_connection = {};
  }
  tell(std::move(finished));
}

void SessionWorker::calibrate(const CalibrateCommand& command) {
  if (!m_connection) {
    tell(CalibrationFinished{nullptr, notConnected()});
    return;
  }
  opcua::Connection again;
  base::Instant nextTold{};
  streaming::CalibrationHooks hooks;
  hooks.progress = [&](const streaming::CalibrationProgress& progress) {
    // More than a display can show would only fill the ring.
    if (m_connection.link->now() >= nextTold) {
      nextTold = m_connection.link->now() + kProgressInterval;
      tellIfRoom(progress);
    }
    return !m_stopRun.load() && !m_quit.load();
  };
  hooks.reconnect = [&]() -> opcua::Link* {
    opcua::Attempt attempt = m_connector(m_request);
    if (attempt.connection) {
      again = std::move(*attempt.connection);
    }
    return again.link;
  };
  auto calibration = streaming::calibrate(*m_connection.link, command.plan, hooks);
  if (calibration) {
    auto record = std::make_shared<streaming::CalibrationRecord>();
    record->endpoint = m_request.endpoint;
    record->server = m_server;
    record->measuredAtUtc = command.startedAtUtc;
    record->toolVersion = RIVULET_VERSION;
    record->calibration = std::move(*calibration);
    tell(CalibrationFinished{std::move(record), {}});
    return;
  }
  const base::Error error = calibration.error();
  if (error.code == opcua::LinkError::ConnectionLost) {
    // The new connection was for the cells only: the operator decides whether to connect again.
    tell(LinkChanged{LinkState::Lost, error, false, {}});
    m_connection = {};
  }
  tell(CalibrationFinished{nullptr, error});
}

}  // namespace rivulet::session
