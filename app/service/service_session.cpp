// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/service_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "base/sha256.h"
#include "base/text.h"
#include "base/units.h"
#include "job/functions.h"
#include "journal/audit.h"
#include "platform/log.h"
#include "platform/utc_now.h"
#include "preparation/judged.h"
#include "preparation/release_file.h"
#include "report/run_history.h"
#include "run/factor_feed.h"
#include "service/machine_lock.h"
#include "streaming/control/control_alarm.h"
#include "streaming/run/run_summary.h"
#include "streaming/start/first_move.h"
#include "streaming/start/stop_bound.h"

namespace rivulet::service {

using permission::Act;

namespace {

/// How often a machine that is gone is looked for.
constexpr std::chrono::seconds kConnectInterval{2};
/// A position that is older is not told.
constexpr std::chrono::seconds kPositionAgeMax{1};
/// Axes that stand are told so much off from one reading to the next, at most.
constexpr double kStandsMm = 0.05;
constexpr std::size_t kConfirmationDigits = 16;
/// The folder of jobs is looked at this often.
constexpr std::chrono::seconds kLookInterval{2};
/// Of a folder, so many entries are looked at, and so many files are named.
constexpr std::size_t kEntriesMax = 5000;
constexpr std::size_t kFilesMax = 200;
constexpr const char* kIsAsked =
    "The control is being asked where the run or job can go on. Call again in a second.";

Answer no(std::string why) {
  return {false, std::move(why), {}};
}
Answer no(const base::Error& error) {
  return no(error.text());
}
Answer yes(std::string what, std::string confirmation = {}) {
  return {true, std::move(what), std::move(confirmation)};
}

std::string refusalText(permission::Refusal refusal) {
  streaming::Blocked blocked;
  switch (refusal) {
    case permission::Refusal::Locked:
      return "This service has users: log in with name and PIN. Only Stop works without.";
    case permission::Refusal::NeedsEngineer:
      blocked.reason = streaming::BlockReason::NeedsEngineer;
      break;
    case permission::Refusal::NotReleased:
      blocked.reason = streaming::BlockReason::NotReleased;
      break;
  }
  return streaming::blockedError(blocked).message;
}

/// Adaptive feed; empty: none.
std::string factorText(const streaming::RunSettings& settings) {
  const auto agreed = run::agreedFactor(settings);
  return agreed ? run::followsText(settings.factor.address, *agreed) + ' ' : std::string();
}

std::string blockedText(const streaming::Blocked& blocked) {
  return blocked.reason == streaming::BlockReason::Locked ? refusalText(permission::Refusal::Locked)
                                                          : streaming::blockedError(blocked).text();
}

/// What a run has not done as it should; empty: nothing.
std::string faultOf(const streaming::RunReport& report) {
  if (report.error.code) {
    return report.error.text();
  }
  const trace::Integrity& integrity = report.integrity;
  if (integrity.judged && !integrity.isFaultless()) {
    return fmt::format("The machine has repeated {} points and skipped {}. Check the workpiece.",
                       integrity.repeated, integrity.skipped);
  }
  return report.wrong
             ? "Wrong motion: " + streaming::describe(*report.wrong) + ". Check workpiece and tool."
             : std::string();
}

bool isBelow(const std::filesystem::path& folder, const std::filesystem::path& path) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

/// Where a job begins or goes on, and what is done first. Everything only the control knows is
/// named: it is not done again.
std::string beginningOf(const run::JobRestart& restart, std::size_t stretches) {
  if (restart.restart.steps.empty()) {
    return " at its beginning: nothing of it has been executed.";
  }
  std::string text = restart.stretch > 0
                         ? fmt::format(" with stretch {} of {}.", restart.stretch, stretches)
                         : fmt::format(" after stretch {}, the last.", stretches);
  text += " Before that the control does: ";
  for (const std::string& step : restart.restart.steps) {
    text += step + " ";
  }
  for (const std::string& block : restart.restart.notRestored) {
    text += fmt::format("Not done again, because only the control knows its effect: {}. ", block);
  }
  return text;
}

std::vector<double> lengthsOf(const std::vector<gcode::StreamPoint>& points) {
  std::vector<double> lengths(points.size() + 1, 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    lengths[i + 1] = lengths[i] + base::distance(points[i - 1].positionMm, points[i].positionMm);
  }
  return lengths;
}

}  // namespace

std::string filesIn(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<std::pair<fs::file_time_type, std::string>> files;
  std::error_code status;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         status);
  for (std::size_t seen = 0; !status && entry != fs::end(entry) && seen < kEntriesMax; ++seen) {
    const bool isHidden = entry->path().filename().string().starts_with('.');
    std::error_code gone;
    if (isHidden) {
      entry.disable_recursion_pending();
    } else if (fs::is_regular_file(entry->symlink_status(gone))) {
      files.emplace_back(entry->last_write_time(gone),
                         entry->path().lexically_relative(folder).string());
    }
    entry.increment(status);
  }
  std::sort(files.begin(), files.end(), std::greater<>());
  files.resize(std::min(files.size(), kFilesMax));
  std::string names;
  for (const auto& [at, name] : files) {
    if (name.find('\n') == std::string::npos) {
      names += name + '\n';
    }
  }
  return names;
}

bool isNotYet(const Answer& answer) {
  return !answer.accepted && answer.message.ends_with("again in a second.");
}

