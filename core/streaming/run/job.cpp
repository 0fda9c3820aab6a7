// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/contract.h"
#include "base/units.h"
#include "live/error.h"
#include "opcua/await.h"
#include "streaming/control/control_alarm.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/methods/method.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/hosted_run.h"
#include "streaming/run/run_trace.h"
#include "streaming/start/start_policy.h"
#include "templates/continuation.h"
#include "templates/lint/lint.h"
#include "trace/analysis/statistics.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using opcua::Variable;
using opcua::VariableKind;

/// How often the control is asked while the operator goes to press cycle start.
constexpr Duration kStartPollInterval = std::chrono::milliseconds{50};

/// Where the tool is, and whether the control is ready.
/// @param turns  the program names rotary axes
Result<Preflight> readPlace(opcua::Link& link, const RunSettings& settings, bool turns) {
  const std::array<Variable, 5> watched{{{VariableKind::ChannelStatus, 0},
                                         {VariableKind::ActualPosition, 0},
                                         {VariableKind::ActualPosition, 1},
                                         {VariableKind::ActualPosition, 2},
                                         {VariableKind::Alarm, 0}}};
  const auto numbers = opcua::readNumbers(link, watched, settings.setupDeadline);
  if (!numbers) {
    return base::fail(numbers.error());
  }
  if ((*numbers)[0] != opcua::kChannelReset) {
    return base::fail(channelBusy());
  }
  if (Result<void> fine = requireNoAlarm((*numbers)[4]); !fine) {
    return base::fail(fine.error());
  }
  Preflight flight;
  flight.toolMm = {(*numbers)[1], (*numbers)[2], (*numbers)[3]};
  if (turns || base::any(settings.parameters.rotaryAxes)) {
    const Result<ControlAxes> axes = readControlAxes(link, settings.setupDeadline);
    if (!axes) {
      return base::fail(axes.error());
    }
    flight.axes = *axes;
    const Result<base::RotaryDeg> angles =
        readAngles(link, flight.axes, flight.axes.set(), settings.setupDeadline);
    if (!angles) {
      return base::fail(angles.error());
    }
    flight.toolDeg = *angles;
  }
  return flight;
}

/// A tool is lifted only where that has been seen to come back.
Result<void> requireLift(const RunSettings& settings) {
  if (settings.parameters.liftMm <= settings.liftMmMax) {
    return {};
  }
  return base::fail(
      templates::TemplateError::BadCorrection,
      settings.liftMmMax > 0.0
          ? fmt::format("On this control the tool may be lifted by at most {:g} mm: choose a "
                        "smaller lift.",
                        settings.liftMmMax)
          : std::string("The lift of the tool has not been tested on this control (rivulet-cli "
                        "commission --feed-cell --air-move X20 --lift 2): test it, or choose a "
                        "lift of 0."));
}

/// One run, step by step. Every step returns an error that ends the job. Where its points come from
/// is its subclass.
class Job : public HostedRun {
 public:
  Job(opcua::Link& link, opcua::Control& control, const gcode::Program& program,
      const templates::FlexibleProgram& flexible, const RunSettings& settings, RunOrders& orders,
      RunSink& sink, JobRecorder recorder)
      : HostedRun(link, control, flexible, settings, orders, sink, recorder.writer),
        m_program(program),
        m_recorder(std::move(recorder)),
        m_type(methodType(m_settings.parameters.method)) {}

  RunReport run() {
    m_report.programName = m_program.name;
    m_report.merged = m_program.merged;
    m_type.complete(m_settings, entropy(m_program.hash));
    m_report.settings = m_settings;
    Result<void> result;
    for (const auto step :
         {&Job::mayStart, &Job::lookFirst, &Job::claimCells, &Job::findAccess, &Job::arm}) {
      if (result && !m_isCancelled) {
        result = (this->*step)();
      }
    }
    if (m_isCancelled) {
      m_report.outcome = Outcome::Stopped;
      m_report.stopConfirmedAfter = m_cancelTime;
    }
    if (result && !m_isCancelled) {
      stream();
    } else if (!result) {
      m_report.error = result.error();
    }
    finish();
    return std::move(m_report);
  }

