// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/run_controller.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <span>

#include "base/text.h"
#include "gcode/nearest_move.h"
#include "hmi/hazard_text.h"
#include "job/main_program.h"
#include "live/setup.h"
#include "report/run_history.h"
#include "run/factor_feed.h"
#include "streaming/start/first_move.h"
#include "templates/target.h"
#include "widgets/common/blocked_text.h"
#include "widgets/common/error_text.h"
#include "widgets/common/note_text.h"
#include "widgets/common/number_format.h"
#include "widgets/runs/run_texts.h"
#include "widgets/streaming/report_panel.h"

namespace rivulet::hmi {

using gcode::Severity;
using permission::Act;
using Source = Messages::Source;
using session::StreamSession;

namespace {

/// Look-ahead rounds corners by less.
constexpr double kOnPathMm = 1.0;
/// No method lets the control know more points ahead.
constexpr std::size_t kMovesAheadMax = 1000;

/// A correction moves the path by an amount that the axes have not yet, or no longer, followed.
bool isCorrected(const streaming::LiveUpdate& update) {
  return update.correction && !(update.correction->confirmedMm == base::Vec3{});
}

/// The first of the moves [begin, end) that the tool can be on: of a way there and back, or of
/// crossing ways, farther ones say nothing. @param from  where the first of them begins
std::optional<std::size_t> moveAt(std::span<const gcode::StreamPoint> points, std::size_t begin,
                                  std::size_t end, const gcode::StreamPoint& from,
                                  base::Vec3 positionMm) {
  const std::array<gcode::StreamPoint, 2> first{from, points[begin]};
  std::optional<std::size_t> found;
  double leastMm = kOnPathMm;
  for (std::size_t i = begin; i < end; ++i) {
    const double offMm = (i == begin ? gcode::nearestMove(first, 1, 2, positionMm)
                                     : gcode::nearestMove(points, i, i + 1, positionMm))
                             .distanceMm;
    if (found && offMm >= leastMm) {
      break;
    }
    if (offMm <= leastMm) {
      found = i;
      leastMm = offMm;
    }
  }
  return found;
}

streaming::Counters inProgram(streaming::Counters counters, std::size_t firstPoint) {
  if (counters.total > 0) {
    counters.sent += firstPoint;
    counters.accepted += firstPoint;
    counters.executed += firstPoint;
    counters.total += firstPoint;
  }
  return counters;
}

}  // namespace

RunController::RunController(StreamSession& session, Document& document, MachineModel& machine,
                             Messages& messages)
    : m_session(session), m_document(document), m_machine(machine), m_messages(messages) {
  connect(&m_session, &StreamSession::updateArrived, this, &RunController::takeUpdate);
  connect(&m_session, &StreamSession::jobUpdated, this, &RunController::takeJob);
  connect(&m_session, &StreamSession::livePointsArrived, this,
          [this](const session::LivePoints& points) { m_document.appendLive(points); });
  connect(&m_session, &StreamSession::recordingCut, this, &RunController::raiseCut);
  connect(&m_session, &StreamSession::runFinished, this, &RunController::takeFinished);
  connect(&m_session, &StreamSession::resumeFound, this, &RunController::takeResume);
  connect(&m_session, &StreamSession::runEnded, this, &RunController::takeEnded);
  connect(&m_session, &StreamSession::calibrationProgressed, this,
          [this](const streaming::CalibrationProgress& progress) {
            if (isCalibrating()) {
              Q_EMIT calibrationProgressed(progress);
            }
          });
  connect(&m_session, &StreamSession::noteArrived, this, [this](const trace::Note& note) {
    if (note.text == streaming::kStopNote || note.text == streaming::kHoldNote ||
        note.text == streaming::kContinueNote) {
      return;  // said when the button was pressed, in the operator's language
    }
    if (note.text.starts_with(streaming::kFactorNote)) {
      return;  // shown as it changes
    }
    m_messages.log(Severity::Note, Source::Run,
                   [text = QString::fromStdString(note.text)] { return widgets::noteText(text); });
  });
  connect(&m_machine, &MachineModel::linkChanged, this, [this] {
    if (m_machine.isConnected()) {  // until another is: a lost connection changes no program
      m_document.setTarget(templates::targetOf(m_machine.link().server.applicationUri));
    }
    Q_EMIT permissionsChanged();
  });
  connect(&m_machine, &MachineModel::calibrationEnded, this, &RunController::permissionsChanged);
  connect(&m_machine, &MachineModel::calibrationChanged, this, [this] {
    m_document.setCalibration(m_machine.calibration(), m_machine.isCalibrationOutdated());
  });
  connect(&m_machine, &MachineModel::seen, this, [this](bool isNews) {
    if (const auto& positionMm = m_machine.view().positionMm) {
      m_document.setToolPosition(*positionMm);
    }
    if (isNews) {
      Q_EMIT permissionsChanged();
    }
  });
  connect(&m_document, &Document::judged, this, &RunController::permissionsChanged);
  connect(&m_document, &Document::fileStateChanged, this, &RunController::permissionsChanged);
  connect(&m_document, &Document::programLoaded, this, [this] {
    // The points of another program are not those of the run that was left.
    m_left.reset();
    m_update = {};
    m_runBegin = 0;
    forgetResume();
  });
}

streaming::StartFacts RunController::facts(Act act) const {
  const Findings& findings = m_document.findings();
  const widgets::MachineView& machine = m_machine.view();
  streaming::StartFacts facts;
  facts.activity = m_session.isRunning()         ? streaming::Activity::Streaming
                   : m_session.isAsking()        ? streaming::Activity::CheckingResume
                   : m_session.isCalibrating()   ? streaming::Activity::Calibrating
                   : m_session.isCommissioning() ? streaming::Activity::Commissioning
                                                 : streaming::Activity::Idle;
  facts.isConnected = m_machine.isConnected();
  facts.isVirtualMachine = machine.isVirtualMachine;
  facts.program = m_document.program().get();
  facts.hasFileChanged = m_document.hasFileChanged();
  if (const auto& live = m_document.live()) {
    facts.live = streaming::LiveFacts{live->obstacle};
    facts.turnedAxes = live->setup.rotaryAxes;
  } else if (m_document.view()) {
    facts.turnedAxes = m_document.view()->turnedAxes;
  }
  facts.method = m_document.settings().parameters.method;
  facts.settingsError = findings.settingsError;
  facts.verdict = findings.verdict;
  facts.rehearsed = findings.rehearsed;
  facts.jobCheck = jobCheck(act);
  facts.channelStatus = machine.channelStatus;
  facts.alarm = machine.alarmNumber;
  facts.controlAxes = machine.rotaryAxes;
  facts.hasRunToResume = m_left || m_question;
  facts.acceptsRepeats = true;  // `Preflight` asks for it
  facts.refusal = refusal(act);
  return facts;
}

std::optional<streaming::JobCheck> RunController::jobCheck(Act act) const {
  if (const job::NativeBlock* const untried =
          m_document.isJob() ? m_document.jobRelease().firstUntried(*m_document.view()->plan)
                             : nullptr) {
    return streaming::JobCheck{
        true, base::makeError(job::JobError::BeyondMachine,
                              tr("Line %1: \"%2\" has not been tried on this machine. Test it on "
                                 "the page Job test, or run the motion only.")
                                  .arg(untried->place.line.value)
                                  .arg(QString::fromStdString(untried->text))
                                  .toStdString())};
  }
  const Findings& findings = m_document.findings();
  const bool isRestart = act == Act::Resume && m_restart;
  if (!isRestart && !findings.isJobChecked) {
    return std::nullopt;
  }
  streaming::JobCheck check{isRestart || findings.hazards != nullptr, {}};
  if (check.isDone) {
    const QString why = hazardsText(isRestart ? m_restart->hazards : *findings.hazards, true);
    if (!why.isEmpty()) {
      check.obstacle = base::makeError(job::JobError::BeyondMachine,
                                       why.section(QLatin1Char('\n'), 0, 0).toStdString());
    }
  }
  return check;
}

std::optional<streaming::Blocked> RunController::startBlocked() const {
  return streaming::startBlocked(facts(Act::Start));
}

std::optional<streaming::Blocked> RunController::resumeBlocked() const {
  return streaming::resumeBlocked(facts(Act::Resume));
}

std::optional<streaming::Blocked> RunController::calibrationBlocked() const {
  return streaming::calibrationBlocked(facts(Act::Calibrate));
}

bool RunController::hasRunToResume() const {
  return m_left && base::hasWindows(m_document.settings().parameters.method);
}

bool RunController::canHold() const {
  return base::hasWindows(m_document.settings().parameters.method) && !refusal(Act::Hold);
}

bool RunController::canChangeSettings() const {
  return !isRunning() && !refusal(Act::ChangeSettings);
}

void RunController::correct(const base::Vec3& valueMm) {
  if (!refusal(Act::Correct)) {
    m_session.correct(valueMm);
    Q_EMIT corrected(valueMm);
  }
}

bool RunController::refuses(const std::optional<streaming::Blocked>& blocked) {
  if (blocked) {
    m_messages.show(Severity::Warning, [blocked] { return widgets::blockedText(blocked); });
  }
  return blocked.has_value();
}

bool RunController::start() {
  return !refuses(startBlocked()) && startRun(std::nullopt);
}

void RunController::stop() {
  if (!m_session.isRunning()) {
    m_messages.didAct(Act::Stop, {{"machine", m_machine.endpoint().toStdString()}});
    if (m_session.isCommissioning()) {
      m_session.stop();
      m_messages.show(Severity::Error, [] {
        return tr(
            "The test of the control is aborted. If an axis still moves, press NC STOP at "
            "the machine.");
      });
      return;
    }
    if (m_session.isCalibrating()) {
      m_session.stop();  // the reset would wait for its end
    }
    if (m_machine.isConnected() && m_session.endRun(std::nullopt, true)) {
      m_messages.show(Severity::Warning, [] {
        return tr(
            "A reset of the control was requested. If an axis still moves, press NC STOP at the "
            "machine.");
      });
    } else {
      sayCannotStop();
    }
    return;
  }
  // Also while the rest of a window is executed, behind an end.
  const bool canHold = m_update.feed && m_update.state != streaming::RunState::Armed;
  if (!canHold) {
    end();
  } else if (!m_isHeld) {
    m_isHeld = true;
    m_session.hold(true);
    m_messages.didAct(Act::Stop, {{"point", std::to_string(m_update.counters.executed)}});
    m_messages.log(Severity::Note, Source::Run,
                   [] { return tr("Stop: the axes are held on the path."); });
  }
}

void RunController::sayCannotStop() {
  m_messages.show(Severity::Error, [] {
    return tr("Rivulet cannot stop what the control executes now. Press NC STOP at the machine.");
  });
}

void RunController::takeEnded(const session::RunEnded& ended) {
  if (!ended.byReset) {
    return;  // see `FoundRuns`
  }
  if (!ended.confirmedAfter) {
    m_messages.log(Severity::Error, Source::Control,
                   [error = ended.error] { return widgets::errorText(error); });
    sayCannotStop();
    return;
  }
  m_messages.show(Severity::Note, [seconds = base::toSeconds(*ended.confirmedAfter)] {
    return tr("The control was reset: its program has ended after %1.")
        .arg(widgets::secondsText(seconds, 2));
  });
}

void RunController::leave() {
  m_session.leave();
  noteEnd();
}

void RunController::noteEnd() {
  if (!std::exchange(m_isEnding, true)) {
    m_messages.didAct(Act::Stop, {{"point", std::to_string(m_update.counters.executed)}});
    m_messages.log(Severity::Note, Source::Run, [] { return tr("Stop requested."); });
  }
}

void RunController::end() {
  m_session.stop();
  noteEnd();
  m_isHeld = false;
  m_session.hold(false);
}

void RunController::setOverride(double percent) {
  if (!refusal(Act::Override)) {
    m_session.setOverride(percent);
    m_messages.didAct(Act::Override, {{"percent", std::to_string(static_cast<int>(percent))}});
  }
}

void RunController::lift(double mm) {
  if (refusal(Act::Hold)) {
    return;
  }
  m_session.lift(mm);
  m_messages.didAct(Act::Hold, {{"lift_mm", base::formatNumber(mm)}});
  m_messages.log(Severity::Note, Source::Run, [mm] {
    return mm > 0.0 ? tr("The tool is to be lifted by %1.").arg(widgets::lengthText(mm, 3))
                    : tr("The tool is to be lowered.");
  });
}

void RunController::hold(bool hold) {
  if (refusal(Act::Hold)) {
    return;
  }
  m_isHeld = hold;
  m_session.hold(hold);
  m_messages.didAct(hold ? Act::Hold : Act::Continue,
                    {{"point", std::to_string(m_update.counters.executed)}});
  m_messages.log(Severity::Note, Source::Run,
                 [hold] { return hold ? tr("Pause requested.") : tr("Continue requested."); });
}

void RunController::calibrate(const streaming::CalibrationPlan& plan) {
  if (refuses(calibrationBlocked())) {
    return;
  }
  m_messages.clear();
  m_session.calibrate(plan);
  m_messages.didAct(Act::Calibrate, {{"machine", m_machine.endpoint().toStdString()},
                                     {"cells", std::to_string(plan.firstCell) + " to " +
                                                   std::to_string(plan.lastCell)}});
  Q_EMIT calibrationProgressed({});
  m_messages.log(Severity::Note, Source::Control,
                 [first = QString::number(plan.firstCell), last = QString::number(plan.lastCell)] {
                   return tr("Calibration on R%1 to R%2 started.").arg(first, last);
                 });
  Q_EMIT permissionsChanged();
}

void RunController::askResume() {
  if (refuses(resumeBlocked())) {
    return;
  }
  ask(*m_left);
}

void RunController::ask(session::ResumeQuestion question) {
  forgetResume();
  m_question = std::move(question);
  Q_EMIT resumeAsked();
  m_session.askResume(*m_question);
  Q_EMIT permissionsChanged();
}

bool RunController::askFromStretch(int stretch) {
  if (!m_document.isJob() || refuses(startBlocked())) {
    return false;
  }
  if (refusal(Act::ChangeSettings)) {
    return !refuses(streaming::Blocked{streaming::BlockReason::NeedsEngineer, {}, {}});
  }
  ask({m_document.program(),
       m_document.runSettings(),
       {},
       m_document.view()->plan,
       m_document.jobMachine(),
       stretch});
  return true;
}

widgets::ResumePlace RunController::placeOf(const run::JobRestart& restart) const {
  widgets::ResumePlace place;
  place.isJob = true;
  place.stretch = restart.stretch;
  place.steps = restart.restart.steps;
  place.notRestored = restart.restart.notRestored;
  place.restMm = restart.restMm;
  const auto& points = m_document.points();
  const auto& starts = m_document.view()->stretchStarts;
  place.points = points.size();
  place.point = restart.stretch == 0 ? points.size()
                                     : starts.at(static_cast<std::size_t>(restart.stretch) - 1) +
                                           (restart.resume ? restart.resume->point : 0);
  if (place.point < points.size()) {
    place.line = points[place.point].line;
    place.positionMm = points[place.point].positionMm;
  }
  // After the steps, blocks of the control may come first.
  for (const job::Part& part : restart.restart.plan.parts) {
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    if (native == nullptr && std::get<job::Stretch>(part).number > 0) {
      break;
    }
    if (native != nullptr && !native->isInserted) {
      place.block = native->source;
      place.line = native->place.line;
      break;
    }
  }
  return place;
}

QString RunController::jobRefusal(bool isMachineKnown, int chosen) {
  return !isMachineKnown
             ? tr("The tools and offsets of this machine are not known, so the state in which the "
                  "job goes on cannot be computed. Start from the beginning.")
         : chosen == 1
             ? tr("The state before the first part is not known: only the control knows what an "
                  "earlier block does. Start from the beginning.")
         : chosen > 1
             ? tr("The state before this part is not known: only the control knows what an "
                  "earlier block does. Choose an earlier part, or start from the beginning.")
             : tr("It is not known for certain where the job was left. Press Start, then Begin "
                  "with a part, or start from the beginning.");
}

void RunController::takeResume(const session::ResumeFound& found) {
  if (!m_question) {
    forgetResume();
    return;
  }
  if (found.job) {
    m_restart = found.job;
    m_place = placeOf(*found.job);
    Q_EMIT placeFound(*m_place);
    Q_EMIT permissionsChanged();
    return;
  }
  if (!found.resume) {
    const bool isJob = m_question->plan && found.error.code == streaming::StreamError::CannotResume;
    refuseResume([error = found.error, isJob, isMachineKnown = m_question->machine != nullptr,
                  chosen = m_question->fromStretch] {
      return isJob ? jobRefusal(isMachineKnown, chosen) : widgets::errorText(error);
    });
    return;
  }
  // The list of the run that was left: open coordinates as they were then.
  const auto list =
      gcode::streamPoints(m_question->program->trajectory, found.resume->startMm).points;
  m_resume = found.resume;
  widgets::ResumePlace place;
  place.point = m_resume->point;
  place.points = list.size();
  place.line = list.at(m_resume->point).line;
  place.positionMm = list[m_resume->point].positionMm;
  place.changedFrom = m_resume->changedFrom;
  place.restMm = m_resume->restMm;
  const auto toolMm = m_machine.positionNowMm();
  if (place.restMm.value_or(0.0) > 0.0) {
    place.approachMm = base::distance(list.at(m_resume->point - 1).positionMm, place.positionMm);
  } else if (toolMm) {
    place.approachMm = base::distance(*toolMm, place.positionMm);
  }
  m_place = place;
  Q_EMIT placeFound(place);
  m_messages.log(Severity::Note, Source::Run, [place] {
    return tr("The run was left before point %1 of %2.")
        .arg(widgets::countText(place.point + 1), widgets::countText(place.points));
  });
  Q_EMIT permissionsChanged();
}

void RunController::offerStartAtLine(std::size_t line) {
  const auto& points = m_document.points();
  if (isRunning() || !m_document.view() || m_document.live()) {
    return;
  }
  if (m_document.isJob()) {
    // What the control executes before the line must not be left out without a word.
    m_messages.show(Severity::Warning, [] {
      return tr(
          "A whole job begins at its beginning, or with a part: press Start, then Begin with a "
          "part. To begin at this line, choose Motion only in the settings, and set tool, spindle "
          "and coolant yourself.");
    });
    return;
  }
  const auto found = std::find_if(points.begin(), points.end(),
                                  [line](const auto& point) { return point.line.value >= line; });
  if (found == points.end()) {
    m_messages.show(Severity::Warning, [line] {
      return tr("Line %1 and those after it move nothing. Choose an earlier line.")
          .arg(widgets::countText(line));
    });
    return;
  }
  forgetResume();
  // The tool goes to where the path of the line begins, so that all of it is executed.
  const auto moved = static_cast<std::size_t>(found - points.begin());
  const std::size_t first = moved > 0 ? moved - 1 : 0;
  m_resume = streaming::Resume{first, m_document.view()->startMm, {}, std::nullopt};
  m_document.setHeld(true);  // the points are those of this list
  widgets::ResumePlace place;
  place.isChosen = true;
  place.point = first;
  place.points = points.size();
  place.line = found->line;
  place.positionMm = points[first].positionMm;
  place.feedMmPerS = m_document.commandedMmPerS(first);
  place.isRapid = points[first].kind == gcode::MoveKind::Rapid;
  if (const auto toolMm = m_machine.positionNowMm()) {
    place.approachMm = base::distance(*toolMm, place.positionMm);
  }
  m_place = place;
  Q_EMIT placeFound(place);
  Q_EMIT permissionsChanged();
}

std::optional<streaming::Blocked> RunController::placeBlocked() const {
  if (!m_place || !m_place->isChosen) {
    return resumeBlocked();
  }
  if (auto blocked = startBlocked()) {
    return blocked;
  }
  return base::hasWindows(m_document.settings().parameters.method)
             ? std::nullopt
             : std::optional(
                   streaming::Blocked{streaming::BlockReason::MethodCannotResume, {}, {}});
}

void RunController::adopt(session::ResumeQuestion run) {
  m_left = std::move(run);
  holdPoints();
  Q_EMIT permissionsChanged();
}

void RunController::holdPoints() {
  m_document.setHeld(m_left && !m_left->plan);
}

void RunController::refuseResume(const Messages::Text& why) {
  m_question.reset();
  m_messages.log(Severity::Warning, Source::Run, why);
  Q_EMIT resumeRefused(why());
  Q_EMIT permissionsChanged();
}

void RunController::forgetResume() {
  m_resume.reset();
  m_restart.reset();
  m_question.reset();
  m_place.reset();
  holdPoints();
  Q_EMIT resumeForgotten();
  Q_EMIT permissionsChanged();
}

bool RunController::resume() {
  if (!m_resume && !m_restart) {
    m_messages.show(Severity::Warning, [] {
      return tr("Press Resume first: it asks the control where the run was left.");
    });
    return false;
  }
  return !refuses(placeBlocked()) && startRun(m_resume, m_restart);
}

bool RunController::startRun(std::optional<streaming::Resume> resume,
                             std::shared_ptr<const run::JobRestart> restart) {
  streaming::RunSettings settings = m_document.runSettings();
  settings.resume = resume;
  m_firstPoint = resume ? resume->point : 0;
  const bool isChosen = m_place && m_place->isChosen;
  if (isChosen || !resume) {
    m_runBegin = m_firstPoint;
  }
  const std::size_t shownFrom = restart ? placeOf(*restart).point : m_firstPoint;
  const std::optional<session::ResumeQuestion> question = m_question;
  forgetResume();
  if (!resume && !restart) {
    m_document.placePoints();
  }
  forgetLast();
  m_startMm = m_machine.view().positionMm;
  announceStart(settings, restart.get(), isChosen);
  ActDetails details{{"program", m_document.program()->name},
                     {"hash", m_document.program()->hash},
                     {"machine", m_machine.endpoint().toStdString()},
                     {"first_point", std::to_string(shownFrom + 1)}};
  session::StartCommand command;
  if (const auto& live = m_document.live()) {
    details.emplace_back("agreed", live::textOf(live->setup));
    command.live = live->setup;
    m_document.beginLivePath();
  }
  if (const auto agreed = run::agreedFactor(settings)) {
    details.emplace_back("feed_from", settings.factor.address + ": " + live::textOf(*agreed));
  }
  if (!m_confirmed.empty()) {
    details.emplace_back("confirmed", std::exchange(m_confirmed, {}));
  }
  m_messages.didAct((resume && !isChosen) || restart ? Act::Resume : Act::Start, details);
  command.program = m_document.program();
  command.source = m_document.source();
  command.settings = settings;
  if (m_document.isJob()) {
    command.plan = restart ? std::shared_ptr<const job::Plan>(restart, &restart->restart.plan)
                           : m_document.view()->plan;
    command.restart = restart;
    command.dryRunMm = m_document.dryRunMm();
    command.stretchStarts = m_document.view()->stretchStarts;
    command.points = m_document.points().size();
  }
  if ((resume && !isChosen) || restart) {
    command.resumes = question;
  }
  m_plan = command.plan;
  m_session.start(std::move(command));
  m_document.setRunning(m_session.isRunning());
  Q_EMIT started(shownFrom);
  Q_EMIT permissionsChanged();
  return true;
}

void RunController::forgetLast() {
  m_report.reset();
  m_update.feed.reset();
  m_isHeld = m_isEnding = false;
  m_firstMotion.reset();
  forgetMove();
  m_wrong.reset();
  m_hasWrongMotion = false;
  Q_EMIT wrongMotionChanged();
  m_messages.clear();
  for (const alarm::Code code :
       {alarm::Code::RunFailed, alarm::Code::WrongMotion, alarm::Code::MovesWrong,
        alarm::Code::NotJudged, alarm::Code::NotRecorded, alarm::Code::RecordingCut}) {
    m_messages.settle(code);
  }
}

bool RunController::raise(double toMm, double feedMmPerS) {
  if (refuses(startBlocked())) {
    return false;
  }
  m_left.reset();
  startPositioning(Positioning::Raise, streaming::raiseProgram(toMm), feedMmPerS, {},
                   {{"z_mm", base::formatNumber(toMm)}}, [toMm] {
                     return tr("The tool is raised to Z %1.").arg(widgets::lengthText(toMm));
                   });
  return true;
}

base::Result<streaming::BackWay> RunController::wayBack(const streaming::BackWish& wish) const {
  const auto toolMm = m_machine.positionNowMm();
  const base::RotarySet& turned =
      m_question ? m_question->settings.parameters.rotaryAxes : base::RotarySet{};
  const auto& toolDeg = m_machine.view().rotaryDeg;
  if (!m_question || !m_resume || !toolMm || (base::any(turned) && !toolDeg)) {
    return base::fail(streaming::StreamError::CannotResume,
                      "It is not known where the tool stands on the path of the run.");
  }
  return streaming::backAlong(*m_question->program, m_question->settings, m_question->checkpoint,
                              m_resume->point, {*toolMm, toolDeg.value_or(base::RotaryDeg{})},
                              wish);
}

bool RunController::driveBack(const streaming::BackWay& way, double feedMmPerS) {
  if (!m_question || refuses(startBlocked())) {
    return false;
  }
  session::StartCommand command;
  command.settings.parameters = m_question->settings.parameters;
  command.drivenBack = report::RunStore().find(m_question->checkpoint.runNumber);
  if (!command.drivenBack) {
    m_messages.show(Severity::Warning, [] {
      return tr("The file of the run is gone: the run could not go on after the way back.");
    });
    return false;
  }
  command.drivenBack->back = way.part;
  const base::RotarySet rotaryAxes = m_question->settings.parameters.rotaryAxes;
  startPositioning(Positioning::Back, streaming::backProgram(way, rotaryAxes), feedMmPerS,
                   std::move(command), {{"back_mm", base::formatNumber(way.lengthMm)}},
                   [lengthMm = way.lengthMm] {
                     return tr("The tool is driven back by %1 along the path.")
                         .arg(widgets::lengthText(lengthMm));
                   });
  return true;
}

void RunController::startPositioning(Positioning kind, gcode::Program program, double feedMmPerS,
                                     session::StartCommand command, ActDetails details,
                                     const Messages::Text& text) {
  const templates::TemplateParameters ofRun = command.settings.parameters;
  command.program = std::make_shared<const gcode::Program>(std::move(program));
  command.settings = m_document.runSettings();
  command.settings.programFeeds.reset();
  command.settings.feedMmPerS = feedMmPerS;
  command.settings.factor = {};
  command.settings.parameters.factorLeast = command.settings.parameters.factorMost = 0.0;
  if (kind == Positioning::Back) {
    command.settings.parameters.method = base::MethodKind::Window;
    command.settings.parameters.feedPerPoint = false;
    command.settings.parameters.axes = ofRun.axes;
    command.settings.parameters.rotaryAxes = ofRun.rotaryAxes;
  }
  forgetResume();
  forgetLast();
  m_update = {};
  m_runBegin = 0;
  m_positioning = kind;
  m_machine.showPreparing(true);
  details.insert(details.begin(), {{"program", command.program->name},
                                   {"machine", m_machine.endpoint().toStdString()}});
  m_messages.didAct(Act::Start, details);
  m_messages.show(Severity::Note, text);
  m_session.start(std::move(command));
  m_document.setRunning(m_session.isRunning());
  Q_EMIT updated(m_update);
  Q_EMIT permissionsChanged();
}

void RunController::takePositioned(const session::RunFinished& finished) {
  const Positioning kind = std::exchange(m_positioning, Positioning::None);
  m_machine.showPreparing(false);
  m_machine.forgetExecuted();
  m_messages.clear();
  m_report = finished.report;  // for what is said of it
  m_update.counters = m_report->counters;
  logOutcome(finished);
  m_report.reset();
  m_update = {};
  m_document.setRunning(false);
  Q_EMIT updated(m_update);
  Q_EMIT permissionsChanged();
  if (kind == Positioning::Back) {
    askResume();
  } else {
    Q_EMIT raised();
  }
}

void RunController::announceStart(const streaming::RunSettings& settings,
                                  const run::JobRestart* restart, bool isChosen) {
  m_machine.showPreparing(true);
  const std::optional<base::Vec3>& toolMm = m_machine.view().positionMm;
  if (restart != nullptr) {
    m_messages.log(Severity::Note, Source::Run,
                   [line = placeOf(*restart).line.value, steps = restart->restart.steps.size()] {
                     return tr("The job goes on at line %1, after %Ln blocks of the control.",
                               nullptr, static_cast<int>(steps))
                         .arg(widgets::countText(line));
                   });
  } else if (settings.resume) {
    m_messages.log(Severity::Note, Source::Run, [point = m_firstPoint + 1, isChosen] {
      return (isChosen ? tr("The run starts at point %1.") : tr("The run resumes at point %1."))
          .arg(widgets::countText(point));
    });
  } else if (m_document.isJob()) {
    const overview::JobOutline& outline = m_document.view()->outline;
    m_messages.log(Severity::Note, Source::Run,
                   [stretches = outline.stretches(), blocks = outline.needed().size()] {
                     return tr("Start of a whole job: %1, %Ln blocks for the control.", nullptr,
                               static_cast<int>(blocks))
                         .arg(tr("%Ln parts", nullptr, static_cast<int>(stretches)));
                   });
  } else if (m_document.live()) {
    m_messages.log(Severity::Note, Source::Run,
                   [name = QString::fromStdString(m_document.live()->name)] {
                     return tr("Start. The points come from %1.").arg(name);
                   });
  } else if (toolMm && !m_document.points().empty()) {
    const double lengthMm = base::distance(*toolMm, m_document.points().front().positionMm);
    m_messages.log(Severity::Note, Source::Run, [lengthMm] {
      return tr("Start. The tool first moves %1 in a straight line to the first point.")
          .arg(widgets::lengthText(lengthMm));
    });
  }
  const auto& flexible = m_document.findings().flexible;
  if (settings.transfer == streaming::TransferWay::ByHand && flexible) {
    m_messages.show(Severity::Note, [flexible] {
      return tr("Save the template on its page as %1, copy it to the part programs of the control, "
                "select it in channel 1 and press cycle start. The axes move only after the "
                "template has shown its layout number %2.")
          .arg(QString::fromStdString(flexible->name))
          .arg(flexible->layoutNumber);
    });
  }
}

void RunController::takeUpdate(const streaming::LiveUpdate& update) {
  const bool isNewState = update.state != m_update.state;
  const bool isMoving = update.state == streaming::RunState::Running;
  m_update = update;
  if (isPositioning()) {
    m_update.counters = {};  // of the program, nothing is executed
    m_machine.showPreparing(update.state == streaming::RunState::Armed);
    Q_EMIT updated(m_update);
    if (update.sample) {
      m_machine.showSample(*update.sample, std::nullopt);
    }
    if (isNewState) {
      Q_EMIT permissionsChanged();
    }
    return;
  }
  m_update.counters = inProgram(update.counters, m_firstPoint);
  if (isMoving && !m_firstMotion) {
    m_firstMotion = update.at;
  }
  const base::Instant origin = m_firstMotion.value_or(update.at);
  m_machine.showPreparing(update.state == streaming::RunState::Armed);
  followTool(update);
  showExecuted();
  if (update.wrong && !m_wrong) {
    takeWrong(*update.wrong);
  }
  Q_EMIT updated(m_update);
  if (isNewState && isMoving) {
    const auto& flexible = m_document.findings().flexible;
    m_machine.showRunning(QString::fromStdString(m_job      ? m_job->program
                                                 : flexible ? flexible->name
                                                            : ""));
  }
  if (update.sample) {
    takeSample(*update.sample, origin);
  }
  if (update.equipment) {
    m_machine.showEquipment(*update.equipment);
  }
  if (update.pause) {
    trace::Pause pause = *update.pause;
    pause.start = base::Instant{pause.start - origin};
    Q_EMIT paused(pause);
  }
  if (isNewState) {
    Q_EMIT permissionsChanged();
  }
}

void RunController::takeJob(const session::JobUpdate& job) {
  const bool waited = m_job && m_job->waitsForCycleStart;
  m_job = job;
  if (job.waitsForCycleStart && !waited) {
    m_messages.show(Severity::Note, [line = job.line.value] {
      return tr("The program waits for cycle start at the control (line %1).")
          .arg(widgets::countText(line));
    });
  } else if (waited && !job.waitsForCycleStart) {
    m_messages.clear();
  }
  Q_EMIT jobChanged();
}

void RunController::takeWrong(const streaming::WrongMotion& wrong) {
  m_wrong = wrong;
  m_hasWrongMotion = true;
  m_messages.raise(alarm::Code::MovesWrong,
                   {m_document.program()->name, std::to_string(m_firstPoint + wrong.point)});
  m_messages.log(Severity::Error, Source::Run, [text = wrongMotion()] { return text; });
  Q_EMIT wrongMotionChanged();
}

QString RunController::wrongMotion() const {
  if (!m_hasWrongMotion) {
    return {};
  }
  if (!isRunning() || !m_wrong) {
    return tr("The run has executed wrong points: see the report, and check the workpiece.");
  }
  const QString point = widgets::countText(m_firstPoint + m_wrong->point);
  return m_wrong->kind == streaming::WrongMotion::Kind::OffPath
             ? tr("Wrong motion: after point %1 the tool is %2 off the path.")
                   .arg(point, widgets::lengthText(m_wrong->offMm, 2))
             : tr("Wrong motion: the control has repeated points after point %1.").arg(point);
}

void RunController::acknowledgeWrongMotion() {
  if (m_hasWrongMotion && !isRunning()) {
    m_hasWrongMotion = false;
    Q_EMIT wrongMotionChanged();
  }
}

void RunController::showExecuted() {
  const auto& points = m_document.points();
  const std::size_t number = m_update.counters.executed;
  if (m_job && m_job->isNative) {
    m_machine.forgetExecuted();  // the control moves as its own blocks say
    m_machine.showRunning(QString::fromStdString(m_job->program));
    return;
  }
  if (m_firstMotion && number <= points.size()) {
    const streaming::StreamSettings& settings = m_document.settings();
    m_machine.showExecuted(
        number, number > 0 ? points[number - 1].positionMm : base::Vec3{},
        m_document.commandedMmPerS(m_move.value_or(std::min(number, points.size() - 1))),
        settings.usesProgramFeeds() && !m_document.live() ? std::optional(settings.overrideFactor)
                                                          : std::nullopt);
  }
}

void RunController::takeSample(const trace::LiveSample& sample, base::Instant origin) {
  const widgets::TraceSample shown{base::toSeconds(sample.at - origin), sample.positionMm,
                                   sample.feedMmPerS};
  if (m_firstMotion && shown.atS >= 0.0) {
    Q_EMIT sampled(shown);
  }
  m_machine.showSample(sample, toGo(sample));
}

std::size_t RunController::runLine() const {
  const auto& points = m_document.points();
  return nativeLine() > 0                    ? nativeLine()
         : m_move && *m_move < points.size() ? points[*m_move].line.value
                                             : 0;
}

void RunController::forgetMove() {
  m_move.reset();
  m_passedSeen = 0;
}

void RunController::followTool(const streaming::LiveUpdate& update) {
  if (update.feed && update.feed->liftedMm) {
    return;  // held, and perhaps lifted off its path: it is where it was
  }
  const auto& points = m_document.points();
  const std::size_t begin = passed();
  const bool isNative = m_job && m_job->isNative;  // on no path that is known here
  if (!m_firstMotion || isNative || isCorrected(update) || begin >= points.size()) {
    m_move.reset();
  } else if (update.sample && update.sample->positionMm) {
    const std::size_t end = std::clamp(m_update.counters.accepted, begin + 1,
                                       std::min(points.size(), begin + kMovesAheadMax));
    gcode::StreamPoint from = points[begin > m_firstPoint ? begin - 1 : begin];
    if (begin == m_firstPoint) {
      from.positionMm = m_startMm.value_or(*update.sample->positionMm);
    }
    m_move = moveAt(points, begin, end, from, *update.sample->positionMm);
    m_passedSeen = std::max(m_passedSeen, m_move.value_or(0));
  }
}

std::optional<widgets::MachineView::ToGo> RunController::toGo(
    const trace::LiveSample& sample) const {
  const auto& points = m_document.points();
  const bool isComing = m_firstMotion && passed() <= m_firstPoint && m_firstPoint < points.size() &&
                        !(m_job && m_job->isNative) && !isCorrected(m_update);
  if (!sample.positionMm || (!m_move && !isComing)) {
    return std::nullopt;
  }
  // Before its path begins, the tool is on its way to the first point.
  const gcode::StreamPoint& target = points[m_move.value_or(m_firstPoint)];
  widgets::MachineView::ToGo toGo{target.positionMm - *sample.positionMm, {}, true};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    toGo.deg[axis] = sample.rotaryDeg ? target.rotaryDeg[axis] - (*sample.rotaryDeg)[axis] : 0.0;
  }
  return toGo;
}