ServiceSession::ServiceSession(SessionOptions options, opcua::Connector connector,
                               report::MachineStore machines)
    : m_options(std::move(options)),
      m_machines(machines),
      m_worker(std::move(connector), std::move(machines)) {
}

void ServiceSession::turn(Clock::time_point now) {
  while (const auto event = m_worker.take()) {
    take(*event);
  }
  lookForFiles(now);
  const bool isGone =
      m_link.state == session::LinkState::Disconnected || m_link.state == session::LinkState::Lost;
  if (isGone && !m_isConnecting && !m_isRunning && !m_endsForGood && now >= m_look.nextConnect) {
    m_look.nextConnect = now + kConnectInterval;
    m_isConnecting = m_worker.post(session::ConnectCommand{m_options.machine});
  }
}

void ServiceSession::take(const session::SessionEvent& event) {
  if (const auto* link = std::get_if<session::LinkChanged>(&event)) {
    takeLink(*link);
  } else if (const auto* seen = std::get_if<session::MachineSeen>(&event)) {
    m_seen = *seen;
  } else if (const auto* update = std::get_if<streaming::LiveUpdate>(&event)) {
    takeUpdate(*update);
  } else if (const auto* whole = std::get_if<session::JobUpdate>(&event)) {
    m_whole = *whole;
  } else if (const auto* cut = std::get_if<run::RecordingCut>(&event)) {
    m_message = cut->error.message;
    log::logger().warn(cut->error.text());
  } else if (const auto* finished = std::get_if<session::RunFinished>(&event)) {
    takeFinished(*finished);
  } else if (const auto* runs = std::get_if<session::RunsSeen>(&event)) {
    takeRuns(*runs);
  } else if (const auto* found = std::get_if<session::ResumeFound>(&event)) {
    takeResume(*found);
  } else if (const auto* ended = std::get_if<session::RunEnded>(&event)) {
    m_isEnding = false;
    m_message = ended->error.code ? ended->error.text()
                : ended->isHeld   ? "The axes of the run on the control are held."
                                  : "The program on the control has ended.";
  } else if (const auto* note = std::get_if<trace::Note>(&event)) {
    log::logger().info("{}", note->text);
  }
}

void ServiceSession::takeLink(const session::LinkChanged& link) {
  const bool wasAlarm = m_link.error.code && m_alarm == m_link.error.text();
  m_link = link;
  m_isConnecting = link.state == session::LinkState::Connecting;
  if (link.state == session::LinkState::Connected) {
    if (wasAlarm) {
      m_alarm.clear();
    }
    m_message = "Connected to the machine.";
    auto machine =
        factsOf(m_machines, m_options.machine.endpoint, link.server, link.isVirtualMachine);
    if (machine) {
      m_machine = *std::move(machine);
    } else {
      m_alarm = machine.error().text();
      m_machine.reset();
    }
    return;
  }
  m_seen.reset();
  m_shown.reset();
  m_shownResume.reset();
  m_found.reset();  // the control is asked again
  m_isAsking = m_isAsking && link.state == session::LinkState::Connecting;
  if (link.error.code) {
    const std::string text = link.error.text();
    if (m_alarm != text) {
      log::logger().warn("{}", text);
    }
    m_alarm = text;
  }
}

void ServiceSession::takeUpdate(const streaming::LiveUpdate& update) {
  // Not each update comes with a position; what was read before the run is none of it.
  std::optional<trace::LiveSample> last = std::move(m_update.sample);
  m_update = update;
  const bool hasPosition = update.sample && update.sample->positionMm;
  if (!hasPosition && last && last->positionMm && update.at - last->at <= kPositionAgeMax) {
    m_update.sample = std::move(last);
  }
  if (!m_whole) {
    m_update.counters.executed += m_pace.firstPoint;
    m_update.counters.sent += m_pace.firstPoint;
    m_update.counters.accepted += m_pace.firstPoint;
    m_update.counters.total += update.counters.total > 0 ? m_pace.firstPoint : 0;
  }
  if (update.state == streaming::RunState::Running && !m_pace.from) {
    m_pace.from.emplace(update.at, m_update.counters.executed);
  }
  if (update.margin) {
    m_margins.add(*update.margin);
  }
  if (update.wrong) {
    m_alarm = "Wrong motion: " + streaming::describe(*update.wrong) +
              ". Stop the run, then check workpiece and tool.";
  }
}

void ServiceSession::takeRuns(const session::RunsSeen& runs) {
  m_runs = runs;
}

void ServiceSession::takeResume(const session::ResumeFound& found) {
  m_isAsking = false;
  m_found = found;
}

void ServiceSession::takeFinished(const session::RunFinished& finished) {
  m_isRunning = false;
  m_isHeld = false;
  m_report = finished.report;
  m_update.state = streaming::endState(m_report->outcome);
  m_update.waitingFor.clear();
  if (m_report->counters.total > 0) {
    const std::size_t before = m_whole ? 0 : m_pace.firstPoint;
    m_update.counters = m_report->counters;
    m_update.counters.executed += before;
    m_update.counters.total += before;
  }
  m_whole.reset();
  m_isSettled = m_report->outcome != streaming::Outcome::Failed;
  m_alarm = faultOf(*m_report);
  m_message =
      fmt::format("Run {}: {} of {} points executed.", streaming::outcomeName(m_report->outcome),
                  m_update.counters.executed, m_update.counters.total);
  log::logger().info("{} {}", m_message, m_alarm);
  m_reportFile.clear();
  if (finished.notRecorded.code) {
    log::logger().warn("The run is not recorded: {}", finished.notRecorded.text());
  }
  if (finished.notKept.code) {
    log::logger().warn("The run is not in the history: {}", finished.notKept.text());
  } else if (const report::HistoryList list = m_history.list(); !list.runs.empty()) {
    // Of a whole job it is known by the number of its last stretch.
    const int number = streaming::summaryOf(*m_report, {}).runNumber;
    const auto own =
        std::find_if(list.runs.begin(), list.runs.end(), [this, number](const auto& run) {
          return run.runNumber == number && run.endpoint == m_options.machine.endpoint;
        });
    m_reportFile = own == list.runs.end() ? std::string() : m_history.reportFile(own->id).string();
  }
}