 protected:
  /// Reads what the run begins with, and takes its points if they are known.
  virtual Result<void> look() = 0;
  /// Where points come from while they are streamed; null: all are known.
  [[nodiscard]] virtual live::PointSupplier* supplier() { return nullptr; }
  /// The program on the control waits for the first window.
  virtual void begin() {}
  /// @return the program on the control ended after the last point of the run
  virtual bool isWhole(const ProgramEnd& end) { return end.isDone; }
  /// The program on the control has ended, or the connection.
  virtual void streamed() {}
  /// The points to be judged: complete when the run has ended.
  [[nodiscard]] virtual const std::vector<gcode::StreamPoint>& pointsOfRun() const {
    return m_flight.points.points;
  }
  virtual void finished() {}

  [[nodiscard]] virtual Result<void> mayStart() {
    if (base::needsCommissioning(m_settings.parameters.method) && !m_settings.isCommissioned) {
      return base::fail(blockedError({BlockReason::NotCommissioned, {}, std::nullopt}));
    }
    return requireLift(m_settings);
  }

  void startRecording() {
    if (m_recorder.writer != nullptr) {
      trace::RunStart start = runStartOf(std::move(m_recorder.start), m_settings, m_program);
      start.continuations = templates::continuationsOf(m_flexible.text);
      m_recorder.writer->start(start);
    }
  }
  void recordPoints() {
    if (m_recorder.writer != nullptr) {
      m_recorder.writer->points(m_flight.points);
    }
  }

  void fail(base::Error error) {
    m_report.outcome = Outcome::Failed;
    m_report.error = std::move(error);
  }

  const gcode::Program& m_program;
  JobRecorder m_recorder;
  const MethodType& m_type;
  Preflight m_flight;
  RunReport m_report;

 private:
  Result<void> lookFirst() {
    const Result<void> looked = look();
    return looked ? looked : base::fail(m_claim.withName(looked.error()));
  }

  Result<void> claimCells() {
    return claim(m_settings.runNumber != 0 ? m_settings.runNumber
                                           : runNumberFrom(entropy(m_program.hash)));
  }

  Result<void> findAccess() {
    Result<std::optional<AccessForms>> forms = chooseAccess();
    m_report.settings.grouping = m_settings.grouping;
    if (!forms) {
      return base::fail(forms.error());
    }
    m_report.accessForms = std::move(*forms);
    return {};
  }

  /// Transfers the flexible program, has it selected and started, and waits until it waits for the
  /// client.
  Result<void> arm() {
    if (Result<void> sound = templates::requireSound(m_flexible); !sound) {
      return sound;
    }
    publish(RunState::Armed, "transfer");
    if (Result<void> done = renewClaim(); !done || m_isCancelled) {
      return done;
    }
    const Result<ProgramTransfer> transfer =
        transferProgram(m_control, m_flexible.name, m_flexible.text, m_settings.transfer);
    if (!transfer) {
      return base::fail(transfer.error());
    }
    m_report.transfer = *transfer;
    m_ledger.note({m_link.now(), fmt::format("program {}: {}, {}, {}", m_flexible.name,
                                             transfer->written ? "written" : "already there",
                                             transfer->compared ? "compared" : "not compared",
                                             transfer->selected ? "selected" : "to be selected")});
    keepCheckpoint(false);
    // A program takes a while to be transferred, and nothing can be repeated meanwhile.
    if (Result<void> done = renewClaim(); !done || m_isCancelled) {
      return done;
    }
    if (Result<void> done =
            startProgram(m_cells.cleared, transfer->selected ? "cycle-start" : "select-and-start");
        !done) {
      return done;
    }
    if (Result<void> started = awaitStart(kStartPollInterval, [this] { return isStarted(); });
        !started || m_isCancelled || m_recorder.feed != nullptr) {
      return started;
    }
    return requireFeedCell();
  }

