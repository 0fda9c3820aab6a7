// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "base/file.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/console_orders.h"
#include "cli/feed_source.h"
#include "cli/found_run.h"
#include "cli/paced_link.h"
#include "cli/run_files.h"
#include "cli/run_settings.h"
#include "forecast/job_forecast.h"
#include "forecast/large_machine.h"
#include "gcode/block_observer.h"
#include "job/dry_plan.h"
#include "job/functions.h"
#include "job/main_program.h"
#include "machine/config.h"
#include "opcua/await.h"
#include "overview/program_view.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "report/job_json.h"
#include "report/load_machine.h"
#include "report/machine_store.h"
#include "report/plan_json.h"
#include "report/report_json.h"
#include "report/run_store.h"
#include "run/resume.h"
#include "run/travel.h"
#include "streaming/control/access_policy.h"
#include "streaming/control/control_axes.h"
#include "streaming/run/job_count.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/fitted_machine.h"
#include "streaming/simulation/job_proof.h"
#include "templates/target.h"
#include "trace/analysis/tool_use.h"

namespace rivulet::cli {

namespace {

/// Says what the control does.
class JobConsole final : public streaming::WholeJobSink, public ConsoleOrders {
 public:
  /// @param isAlone  nobody is at the control: it is simulated
  JobConsole(double stopAfterS, bool isQuiet, bool isAlone, FeedSource& feed)
      : ConsoleOrders(stopAfterS, feed), m_isQuiet(isQuiet), m_isAlone(isAlone) {}

  void update(const streaming::LiveUpdate& update) override {
    tell(update);
    if (update.waitingFor == "claim" && !m_saysClaim) {
      m_saysClaim = true;
      log::logger().warn(kClaimMayLapse);
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  void nativeBlocks(int next) override {
    if (!m_isQuiet) {
      say(fmt::format("the control executes the blocks before stretch {}\n", next));
    }
  }
  /// Of the blocks that may take long, so that nobody wonders.
  void nativeBlock(const job::NativeBlock& block) override {
    if (!m_isQuiet && block.reason == job::NativeReason::Tool) {
      say(fmt::format("the control executes line {}: {}\n", block.place.line.value, block.source));
    }
  }
  void stretchBegins(const job::Stretch& stretch, base::Vec3 startMm) override {
    if (!m_isQuiet) {
      say(fmt::format("stretch {}: lines {} to {}, {} points, from X {:.3f} Y {:.3f} Z {:.3f}\n",
                      stretch.number, stretch.blocks.front().line.value,
                      stretch.blocks.back().line.value, stretch.pointCount, startMm.x, startMm.y,
                      startMm.z));
    }
  }
  bool waitsForCycleStart() override {
    if (!m_isQuiet) {
      say(fmt::format("the program waits for cycle start (M0, M1){}\n",
                      m_isAlone ? ": pressed" : ": press it at the control"));
    }
    return m_isAlone;
  }

 private:
  /// At once, also into a pipe.
  static void say(const std::string& line) {
    fmt::print("{}", line);
    std::fflush(stdout);
  }

  bool m_isQuiet;
  bool m_isAlone;
  bool m_saysClaim = false;
};

/// For the person at the control.
std::string readMe(const job::Plan& plan, const job::JobPrograms& programs) {
  const bool hasLoop = programs.loop.isOwnFile;
  std::string text = fmt::format(
      "Job {} of {}\n\n"
      "1. Copy {} to the part programs of the control{}.\n"
      "   Do not change {}.\n"
      "2. Set up work offset, tools and stock as for {} itself.\n"
      "3. Select {} in channel 1. The cells begin at R{}: nothing else may use R{} to R{}.\n"
      "4. Press cycle start. Nothing moves before Rivulet has connected.\n\n"
      "The control executes {} blocks itself, and Rivulet streams {} stretches between them.\n"
      "Stop in Rivulet ends the job after the window in motion, or before the next block.\n"
      "Emergency stop, feed override and reset at the control work as always.\n\n",
      programs.number, plan.program.name, programs.mainName,
      hasLoop ? fmt::format(", and {} to its subprograms", programs.loop.name) : "",
      hasLoop ? "them" : "it", plan.program.name, programs.mainName, programs.loop.cells.run,
      programs.loop.cells.run, programs.loop.cells.last(), plan.nativeCount(), plan.stretchCount());
  for (const job::FunctionUse& use : plan.functions) {
    text += job::describe(use) + '\n';
  }
  for (const job::Part& part : plan.parts) {
    if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
      text += fmt::format("  line {:<7} {:<19} {}\n", native->place.line.value,
                          job::nativeReasonName(native->reason), native->source);
    } else if (const auto& stretch = std::get<job::Stretch>(part); stretch.number > 0) {
      text += fmt::format("  stretch {:<4} {} points\n", stretch.number, stretch.pointCount);
    }
  }
  return text;
}

class JobCommand {
 public:
  explicit JobCommand(const JobOptions& options) : m_options(options) {}
  base::Result<void> prepare();
  base::Result<void> writeFiles() const;
  base::Result<void> makePrograms();
  base::Result<void> connect();
  /// What was said of M functions, for the next job on this machine.
  base::Result<void> keepFunctions();
  /// What is on the control, and what was left there: neither is lost without a word.
  base::Result<void> lookForRun();
  /// Where a job is to go on: what is done first is shown, and has to be confirmed.
  base::Result<void> restart();
  /// Compares the job with the machine, and estimates its time.
  base::Result<void> look();
  /// Last: the program that was left is ended, and the place asked for once more.
  base::Result<void> endLeft();
  [[nodiscard]] Exit run();
  [[nodiscard]] Exit verify();
  [[nodiscard]] const std::vector<forecast::Hazard>& hazards() const { return m_hazards; }
  /// Before the job goes on; empty: it begins at the beginning.
  [[nodiscard]] std::vector<std::string> steps() const {
    return m_restart ? m_restart->restart.steps : std::vector<std::string>();
  }
  /// What its program does before that; empty: it has ended.
  [[nodiscard]] std::string rest() const {
    return m_restart ? run::restText(m_restart->restMm) : std::string();
  }

