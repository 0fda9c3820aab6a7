// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/units.h"
#include "cli/access_text.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/console_orders.h"
#include "cli/correction_source.h"
#include "cli/feed_source.h"
#include "cli/found_run.h"
#include "cli/paced_link.h"
#include "cli/run_files.h"
#include "cli/run_settings.h"
#include "cli/status_line.h"
#include "feasibility/verdict.h"
#include "forecast/machine_verdict.h"
#include "gcode/block_observer.h"
#include "gcode/error.h"
#include "gcode/program.h"
#include "gcode/thinning.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "machine/config.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "report/calibration_json.h"
#include "report/machine_store.h"
#include "report/operating_point.h"
#include "report/report_json.h"
#include "report/run_store.h"
#include "run/resume.h"
#include "run/stands_within.h"
#include "run/travel.h"
#include "streaming/control/access_policy.h"
#include "streaming/control/control_axes.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/recovery/back_along.h"
#include "streaming/run/job.h"
#include "streaming/setup/commissioning.h"
#include "streaming/simulation/template_proof.h"
#include "streaming/start/first_move.h"
#include "streaming/start/start_policy.h"
#include "streaming/start/stop_bound.h"
#include "templates/flexible_program.h"
#include "templates/target.h"

namespace rivulet::cli {

namespace {

streaming::AccessPreference preferenceOf(const std::string& name) {
  using streaming::AccessPreference;
  return name == "single"  ? AccessPreference::Single
         : name == "array" ? AccessPreference::Array
         : name == "list"  ? AccessPreference::List
                           : AccessPreference::Automatic;
}

}  // namespace

streaming::RunSettings settingsOf(const StreamOptions& options,
                                  const gcode::Trajectory& trajectory) {
  streaming::RunSettings settings;
  settings.parameters = options.point.parameters();
  if (options.point.axes.empty()) {
    settings.parameters = streaming::withTurnedAxes(settings.parameters, trajectory);
  }
  settings.deltaMm = options.point.deltaMm;
  settings.passedBy = streaming::passedByFromName(options.passedBy).value_or(settings.passedBy);
  if (options.point.feedMmPerMin > 0.0) {
    settings.feedMmPerS = base::mmPerSFromMmPerMin(options.point.feedMmPerMin);
  }
  const streaming::AccessPlan plan =
      streaming::accessPlan(preferenceOf(options.access), settings.parameters.method);
  settings.access = plan.choice;
  settings.grouping = plan.grouping;
  settings.monitor = !options.noMonitor;
  settings.transfer =
      options.transfer == "by-hand" ? streaming::TransferWay::ByHand : streaming::TransferWay::Link;
  settings.placePauses = !options.evenPauses;
  settings.tolerance = options.resampling.toleranceMm;
  settings.factor = options.live.factor.agreed();
  return settings;
}

base::Result<void> requireRunMemory(std::size_t points) {
  constexpr double kPointBytes = 240.0;  // text, path, copies for run and method (docs/trust.md)
  return memoryBudget().require(kPointBytes * static_cast<double>(points),
                                fmt::format("A run of {} points", points));
}

base::Result<void> takeFeeds(streaming::RunSettings& settings, const OperatingOptions& options,
                             const machine::MachineConfig& machine, const gcode::Program& program) {
  if (options.feedMmPerMin > 0.0) {
    settings.feedMmPerS = base::mmPerSFromMmPerMin(options.feedMmPerMin);
    return {};
  }
  settings.programFeeds = report::programFeedsOf(machine, options.overridePercent / 100.0,
                                                 base::mmPerSFromMmPerMin(options.rapidMmPerMin));
  base::Result<void> known = streaming::requireFeeds(program.trajectory, settings);
  if (!known) {
    known.error().context = program.name;
    known.error().message += " (--feed 500)";
  }
  return known;
}

streaming::FeedCells feedCellsOf(const OperatingOptions& options) {
  return options.feedCells == "window"  ? streaming::FeedCells::PerWindow
         : options.feedCells == "point" ? streaming::FeedCells::PerPoint
                                        : streaming::FeedCells::Best;
}

base::Result<void> takeSilenceLimit(templates::TemplateParameters& parameters,
                                    const OperatingOptions& options, const Connection& connection) {
  const auto identity = connection.control->identity();
  if (options.silenceLimitS || !identity) {
    return {};  // what does not say who it is has no limits
  }
  const auto profile = report::MachineStore().profile(connection.name, *identity);
  if (!profile) {
    return base::fail(profile.error());
  }
  parameters.silenceLimitS = streaming::silenceLimitS(*profile ? &**profile : nullptr);
  return {};
}

base::Result<streaming::FeedProof> takeStopLimit(streaming::RunSettings& settings,
                                                 const OperatingOptions& options,
                                                 const Connection& connection) {
  const auto identity = connection.control->identity();
  std::optional<streaming::FeedTest> test;
  double limitS = streaming::stopLimitS(nullptr);
  if (identity) {  // what does not say who it is has no limits, and has not been tested
    const auto profile = report::MachineStore().profile(connection.name, *identity);
    auto found = report::MachineStore().feedTest(connection.name, *identity);
    if (!profile || !found) {
      return base::fail(profile ? found.error() : profile.error());
    }
    test = *std::move(found);
    limitS = streaming::stopLimitS(*profile ? &**profile : nullptr);
  }
  const opcua::ServerIdentity now = identity.value_or(opcua::ServerIdentity{});
  const bool isVirtual = connection.control->isVirtualMachine();
  const streaming::FeedProof proof = streaming::feedProof(test, now, isVirtual);
  settings.liftMmMax = streaming::provedLiftMm(test, now, isVirtual);
  settings.windowSMax = streaming::windowSMaxOf(proof, settings.parameters.target,
                                                options.stopLimitS.value_or(limitS));
  return proof;
}

base::Result<void> requireCreditTest(const Connection& connection) {
  const auto identity = connection.control->identity();
  if (!identity) {
    return base::fail(identity.error());
  }
  const auto test = report::MachineStore().creditTest(connection.name, *identity);
  return test ? streaming::requireCreditTest(*test, connection.name, *identity)
              : base::Result<void>(base::fail(test.error()));
}

base::Result<streaming::JobRelease> jobRelease(const Connection& connection) {
  const auto identity = connection.control->identity();
  return identity ? report::MachineStore().jobRelease(connection.name, *identity,
                                                      connection.control->isVirtualMachine())
                  : base::Result<streaming::JobRelease>(base::fail(identity.error()));
}

base::Result<void> requireTest(const StreamOptions& options, const Connection& connection) {
  if (options.point.parameters().target == templates::TargetControl::LinuxCnc) {
    return {};  // its interpreter reads a pin when it passes the block, see docs/linuxcnc.md
  }
  if (!options.simulate) {
    return requireCreditTest(connection);
  }
  streaming::CommissioningPlan plan;
  plan.firstCell = options.point.baseCell;
  const auto result = streaming::commission(*connection.link, *connection.control, plan);
  if (!result) {
    return base::fail(result.error());
  }
  if (!result->passed()) {
    return base::fail(streaming::StreamError::NotCommissioned,
                      "This virtual machine does not pass the test of method credit: see "
                      "commission --simulate. Choose method window.");
  }
  return {};
}

namespace {

/// Beside the orders of every run: corrections.
class StreamOrders final : public ConsoleOrders {
 public:
  /// @param source  of corrections; null: none
  StreamOrders(double stopAfterS, CorrectionSource* source, FeedSource& feed)
      : ConsoleOrders(stopAfterS, feed), m_source(source) {}
  base::Vec3 correctionMm(base::Instant) override {
    return m_source != nullptr ? m_source->valueMm() : base::Vec3{};
  }