const report::SavedRun* ServiceSession::leftRun() const {
  const std::optional<report::SavedRun>& run =
      m_runs.onControl ? m_runs.onControl->saved : m_runs.left;
  const bool isServed = m_runs.onControl && m_runs.onControl->onControl.hasClient;
  return run && !isServed && !m_isRunning ? &*run : nullptr;
}

bool ServiceSession::isReleased() const {
  if (!m_job) {
    return false;
  }
  const auto releases = preparation::readReleases(preparation::releaseFileIn(m_options.state));
  return releases && permission::releaseOf(*releases, m_job->released) != nullptr;
}

std::optional<Answer> ServiceSession::refused(const Caller& caller, Act act) const {
  const auto refusal = permission::refusal(caller.standing, act);
  return refusal ? std::optional(no(refusalText(*refusal))) : std::nullopt;
}

streaming::StartFacts ServiceSession::facts(const Caller& caller, Act act,
                                            const run::JobRestart* restart) const {
  streaming::StartFacts facts;
  facts.activity = m_isRunning  ? streaming::Activity::Streaming
                   : m_isAsking ? streaming::Activity::CheckingResume
                                : streaming::Activity::Idle;
  facts.isConnected = m_link.state == session::LinkState::Connected && m_machine.has_value();
  facts.isVirtualMachine = m_link.isVirtualMachine;
  const bool mayRepeat = m_job && streaming::mayRepeat(m_job->settings.parameters.method);
  facts.refusal = permission::refusal(caller.standing, act, isReleased(), mayRepeat);
  // Nobody at a service types that old points may be executed again.
  facts.acceptsRepeats = facts.isVirtualMachine;
  facts.hasRunToResume = leftRun() != nullptr;
  if (m_seen) {
    facts.channelStatus = m_seen->channelStatus;
    facts.alarm = m_seen->alarm;
    facts.controlAxes = m_seen->rotaryAxes;
  }
  if (!m_job) {
    return facts;
  }
  facts.program = m_job->view->program.get();
  facts.hasFileChanged = m_job->hasFileChanged();
  facts.turnedAxes = m_job->view->turnedAxes;
  facts.method = m_job->settings.parameters.method;
  facts.settingsError = m_job->judged.settingsError;
  facts.verdict = m_job->judged.verdict;
  const session::Hazards* hazards = restart != nullptr ? &restart->hazards : m_job->hazards.get();
  if (hazards != nullptr) {
    facts.jobCheck = streaming::JobCheck{true, {}};
    if (const auto none = forecast::requireNoHazard(*m_job->view->plan, *hazards); !none) {
      facts.jobCheck->obstacle = none.error();
    }
  }
  return facts;
}

void ServiceSession::lookForFiles(Clock::time_point now) {
  if (!m_isRunning && now >= m_look.nextFiles) {
    m_look.files = filesIn(m_options.jobs);
    m_look.nextFiles = now + kLookInterval;
  }
}

/// Whatever is asked for, a file outside is not looked at: the answer does not say whether it
/// exists.
base::Result<std::filesystem::path> ServiceSession::pathOf(const std::string& file) const {
  std::error_code status;
  const auto folder = std::filesystem::canonical(m_options.jobs, status);
  if (status) {
    return base::fail(ServiceError::NotAJob,
                      "The folder of jobs (--jobs) cannot be read: " + status.message() + ".",
                      m_options.jobs.string());
  }
  auto path = std::filesystem::weakly_canonical(folder / file, status);
  if (status || !isBelow(folder, path)) {
    return base::fail(ServiceError::NotAJob, "Only files in the folder of jobs can be loaded.",
                      file);
  }
  return path;
}

/// Subprograms are taken from the folder of their program: a link there must not lead out either.
base::Result<void> ServiceSession::requireNoWayOut(const std::filesystem::path& program) const {
  std::error_code status;
  const auto folder = std::filesystem::canonical(m_options.jobs, status);
  for (std::filesystem::directory_iterator entry(program.parent_path(), status), end;
       !status && entry != end; entry.increment(status)) {
    std::error_code broken;
    const bool isLink = entry->is_symlink(broken);
    if (isLink && !isBelow(folder, std::filesystem::weakly_canonical(entry->path(), broken))) {
      return base::fail(ServiceError::NotAJob,
                        "This link leads out of the folder of jobs. Put a copy in its place.",
                        entry->path().filename().string());
    }
  }
  return {};
}