  /// Stores the checkpoint: before the program is started with all points, and again before the
  /// first window. From then on it is not known without the control's cells whether anything moved.
  void keepCheckpoint(bool isGranted) {
    if (m_recorder.keeper == nullptr || !m_report.checkpoint) {
      return;
    }
    std::vector<gcode::StreamPoint> all;
    Checkpoint checkpoint = *m_report.checkpoint;
    if (isGranted) {
      checkpoint.granted = true;
    } else if (m_settings.resume) {
      if (Result<gcode::PointList> list =
              pointsOnAxes(m_program.trajectory, m_settings.parameters,
                           {checkpoint.startMm, checkpoint.startDeg}, m_settings.programFeeds)) {
        all = std::move(list->points);
      }
    } else {
      all = m_flight.points.points;
    }
    if (const Result<void> kept = m_recorder.keeper->keep(checkpoint, m_settings, all); !kept) {
      m_ledger.note({m_link.now(),
                     "the checkpoint could not be stored, so the run cannot be resumed "
                     "after a crash of this program: " +
                         kept.error().text()});
    }
  }

  /// @return true: the program has written its layout number. It is the right one, and waits for
  ///         the run cell.
  Result<bool> isStarted() {
    std::vector<Variable> watched{{VariableKind::ChannelStatus, 0},
                                  opcua::rParameter(m_cells.layout),
                                  {VariableKind::Alarm, 0}};
    if (m_cells.corrects()) {
      watched.push_back(opcua::rParameter(m_cells.state));
    }
    const auto numbers = opcua::readNumbers(m_claim.link(), watched, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    const int layout = static_cast<int>((*numbers)[1]);
    if (Result<void> fine = requireNoAlarm((*numbers)[2]); !fine) {
      return base::fail(fine.error());
    }
    // The layout cell was cleared: the number in it is of the program that was started now.
    if (m_cells.corrects() && layout == m_flexible.layoutNumber) {
      if (Result<void> fit = mayCorrect((*numbers)[3]); !fit) {
        return base::fail(fit.error());
      }
    }
    if ((*numbers)[0] == opcua::kChannelReset || layout == 0) {
      return false;
    }
    if (layout != m_flexible.layoutNumber) {
      return base::fail(StreamError::WrongProgram,
                        fmt::format("The control runs another flexible program (layout {} instead "
                                    "of {}). Nothing was started: reset the control and select {}.",
                                    layout, m_flexible.layoutNumber, m_flexible.name));
    }
    return true;
  }

  /// @param state  the state of a program with correction, right after its start
  static Result<void> mayCorrect(double state) {
    if (state == static_cast<double>(templates::WindowState::OverlayLeft)) {
      return base::fail(StreamError::OverlayLeft,
                        "An overlay is already active on the axes, so the tool is not where the "
                        "path would begin. Remove it at the control (press reset, wait, and check "
                        "that $AA_OFF is 0), then start again.");
    }
    if (state == static_cast<double>(templates::WindowState::OverlayIntegrates)) {
      return base::fail(StreamError::OverlayIntegrates,
                        "The control adds up overlaid values (MD36750 bit 0): a correction would "
                        "drive the axes away. Set the bit to 0, or do without online correction.");
    }
    return {};
  }

  void stream() {
    begin();
    MethodSetup setup{m_flight.points.points, m_flight.toolMm, m_cells, m_settings,
                      m_flight.toolDeg,       supplier()};
    const std::unique_ptr<Method> method = m_type.make(std::move(setup));
    FeedControl& feed = m_recorder.feed != nullptr ? *m_recorder.feed : m_feed;
    Driver driver(m_link, *method, m_settings, m_orders, m_ledger, m_report.counters.total, m_cells,
                  feed);
    ControlAxes shown;
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (m_cells.rotaryAxes[axis]) {
        shown.index[axis] = m_flight.axes.index[axis];
      }
    }
    driver.watchRotary(shown.index);
    if (live::PointSupplier* const points = supplier()) {
      driver.watchSupplier(*points);
    }
    if (m_control.abilities().keepsTrace) {
      m_trace.emplace(
          pointsOfRun(), m_cells.rotaryAxes,
          supplier() != nullptr ? trace::PointsOfRun::Growing : trace::PointsOfRun::Known,
          m_recorder.writer);
      driver.watchTrace(*m_trace);
    } else if (m_recorder.trace != nullptr) {
      driver.watchTrace(*m_recorder.trace);
    }
    driver.watchPath({m_flight.points.points,
                      m_flight.toolMm,
                      {m_settings.feedMmPerS, m_settings.parameters.correctionLimitMm,
                       base::usesDelta(m_settings.parameters.method) ? m_settings.deltaMm : 0.0}});
    m_ledger.onGranted = [this] { keepCheckpoint(true); };
    const Instant from = m_link.now();
    const StreamEnd end = driver.run();
    if (m_report.checkpoint) {
      m_report.checkpoint->granted = method->progress().granted;
    }
    m_report.counters = driver.counters();
    m_report.pauses = driver.pauses();
    m_report.duration = m_link.now() - from;
    m_report.stopConfirmedAfter = end.stopConfirmedAfter;
    m_report.error = end.error;
    m_report.slowedBy = end.slowedBy;
    m_report.wrong = end.wrong;
    m_report.feed = feed.events(m_link.now());
    m_report.factor = feed.factors();
    m_streamed = true;
    m_report.leftHeld = end.leftHeld;
    if (end.error.code || (!end.programEnded && !end.leftHeld)) {
      m_report.outcome = Outcome::Failed;
    } else if (end.stopped) {
      m_report.outcome = Outcome::Stopped;
    } else {
      m_report.outcome = Outcome::Completed;
    }
    if (end.programEnded) {
      takeProgramEnd();
    }
    streamed();
  }