 private:
  base::Result<void> planFeeds();
  [[nodiscard]] base::Result<job::Profile> profileOfMachine() const;
  /// The job is made for a virtual machine that is set up for it. Files are for a control, which
  /// knows tools and functions better.
  [[nodiscard]] bool isVirtualAlone() const {
    return (m_options.simulate || m_options.verify) && m_options.output.empty();
  }
  base::Result<std::optional<machine::MachineConfig>> machine();
  /// From where the tool stands; nothing has been executed.
  base::Result<void> requireClearWay(const machine::MachineConfig& machine,
                                     const streaming::CutBox& cut);
  base::Result<run::JobRestart> findRestart(const machine::MachineConfig& machine);
  base::Result<run::JobRestart> ask(const machine::MachineConfig& machine,
                                    const report::SavedRun& run, streaming::ActiveProgram active);
  base::Result<void> confirm() const;
  [[nodiscard]] run::RunFacts facts() const;
  [[nodiscard]] std::vector<base::Duration> expected() const;
  void archive(const streaming::WholeJobReport& done, run::RunRecord& record) const;
  void print(const streaming::WholeJobReport& done) const;
  void printNotes() const;

  const JobOptions& m_options;
  machine::MachineConfig m_machine;  ///< of --preset
  std::vector<std::string> m_notes;  ///< how the virtual machine has been set up for the job
  job::Plan m_plan;
  streaming::RunSettings m_settings;
  job::JobPrograms m_programs;
  Connection m_connection;
  std::optional<run::JobRestart> m_restart;
  std::optional<report::SavedRun> m_resumed;  ///< of `m_restart`; nothing: a chosen stretch
  /// All of the job; null: `m_plan` is all of it.
  std::shared_ptr<const job::Plan> m_whole;
  std::vector<forecast::Hazard> m_hazards;
  std::optional<forecast::JobForecast> m_forecast;
};

base::Result<void> JobCommand::prepare() {
  auto program = gcode::loadProgram(m_options.file, m_options.loading.loadOptions());
  if (!program) {
    return base::fail(program.error());
  }
  auto machine = machine::loadPreset(m_options.preset);
  if (!machine) {
    return base::fail(machine.error());
  }
  m_machine = std::move(*machine);
  gcode::LoadOptions options = m_options.loading.loadOptions();
  options.subprogram = gcode::subprogramsBeside(m_options.file);
  const bool isVirtual = m_options.simulate || m_options.verify;
  auto profile = profileOfMachine();
  if (!profile) {
    return base::fail(profile.error());
  }
  report::LoadMachine known{*std::move(profile), std::nullopt, isVirtualAlone()};
  if (isVirtual || m_options.namesMachine) {
    known.tools = m_machine.tools;
  }
  known.tell(options);
  const auto makePlan = [&]() -> base::Result<job::Plan> {
    auto plan = job::makePlan(program->name, program->text, options, known.words);
    return plan && m_options.dryRunMm > 0.0 ? job::dryPlan(std::move(*plan), m_options.dryRunMm)
                                            : std::move(plan);
  };
  const auto areOffsetsRead = std::make_shared<bool>(false);
  if (isVirtualAlone()) {
    options.workOffsetMm = streaming::workOffsets(m_machine, areOffsetsRead);
  }
  auto plan = makePlan();
  // Where the workpiece lies may depend on the program, and the program on that ($AA_IM): if it
  // does not come to rest, nobody knows it.
  for (int round = 0; plan && *areOffsetsRead && round < 2; ++round) {
    const machine::MachineConfig fitted = streaming::fitMachine(m_machine, *plan).config;
    options.workOffsetMm = round == 0 ? streaming::workOffsets(fitted, areOffsetsRead) : nullptr;
    auto again = makePlan();
    if (again &&
        streaming::fitMachine(m_machine, *again).config.workOffsetsMm == fitted.workOffsetsMm) {
      plan = std::move(again);
      break;
    }
    plan = std::move(again);
  }
  if (!plan) {
    return base::fail(plan.error());
  }
  m_plan = std::move(*plan);
  if (base::Result<void> meant = requireMeaning(m_plan.program, !m_options.output.empty());
      !meant) {
    return meant;
  }
  if (isVirtual) {
    streaming::FittedMachine fitted = streaming::fitMachine(std::move(m_machine), m_plan);
    m_machine = std::move(fitted.config);
    m_notes = std::move(fitted.notes);
  }
  m_settings.parameters = m_options.point.parameters();
  if (m_options.point.axes.empty()) {
    m_settings.parameters = streaming::withTurnedAxes(m_settings.parameters, m_plan);
  }
  const streaming::AccessPlan access =
      streaming::accessPlan(streaming::AccessPreference::Automatic, m_settings.parameters.method);
  m_settings.access = access.choice;
  m_settings.grouping = access.grouping;
  m_settings.monitor = !m_options.noMonitor;
  m_settings.factor = m_options.factor.agreed();
  if (base::Result<void> feeds = planFeeds(); !feeds) {
    return feeds;
  }
  if (base::Result<void> made = makePrograms(); !made) {
    return made;
  }
  if (isVirtual && !m_options.namesMachine) {
    const std::vector<std::string> notes = forecast::enlarge(m_machine, m_plan);
    m_notes.insert(m_notes.end(), notes.begin(), notes.end());
  }
  return {};
}

/// What is known of the machine before it is connected.
base::Result<job::Profile> JobCommand::profileOfMachine() const {
  auto given = job::functionsOf(m_options.functions);
  if (!given) {
    return base::fail(given.error());
  }
  job::Profile profile = jobProfile(m_options.endpoint, isVirtualAlone());
  given->merge(profile.functions);  // what is said now comes before what was said once
  profile.functions = *std::move(given);
  return profile;
}

base::Result<void> JobCommand::keepFunctions() {
  if (m_options.functions.empty() || m_options.endpoint.empty()) {
    return {};
  }
  const auto identity = m_connection.control->identity();
  const auto given = job::functionsOf(m_options.functions);
  if (!identity || !given) {
    return base::fail(identity ? given.error() : identity.error());
  }
  const report::MachineStore store;
  job::Functions functions = *given;
  functions.merge(store.functions(m_connection.name));
  return store.save(m_connection.name, *identity, functions);
}

base::Result<void> JobCommand::planFeeds() {
  if (base::Result<void> taken = takeFeeds(m_settings, m_options.point, m_machine, m_plan.program);
      !taken) {
    return taken;
  }
  if (m_settings.programFeeds) {
    streaming::planFeeds(
        m_settings,
        gcode::streamPoints(m_plan.program.trajectory, {}, {}, &*m_settings.programFeeds).points,
        {}, feedCellsOf(m_options.point));
  }
  return {};
}

base::Result<void> JobCommand::writeFiles() const {
  const std::filesystem::path folder(m_options.output);
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  std::vector<std::pair<std::string, std::string>> files{
      {m_programs.mainName, m_programs.mainText},
      {"README.txt", readMe(m_plan, m_programs)},
      {"job.json", report::planJson(m_plan).dump(2, ' ', false,
                                                 nlohmann::ordered_json::error_handler_t::replace) +
                       "\n"}};
  if (m_programs.loop.isOwnFile) {
    files.insert(files.begin() + 1, {m_programs.loop.name, m_programs.loop.text});
  }
  for (const auto& [name, text] : files) {
    if (const auto written = base::writeFile((folder / name).string(), text); !written) {
      return written;
    }
    if (!m_options.json) {
      fmt::print("{}\n", (folder / name).string());
    }
  }
  return {};
}

base::Result<void> JobCommand::makePrograms() {
  if (auto fits = requireRunMemory(m_plan.program.trajectory.points.size()); !fits) {
    return fits;
  }
  auto programs = job::makePrograms(m_plan, m_settings.parameters);
  if (!programs) {
    return base::fail(programs.error());
  }
  m_programs = std::move(*programs);
  return {};
}

base::Result<void> JobCommand::connect() {
  auto connection =
      m_options.simulate
          ? base::Result<Connection>(simulate(m_machine, m_options.preset, m_options.seed))
          : connectTo(m_options.endpoint);
  if (!connection) {
    return base::fail(connection.error());
  }
  m_connection = std::move(*connection);
  const auto identity = m_connection.control->identity();
  if (!identity) {
    return base::fail(identity.error());
  }
  const auto release = jobRelease(m_connection);
  if (!release) {
    return base::fail(release.error());
  }
  if (base::Result<void> released = release->require(m_plan); !released) {
    released.error().message += " Nothing was changed on the control.";
    return released;
  }
  const templates::TemplateParameters before = m_settings.parameters;
  m_settings.parameters =
      templates::forTarget(m_settings.parameters, templates::targetOf(identity->applicationUri));
  if (base::Result<void> taken =
          takeSilenceLimit(m_settings.parameters, m_options.point, m_connection);
      !taken) {
    return taken;
  }
  if (m_settings.parameters.target != before.target ||
      m_settings.parameters.silenceLimitS != before.silenceLimitS) {
    if (base::Result<void> made = makePrograms(); !made) {
      return made;
    }
  }
  // Wrong motion of a virtual machine does no harm; LinuxCNC reads a pin when it passes the block.
  const bool needsTest =
      base::needsCommissioning(m_settings.parameters.method) &&
      !templates::runsWholeJobs(identity->applicationUri, m_connection.control->isVirtualMachine());
  if (needsTest) {
    if (base::Result<void> tested = requireCreditTest(m_connection); !tested) {
      return tested;
    }
  }
  m_settings.isCommissioned = true;
  if (!m_options.simulate) {
    m_settings.origin = report::thisUser();
  }
  return {};
}

/// What is known of the machine that is to run the job; nothing: it reports nothing that is known
/// here.
base::Result<std::optional<machine::MachineConfig>> JobCommand::machine() {
  if (m_options.simulate) {
    return std::optional(m_machine);
  }
  return run::machineOf(*m_connection.control, m_connection.name);
}

base::Result<void> JobCommand::lookForRun() {
  if (m_options.simulate) {
    return {};
  }
  const bool goesOn = !m_options.resume.empty();
  const auto found = report::findRun(report::RunStore(), *m_connection.link, *m_connection.control,
                                     m_settings.parameters.baseCell);
  if (!found) {
    return base::fail(found.error());
  }
  if (*found && !(goesOn && !(*found)->onControl.hasClient)) {
    return base::fail(streaming::StreamError::ChannelBusy, adviceFor(**found, m_connection.name));
  }
  if (goesOn || m_options.fromStretch > 0 || m_options.fromStart) {
    return {};
  }
  const auto left = report::RunStore(report::RunStore::folderOfJobs()).leftOn(m_connection.name);
  if (!left || left->isUntouched()) {
    return {};
  }
  return base::fail(
      streaming::StreamError::CannotResume,
      fmt::format("A whole job was left on this control: {} of {}, started by {} on {} at {}. To "
                  "go on with it:\n  {}\nTo begin {} at its beginning instead, give --from-start: "
                  "then the other one cannot be resumed. Nothing has moved.",
                  left->number(), left->programName, left->settings.origin.user,
                  left->settings.origin.computer, left->settings.origin.startedAtUtc,
                  resumeCommand(*left, left->file), m_plan.program.name));
}

base::Result<void> JobCommand::restart() {
  if (m_options.resume.empty() && m_options.fromStretch == 0) {
    return {};
  }
  const auto machine = this->machine();
  if (!machine) {
    return base::fail(machine.error());
  }
  if (!*machine) {
    return base::fail(run::machineNotKnown());
  }
  base::Result<run::JobRestart> found = findRestart(**machine);
  if (!found) {
    return base::fail(found.error());
  }
  m_restart = std::move(*found);
  m_whole = std::make_shared<const job::Plan>(std::move(m_plan));
  m_plan = m_restart->restart.plan;
  if (base::Result<void> made = makePrograms(); !made) {
    return made;
  }
  return confirm();
}

base::Result<run::JobRestart> JobCommand::findRestart(const machine::MachineConfig& machine) {
  if (m_options.fromStretch > 0) {
    return run::beginWith(m_options.fromStretch, m_plan, machine);
  }
  const auto run = report::readSavedRun(m_options.resume, memoryBudget());
  if (!run) {
    return base::fail(run.error());
  }
  m_settings.parameters = run->settings.parameters;
  m_settings.programFeeds = run->settings.programFeeds;
  m_settings.feedMmPerS = run->settings.feedMmPerS;
  m_resumed = *run;
  return ask(machine, *m_resumed, streaming::ActiveProgram::Stays);
}

base::Result<run::JobRestart> JobCommand::ask(const machine::MachineConfig& machine,
                                              const report::SavedRun& run,
                                              streaming::ActiveProgram active) {
  return run::askJob(*m_connection.link, m_whole ? *m_whole : m_plan, machine, m_settings,
                     run.checkpoint, run.job, active);
}

base::Result<void> JobCommand::endLeft() {
  if (!m_resumed) {
    return {};
  }
  const auto machine = this->machine();
  if (!machine) {
    return base::fail(machine.error());
  }
  const auto found = ask(**machine, *m_resumed, streaming::ActiveProgram::IsEnded);
  if (!found) {
    return base::fail(found.error());
  }
  return run::isSame(*found, *m_restart) ? base::Result<void>() : base::fail(run::changedSince());
}

base::Result<void> JobCommand::confirm() const {
  if (!m_options.json && m_restart->restMm) {
    fmt::print("{}\n", rest());
  }
  if (!m_options.json && m_restart->restart.steps.empty()) {
    fmt::print("nothing of the job has been executed: it begins at its beginning\n");
  } else if (!m_options.json) {
    fmt::print("before the job goes on, the control does:\n");
    for (const std::string& step : m_restart->restart.steps) {
      fmt::print("  {}\n", step);
    }
    for (const std::string& block : m_restart->restart.notRestored) {
      fmt::print("not done again, because only the control knows its effect: {}\n", block);
    }
  }
  return m_options.confirmed
             ? base::Result<void>()
             : base::fail(streaming::StreamError::CannotResume,
                          "Check what is done first, and that nothing is in the way of the tool, "
                          "then give --yes. Nothing has moved.");
}

run::RunFacts JobCommand::facts() const {
  run::RunFacts facts = factsOf(m_options, m_plan.program, m_connection.name);
  facts.kind = run::RunKind::WholeJob;
  facts.job =
      m_restart ? m_restart->kept(m_programs.number) : report::SavedJob{m_programs.number, 0, {}};
  facts.dryRunMm = m_options.dryRunMm;
  return facts;
}

base::Result<void> JobCommand::look() {
  const auto machine = this->machine();
  if (!machine) {
    return base::fail(machine.error());
  }
  if (!*machine) {
    log::logger().warn(
        "Travel, spindle speed and tools were not checked: the limits of this machine are not "
        "known.");
    return {};
  }
  const forecast::HazardOptions options{(*machine)->start()};
  const forecast::CheckedJob checked = forecast::checkJob(m_plan, **machine, options);
  m_hazards = checked.hazards;
  if (!m_options.json) {
    for (const forecast::Hazard& hazard : m_hazards) {
      log::logger().warn(forecast::describe(hazard));
    }
  }
  if (base::Result<void> none = forecast::requireNoHazard(m_plan, m_hazards); !none) {
    return none;
  }
  // What this machine does not know, nobody does who simulates it.
  const auto unknown =
      std::find_if(m_hazards.begin(), m_hazards.end(), [](const forecast::Hazard& hazard) {
        return hazard.kind == forecast::HazardKind::NotChecked && hazard.alarm > 0;
      });
  if (m_options.simulate && unknown != m_hazards.end()) {
    return base::fail(job::JobError::BeyondMachine,
                      fmt::format("The virtual machine would stop with alarm {}: {} Nothing was "
                                  "moved.",
                                  unknown->alarm, unknown->text),
                      fmt::format("{}:{}", m_plan.program.name, unknown->line.value));
  }
  // A job that goes on raises the tool itself.
  if (base::Result<void> clear = m_options.simulate || m_restart
                                     ? base::Result<void>()
                                     : requireClearWay(**machine, checked.cut);
      !clear) {
    return clear;
  }
  m_forecast = forecast::forecast(m_plan, **machine, m_settings, options);
  if (!m_options.json) {
    fmt::print("estimated: {}\n", report::describe(m_forecast->times));
  }
  return {};
}

base::Result<void> JobCommand::requireClearWay(const machine::MachineConfig& machine,
                                               const streaming::CutBox& cut) {
  const std::array<opcua::Variable, 3> position{{{opcua::VariableKind::ActualPosition, 0},
                                                 {opcua::VariableKind::ActualPosition, 1},
                                                 {opcua::VariableKind::ActualPosition, 2}}};
  const auto mm = opcua::readNumbers(*m_connection.link, position, m_settings.setupDeadline);
  if (!mm) {
    return base::fail(mm.error());
  }
  const base::AxisPosition tool{{(*mm)[0], (*mm)[1], (*mm)[2]}, {}};
  return cli::requireClearWay(forecast::cutOnTheWay(m_plan, machine, tool, cut),
                              m_options.straight || m_connection.control->isVirtualMachine(),
                              m_plan.program.name);
}

void JobCommand::print(const streaming::WholeJobReport& done) const {
  std::size_t executed = 0;
  for (const streaming::StretchReport& stretch : done.stretches) {
    executed += stretch.run.counters.executed;
  }
  fmt::print("{}: {} of {} stretches begun, {} points executed, {} blocks for the control\n",
             streaming::outcomeName(done.outcome), done.stretches.size(), m_plan.stretchCount(),
             executed, m_plan.nativeCount());
  if (done.outcome != streaming::Outcome::Completed) {
    fmt::print("it ended {}\n", streaming::describe(done.reached));
  }
  if (done.integrity.judged) {
    fmt::print("{} repeated, {} skipped, {} foreign\n", done.integrity.repeated,
               done.integrity.skipped, done.integrity.foreign);
  } else {
    fmt::print("not judged: {}\n", done.controlTrace
                                       ? "the trace of the control does not show all points"
                                       : "no trace of the control");
  }
  fmt::print("measured: {}\n", report::describe(done.times));
  for (const trace::ToolUse& use : done.tools) {
    fmt::print("  {}\n", report::describe(use));
  }
}

void JobCommand::printNotes() const {
  for (const std::string& note : m_notes) {
    fmt::print("{}\n", note);
  }
  for (const job::FunctionUse& use : m_plan.functions) {
    fmt::print("{}\n", job::describe(use));
  }
}

Exit JobCommand::verify() {
  m_settings.isCommissioned = true;  // a virtual machine
  const auto proof = streaming::proveJob(m_plan, m_machine, m_settings, m_options.seed);
  if (!proof) {
    return reportError(proof.error(), m_options.json);
  }
  if (m_options.json) {
    printJson({{"same", proof->difference.empty()},
               {"difference", proof->difference},
               {"compared_with_source", proof->isSource},
               {"motions", proof->ends},
               {"farthest_mm", proof->farthestMm},
               {"plain_s", base::toSeconds(proof->plain)},
               {"job_s", base::toSeconds(proof->asJob)},
               {"stretches", m_plan.stretchCount()},
               {"native_blocks", m_plan.nativeCount()},
               {"m_functions", report::functionsJson(m_plan.functions)},
               {"machine_notes", m_notes}});
  } else {
    printNotes();
    fmt::print(
        "{}\n{} motions compared with {}, at most {:.4f} mm apart; {:.1f} s, as a job {:.1f} s\n",
        proof->difference.empty() ? "The job does what the program does." : proof->difference,
        proof->ends, proof->isSource ? "the program itself" : "the same blocks without a client",
        proof->farthestMm, base::toSeconds(proof->plain), base::toSeconds(proof->asJob));
  }
  return proof->difference.empty() ? Exit::Done : Exit::Wrong;
}

/// The job as the window keeps it, too: counted in all its points.
void JobCommand::archive(const streaming::WholeJobReport& done, run::RunRecord& record) const {
  if (m_options.simulate) {
    record.finish({}, {});
    return;
  }
  const auto plan = m_whole ? m_whole : std::make_shared<const job::Plan>(m_plan);
  const auto view =
      overview::makeProgramView(std::shared_ptr<const gcode::Program>(plan, &plan->program), {},
                                m_settings.parameters.pointsPerLoop, {}, {}, plan);
  const bool goesOn = m_restart && m_restart->resume;
  const streaming::JobCount count(view->stretchStarts, view->points.points.size(),
                                  goesOn ? m_restart->stretch : 0,
                                  goesOn ? m_restart->resume->point : 0);
  record.finish(count.reportOf(done, m_settings, plan->program.name),
                {view->points.points, done.times, done.tools});
}

/// How long each part takes.
std::vector<base::Duration> JobCommand::expected() const {
  std::vector<base::Duration> times;
  if (m_forecast) {
    times.resize(m_plan.parts.size());
    for (const forecast::PartTimes& part : m_forecast->parts) {
      times[part.part] = part.times.total();
    }
  }
  return times;
}

Exit JobCommand::run() {
  if (!m_options.json) {
    printNotes();
  }
  if (m_options.dryRunMm > 0.0 && !m_options.json) {
    fmt::print("dry run: {:g} mm higher, without spindle and coolant\n", m_options.dryRunMm);
  }
  run::RunRecord record(facts());
  if (const base::Result<void> opened = record.open(); !opened) {
    return reportError(opened.error(), m_options.json);
  }
  base::Result<FeedSource> feed =
      FeedSource::open(m_options.orders, m_options.factor.source == "-");
  if (!feed) {
    return reportError(feed.error(), m_options.json);
  }
  auto factor = openFactor(m_settings);
  if (!factor) {
    return reportError(factor.error(), m_options.json);
  }
  PacedLink paced(*m_connection.link);
  const bool isPaced = m_options.simulate && *factor != nullptr;
  if (*factor) {
    feed->follow(**factor);
  }
  JobConsole console(m_options.stopAfterS, m_options.json, m_options.simulate, *feed);
  streaming::WholeJobReport done = streaming::runWholeJob(
      isPaced ? static_cast<opcua::Link&>(paced) : *m_connection.link, *m_connection.control,
      m_plan, m_programs, m_settings, console, console,
      {m_restart ? m_restart->resume : std::nullopt, record.keeper(), record.writer(),
       record.start(), expected()});
  if (*factor) {
    (*factor)->finish(streaming::outcomeName(done.outcome), done.factor);
    factor->reset();
  }
  archive(done, record);
  if (m_options.json) {
    nlohmann::ordered_json json = report::wholeJobJson(m_plan, done);
    json["job"] = m_programs.number;
    if (m_options.dryRunMm > 0.0) {
      json["dry_run_mm"] = m_options.dryRunMm;
    }
    json["hazards"] = report::hazardsJson(m_hazards);
    json.update(filesJson(record, "saved_job"));
    if (m_restart) {
      json["restart"] = m_restart->restart.steps;
    }
    if (m_forecast) {
      json["estimated"] = report::jobTimesJson(m_forecast->times);
    }
    json["m_functions"] = report::functionsJson(m_plan.functions);
    json["machine_notes"] = m_notes;
    printJson(json);
  } else {
    print(done);
    printFactor(done.factor);
  }
  const bool isComplete = tellFiles(record);
  if (done.leftHeld && !m_options.simulate) {
    log::logger().warn(leftHeldText(m_connection.name));
  }
  if (done.outcome != streaming::Outcome::Completed && done.reached.stretch > 0 && !record.left()) {
    fmt::print(stderr,
               "The job is not complete. To go on:\n  rivulet-cli job {} ... --from-stretch {}\n",
               shellWord(m_options.file), done.reached.stretch);
  }
  if (!done.error.code) {
    return isComplete && (!done.integrity.judged || done.integrity.isFaultless()) ? Exit::Done
                                                                                  : Exit::Wrong;
  }
  if (!m_options.json) {
    log::logger().error(done.error.text());
  }
  return exitForRun(done.error);
}

}  // namespace

job::Profile jobProfile(const std::string& endpoint, bool isVirtualAlone) {
  job::Profile profile = report::MachineStore().jobProfile(endpoint, isVirtualAlone);
  profile.assumesTool = isVirtualAlone;
  return profile;
}

base::Result<void> tryJob(const std::string& file, const LoadingOptions& loading) {
  JobOptions options;
  options.file = file;
  options.loading = loading;
  options.simulate = true;
  options.json = true;  // prints nothing
  JobCommand command(options);
  base::Result<void> done = command.prepare();
  for (const auto step : {&JobCommand::connect, &JobCommand::look}) {
    done = done ? (command.*step)() : done;
  }
  return done;
}

Exit job(const JobOptions& options) {
  interrupt::watch();
  JobCommand command(options);
  base::Result<void> done = command.prepare();
  if (done && !options.output.empty()) {
    done = command.writeFiles();
  }
  if (done && options.verify) {
    return command.verify();
  }
  const bool runs = options.simulate || !options.endpoint.empty();
  if (done && runs) {
    done = command.connect();
    for (const auto step : {&JobCommand::keepFunctions, &JobCommand::lookForRun,
                            &JobCommand::restart, &JobCommand::look, &JobCommand::endLeft}) {
      done = done ? (command.*step)() : done;
    }
  }
  if (!done) {
    if (options.json && (!command.hazards().empty() || !command.steps().empty())) {
      printJson({{"error", report::errorJson(done.error())},
                 {"hazards", report::hazardsJson(command.hazards())},
                 {"rest", command.rest()},
                 {"restart", command.steps()}});
      return exitFor(done.error());
    }
    return reportError(done.error(), options.json);
  }
  return runs ? command.run() : Exit::Done;
}

}  // namespace rivulet::cli