void RunController::takeFinished(const session::RunFinished& finished) {
  if (isPositioning()) {
    takePositioned(finished);
    return;
  }
  m_report = finished.report;
  forgetMove();  // from now on its report counts
  const bool wasJob = m_job.has_value();
  m_job.reset();
  if (m_report->outcome == streaming::Outcome::Completed) {
    m_left.reset();
  } else if (wasJob && finished.left) {
    m_left = session::ResumeQuestion{m_document.program(),      m_report->settings,
                                     finished.left->checkpoint, m_document.view()->plan,
                                     m_document.jobMachine(),   0,
                                     finished.left->job};
  } else if (m_report->checkpoint) {
    m_left = session::ResumeQuestion{m_document.program(), m_report->settings,
                                     *m_report->checkpoint, m_plan, m_document.jobMachine()};
  }
  holdPoints();
  m_update.state = streaming::endState(m_report->outcome);
  m_update.counters = inProgram(m_report->counters, m_firstPoint);
  if (wasJob && m_report->outcome == streaming::Outcome::Completed) {
    const std::size_t all = m_document.points().size();
    m_update.counters = {all, all, all, all};
  }
  m_update.stopConfirmedAfter = m_report->stopConfirmedAfter;
  m_update.waitingFor.clear();
  m_machine.showPreparing(false);
  m_machine.forgetExecuted();
  Q_EMIT updated(m_update);
  logOutcome(finished);
  m_messages.settle(alarm::Code::MovesWrong);
  const trace::Integrity& integrity = m_report->integrity;
  m_hasWrongMotion = integrity.judged ? !integrity.isFaultless() : m_report->wrong.has_value();
  m_document.setRunning(false);
  Q_EMIT permissionsChanged();
  Q_EMIT this->finished(m_report);
  Q_EMIT wrongMotionChanged();
  if (wasJob) {
    Q_EMIT jobChanged();
  }
}