  /// How the program ended and how far it came, according to its cells.
  void takeProgramEnd() {
    const std::optional<ProgramEnd> end =
        m_type.askEnd(m_link, m_cells, m_settings, m_flight.points.points);
    if (!end) {
      return;
    }
    if (!end->isKnown) {
      m_ledger.note({m_link.now(), "the reason why the program ended could not be read"});
    }
    if (end->executed) {
      m_report.counters.executed = *end->executed;
    }
    const bool isDone = isWhole(*end);
    if (m_report.error.code) {
      return;  // the first error is the cause
    }
    const bool isCompleted = m_report.outcome == Outcome::Completed;
    if (end->error.code && (end->isKnown || isCompleted)) {
      fail(end->error);
    } else if (isCompleted && !isDone) {
      fail(endedEarly());
    }
  }

  [[nodiscard]] static base::Error endedEarly() {
    return base::makeError(StreamError::EndedEarly,
                           "The program on the control ended before every point was executed.");
  }

  void finish() {
    if (m_streamed) {
      judge();
      m_report.holds = takeHolds(m_report.pauses, m_report.feed);
    }
    if (m_report.outcome == Outcome::Completed) {
      m_report.counters.executed = m_report.counters.total;
    }
    if (m_report.integrity.judged) {
      m_report.counters.executed = m_report.integrity.executed;
    }
    if (m_report.outcome == Outcome::Completed && m_report.integrity.judged &&
        m_report.integrity.executed < m_report.counters.total) {
      fail(endedEarly());
    }
    if (m_report.error.code != opcua::LinkError::ConnectionLost) {
      m_claim.release();
    }
    finished();
    m_report.access = m_ledger.statistics();
    if (m_recorder.writer != nullptr) {
      m_recorder.writer->end({std::string(outcomeName(m_report.outcome)), m_report.counters.sent,
                              m_report.counters.accepted, m_report.counters.executed,
                              m_report.counters.total, m_report.duration,
                              m_report.error.code ? m_report.error.text() : std::string()});
    }
    publish(endState(m_report.outcome), "");
  }

  /// The control's own trace replaces the client's view.
  void judge() {
    if (!m_trace || m_report.error.code == opcua::LinkError::ConnectionLost) {
      return;
    }
    publish(m_report.outcome == Outcome::Stopped ? RunState::Stopping : RunState::Running, "trace");
    if (const Result<void> fetched = fetchRest(m_control, *m_trace); !fetched) {
      m_ledger.note(
          {m_link.now(), "the control's trace could not be fetched: " + fetched.error().text()});
      return;
    }
    TraceFindings found = m_trace->finish();
    m_report.integrity = std::move(found.integrity);
    m_report.controlTrace = std::move(found.kept);
    if (!found.isWhole) {
      // Its pauses and its time are those of a part of the run.
      m_ledger.note({m_link.now(), "the control's trace is incomplete: the run is not judged"});
      return;
    }
    m_report.pauses = std::move(found.pauses);
    if (found.duration > Duration{}) {
      m_report.duration = found.duration;
    }
  }