 private:
  CorrectionSource* m_source;
};

/// A progress line on a terminal, nothing in a pipe.
class ConsoleSink final : public streaming::RunSink {
 public:
  explicit ConsoleSink(FeedSource& feed) : m_feed(feed) {}
  void update(const streaming::LiveUpdate& update) override {
    m_feed.tell(update);
    const bool isOver =
        update.state == streaming::RunState::Aborted || update.state == streaming::RunState::Done;
    if (!isOver && (update.waitingFor == "network") != m_isSilent) {
      m_isSilent = !m_isSilent;
      log::logger().warn(m_isSilent
                             ? "Nothing comes from the control. Check cable, switch and server."
                             : "The control answers again.");
    }
    if (update.waitingFor == "claim" && !m_saysClaim) {
      m_saysClaim = true;
      log::logger().warn(kClaimMayLapse);
    }
    if (update.wrong && !m_saysWrong) {
      m_saysWrong = true;
      log::logger().error("Wrong motion: {}. Stop the run, then check workpiece and tool.",
                          streaming::describe(*update.wrong));
    }
    if (update.counters.total == 0) {
      return;
    }
    const std::size_t share = 40 * update.counters.executed / update.counters.total;
    if (share == m_share && update.state == m_state) {
      return;
    }
    m_share = share;
    m_state = update.state;
    m_line.show(fmt::format("{:<8} [{:<40}] {} of {} points", streaming::runStateName(update.state),
                            std::string(share, '#'), update.counters.executed,
                            update.counters.total));
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}