base::Result<LoadedJob> ServiceSession::load(const Caller& caller, const std::string& file,
                                             const std::string& settings) const {
  auto path = pathOf(file);
  if (!path) {
    return base::fail(path.error());
  }
  if (auto closed = requireNoWayOut(*path); !closed) {
    return base::fail(closed.error());
  }
  const auto settingsOf = [&](const std::string& hash) -> base::Result<JobSettings> {
    if (caller.standing.role == permission::Role::Engineer) {
      return settingsWith(defaultSettings(), settings);
    }
    // An operator gets the settings of the program's last release.
    const auto releases = preparation::readReleases(preparation::releaseFileIn(m_options.state));
    const permission::Release* last =
        releases ? permission::lastReleaseOf(*releases, hash) : nullptr;
    return settingsWith(defaultSettings(), last != nullptr ? last->job.settings : std::string());
  };
  return service::loadJob(*path, {}, settingsOf, toolMm().value_or(base::Vec3{}), *m_machine);
}

Answer ServiceSession::loadJob(const Caller& caller, const std::string& file,
                               const std::string& settings) {
  if (auto answer = refused(caller, Act::OpenProgram)) {
    return *answer;
  }
  if (!settings.empty()) {
    if (auto answer = refused(caller, Act::ChangeSettings)) {
      return *answer;
    }
  }
  streaming::Blocked blocked;
  blocked.reason = streaming::BlockReason::RunInProgress;
  if (m_isRunning) {
    return no(blockedText(blocked));
  }
  blocked.reason = streaming::BlockReason::NotConnected;
  if (m_link.state != session::LinkState::Connected || !m_machine) {
    return no("The machine cannot be reached, so the job cannot be judged. " + m_alarm);
  }
  auto job = load(caller, file, settings);
  if (!job) {
    return no(job.error());
  }
  m_job = *std::move(job);
  m_shown.reset();
  m_found.reset();
  m_question.reset();
  m_report.reset();
  m_update = {};
  m_pace.firstPoint = 0;
  m_message = fmt::format("{} is loaded.", m_job->view->program->name);
  record(caller, Act::OpenProgram,
         {{"program", m_job->view->program->name},
          {"hash", m_job->view->program->hash},
          {"settings", m_job->released.settings}});
  return yes(fmt::format(
      "{} is loaded: {} points, {}.", m_job->view->program->name, m_job->view->points.points.size(),
      m_job->view->isJob()
          ? fmt::format("a whole job of {} stretches", m_job->view->plan->stretchCount())
          : "motion alone"));
}

std::string ServiceSession::replacedText() const {
  const report::SavedRun* left = leftRun();
  return left == nullptr || left->isUntouched()
             ? std::string()
             : fmt::format(
                   "The {} {} was left and can be resumed (PreflightResume); once another one has "
                   "begun, it cannot. ",
                   left->job ? "job" : "run", left->name());
}

std::string ServiceSession::describeStart() const {
  const overview::ProgramView& view = *m_job->view;
  const auto& points = view.points.points;
  const streaming::RunSettings& settings = m_job->runSettings;
  std::string text = replacedText();
  text += fmt::format(
      "Start streams {} ({}, read from {}) to {}: {} points by method {}, {} per window. ",
      view.program->name, view.program->hash, m_job->file.string(), m_options.machine.endpoint,
      points.size(), base::methodName(settings.parameters.method),
      settings.parameters.pointsPerLoop);
  text += settings.programFeeds
              ? fmt::format(
                    "The feeds are those of the program at {:.0f} %, the largest is {:.0f} "
                    "mm/min. ",
                    100.0 * settings.programFeeds->overrideFactor,
                    base::mmPerMinFromMmPerS(settings.feedMmPerS))
              : fmt::format("The feed is {:.0f} mm/min for all moves. ",
                            base::mmPerMinFromMmPerS(settings.feedMmPerS));
  text += factorText(settings);
  if (view.program->merged) {
    text += gcode::describe(*view.program->merged) + ' ';
  } else if (m_job->settings.tolerance > 0.0) {
    text += view.isJob() ? "All points are streamed: a whole job has no tolerance. "
                         : "All points are streamed: fewer cannot be kept within the tolerance. ";
  }
  if (view.isJob()) {
    text += fmt::format("The control executes {} blocks itself. ", view.outline.needed().size());
    if (m_job->settings.dryRunMm > 0.0) {
      text += fmt::format("It is a dry run, {:.1f} mm higher. ", m_job->settings.dryRunMm);
    }
    for (const job::FunctionUse& use : view.plan->functions) {
      text += job::describe(use) + ". ";
    }
    if (!m_job->hazards) {
      text += "The job is not compared with the machine, because its limits are not known. ";
    }
  } else if (const std::size_t leftOut = view.outline.needed().size(); leftOut > 0) {
    text += fmt::format(
        "{} blocks for the control are left out: set tool, spindle and coolant at the control. ",
        leftOut);
  }
  if (const auto at = toolMm(); at && !points.empty()) {
    const base::Vec3 to = points.front().positionMm;
    text += fmt::format(
        "The tool is at X {:.3f} Y {:.3f} Z {:.3f} and first moves {:.1f} mm in a straight line to "
        "X {:.3f} Y {:.3f} Z {:.3f}.",
        at->x, at->y, at->z, base::distance(*at, to), to.x, to.y, to.z);
    const auto cut =
        !view.isJob()
            ? streaming::cutOnTheWay(*at, streaming::firstPlace(view.program->trajectory, *at),
                                     streaming::cutOf(points))
        : m_job->hazards && m_machine->known
            ? forecast::cutOnTheWay(*view.plan, *m_machine->known, {*at, {}}, m_job->cut)
            : std::nullopt;
    if (cut) {
      text += ' ' + streaming::describe(*cut);
    }
    if (settings.windowSMax > 0.0) {
      text += ' ' + streaming::describe(streaming::stopBound(points, at, settings),
                                        m_machine->feedProof, true);
    }
  }
  return text;
}