  void describeTo(LiveUpdate& update) const override {
    if (m_recorder.feed != nullptr) {
      update.feed = m_recorder.feed->state();
    }
    update.counters = m_report.counters;
    update.stopConfirmedAfter = m_report.stopConfirmedAfter;
  }

  std::optional<RunTrace> m_trace;
  bool m_streamed = false;
};

/// All points are those of a program.
class ProgramJob final : public Job {
 public:
  using Job::Job;

 protected:
  Result<void> look() override {
    Result<Preflight> flight = preflight(m_link, m_program, m_settings);
    if (!flight) {
      return base::fail(flight.error());
    }
    m_flight = std::move(*flight);
    m_report.counters.total = m_flight.points.points.size();
    m_report.checkpoint = m_type.checkpoint(
        m_settings, m_settings.resume.value_or(Resume{0, m_flight.toolMm, m_flight.toolDeg, {}}));
    if (m_report.checkpoint) {
      m_report.checkpoint->pointCount = m_flight.pointCount;
      m_report.checkpoint->pointsHash = m_flight.pointsHash;
    }
    startRecording();
    recordPoints();
    return {};
  }
};

/// The points come from a supplier: they need not be known before the start.
class SuppliedJob final : public Job {
 public:
  SuppliedJob(opcua::Link& link, opcua::Control& control, const gcode::Program& program,
              const templates::FlexibleProgram& flexible, const RunSettings& settings,
              RunOrders& orders, RunSink& sink, JobRecorder recorder, live::PointSupplier& supplier)
      : Job(link, control, program, flexible, settings, orders, sink, std::move(recorder)),
        m_supplier(supplier) {}

 protected:
  Result<void> mayStart() override {
    return base::takesLivePoints(m_settings.parameters.method)
               ? Job::mayStart()
               : Result<void>(
                     base::fail(blockedError({BlockReason::LiveNeedsWindows, {}, std::nullopt})));
  }

  Result<void> look() override {
    Result<Preflight> flight = readPlace(m_link, m_settings, false);
    if (!flight) {
      return base::fail(flight.error());
    }
    m_flight = std::move(*flight);
    startRecording();
    // Which axes a live run moves is not known before: the control must have all of them.
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (m_cells.rotaryAxes[axis] && m_flight.axes.index[axis] < 0) {
        return base::fail(
            StreamError::AxisMissing,
            fmt::format("The control has no axis {}: leave it out.", base::kRotaryAxisNames[axis]));
      }
    }
    return {};
  }

  live::PointSupplier* supplier() override { return &m_supplier; }
  [[nodiscard]] const std::vector<gcode::StreamPoint>& pointsOfRun() const override {
    return m_supplier.points();
  }

  void begin() override {
    const templates::TemplateParameters& parameters = m_settings.parameters;
    const live::WindowPlan plan{
        static_cast<std::size_t>(m_cells.pointsPerLoop),
        static_cast<std::size_t>(m_cells.windows + m_type.windowsTakenMax(parameters)),
        parameters.feedPerPoint, windowCut(m_settings).secondsMax,
        windowCut(m_settings).packedAxes};
    m_supplier.begin({{m_flight.toolMm, m_flight.toolDeg},
                      base::mmPerMinFromMmPerS(m_settings.feedMmPerS),
                      m_cells.axes,
                      m_cells.rotaryAxes,
                      plan},
                     m_link.now());
  }

  bool isWhole(const ProgramEnd& end) override {
    if (!end.windows) {
      return end.isDone;
    }
    const std::vector<std::size_t>& begins = m_supplier.windowBegins();
    m_report.counters.executed = begins[std::min(*end.windows, begins.size() - 1)];
    // If that there are no more was known only after the last window, the program has been told to
    // end there.
    return end.isDone || (end.isStopped && m_supplier.isDry() &&
                          m_report.counters.executed == m_supplier.points().size());
  }

  /// Its points are known only now.
  void streamed() override {
    m_flight.points.points = m_supplier.points();
    recordPoints();
    if (m_report.outcome != Outcome::Completed) {
      return;
    }
    if (const base::Error refusal = m_supplier.summary().refusal; refusal.code) {
      fail(refusal);
    } else if (m_supplier.points().empty()) {
      fail(base::makeError(live::LiveError::NoPoint,
                           "The source ended before its first point. Nothing has moved.",
                           m_program.name));
    }
  }

  void finished() override {
    m_supplier.executed(m_report.counters.executed);
    m_report.live = m_supplier.summary();
    m_supplier.finish(outcomeName(m_report.outcome),
                      m_report.error.code ? m_report.error.text() : std::string());
  }

 private:
  live::PointSupplier& m_supplier;
};

}  // namespace