 private:
  FeedSource& m_feed;
  StatusLine m_line;
  bool m_isSilent = false;  ///< nothing comes from the control
  bool m_saysClaim = false;
  bool m_saysWrong = false;
  std::optional<std::size_t> m_share;
  streaming::RunState m_state = streaming::RunState::Idle;
};

/// The verdict before anything moved.
struct Judgement {
  bool feasible = false;
  opcua::Grouping form = opcua::Grouping::List;  ///< expected form of access of the run
  std::optional<feasibility::Verdict> verdict;   ///< nothing for a single point
  std::optional<streaming::OverrideLimit> limit;
};

void print(const streaming::RunReport& report, const CalibrationChoice& calibrated,
           const Judgement& judged) {
  fmt::print("{}: {} of {} points executed", streaming::outcomeName(report.outcome),
             report.counters.executed, report.counters.total);
  if (report.integrity.judged) {
    fmt::print(", {} repeated, {} skipped, {} foreign", report.integrity.repeated,
               report.integrity.skipped, report.integrity.foreign);
  } else {
    fmt::print(" (not judged: {})", report.controlTrace
                                        ? "the control's trace is too short or has gaps"
                                        : "no trace of the control");
  }
  base::Duration paused{};
  for (const trace::Pause& pause : report.pauses) {
    paused += pause.duration;
  }
  fmt::print("\n{:.1f} s, {} pauses of {:.1f} ms on average\n", base::toSeconds(report.duration),
             report.pauses.size(),
             report.pauses.empty()
                 ? 0.0
                 : base::toMilliseconds(paused) / static_cast<double>(report.pauses.size()));
  if (report.transfer) {
    fmt::print("program on the control: {}, {}\n",
               report.transfer->written ? "written" : "already there",
               report.transfer->compared ? "read back and identical" : "could not be read back");
  }
  fmt::print("access form: {}\n", accessText(report.settings.grouping, report.accessForms));
  fmt::print("access per variable: mean {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n",
             base::toMilliseconds(report.access.perNode.mean),
             base::toMilliseconds(report.access.perNode.p99),
             base::toMilliseconds(report.access.perNode.max));
  if (!report.slowedBy.empty()) {
    fmt::print("{}\n", report.slowedBy);
  }
  printFactor(report.factor);
  if (judged.verdict) {
    fmt::print("{}\n", accessSourceText(calibrated, judged.form, *judged.verdict));
  }
  if (judged.limit) {
    fmt::print("feeds of the program at {:.4g} %: {}\n",
               100.0 * report.settings.programFeeds->overrideFactor,
               streaming::describe(*judged.limit));
  }
  if (!judged.feasible) {
    fmt::print("The settings were outside the feasible region.\n");
  }
  if (report.error.code) {
    log::logger().error(report.error.text());
  }
}

/// Writes the flexible program to a file and prints what to do with it.
base::Result<void> printSteps(const StreamOptions& options,
                              const templates::FlexibleProgram& program) {
  const std::string path = options.programFile.empty() ? program.name : options.programFile;
  if (const auto written = base::writeFile(path, program.text); !written) {
    return base::fail(written.error());
  }
  fmt::print(stderr,
             "The program is in {}.\n1. Copy it to the part programs of the control as {}. Do not "
             "change it.\n2. Select it in channel 1.\n3. Press cycle start. It waits; the axes "
             "move only after Rivulet has found the\n   layout number {} in R{}.\nRivulet waits up "
             "to {:.0f} s from now on.\n",
             path, program.name, program.layoutNumber, program.cells.layout,
             base::toSeconds(streaming::RunSettings{}.startDeadline));
  return {};
}

/// A run of `stream`: `prepare` looks for what stands in its way, `run` makes it.
class StreamCommand {
 public:
  explicit StreamCommand(const StreamOptions& options) : m_options(options) {}
  base::Result<void> prepare();
  [[nodiscard]] Exit run();

 private:
  base::Result<void> load();
  base::Result<void> loadDriven();
  [[nodiscard]] std::vector<gcode::StreamPoint> points() const;
  void planFeeds();
  [[nodiscard]] feasibility::AccessModel access();
  base::Result<void> openSource();
  base::Result<void> connect();
  base::Result<void> readResumed();
  base::Result<void> applyRules();
  base::Result<void> lookForRun();
  base::Result<void> findWayBack();
  base::Result<void> judge();
  base::Result<void> findResume();
  base::Result<void> checkTravel();
  /// Says how soon a stop stands.
  void tellStop(const streaming::Preflight& flight);
  [[nodiscard]] Exit show(const streaming::RunReport& done, const run::RunRecord& record) const;

