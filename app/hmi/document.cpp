// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/document.h"

#include <fmt/format.h>

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "base/hash.h"
#include "base/units.h"
#include "feasibility/client_turn.h"
#include "forecast/region.h"
#include "job/main_program.h"
#include "preparation/judged.h"
#include "report/calibration_json.h"
#include "report/known_machine.h"
#include "report/operating_point.h"
#include "session/background.h"
#include "streaming/control/access_policy.h"
#include "streaming/start/stop_bound.h"
#include "templates/target.h"

namespace rivulet::hmi {

namespace {

/// Axes at rest tremble; less than this is no other position.
constexpr double kToolMovedMm = 0.01;

/// The times of a run are estimated again this long after the last change of a setting.
constexpr int kEstimateMs = 400;
constexpr std::size_t kPointsMin = 2;

}  // namespace

const machine::MachineConfig& usualMachine() {
  static const machine::MachineConfig machine = *machine::loadPreset("dmu75-mill");
  return machine;
}

Document::Document(const streaming::StreamSettings& settings)
    : m_machineFeeds(report::programFeedsOf(report::configOf(nullptr), 1.0)), m_settings(settings) {
  m_settings.feedMmPerS = std::min(m_settings.feedMmPerS, feedMmPerSMax());
  connect(&m_loader, &session::ProgramLoader::progressed, this,
          [this](double share) { Q_EMIT readingProgressed(share); });
  connect(&m_loader, &session::ProgramLoader::loaded, this, &Document::take);
  connect(&m_loader, &session::ProgramLoader::placed, this, &Document::takePlaced);
  connect(&m_loader, &session::ProgramLoader::failed, this,
          [this](const base::Error& error, const QString& path) {
            Q_EMIT readingProgressed(std::nullopt);
            Q_EMIT readingFailed(error, path);
          });
  connect(&m_loader, &session::ProgramLoader::cancelled, this, [this] {
    Q_EMIT readingProgressed(std::nullopt);
    Q_EMIT readingCancelled();
  });
  connect(&m_livePath, &session::LivePath::grown, this,
          [this](const std::shared_ptr<const overview::ProgramView>& view) {
            if (m_live) {
              m_view = view;
              Q_EMIT programPlaced();
            }
          });
  connect(&m_watch, &session::FileWatch::stateChanged, this, &Document::fileStateChanged);
  connect(&m_timer, &session::ProgramTimer::estimated, this,
          [this](const std::shared_ptr<const overview::ProgramTimes>& times,
                 const std::shared_ptr<const overview::ProgramView>& view) {
            if (m_view && view->program == program() && times->atS.size() == points().size()) {
              m_estimate.times = times;
              Q_EMIT timesEstimated(times);
              Q_EMIT pausesChanged();
            }
          });
  connect(&m_timer, &session::ProgramTimer::planned, this,
          [this](const std::shared_ptr<const overview::PauseMap>& pauses,
                 const std::shared_ptr<const overview::ProgramView>& view) {
            if (m_view == view) {
              m_estimate.pauses = pauses;
              m_estimate.pausesFor = m_estimate.timesFor;
              Q_EMIT pausesChanged();
            }
          });
  connect(&m_jobCheck, &session::JobCheck::finished, this,
          [this](const std::shared_ptr<const forecast::CheckedJob>& checked) {
            m_checked.job = checked;
            showHazards();
            Q_EMIT judged();
          });
  connect(&m_rehearsal, &session::Rehearsal::finished, this, &Document::takeRehearsal);
  m_estimateTimer.setSingleShot(true);
  m_estimateTimer.setInterval(kEstimateMs);
  connect(&m_estimateTimer, &QTimer::timeout, this, [this] {
    rehearse();
    estimateTimes();
  });
  judge();
}

void Document::open(const QString& path, const session::Reading& reading) {
  m_isMotionAlone = false;
  m_moves.ofRun.reset();
  if (QFileInfo(path).absoluteFilePath() != m_path) {
    // Chosen for another program.
    m_settings.dryRunMm = 0.0;
    m_settings.wholeJob = m_settings.wholeJob || !m_path.isEmpty();
    Q_EMIT settingsChanged();
  }
  read(path, reading);
}

void Document::openMotion(const QString& path, const session::Reading& reading,
                          const gcode::MoveRules& limit) {
  m_isMotionAlone = true;
  m_moves.ofRun = limit;
  m_settings.dryRunMm = 0.0;
  Q_EMIT settingsChanged();
  read(path, reading);
}

void Document::openLive(const live::Setup& setup, const std::string& name) {
  m_loader.cancel();
  m_watch.clear();
  m_path.clear();
  m_requestedPath.clear();
  m_reading = {};
  m_dryRunError.reset();
  m_settings.dryRunMm = 0.0;
  m_live = LiveInput{setup, name, std::nullopt};
  showNoPoints();
  Q_EMIT programLoaded();
  judge();
}

void Document::showNoPoints() {
  forgetTimes();
  m_passes = {};  // they hold a program that may be large
  // What is agreed stands for the program: a release is for it.
  const std::string hash = fmt::format("{:016x}", base::hashOf(live::textOf(m_live->setup)));
  m_livePath.begin(m_live->name, hash);
  m_view = overview::makeProgramView(session::liveProgram(m_live->name, hash), {}, 2);
}

void Document::setLiveObstacle(std::optional<base::Error> obstacle) {
  if (m_live) {
    m_live->obstacle = std::move(obstacle);
    judge();
  }
}

void Document::beginLivePath() {
  showNoPoints();
  Q_EMIT programPlaced();
}

const overview::JobOutline* Document::outline() const {
  return m_view && !m_view->outline.needed().empty() ? &m_view->outline : nullptr;
}

const std::vector<job::FunctionUse>& Document::foreignFunctions() const {
  static const std::vector<job::FunctionUse> none;
  return m_view && m_view->plan ? m_view->plan->functions : none;
}

std::optional<Document::JobObstacle> Document::jobObstacle() const {
  if (outline() == nullptr) {
    return std::nullopt;
  }
  if (!m_jobRelease.runsJobs()) {
    return JobObstacle::Machine;
  }
  if (!base::hasWindows(m_settings.parameters.method)) {
    return JobObstacle::Method;
  }
  if (m_settings.parameters.correctionLimitMm > 0.0) {
    return JobObstacle::Correction;
  }
  // Read as a job, it would be one.
  return m_reading.asJob && !isJob() ? std::optional(JobObstacle::NotWhole) : std::nullopt;
}

bool Document::wantsJob() const {
  return m_settings.wholeJob && m_jobRelease.runsJobs() && !m_isMotionAlone &&
         base::hasWindows(m_settings.parameters.method) &&
         m_settings.parameters.correctionLimitMm == 0.0;
}

void Document::setJobRelease(const streaming::JobRelease& release) {
  m_jobRelease = release;
  followJob();
}

void Document::followJob() {
  // A file that has changed is read when the operator says so.
  const double dryRunMm = wantsJob() ? m_settings.dryRunMm : 0.0;
  const bool differs = m_reading.asJob != wantsJob() || m_reading.dryRunMm != dryRunMm ||
                       !(m_reading.machine == m_loadMachine);
  // The cycles of a TNC need the radius of the tool.
  const bool hasCycles = m_view && m_view->program->dialect == gcode::Dialect::Heidenhain;
  const bool concerns = outline() != nullptr || !foreignFunctions().empty() || hasCycles;
  if (concerns && differs && !m_motion.isRunning && !m_motion.isHeld && !hasFileChanged() &&
      !m_loader.isBusy()) {
    read(m_path, m_reading);
  }
}

std::optional<base::Error> Document::dryRunProblem() const {
  // Until it has been read again, the program is the one that was not to be run.
  const bool isAsWanted =
      dryRunMm() == m_settings.dryRunMm && (m_settings.dryRunMm == 0.0 || wantsJob());
  if (!m_view || isAsWanted) {
    return std::nullopt;
  }
  if (m_dryRunError && m_reading.dryRunMm == m_settings.dryRunMm) {
    return m_dryRunError;
  }
  return base::makeError(
      job::JobError::NotDry,
      (outline() == nullptr
           ? tr("A dry run needs the whole job, but only the motion of this program would be "
                "streamed. Choose Whole job.")
           : tr("A dry run needs the whole job: choose method window or credit, and no online "
                "correction."))
          .toStdString());
}

session::ProgramSource Document::source() const {
  session::ProgramSource source;
  source.file = m_path.toStdString();
  source.reading.setReading(m_reading);
  source.reading.moveRules = m_moves.limit;
  return source;
}

void Document::readAgain(const session::Reading& reading) {
  if (m_view && !m_live && !m_motion.isRunning) {
    read(m_path, reading);
  }
}

void Document::read(const QString& path, const session::Reading& reading) {
  m_requestedPath = path;
  session::Reading whole = reading;
  whole.asJob = wantsJob();
  whole.dryRunMm = whole.asJob ? m_settings.dryRunMm : 0.0;
  whole.machine = m_loadMachine;
  Q_EMIT readingProgressed(0.0);
  m_loader.load({path, std::move(whole), m_toolMm, std::max(2, m_settings.parameters.pointsPerLoop),
                 m_machineFeeds, wantedMoveRules()});
}

void Document::take(const session::LoadedProgram& loaded) {
  Q_EMIT readingProgressed(std::nullopt);
  if (m_motion.isRunning) {
    return;  // a run was started meanwhile: what is running stays what is shown
  }
  m_live.reset();
  m_view = loaded.view;
  m_moves.whole = loaded.whole;
  m_moves.limit = loaded.request.moveRules;
  m_path = QFileInfo(loaded.request.path).absoluteFilePath();
  m_reading = loaded.request.reading;
  m_dryRunError = loaded.dryRunError;
  m_watch.watch(m_path, loaded.stamp);
  forgetTimes();
  Q_EMIT programLoaded();
  judge();
  followJob();  // the settings may have changed meanwhile
}

void Document::takePlaced(const std::shared_ptr<const overview::ProgramView>& view,
                          const session::PlaceRequest& request) {
  // A run has begun meanwhile: its points begin where the tool is, but are divided as they were.
  if (request.view != m_view || (m_motion.isRunning && !(request.moveRules == m_moves.limit))) {
    return;
  }
  m_view = view;
  m_moves.limit = request.moveRules;
  m_estimate.pauses.reset();
  m_estimate.timesFor.reset();
  Q_EMIT programPlaced();
  if (!m_motion.isRunning) {
    judge();
  }
}

void Document::forgetTimes() {
  m_timer.cancel();
  m_estimate.timesFor.reset();
  m_estimate.pauses.reset();
  m_estimate.times.reset();
}

std::shared_ptr<const gcode::Program> Document::program() const {
  return m_view ? m_view->program : nullptr;
}

const std::vector<gcode::StreamPoint>& Document::points() const {
  static const std::vector<gcode::StreamPoint> none;
  if (m_live) {
    return m_livePath.points();
  }
  return m_view ? m_view->points.points : none;
}

void Document::setSettings(const streaming::StreamSettings& settings) {
  m_settings = settings;
  m_isMotionAlone = m_isMotionAlone && settings.dryRunMm == 0.0;
  m_settings.feedMmPerS = std::min(m_settings.feedMmPerS, feedMmPerSMax());
  Q_EMIT settingsChanged();
  judge();
  followJob();
}

void Document::editSettings(const streaming::StreamSettings& settings) {
  m_settings = settings;
  m_isMotionAlone = m_isMotionAlone && settings.dryRunMm == 0.0;
  m_settings.feedMmPerS = std::min(m_settings.feedMmPerS, feedMmPerSMax());
  judge();
  followJob();
}

void Document::chooseJob(bool isWhole) {
  m_settings.wholeJob = isWhole;
  m_settings.dryRunMm = 0.0;
  m_isMotionAlone = false;
  Q_EMIT settingsChanged();
  judge();
  followJob();
}

templates::TemplateParameters Document::parameters() const {
  templates::TemplateParameters parameters =
      templates::forTarget(m_settings.parameters, m_stop.target);
  parameters.silenceLimitS = m_stop.silenceLimitS;
  // What the machine has not been seen to do is left out.
  const bool mayLift =
      parameters.liftMm <= m_stop.liftMmMax && base::fillsWindows(parameters.method);
  parameters.liftMm = mayLift ? parameters.liftMm : 0.0;
  if (m_view && base::streamsRotary(parameters.method)) {
    parameters.rotaryAxes = m_live ? m_live->setup.rotaryAxes : m_view->turnedAxes;
  }
  parameters.feedPerPoint =
      m_view && !m_live && m_settings.usesProgramFeeds() && m_passes.feedCells.feedPerPoint;
  return parameters;
}

void Document::chooseFeedCells(const feasibility::AccessModel& access) {
  if (!m_view || m_live || points().empty() || !m_settings.usesProgramFeeds()) {
    return;
  }
  streaming::RunSettings settings = runSettings();
  settings.parameters.feedPerPoint = false;
  const auto turn = report::operatingPointOf(settings).turn();
  const base::Duration accessTime = access.timePerNode(turn);
  const templates::TemplateParameters& wanted = settings.parameters;
  const templates::TemplateParameters& had = m_passes.feedCells.parameters;
  if (m_passes.feedCells.view == m_view && m_passes.feedCells.accessTime == accessTime &&
      had.method == wanted.method && had.pointsPerLoop == wanted.pointsPerLoop &&
      had.windows == wanted.windows && had.packed == wanted.packed &&
      had.correctionLimitMm == wanted.correctionLimitMm) {
    return;
  }
  m_passes.feedCells = {m_view, wanted, accessTime,
                        streaming::prefersFeedPerPoint(points(), settings, access)};
}

double Document::commandedMmPerS(std::size_t point) const {
  if (m_live) {
    return point < points().size()
               ? points()[point].feedMmPerS
               : base::mmPerSFromMmPerMin(m_live->setup.agreement.feedMmPerMinMax);
  }
  if (!m_settings.usesProgramFeeds() || point >= points().size()) {
    return m_settings.feedMmPerS;
  }
  return std::min(m_settings.overrideFactor * points()[point].feedMmPerS,
                  points()[point].kind == gcode::MoveKind::Rapid ? m_machineFeeds.rapidMmPerS
                                                                 : feedMmPerSMax());
}

streaming::RunSettings Document::runSettings() const {
  streaming::RunSettings settings =
      preparation::runSettings(m_settings, parameters(), m_live ? nullptr : m_view.get(),
                               m_machineFeeds, m_source.isUsed() ? m_source.record : nullptr);
  settings.windowSMax =
      streaming::windowSMaxOf(m_stop.proof, settings.parameters.target, m_stop.limitS);
  settings.liftMmMax = m_stop.liftMmMax;
  if (m_live) {
    // Of points before the first F; the others have their own.
    settings.feedMmPerS = base::mmPerSFromMmPerMin(m_live->setup.agreement.feedMmPerMinMax);
  }
  return settings;
}

void Document::setTarget(templates::TargetControl target) {
  if (target != m_stop.target) {
    m_stop.target = target;
    judge();
  }
}

void Document::setSilenceLimit(double seconds) {
  if (seconds != m_stop.silenceLimitS) {
    m_stop.silenceLimitS = seconds;
    judge();
  }
}

void Document::setStopLimit(double seconds) {
  if (seconds != m_stop.limitS) {
    m_stop.limitS = seconds;
    judge();
  }
}

void Document::setFeedProof(streaming::FeedProof proof, double liftMmMax) {
  if (proof != m_stop.proof || liftMmMax != m_stop.liftMmMax) {
    m_stop.proof = proof;
    m_stop.liftMmMax = liftMmMax;
    judge();
  }
}

void Document::setMachine(std::shared_ptr<const machine::MachineConfig> machine) {
  if (machine == m_machine) {
    return;
  }
  m_machine = std::move(machine);
  const gcode::ProgramFeeds before = m_machineFeeds;
  m_machineFeeds = report::programFeedsOf(m_machine ? *m_machine : report::configOf(nullptr), 1.0);
  m_settings.feedMmPerS = std::min(m_settings.feedMmPerS, feedMmPerSMax());
  m_rehearsed.outcome.reset();
  m_rehearsed.key.clear();
  forgetTimes();
  if (!(before == m_machineFeeds)) {
    Q_EMIT settingsChanged();
    readAgain(m_reading);  // the points carry feeds within the limits
  }
  judge();
}

void Document::setJobMachine(std::shared_ptr<const machine::MachineConfig> machine) {
  m_jobMachine = std::move(machine);
  m_checked.plan.reset();
  judge();
}

void Document::setLoadMachine(const report::LoadMachine& machine) {
  m_loadMachine = machine;
  followJob();
}

void Document::checkJob() {
  const auto plan = isJob() ? m_view->plan : nullptr;
  if (plan != m_checked.plan) {
    m_checked.plan = plan;
    m_checked.job.reset();
    m_jobCheck.cancel();
    if (plan) {
      // How long it takes is said of another machine, too, if this one is not known.
      m_jobCheck.start(plan, m_jobMachine ? m_jobMachine
                                          : std::shared_ptr<const machine::MachineConfig>(
                                                std::shared_ptr<void>(), &usualMachine()));
    }
  }
  m_findings.isJobChecked = plan != nullptr && m_jobMachine != nullptr;
  showHazards();
}

void Document::showHazards() {
  const bool areThere = m_findings.isJobChecked && m_checked.job;
  m_findings.hazards = {m_checked.job, areThere ? &m_checked.job->hazards : nullptr};
}

void Document::setCalibration(std::shared_ptr<const streaming::CalibrationRecord> record,
                              bool isOutdated) {
  m_source.record = std::move(record);
  m_source.isOutdated = isOutdated;
  judge();
}

void Document::setToolPosition(const base::Vec3& positionMm) {
  m_toolMm = positionMm;
  placePoints();
}

gcode::MoveRules Document::wantedMoveRules() const {
  if (m_moves.ofRun) {
    return *m_moves.ofRun;
  }
  return streaming::moveRules(runSettings());
}

void Document::placePoints() {
  if (!m_view || m_live || m_motion.isRunning || m_motion.isHeld) {
    return;
  }
  const bool hasMoved = m_view->dependsOnStart && base::isFinite(m_toolMm) &&
                        base::distance(m_view->startMm, m_toolMm) > kToolMovedMm;
  const gcode::MoveRules limit = isJob() ? gcode::MoveRules{} : wantedMoveRules();
  if (hasMoved || !(limit == m_moves.limit)) {
    m_loader.place({m_view, m_moves.whole, limit, hasMoved ? m_toolMm : m_view->startMm,
                    std::max(2, m_settings.parameters.pointsPerLoop)});
  }
}

void Document::setRunning(bool isRunning) {
  m_motion.isRunning = isRunning;
  if (isRunning) {
    if (m_timer.isBusy()) {
      m_estimate.timesFor.reset();  // what it has told is a first figure
    }
    m_timer.cancel();
    m_rehearsal.cancel();
    if (!m_rehearsed.outcome) {
      m_rehearsed.key.clear();
    }
  } else if (!m_estimate.times || !m_estimate.times->run || !m_estimate.timesFor) {
    m_estimate.timesFor.reset();  // the run has interrupted it
    m_estimateTimer.start();
  }
}

feasibility::AccessModel Document::accessModel(widgets::AccessSource& source) const {
  source.form = opcua::Grouping::List;
  if (!m_source.isUsed()) {
    return {};
  }
  const streaming::Calibration& calibration = m_source.record->calibration;
  source.form =
      streaming::accessPlan(m_settings.access, m_settings.parameters.method).expected(&calibration);
  return report::accessModel(calibration, source.form);
}

void Document::judge() {
  Findings found;
  found.source = m_source;
  found.access = accessModel(found.source);
  chooseFeedCells(found.access);
  const streaming::RunSettings settings = runSettings();
  found.operatingPoint = report::operatingPointOf(settings);
  found.source.cellsMax = feasibility::turnOf(found.operatingPoint.turn()).content;
  // The points of a live run come while it is in progress.
  const auto view = m_live ? nullptr : m_view;
  found.isBeingMeasured =
      view && !measure(found.operatingPoint.pointsPerLoop, settings.programFeeds.has_value());
  static_cast<preparation::Judged&>(found) = preparation::judgeWith(
      m_passes.measured.distances, view.get(), settings, found.access, dryRunProblem());
  if (found.settingsError && found.settingsError->code == streaming::StreamError::FeedUnknown) {
    found.settingsError->context = tr("Line %1").arg(m_view->lineWithoutFeed->value).toStdString();
  }
  m_findings = std::move(found);
  checkJob();
  // The equations see averages; a feasible verdict is checked by a simulation before any start.
  if (m_findings.isBeingMeasured || (m_findings.verdict && m_findings.verdict->feasible)) {
    m_findings.rehearsed = streaming::Rehearsed{};
    if (!m_findings.isBeingMeasured && m_rehearsed.outcome && rehearsalKey() == m_rehearsed.key) {
      takeRehearsal(m_rehearsed.outcome, m_rehearsed.key);
    }
  }
  placePoints();
  m_estimateTimer.start();
  Q_EMIT judged();
  Q_EMIT pausesChanged();
}

bool Document::measure(int pointsPerLoop, bool isTimed) {
  const Measured wanted{m_view, pointsPerLoop, isTimed, {}, false};
  if (!m_passes.measured.isFor(wanted)) {
    m_passes.measured = wanted;
    const auto distances = [wanted] {
      return preparation::distancesOf(*wanted.view, wanted.pointsPerLoop, wanted.isTimed);
    };
    if (points().size() <= overview::kPointsAtOnce || pointsPerLoop == m_view->distancesFor) {
      m_passes.measured.distances = distances();
      m_passes.measured.isDone = true;
    } else {
      session::inBackground(this, distances, [wanted](Document& self, const auto& found) {
        if (self.m_passes.measured.isFor(wanted)) {
          self.m_passes.measured.distances = found;
          self.m_passes.measured.isDone = true;
          self.judge();
        }
      });
    }
  }
  return m_passes.measured.isDone;
}

session::TimeSettings Document::timeSettings() const {
  const streaming::RunSettings settings = runSettings();
  return {
      settings.parameters.method, settings.parameters.pointsPerLoop,           settings.feedMmPerS,
      settings.programFeeds,      streaming::windowCut(settings).feedPerPoint, m_machine};
}

void Document::estimateTimes() {
  const session::TimeSettings settings = timeSettings();
  if (m_live || points().size() < kPointsMin || m_motion.isRunning ||
      m_estimate.timesFor == settings || !(settings.feedMmPerS > 0.0)) {
    return;
  }
  m_estimate.timesFor = settings;
  m_timer.start(m_view, settings);
}

std::string Document::rehearsalKey() const {
  const feasibility::OperatingPoint& point = m_findings.operatingPoint;
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {}", program()->hash, points().size(),
                     m_view->startMm.x, m_view->startMm.y, m_view->startMm.z,
                     m_findings.flexible ? m_findings.flexible->layoutNumber : 0, point.feedMmPerS,
                     m_settings.usesProgramFeeds(), point.deltaMm,
                     static_cast<int>(m_settings.access),
                     static_cast<const void*>(m_source.isUsed() ? m_source.record.get() : nullptr));
}