std::string ServiceSession::newConfirmation(const std::string& text) {
  return base::sha256Hex(fmt::format("{} {} {}", ++m_shownCount, utc::now(), text))
      .substr(0, kConfirmationDigits);
}

bool ServiceSession::hasToolMoved(const Shown& shown) const {
  const auto at = toolMm();
  return !at || base::distance(*at, shown.toolMm) > kStandsMm;
}

std::optional<base::Vec3> ServiceSession::toolMm() const {
  return m_seen ? m_seen->positionMm : std::nullopt;
}

Answer ServiceSession::preflight(const Caller& caller) {
  if (auto answer = refused(caller, Act::Start)) {
    return *answer;  // what somebody else was shown stays
  }
  m_shown.reset();
  const auto at = toolMm();
  if (m_job && at && m_machine && !m_isRunning) {
    m_job->place(*at, *m_machine);
  }
  if (const auto blocked = streaming::startBlocked(facts(caller, Act::Start))) {
    return no(blockedText(*blocked));
  }
  if (!at) {
    return no("The control has not been read yet. Call Preflight again in a second.");
  }
  const std::string text = describeStart();
  m_shown = Shown{newConfirmation(text), *at};
  return yes(text, m_shown->confirmation);
}

Answer ServiceSession::preflightStretch(const Caller& caller, const std::string& stretch) {
  // Where a job begins is a setting of it.
  for (const Act act : {Act::Start, Act::ChangeSettings}) {
    if (auto answer = refused(caller, act)) {
      return *answer;  // what somebody else was shown stays
    }
  }
  m_shown.reset();
  if (m_isAsking) {
    return no(kIsAsked);
  }
  if (const auto blocked = streaming::startBlocked(facts(caller, Act::Start))) {
    return no(blockedText(*blocked));
  }
  const auto number = base::parseInteger(stretch);
  if (!m_job->view->isJob() || !number || *number < 1) {
    return no(m_job->view->isJob() ? fmt::format("\"{}\" is no stretch: choose 1 to {}.", stretch,
                                                 m_job->view->plan->stretchCount())
                                   : "Only a whole job begins with a stretch. Call Preflight.");
  }
  const auto at = toolMm();
  if (!at) {
    return no("The control has not been read yet. Call PreflightStretch again in a second.");
  }
  if (!m_found || !m_question || m_question->fromStretch != *number) {
    return ask({m_job->view->program,
                m_job->runSettings,
                {},
                m_job->view->plan,
                m_machine->known,
                *number});
  }
  if (const base::Error error = m_found->error; error.code) {
    m_found.reset();  // the next call asks again
    return no(error);
  }
  if (const auto blocked = streaming::startBlocked(facts(caller, Act::Start, m_found->job.get()))) {
    return no(blockedText(*blocked));
  }
  const std::string text = describeBeginning(*m_found->job);
  m_shown = Shown{newConfirmation(text), *at, m_found->job};
  return yes(text, m_shown->confirmation);
}

Answer ServiceSession::start(const Caller& caller, const std::string& confirmation) {
  const auto restart = m_shown ? m_shown->restart : nullptr;
  if (auto answer = restart ? refused(caller, Act::ChangeSettings) : std::nullopt) {
    return *answer;
  }
  if (const auto blocked = streaming::startBlocked(facts(caller, Act::Start, restart.get()))) {
    return no(blockedText(*blocked));
  }
  if (!m_shown || confirmation != m_shown->confirmation) {
    return no(
        "Start needs the confirmation that the last Preflight has returned: call Preflight, check "
        "what it says, then start.");
  }
  if (hasToolMoved(*m_shown)) {
    m_shown.reset();
    return no("The tool has moved since the preflight. Call Preflight again.");
  }
  session::StartCommand command;
  command.settings = m_job->runSettings;
  if (m_job->view->isJob()) {
    command.plan = m_job->view->plan;
    command.dryRunMm = m_job->settings.dryRunMm;
  }
  if (restart) {
    command.plan = std::shared_ptr<const job::Plan>(restart, &restart->restart.plan);
    command.restart = restart;
    command.resumes = m_question;
  }
  m_pace.firstPoint = 0;
  return begin(caller, Act::Start, std::move(command));
}