  const StreamOptions& m_options;
  gcode::Program m_program;
  machine::MachineConfig m_machine;  ///< of the preset: what is known of the machine
  streaming::RunSettings m_settings;
  templates::FlexibleProgram m_flexible;  ///< of the settings, once the machine is known
  std::optional<CorrectionSource> m_source;
  std::unique_ptr<run::FactorFeed> m_factor;
  Connection m_connection;
  CalibrationChoice m_calibrated;
  Judgement m_judged;
  streaming::FeedProof m_proof = streaming::FeedProof::NotTested;
  std::optional<report::SavedRun> m_resumed;  ///< the run that goes on
  std::optional<report::SavedRun> m_driven;   ///< the run that is driven back
  gcode::MoveRules m_moveRules;               ///< by which they have been merged and divided
  nlohmann::ordered_json m_stop;
  report::RunStore m_runs;
};

base::Result<void> StreamCommand::prepare() {
  for (const auto step :
       {&StreamCommand::load, &StreamCommand::openSource, &StreamCommand::connect,
        &StreamCommand::lookForRun, &StreamCommand::findWayBack, &StreamCommand::judge,
        &StreamCommand::findResume, &StreamCommand::checkTravel}) {
    if (base::Result<void> done = (this->*step)(); !done) {
      return done;
    }
    if (interrupt::wasSeen()) {
      return base::fail(streaming::StreamError::Cancelled,
                        "Stopped before the run was started. Nothing has moved.");
    }
  }
  return m_settings.transfer == streaming::TransferWay::ByHand ? printSteps(m_options, m_flexible)
                                                               : base::Result<void>();
}

base::Result<void> StreamCommand::load() {
  if (m_options.simulate &&
      m_options.point.parameters().target == templates::TargetControl::LinuxCnc) {
    return base::fail(templates::TemplateError::NotOnTarget,
                      "The virtual machine is no LinuxCNC: leave out --simulate or --control.");
  }
  if (m_options.tool.raiseToMm) {
    m_program = streaming::raiseProgram(*m_options.tool.raiseToMm);
  } else if (m_options.tool.back) {
    if (base::Result<void> loaded = loadDriven(); !loaded) {
      return loaded;
    }
  } else if (auto program = gcode::loadProgram(m_options.file, m_options.loading.loadOptions())) {
    m_program = std::move(*program);
  } else {
    return base::fail(program.error());
  }
  if (base::Result<void> meant = requireMeaning(m_program, false); !meant) {
    return meant;
  }
  if (const auto blocked = streaming::programBlocked(m_program)) {
    base::Error error = streaming::blockedError(*blocked);
    error.context = m_program.name;
    return base::fail(error);
  }
  if (auto split = m_options.resampling.split(m_program); !split) {
    return split;
  }
  if (auto fits = requireRunMemory(m_program.trajectory.points.size()); !fits) {
    return fits;
  }
  m_settings = settingsOf(m_options, m_program.trajectory);
  if (m_driven) {
    m_settings.parameters = m_driven->settings.parameters;
    m_settings.parameters.method = base::MethodKind::Window;
    m_settings.parameters.feedPerPoint = false;
    m_settings.parameters.factorLeast = m_settings.parameters.factorMost = 0.0;
    m_settings.factor = {};
  }
  auto machine = machine::loadPreset(m_options.preset);
  if (!machine) {
    return base::fail(machine.error());
  }
  m_machine = *std::move(machine);
  if (base::Result<void> taken = takeFeeds(m_settings, m_options.point, m_machine, m_program);
      !taken) {
    return taken;
  }
  return templates::requireProgram(m_settings.parameters);
}

/// The program of the run that is driven back, as it was read for that run.
base::Result<void> StreamCommand::loadDriven() {
  auto run = report::readSavedRun(m_options.tool.back->run, memoryBudget());
  if (!run) {
    return base::fail(run.error());
  }
  if (run->job) {
    return base::fail(streaming::StreamError::CannotResume,
                      "A whole job is not driven back along its path: raise the tool, or go on.",
                      m_options.tool.back->run);
  }
  gcode::LoadOptions reading = run->reading;
  reading.budget = memoryBudget();
  auto program = gcode::loadProgram(run->programFile, reading);
  if (!program) {
    return base::fail(program.error());
  }
  m_program = *std::move(program);
  m_driven = *std::move(run);
  return {};
}

/// As far as they are known before the control is asked where the tool is.
std::vector<gcode::StreamPoint> StreamCommand::points() const {
  return gcode::streamPoints(m_program.trajectory, {}, {},
                             m_settings.programFeeds ? &*m_settings.programFeeds : nullptr)
      .points;
}

void StreamCommand::planFeeds() {
  streaming::planFeeds(m_settings, points(), access(), feedCellsOf(m_options.point));
}

feasibility::AccessModel StreamCommand::access() {
  if (!m_settings.calibration) {
    return {};
  }
  m_judged.form = streaming::AccessPlan{m_settings.access, m_settings.grouping}.expected(
      m_settings.calibration.get());
  return report::accessModel(*m_settings.calibration, m_judged.form);
}

base::Result<void> StreamCommand::openSource() {
  if (!m_options.correct.empty()) {
    base::Result<CorrectionSource> opened = CorrectionSource::open(m_options.correct);
    if (!opened) {
      return base::fail(opened.error());
    }
    m_source.emplace(std::move(*opened));
  }
  auto factor = openFactor(m_settings);
  if (!factor) {
    return base::fail(factor.error());
  }
  m_factor = std::move(*factor);
  return {};
}

base::Result<void> StreamCommand::connect() {
  auto connection = m_options.simulate ? simulate(m_options.preset, m_options.seed)
                                       : connectTo(m_options.endpoint);
  if (!connection) {
    return base::fail(connection.error());
  }
  m_connection = std::move(*connection);
  if (base::needsCommissioning(m_settings.parameters.method)) {
    if (base::Result<void> tested = requireTest(m_options, m_connection); !tested) {
      return tested;
    }
    m_settings.isCommissioned = true;
  }
  if (!m_options.simulate) {
    auto choice = calibrationOf(m_connection);
    if (!choice) {
      return base::fail(choice.error());
    }
    m_calibrated = std::move(*choice);
    if (const streaming::CalibrationRecord* record = m_calibrated.usable()) {
      m_settings.calibration = std::make_shared<const streaming::Calibration>(record->calibration);
    }
  }
  if (base::Result<void> taken =
          takeSilenceLimit(m_settings.parameters, m_options.point, m_connection);
      !taken) {
    return taken;
  }
  const auto proof = takeStopLimit(m_settings, m_options.point, m_connection);
  if (!proof) {
    return base::fail(proof.error());
  }
  m_proof = *proof;
  for (const auto step : {&StreamCommand::readResumed, &StreamCommand::applyRules}) {
    if (base::Result<void> done = (this->*step)(); !done) {
      return done;
    }
  }
  planFeeds();
  auto flexible = templates::makeProgram(m_settings.parameters);
  if (!flexible) {
    return base::fail(flexible.error());
  }
  m_flexible = std::move(*flexible);
  return m_options.simulate ? base::Result<void>() : streaming::requireProven(m_flexible);
}

base::Result<void> StreamCommand::readResumed() {
  if (m_options.resume.empty()) {
    return {};
  }
  auto run = report::readSavedRun(m_options.resume, memoryBudget());
  if (!run) {
    return base::fail(run.error());
  }
  m_resumed = *std::move(run);
  return {};
}

/// Moves within the tolerance become one; where a stop acts before the next window, none takes
/// longer than a window may.
base::Result<void> StreamCommand::applyRules() {
  m_moveRules = streaming::moveRules(m_settings);
  if (m_resumed) {
    const gcode::MoveRules& earlier = m_resumed->reading.moveRules;
    if (m_settings.tolerance > 0.0 && m_settings.tolerance != earlier.tolerance) {
      return base::fail(
          streaming::StreamError::ProgramChanged,
          fmt::format("The interrupted run has the tolerance {}. Leave out --tolerance.",
                      earlier.tolerance));
    }
    m_settings.tolerance = earlier.tolerance;
    m_moveRules = earlier;
  }
  if (auto applied = gcode::applyRules(m_program, m_moveRules, memoryBudget()); !applied) {
    base::Error error = applied.error();
    if (error.code == base::BudgetError::Exceeded) {
      error.message += " Or give a longer time with --stop-limit.";
    }
    return base::fail(error);
  }
  tellMerged(m_program);
  return requireRunMemory(m_program.trajectory.points.size());
}

base::Result<void> StreamCommand::judge() {
  streaming::StartFacts facts;
  facts.isConnected = true;
  facts.isVirtualMachine = m_connection.control->isVirtualMachine();
  facts.program = &m_program;
  facts.turnedAxes = gcode::turnedAxes(m_program.trajectory);
  facts.method = m_settings.parameters.method;
  // Wrong motion of a virtual machine does no harm.
  facts.acceptsInfeasible = m_options.accepted.infeasible || facts.isVirtualMachine;
  facts.acceptsRepeats = m_options.accepted.repeats || facts.isVirtualMachine;
  const feasibility::OperatingPoint point = report::operatingPointOf(m_settings);
  const std::vector<gcode::StreamPoint> points = this->points();
  m_judged.feasible = true;  // a single point needs no refill; method file waits
  if (points.size() >= 2 && !base::sendsBlocks(point.method)) {
    // Fewer points per loop than two have no distances; the judge refuses them.
    const int perLoop = std::max(2, point.pointsPerLoop);
    const auto verdict = forecast::judgeOn(
        m_machine, points, point, feasibility::programDistances(points, perLoop, point.feedMmPerS),
        access());
    if (!verdict) {
      return base::fail(verdict.error());
    }
    m_judged.feasible = verdict->feasible;
    m_judged.verdict = *verdict;
    m_judged.limit = streaming::overrideLimit(*verdict, points, m_settings);
    facts.verdict = *verdict;
  }
  const auto blocked = streaming::startBlocked(facts);
  if (!blocked) {
    return {};
  }
  base::Error error = streaming::blockedError(*blocked);
  if (blocked->reason == streaming::BlockReason::Infeasible) {
    error.message += " Or give --accept-infeasible.";
  } else if (blocked->reason == streaming::BlockReason::MayRepeat) {
    error.message += " Or give --accept-repeats.";
  }
  return base::fail(error);
}

/// A run that is on the control already is not refused without a way to go on.
base::Result<void> StreamCommand::lookForRun() {
  if (m_options.simulate) {
    return {};
  }
  m_settings.origin = report::thisUser();
  const auto found = report::findRun(m_runs, *m_connection.link, *m_connection.control,
                                     m_settings.parameters.baseCell);
  if (!found) {
    return base::fail(found.error());
  }
  if (!*found) {
    return {};
  }
  const report::FoundRun& run = **found;
  if (!m_options.resume.empty() && !run.onControl.hasClient) {
    return {};  // whether it is the right one is checked before it is ended
  }
  return base::fail(streaming::StreamError::ChannelBusy, adviceFor(run, m_connection.name));
}

/// From here on the program is the way back.
base::Result<void> StreamCommand::findWayBack() {
  if (!m_driven) {
    return {};
  }
  const auto left = run::askResume(*m_connection.link, m_program, m_driven->settings,
                                   m_driven->checkpoint, streaming::ActiveProgram::Stays);
  if (!left) {
    return base::fail(left.error());
  }
  if (left->restMm) {
    return base::fail(streaming::StreamError::ChannelBusy,
                      "The program of the run still stands on the control. End it first "
                      "(rivulet-cli runs --end), or reset the control.");
  }
  const auto flight = streaming::preflight(*m_connection.link, m_program, m_settings);
  if (!flight) {
    return base::fail(flight.error());
  }
  const auto way =
      streaming::backAlong(m_program, m_driven->settings, m_driven->checkpoint, left->point,
                           {flight->toolMm, flight->toolDeg}, {m_options.tool.back->mm});
  if (!way) {
    return base::fail(way.error());
  }
  m_driven->back = way->part;
  m_program = streaming::backProgram(*way, m_settings.parameters.rotaryAxes);
  const base::Vec3 to = way->places.back().mm;
  log::logger().info("Back along the path by {:.3f} mm, to X {:.3f} Y {:.3f} Z {:.3f}.",
                     way->lengthMm, to.x, to.y, to.z);
  return applyRules();
}

base::Result<void> StreamCommand::findResume() {
  if (!m_resumed) {
    return {};
  }
  const report::SavedRun* run = &*m_resumed;
  streaming::RunSettings earlier = m_settings;
  earlier.parameters = run->settings.parameters;
  earlier.programFeeds = run->settings.programFeeds;
  const auto ask = [&](streaming::ActiveProgram active) {
    return run::askResume(*m_connection.link, m_program, earlier, run->checkpoint, active);
  };
  const auto resume = ask(streaming::ActiveProgram::Stays);
  if (!resume) {
    return base::fail(resume.error());
  }
  if (resume->changedFrom) {
    const std::string change = fmt::format(
        "From point {} on, the program differs from that of the interrupted run. None "
        "of these points has been executed.",
        *resume->changedFrom + 1);
    if (!m_options.acceptChanges) {
      return base::fail(streaming::StreamError::ProgramChanged,
                        change + " Check the new path, then give --accept-changes.",
                        m_program.name);
    }
    log::logger().warn(change);
  }
  if (resume->restMm) {
    log::logger().warn(run::restText(resume->restMm));
  }
  const auto ended = ask(streaming::ActiveProgram::IsEnded);
  if (!ended) {
    return base::fail(ended.error());
  }
  if (!run::isSame(*ended, *resume)) {
    return base::fail(run::changedSince());
  }
  m_settings.resume = *ended;
  return {};
}

/// The way of all points that are left.
base::Result<void> StreamCommand::checkTravel() {
  // What else stands in the way of a start, the run says itself.
  const auto flight = streaming::preflight(*m_connection.link, m_program, m_settings);
  if (flight && m_options.tool.raiseToMm && flight->toolMm.z >= *m_options.tool.raiseToMm) {
    return base::fail(gcode::GcodeError::NoMotion,
                      fmt::format("The tool stands at Z {:.3f} already.", flight->toolMm.z));
  }
  // The way back has been cut already.
  if (flight && !m_settings.resume && !m_driven && !m_options.simulate) {
    const std::vector<gcode::StreamPoint>& points = flight->points.points;
    const auto cut = streaming::cutOnTheWay(
        flight->toolMm, streaming::firstPlace(m_program.trajectory, flight->toolMm),
        streaming::cutOf(points));
    // A virtual machine has nothing in its way.
    const bool isAccepted = m_options.straight || m_connection.control->isVirtualMachine();
    if (base::Result<void> clear = requireClearWay(cut, isAccepted, m_program.name); !clear) {
      return clear;
    }
  }
  if (flight) {
    tellStop(*flight);
  }
  return flight ? requireTravel(m_connection, m_options.simulate ? m_options.preset : std::string(),
                                flight->points.points)
                : base::Result<void>();
}

void StreamCommand::tellStop(const streaming::Preflight& flight) {
  const templates::CellMap& cells = m_flexible.cells;
  if (cells.hasFeedCell() && m_settings.windowSMax == 0.0) {
    m_stop = {{"acts", "at once"}};
    const auto machine =
        m_options.simulate
            ? machine::loadPreset(m_options.preset).value_or(machine::MachineConfig{})
            : run::machineOf(*m_connection.control, m_connection.name)
                  .value_or(std::nullopt)
                  .value_or(machine::MachineConfig{});
    if (machine.name.empty()) {
      log::logger().info("Stop: the axes stand at once, on the path.");
      return;
    }
    const feasibility::TurnSize turn = report::operatingPointOf(m_settings).turn();
    const double seconds = base::toSeconds(
        run::standsWithin(machine, turn, access().timePerNode(turn), m_settings.feedMmPerS));
    m_stop["within_s"] = seconds;
    log::logger().info("Stop: the axes stand on the path within {:.1f} s.", seconds);
    return;
  }
  const streaming::StopBound bound =
      streaming::stopBound(flight.points.points, flight.toolMm, m_settings);
  m_stop = {{"acts", cells.hasFeedCell() ? "before the next window" : "at the end of the loop"},
            {"at_most_s", bound.seconds},
            {"at_most_mm", bound.mm}};
  if (bound.longMove) {
    m_stop["long_move"] = {{"line", bound.longMove->line.value},
                           {"seconds", bound.longMove->seconds}};
  }
  if (cells.hasFeedCell()) {
    m_stop["why"] = streaming::describe(m_proof);
  }
  log::logger().warn(streaming::describe(bound, m_proof, cells.hasFeedCell()));
}

Exit StreamCommand::run() {
  run::RunFacts facts = factsOf(m_options, m_program, m_connection.name);
  facts.reading.moveRules = m_moveRules;
  facts.drivenBack = m_driven;
  run::RunRecord record(std::move(facts));
  if (const base::Result<void> opened = record.open(); !opened) {
    return reportError(opened.error(), m_options.json);
  }
  base::Result<FeedSource> feed = FeedSource::open(
      m_options.orders, m_options.correct == "-" || m_options.live.factor.source == "-");
  if (!feed) {
    return reportError(feed.error(), m_options.json);
  }
  PacedLink paced(*m_connection.link);
  opcua::Link& link =
      m_options.simulate && m_factor ? static_cast<opcua::Link&>(paced) : *m_connection.link;
  if (m_factor) {
    feed->follow(*m_factor);
  }
  StreamOrders orders(m_options.stopAfterS, m_source ? &*m_source : nullptr, *feed);
  streaming::RunReport done;
  {
    ConsoleSink sink(*feed);  // takes its line away at the end
    done = streaming::runJob(link, *m_connection.control, m_program, m_flexible, m_settings, orders,
                             sink, {record.writer(), record.start(), record.keeper()});
  }
  if (m_factor) {
    m_factor->finish(streaming::outcomeName(done.outcome), done.factor);
    m_factor.reset();  // the sender hears the end
  }
  const base::Vec3 startMm = done.checkpoint ? done.checkpoint->startMm : base::Vec3{};
  const auto path = gcode::streamPoints(m_program.trajectory, startMm).points;
  record.finish(done, {path});
  return show(done, record);
}

Exit StreamCommand::show(const streaming::RunReport& done, const run::RunRecord& record) const {
  if (m_options.json) {
    nlohmann::ordered_json json = report::runJson(done);
    json["feasible"] = m_judged.feasible;
    if (m_judged.verdict) {
      json["access_time"] = accessSourceJson(m_calibrated, m_judged.form, *m_judged.verdict);
    }
    if (m_judged.limit) {
      json["override_limit"] = report::overrideLimitJson(*m_judged.limit);
    }
    if (!m_stop.is_null()) {
      json["stop"] = m_stop;
    }
    json["endpoint"] = m_connection.name;
    json.update(filesJson(record, "saved_run"));
    printJson(json);
  } else {
    print(done, m_calibrated, m_judged);
  }
  if (done.leftHeld && !m_options.simulate) {
    log::logger().warn(leftHeldText(m_connection.name));
  }
  return exitAfter(done, record);
}

/// The same as a whole job.
JobOptions jobOf(const StreamOptions& options) {
  JobOptions job;
  job.point = options.point;
  job.file = options.file;
  job.loading = options.loading;
  job.endpoint = options.endpoint;
  job.simulate = options.simulate;
  if (options.namesMachine) {
    job.preset = options.preset;
    job.namesMachine = true;
  }
  job.seed = options.seed;
  job.stopAfterS = options.stopAfterS;
  job.record = options.record;
  job.orders = options.orders;
  job.factor = options.live.factor;
  job.noMonitor = options.noMonitor;
  job.fromStart = options.fromStart;
  job.straight = options.straight;
  job.command = options.command;
  std::replace(job.command.begin(), job.command.end(), std::string("stream"), std::string("job"));
  job.json = options.json;
  return job;
}

/// Which whole jobs the machine may run.
base::Result<streaming::JobRelease> releaseOf(const StreamOptions& options) {
  if (options.simulate) {
    return streaming::JobRelease();
  }
  const auto connection = connectTo(options.endpoint);
  return connection ? jobRelease(*connection)
                    : base::Result<streaming::JobRelease>(base::fail(connection.error()));
}

/// Says which blocks are left out, if the program has such.
/// @return true if the program is to be run as a whole job
base::Result<bool> isWholeJob(const StreamOptions& options) {
  if (options.motionOnly || options.tool.raiseToMm || options.tool.back) {
    return false;
  }
  gcode::LoadOptions loading = options.loading.loadOptions();
  loading.subprogram = gcode::subprogramsBeside(options.file);
  auto program = gcode::loadProgram(options.file, options.loading.loadOptions());
  if (!program) {
    return false;  // said when it is loaded for its motion
  }
  const auto plan =
      job::makePlan(*program, loading, jobProfile(options.endpoint, options.simulate));
  const std::size_t blocks = plan ? plan->actionCount() : 0;
  if (blocks == 0) {
    return false;
  }
  const auto leaveOut = [blocks](const std::string& why) {
    log::logger().warn(
        "Only the motion is streamed: {}. {} blocks for the control are left out: set tool, "
        "spindle and coolant at the control. With --motion-only there is no such warning.",
        why, blocks);
    return false;
  };
  if (!options.motionOption.empty()) {
    return leaveOut(options.motionOption + " is for the motion alone");
  }
  const base::Result<streaming::JobRelease> release = releaseOf(options);
  if (!release) {
    return base::fail(release.error());
  }
  if (base::Result<void> meant = requireMeaning(plan->program, false); !meant) {
    return base::fail(meant.error());
  }
  if (!release->runsJobs()) {
    return leaveOut("whole jobs have not been tested on this control (commission --jobs)");
  }
  if (!plan->refusals.empty()) {
    return base::fail(
        job::JobError::NotWhole,
        job::describe(plan->refusals.front()) + " To stream the motion alone, give --motion-only.",
        program->name);
  }
  return true;
}

}  // namespace

Exit stream(const StreamOptions& options) {
  interrupt::watch();
  const base::Result<bool> isWhole = isWholeJob(options);
  if (!isWhole) {
    return reportError(isWhole.error(), options.json);
  }
  if (*isWhole) {
    return job(jobOf(options));
  }
  StreamCommand command(options);
  if (const base::Result<void> prepared = command.prepare(); !prepared) {
    return reportError(prepared.error(), options.json);
  }
  return command.run();
}

}  // namespace rivulet::cli