void Document::rehearse() {
  if (!m_findings.rehearsed || m_findings.rehearsed->isDone || m_findings.isBeingMeasured ||
      m_motion.isRunning) {
    return;
  }
  const std::string key = rehearsalKey();
  if (key == m_rehearsed.key && !m_rehearsed.outcome) {
    return;  // in progress
  }
  m_rehearsed.key = key;
  m_rehearsed.outcome.reset();
  session::RehearsalJob job;
  job.points = {m_view, &m_view->points.points};
  job.tightest =
      feasibility::tightestPlace(*m_findings.distances, m_settings.parameters.method).point.value;
  job.settings = runSettings();
  job.machine = m_machine;
  job.access = m_findings.access.measured;
  m_rehearsal.start(std::move(job), key);
}

void Document::takeRehearsal(const std::shared_ptr<const session::RehearsalOutcome>& outcome,
                             const std::string& key) {
  if (key != m_rehearsed.key) {
    return;
  }
  const bool isNew = m_rehearsed.outcome != outcome;
  m_rehearsed.outcome = outcome;
  if (!m_findings.rehearsed || key != rehearsalKey()) {
    return;
  }
  m_findings.rehearsal = outcome;
  if (outcome->verdict) {
    m_findings.verdict = outcome->verdict;
  }
  m_findings.rehearsed =
      outcome->runs == 0
          ? std::nullopt
          : std::optional(streaming::Rehearsed{true, outcome->runs, outcome->faulty});
  if (isNew) {
    Q_EMIT judged();
  }
}