Answer ServiceSession::begin(const Caller& caller, Act act, session::StartCommand command) {
  m_shown.reset();
  m_shownResume.reset();
  command.program = m_job->view->program;
  command.source = {m_job->file.string(), m_job->reading};
  if (command.plan) {
    command.stretchStarts = m_job->view->stretchStarts;
    command.points = m_job->view->points.points.size();
  }
  command.startedAtUtc = base::utcText(utc::now());
  std::vector<std::pair<std::string, std::string>> details{
      {"program", m_job->view->program->name},
      {"hash", m_job->view->program->hash},
      {"machine", m_options.machine.endpoint},
      {"first_point", std::to_string(m_pace.firstPoint + 1)}};
  if (command.restart) {
    details.emplace_back("stretch", std::to_string(command.restart->stretch));
  }
  record(caller, act, std::move(details));
  m_update = {};
  m_update.state = streaming::RunState::Armed;
  m_update.counters.executed = m_pace.firstPoint;
  m_update.counters.total = m_job->view->points.points.size();
  m_whole.reset();
  m_pace.lengthsMm = lengthsOf(m_job->view->points.points);
  m_pace.from.reset();
  m_margins = {};
  m_report.reset();
  m_reportFile.clear();
  m_alarm.clear();
  m_found.reset();
  m_question.reset();
  m_runs = {};
  m_isHeld = false;
  m_isSettled = false;
  m_isRunning = m_worker.post(std::move(command));
  if (!m_isRunning) {
    m_isSettled = true;
    return no("The streaming thread is busy. Try again in a second.");
  }
  m_message = act == Act::Start ? "The run has been started." : "The run is resumed.";
  return yes(m_message);
}

Answer ServiceSession::hold(const Caller& caller, bool hold) {
  if (auto answer = refused(caller, hold ? Act::Hold : Act::Continue)) {
    return *answer;
  }
  if (!m_isRunning) {
    return no("No run is in progress.");
  }
  if (!base::hasWindows(m_job->settings.parameters.method)) {
    return no("Only methods with numbered windows can be held. Stop the run instead.");
  }
  m_isHeld = hold;
  m_worker.holdRun(hold);
  record(caller, hold ? Act::Hold : Act::Continue,
         {{"point", std::to_string(m_update.counters.executed)}});
  m_message = !hold           ? "Continue requested."
              : m_update.feed ? "Hold requested: the axes stand at once, on the path."
                              : "Hold requested: the machine waits before the next window.";
  return yes(m_message);
}

Answer ServiceSession::setOverride(const Caller& caller, const std::string& percent) {
  if (auto answer = refused(caller, Act::Override)) {
    return *answer;
  }
  if (!m_isRunning) {
    return no("No run is in progress.");
  }
  if (!m_update.feed) {
    return no("The program on the control has no feed cell: turn the override at the machine.");
  }
  const double max = permission::overridePercentMax(caller.standing.role);
  const auto value = base::parseNumber(percent);
  if (!value || !(*value >= 0.0) || *value > max) {
    return no(fmt::format("\"{}\" is no override for you: choose 0 to {:g} %.", percent, max));
  }
  m_worker.overrideRun(*value);
  record(caller, Act::Override,
         {{"percent", percent}, {"point", std::to_string(m_update.counters.executed)}});
  m_message = fmt::format("Override of {:g} % requested.", *value);
  return yes(m_message);
}

Answer ServiceSession::stop(const Caller& caller) {
  if (!m_isRunning && m_runs.onControl && !m_isEnding) {
    m_isEnding = m_worker.post(session::EndRunCommand{m_runs.onControl->onControl, true});
    record(caller, Act::Stop, {{"run", std::to_string(m_runs.onControl->onControl.number)}});
    return m_isEnding ? yes("Stop requested: the axes of the run on the control are held. With "
                            "EndRun it goes on to its end.")
                      : no("The streaming thread is busy. Try again in a second.");
  }
  if (!m_isRunning) {
    return no("No run is in progress.");
  }
  m_worker.stopRun(false);
  record(caller, Act::Stop, {{"point", std::to_string(m_update.counters.executed)}});
  m_message = "Stop requested.";
  return yes(
      m_update.feed
          ? "Stop requested: the axes stand at once, on the path. After Resume the rest of the "
            "window in motion is executed, then the run ends."
          : "Stop requested: the axes stand at the end of the window in motion.");
}

void ServiceSession::endForGood() {
  m_endsForGood = true;
  m_worker.leaveRun();
}

/// With the answer of the control.
std::string ServiceSession::describeResume(const report::SavedRun& run) const {
  std::string text =
      fmt::format("ResumeRun goes on with run {} of {}", run.checkpoint.runNumber, run.programName);
  if (m_found->resume) {
    text += fmt::format(" at point {} of {}.", m_found->resume->point + 1,
                        m_job->view->points.points.size());
    if (m_found->resume->changedFrom) {
      text += fmt::format(
          " From point {} on, the program differs from that of the interrupted run; none of these "
          "points has been executed.",
          *m_found->resume->changedFrom + 1);
    }
  } else {
    text += beginningOf(*m_found->job, m_job->view->plan->stretchCount());
  }
  const auto& restMm = m_found->resume ? m_found->resume->restMm : m_found->job->restMm;
  if (const std::string rest = run::restText(restMm); !rest.empty()) {
    text = rest + " " + text;
  }
  return factorText(m_job->runSettings) + text;
}

std::string ServiceSession::describeBeginning(const run::JobRestart& restart) const {
  return replacedText() + factorText(m_job->runSettings) +
         fmt::format("Start begins {} ({}, read from {}) on {}", m_job->view->program->name,
                     m_job->view->program->hash, m_job->file.string(), m_options.machine.endpoint) +
         beginningOf(restart, m_job->view->plan->stretchCount());
}

Answer ServiceSession::ask(session::ResumeQuestion question) {
  m_question = std::move(question);
  m_found.reset();
  m_shown.reset();  // what was shown belongs to the question before
  m_shownResume.reset();
  m_isAsking = m_worker.post(*m_question);
  return no(kIsAsked);
}