Result<Preflight> preflight(opcua::Link& link, const gcode::Program& program,
                            const RunSettings& settings) {
  if (const gcode::Readiness readiness = program.readiness();
      readiness != gcode::Readiness::Streamable) {
    return base::fail(StreamError::ProgramNotStreamable, std::string(gcode::describe(readiness)),
                      program.name);
  }
  if (!(settings.feedMmPerS > 0.0) || !(settings.deltaMm > 0.0)) {
    return base::fail(StreamError::ProgramNotStreamable,
                      "The feed and δ must be greater than zero.");
  }
  if (Result<void> feeds = requireFeeds(program.trajectory, settings); !feeds) {
    feeds.error().context = program.name;
    return base::fail(feeds.error());
  }
  Result<Preflight> place = readPlace(link, settings, !program.trajectory.rotary.empty());
  if (!place) {
    return place;
  }
  Preflight flight = std::move(*place);
  if (Result<void> covered =
          requireRotaryAxes(program.trajectory, settings.parameters, flight.axes, flight.toolDeg);
      !covered) {
    return base::fail(covered.error());
  }
  base::AxisPosition start{flight.toolMm, flight.toolDeg};
  if (settings.resume) {
    start = {settings.resume->startMm, settings.resume->startDeg};
  }
  Result<gcode::PointList> list =
      pointsOnAxes(program.trajectory, settings.parameters, start, settings.programFeeds);
  if (!list) {
    return base::fail(list.error());
  }
  flight.points = std::move(*list);
  flight.pointCount = flight.points.points.size();
  flight.pointsHash = hashOfPoints(flight.points.points);
  if (settings.resume) {
    std::vector<gcode::StreamPoint>& points = flight.points.points;
    const std::size_t done = std::min(settings.resume->point, points.size());
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(done));
    if (points.empty()) {
      return base::fail(StreamError::CannotResume, "Every point has been executed already.",
                        program.name);
    }
  }
  if (flight.points.points.empty()) {
    return base::fail(StreamError::ProgramNotStreamable, "The program moves nothing.",
                      program.name);
  }
  flight.approachMm = base::distance(flight.toolMm, flight.points.points.front().positionMm);
  return flight;
}

RunReport runLive(opcua::Link& link, opcua::Control& control, std::string name,
                  live::PointSupplier& supplier, const templates::FlexibleProgram& flexible,
                  const RunSettings& settings, RunOrders& orders, RunSink& sink,
                  JobRecorder recorder) {
  gcode::Program program;
  program.name = std::move(name);
  return SuppliedJob(link, control, program, flexible, settings, orders, sink, std::move(recorder),
                     supplier)
      .run();
}

RunReport runJob(opcua::Link& link, opcua::Control& control, const gcode::Program& program,
                 const templates::FlexibleProgram& flexible, const RunSettings& settings,
                 RunOrders& orders, RunSink& sink, JobRecorder recorder) {
  return ProgramJob(link, control, program, flexible, settings, orders, sink, std::move(recorder))
      .run();
}

RunReport runJob(opcua::Link& link, opcua::Control& control, const gcode::Program& program,
                 const RunSettings& settings, RunOrders& orders, RunSink& sink,
                 JobRecorder recorder) {
  const auto flexible = templates::makeProgram(settings.parameters);
  if (!flexible) {
    RunReport report;
    report.error = flexible.error();
    report.programName = program.name;
    report.merged = program.merged;
    report.settings = settings;
    return report;
  }
  return runJob(link, control, program, *flexible, settings, orders, sink, std::move(recorder));
}

}  // namespace rivulet::streaming