void RunController::logOutcome(const session::RunFinished& finished) {
  if (m_report->access.requests > 0) {
    m_messages.log(Severity::Note, Source::Run, [grouping = m_report->settings.grouping] {
      return tr("Access: %1.").arg(widgets::groupingText(grouping));
    });
  }
  m_messages.log(Severity::Note, Source::Run, [counters = m_update.counters, begin = m_runBegin] {
    const auto ofRun = [begin](std::size_t count) {
      return widgets::countText(std::max(count, begin) - begin);
    };
    return tr("Run ended: %1 of %2 points executed.")
        .arg(ofRun(counters.executed), ofRun(counters.total));
  });
  if (finished.jobTimes) {
    m_messages.log(Severity::Note, Source::Run,
                   [times = *finished.jobTimes] { return widgets::jobTimesText(times); });
  }
  raiseOutcome();
  if (finished.notKept.code) {
    m_messages.log(Severity::Warning, Source::Run, [error = finished.notKept] {
      return tr("The run is not in the history: %1").arg(widgets::errorText(error));
    });
  }
  if (finished.cut) {
    raiseCut(*finished.cut);
  } else if (finished.notRecorded.code) {
    m_messages.raise(alarm::Code::NotRecorded, {report::RunHistory::folderOfUser().string()},
                     finished.notRecorded);
  }
  if (!finished.recordingPath.empty()) {
    m_messages.log(Severity::Note, Source::Run,
                   [path = QString::fromStdString(finished.recordingPath)] {
                     return tr("Recording: %1").arg(path);
                   });
  }
}