Answer ServiceSession::preflightResume(const Caller& caller) {
  const report::SavedRun* run = leftRun();
  if (m_isAsking) {
    return no(kIsAsked);
  }
  if (run == nullptr) {
    streaming::Blocked blocked;
    blocked.reason = streaming::BlockReason::NothingToResume;
    return no(m_isRunning ? "A run is in progress." : blockedText(blocked));
  }
  if (auto answer = refused(caller, Act::OpenProgram)) {
    return *answer;
  }
  if (m_link.state != session::LinkState::Connected || !m_machine || !toolMm()) {
    return no("The machine cannot be reached. " + m_alarm);
  }
  if (m_runs.onControl && !m_runs.isClientKnown) {
    return no(
        "Whether the run on the control still has a client is being watched. Call "
        "again in a second.");
  }
  const bool isAnswered =
      m_found && m_question && m_question->checkpoint.runNumber == run->checkpoint.runNumber;
  if (!isAnswered) {
    auto loaded = service::loadJob(
        run->programFile, run->reading,
        [run, this](const std::string&) -> base::Result<JobSettings> {
          JobSettings settings{preparation::settingsOfRun(run->settings, defaultSettings().run),
                               run->reading};
          settings.run.wholeJob = m_runs.isJob;
          settings.moveRules = run->reading.moveRules;
          return settings;
        },
        run->checkpoint.startMm, *m_machine);
    if (!loaded) {
      return no(loaded.error());
    }
    m_job = *std::move(loaded);
    m_shown.reset();
    if (const auto blocked = streaming::resumeBlocked(facts(caller, Act::Resume))) {
      return no(blockedText(*blocked));
    }
    session::ResumeQuestion question{m_job->view->program, run->settings, run->checkpoint};
    if (m_job->view->isJob()) {
      question.plan = m_job->view->plan;
      question.machine = m_machine->known;
      question.job = run->job;
    }
    return ask(std::move(question));
  }
  if (m_found->error.code) {
    const base::Error error = m_found->error;
    m_found.reset();  // the next call asks again
    return no(error);
  }
  if (const auto blocked =
          streaming::resumeBlocked(facts(caller, Act::Resume, m_found->job.get()))) {
    return no(blockedText(*blocked));
  }
  const std::string text = describeResume(*run);
  m_shownResume = Shown{newConfirmation(text), *toolMm()};
  return yes(text, m_shownResume->confirmation);
}

Answer ServiceSession::resumeRun(const Caller& caller, const std::string& confirmation) {
  if (const auto blocked = streaming::resumeBlocked(
          facts(caller, Act::Resume, m_found ? m_found->job.get() : nullptr))) {
    return no(blockedText(*blocked));
  }
  if (!m_shownResume || confirmation != m_shownResume->confirmation || !m_found || !m_question) {
    return no(
        "ResumeRun needs the confirmation that the last PreflightResume has returned: call "
        "PreflightResume, check what it says, then resume.");
  }
  if (hasToolMoved(*m_shownResume)) {
    m_shownResume.reset();
    m_found.reset();  // the control is asked again
    return no("The tool has moved since the preflight. Call PreflightResume again.");
  }
  session::StartCommand command;
  command.settings = m_job->runSettings;
  command.resumes = m_question;
  if (m_found->job) {
    command.plan = std::shared_ptr<const job::Plan>(m_found->job, &m_found->job->restart.plan);
    command.restart = m_found->job;
    m_pace.firstPoint = 0;
  } else {
    command.settings.resume = m_found->resume;
    m_pace.firstPoint = m_found->resume->point;
  }
  return begin(caller, Act::Resume, std::move(command));
}

Answer ServiceSession::forgetRun(const Caller& caller) {
  if (auto answer = refused(caller, Act::Resume)) {
    return *answer;
  }
  const report::SavedRun* run = leftRun();
  if (run == nullptr || m_isAsking) {
    return no("No run was left that could be forgotten.");
  }
  if (m_runs.onControl) {
    return no("The program of this run still waits on the control. Call EndRun first.");
  }
  const report::RunStore store(m_runs.isJob ? report::RunStore::folderOfJobs()
                                            : report::RunStore::folderOfUser());
  store.remove(*run);
  m_message = fmt::format("The run {} is forgotten.", run->name());
  m_runs.left.reset();
  m_shownResume.reset();
  m_found.reset();
  m_question.reset();
  return yes(m_message);
}

Answer ServiceSession::endRun(const Caller& caller) {
  if (m_isRunning) {
    return no("A run of this service is in progress. Use Stop.");
  }
  if (!m_runs.onControl || m_isEnding) {
    return no("No program of Rivulet is active on the control.");
  }
  m_isEnding = m_worker.post(session::EndRunCommand{m_runs.onControl->onControl, false});
  record(caller, Act::Stop, {{"run", std::to_string(m_runs.onControl->onControl.number)}});
  return m_isEnding ? yes("The program on the control is told to end.")
                    : no("The streaming thread is busy. Try again in a second.");
}

void ServiceSession::record(const Caller& caller, Act act,
                            std::vector<std::pair<std::string, std::string>> details) {
  journal::AuditEntry entry;
  entry.at = utc::now();
  entry.who = caller.name;
  entry.role = caller.hasRole ? std::string(permission::roleName(caller.standing.role)) : "";
  entry.act = permission::actName(act);
  details.emplace_back("by", "service");
  entry.details = std::move(details);
  const auto written = journal::appendAudit(journal::auditFileIn(m_options.state), entry);
  if (!written) {
    log::logger().error("{}", written.error().text());
  }
}