std::shared_ptr<const overview::PauseMap> Document::pauses() const {
  // Pauses of other settings would mislead.
  const session::TimeSettings settings = timeSettings();
  return m_estimate.pausesFor && m_estimate.pausesFor->method == settings.method &&
                 m_estimate.pausesFor->pointsPerLoop == settings.pointsPerLoop &&
                 m_estimate.pausesFor->programFeeds.has_value() ==
                     settings.programFeeds.has_value() &&
                 m_estimate.pausesFor->feedPerPoint == settings.feedPerPoint
             ? m_estimate.pauses
             : nullptr;
}

std::optional<widgets::PauseSummary> Document::pauseSummary() const {
  const auto map = pauses();
  if (!map) {
    return std::nullopt;
  }
  widgets::PauseSummary summary;
  summary.count = map->count();
  summary.inCut = map->inCut.size();
  if (const overview::RunTime* time = runTime()) {
    summary.costS = time->pausesCostS();
    summary.totalS = time->totalS;
  }
  return summary;
}

const overview::RunTime* Document::runTime() const {
  const bool isOfPauses = m_estimate.times && m_estimate.times->run && m_estimate.pauses &&
                          m_estimate.times->run->pauses == m_estimate.pauses->count() &&
                          m_estimate.pausesFor == timeSettings();
  return isOfPauses ? &*m_estimate.times->run : nullptr;
}