void RunController::raiseCut(const run::RecordingCut& cut) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(cut.recorded);
  m_messages.raise(alarm::Code::RecordingCut,
                   {cut.program, std::to_string(seconds.count()),
                    std::filesystem::path(cut.file).parent_path().string()},
                   cut.error);
}

void RunController::raiseOutcome() {
  const std::string& name = m_report->programName;
  if (m_report->error.code) {
    m_messages.raise(alarm::Code::RunFailed, {name}, m_report->error);
    if (m_report->live && m_report->live->refusal.code) {
      // Whoever writes the source wants to know the line, at once.
      m_messages.show(Severity::Error,
                      [error = m_report->error] { return widgets::errorText(error); });
    }
  }
  const trace::Integrity& integrity = m_report->integrity;
  if (integrity.judged && !integrity.isFaultless()) {
    m_messages.raise(alarm::Code::WrongMotion,
                     {name, std::to_string(integrity.repeated), std::to_string(integrity.skipped)});
  } else if (m_report->finding() == streaming::RunFinding::Faulty && !m_report->error.code &&
             (integrity.judged || !m_report->wrong)) {
    m_messages.raise(alarm::Code::RunIncomplete, {name, std::to_string(integrity.executed),
                                                  std::to_string(m_report->counters.total)});
  } else if (m_report->finding() == streaming::RunFinding::NotJudged && !m_report->error.code &&
             m_machine.view().isVirtualMachine) {
    // Most controls keep no trace: there it is no news, and the report says it.
    m_messages.raise(alarm::Code::NotJudged, {name});
  }
}

}  // namespace rivulet::hmi