void ServiceSession::noteLogin(const Caller& caller) {
  record(caller, Act::LogIn, {});
}

void ServiceSession::noteFailedLogin(const machine::LoginFailure& failure) {
  Caller caller;
  caller.name = failure.user;
  std::vector<std::pair<std::string, std::string>> details{
      {"from", failure.network}, {"in_a_row", std::to_string(failure.wrong)}};
  if (failure.lockedFor > base::Duration::zero()) {
    details.emplace_back("locked_for_s", fmt::format("{:.0f}", base::toSeconds(failure.lockedFor)));
  }
  record(caller, Act::LogInFailed, std::move(details));
}

std::string ServiceSession::stateName() const {
  if (m_isRunning) {
    return std::string(streaming::runStateName(m_update.state));
  }
  if (m_link.state != session::LinkState::Connected) {
    return m_isConnecting && !m_link.error.code ? "connecting" : "disconnected";
  }
  if (leftRun() != nullptr) {
    return "left";
  }
  return m_job ? "loaded" : "idle";
}

double ServiceSession::timeLeftS() const {
  const std::size_t done = m_update.counters.executed;
  if (!m_isRunning || !m_pace.from || done <= m_pace.from->second ||
      done >= m_pace.lengthsMm.size()) {
    return -1.0;
  }
  const double doneMm = m_pace.lengthsMm[done] - m_pace.lengthsMm[m_pace.from->second];
  const double leftMm = m_pace.lengthsMm.back() - m_pace.lengthsMm[done];
  return doneMm > 0.0 ? base::toSeconds(m_update.at - m_pace.from->first) * leftMm / doneMm : -1.0;
}

Snapshot ServiceSession::snapshot() const {
  Snapshot seen;
  seen.machine = m_options.machine.endpoint;
  if (m_machine) {
    seen.model = m_machine->server.productName + " " + m_machine->server.buildNumber;
  }
  seen.isConnected = m_link.state == session::LinkState::Connected;
  seen.isRunning = m_isRunning;
  seen.state = stateName();
  seen.files = m_look.files;
  seen.waitingFor = !m_isRunning                             ? std::string()
                    : m_whole && m_whole->waitsForCycleStart ? "cycle-start"
                                                             : m_update.waitingFor;
  const streaming::RunState run = m_update.state;
  seen.programState = !m_isRunning && !m_report             ? "Initializing"
                      : run == streaming::RunState::Done    ? "Ended"
                      : run == streaming::RunState::Aborted ? "Aborted"
                      : run == streaming::RunState::Holding || run == streaming::RunState::Stopped
                          ? "Interrupted"
                      : run == streaming::RunState::Armed ? "Initializing"
                                                          : "Running";
  seen.itemState = !seen.isConnected ? "NotAvailable" : m_isRunning ? "Executing" : "NotExecuting";
  if (m_job) {
    seen.program = m_job->view->program->name;
    seen.file = m_job->file.string();
    seen.hash = m_job->view->program->hash;
    seen.settings = m_job->released.settings;
    seen.points = static_cast<std::uint32_t>(m_job->view->points.points.size());
    seen.stretches =
        m_job->view->isJob() ? static_cast<std::uint32_t>(m_job->view->plan->stretchCount()) : 0;
  }
  seen.stretch = m_whole ? static_cast<std::uint32_t>(std::max(0, m_whole->stretch)) : 0;
  if (m_isRunning && m_update.feed) {
    seen.overridePercent = m_update.feed->actsPercent.value_or(-1.0);
    if (const auto& source = m_update.feed->source) {
      seen.feedFactor = m_update.feed->factor;
      seen.feedSource = source->source + ": " + (source->why.empty() ? "followed." : source->why);
    }
    seen.stands = m_update.feed->holds && m_update.feed->stoodAfter && !m_update.feed->isIgnored;
  }
  seen.pointsDone = static_cast<std::uint32_t>(m_update.counters.executed);
  seen.progressPercent =
      seen.points > 0 ? 100.0 * std::min(1.0, static_cast<double>(seen.pointsDone) / seen.points)
                      : 0.0;
  seen.timeLeftS = timeLeftS();
  seen.lateWindows = static_cast<std::uint32_t>(m_margins.lateWindows());
  seen.leastMarginS = base::toSeconds(m_margins.least());
  if (m_isRunning && m_update.at > base::Instant{}) {
    if (m_update.sample && m_update.sample->positionMm) {
      const base::Vec3 at = *m_update.sample->positionMm;
      seen.positionMm = {at.x, at.y, at.z};
    }
  } else if (const auto at = toolMm()) {
    seen.positionMm = {at->x, at->y, at->z};
  }
  if (const report::SavedRun* left = leftRun()) {
    seen.canResume = true;
    seen.leftRun = left->name();
  }
  seen.alarm = m_alarm;
  if (seen.alarm.empty() && m_seen && m_seen->alarm.value_or(0) != 0) {
    seen.alarm = streaming::describeControlAlarm(std::to_string(*m_seen->alarm));
  }
  seen.message = m_message;
  if (m_report) {
    seen.outcome = streaming::outcomeName(m_report->outcome);
    seen.runNumber = static_cast<std::uint32_t>(std::max(0, m_report->settings.runNumber));
  }
  seen.report = m_reportFile;
  return seen;
}

}  // namespace rivulet::service