bool Document::addNativeTimes(widgets::TimeLeft& left, std::size_t executed,
                              std::size_t nativeLine) const {
  if (!m_checked.job) {
    return false;
  }
  const std::vector<std::uint32_t>& starts = m_view->stretchStarts;
  std::size_t native = 0;
  std::size_t stretch = 0;              // that comes next
  bool isInProgress = nativeLine == 0;  // or comes after what is
  for (const job::Part& part : m_view->plan->parts) {
    const auto* const block = std::get_if<job::NativeBlock>(&part);
    if (block == nullptr) {
      stretch += std::get<job::Stretch>(part).number > 0 ? 1 : 0;
      continue;
    }
    const double seconds = base::toSeconds(m_checked.job->nativeTimes[native++]);
    const bool isAhead = stretch >= starts.size() || starts[stretch] >= executed;
    isInProgress = isInProgress || (isAhead && block->place.line.value == nativeLine);
    if (isAhead && isInProgress) {
      (block->reason == job::NativeReason::Tool ? left.toolChangesS : left.nativeS) += seconds;
    }
  }
  return true;
}

std::optional<widgets::TimeLeft> Document::timeLeft(std::size_t executed,
                                                    std::size_t nativeLine) const {
  const overview::RunTime* time = runTime();
  if (time == nullptr || executed > time->atS.size()) {
    return std::nullopt;
  }
  const double passedS = executed == 0 ? 0.0 : static_cast<double>(time->atS[executed - 1]);
  widgets::TimeLeft left{std::max(0.0, time->totalS - passedS), 0.0};
  if (time->pauses > 0) {
    const auto after = [executed](const std::vector<std::uint32_t>& points) {
      return std::distance(std::lower_bound(points.begin(), points.end(), executed), points.end());
    };
    const auto pauses =
        static_cast<double>(after(m_estimate.pauses->inCut) + after(m_estimate.pauses->offCut));
    left.pausesS = time->pausesCostS() * pauses / static_cast<double>(time->pauses);
  }
  if (isJob() && !addNativeTimes(left, executed, nativeLine)) {
    return std::nullopt;
  }
  left.totalS += left.toolChangesS + left.nativeS;
  return left;
}

}  // namespace rivulet::hmi
