// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/loaded_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "forecast/job_forecast.h"
#include "preparation/split_program.h"
#include "report/calibration_json.h"
#include "report/known_machine.h"
#include "report/operating_point.h"
#include "service/machine_lock.h"
#include "streaming/control/access_policy.h"
#include "streaming/start/stop_bound.h"
#include "templates/target.h"

namespace rivulet::service {

namespace {

/// The value of a fact that was read back is the one that was given.
bool isSameValue(const std::string& a, const std::string& b) {
  constexpr double kRounding = 1e-4;
  const auto first = base::parseNumber(a);
  const auto second = base::parseNumber(b);
  return first && second ? std::abs(*first - *second) <= kRounding : a == b;
}

const std::string* valueOf(const preparation::SettingsFacts& facts, const std::string& name) {
  const auto found = std::find_if(facts.begin(), facts.end(),
                                  [&name](const auto& fact) { return fact.first == name; });
  return found == facts.end() ? nullptr : &found->second;
}

/// Why the blocks of a program that are for the control would be left out.
std::string whyNoJob(const job::Plan& plan, const streaming::StreamSettings& settings,
                     const MachineFacts& machine) {
  if (!machine.jobs.runsJobs()) {
    return machine.jobs.whyNone();
  }
  if (!plan.refusals.empty()) {
    return job::describe(plan.refusals.front());
  }
  return base::hasWindows(settings.parameters.method) ? "a whole job has no online correction"
                                                      : "a whole job needs method window or credit";
}

feasibility::AccessModel accessOf(const streaming::StreamSettings& settings,
                                  const MachineFacts& machine) {
  if (!machine.calibration) {
    return {};
  }
  const streaming::Calibration& calibration = machine.calibration->calibration;
  return report::accessModel(
      calibration,
      streaming::accessPlan(settings.access, settings.parameters.method).expected(&calibration));
}

}  // namespace

base::Result<MachineFacts> factsOf(const report::MachineStore& store, const std::string& endpoint,
                                   const opcua::ServerIdentity& server, bool isVirtual) {
  const auto profile = store.profile(endpoint, server);
  if (!profile) {
    return base::fail(profile.error());
  }
  auto calibration = store.calibration(endpoint, server);
  if (!calibration) {
    return base::fail(calibration.error());
  }
  const auto feedTest = store.feedTest(endpoint, server);
  if (!feedTest) {
    return base::fail(feedTest.error());
  }
  auto jobs = store.jobRelease(endpoint, server, isVirtual);
  if (!jobs) {
    return base::fail(jobs.error());
  }
  const streaming::MachineProfile* limits = *profile ? &**profile : nullptr;
  MachineFacts facts;
  facts.endpoint = endpoint;
  facts.server = server;
  facts.jobs = *std::move(jobs);
  facts.load = report::loadMachineOf(store, endpoint, server, isVirtual, limits);
  facts.silenceLimitS = streaming::silenceLimitS(limits);
  facts.stopLimitS = streaming::stopLimitS(limits);
  facts.feedProof = streaming::feedProof(*feedTest, server, isVirtual);
  facts.feeds = report::programFeedsOf(report::configOf(limits), 1.0);
  if (const auto known = report::knownMachine(server, limits)) {
    facts.known = std::make_shared<const machine::MachineConfig>(*known);
  }
  if (*calibration && !(*calibration)->isOutdated(server)) {
    facts.calibration =
        std::make_shared<const streaming::CalibrationRecord>(**std::move(calibration));
  }
  return facts;
}

JobSettings defaultSettings() {
  JobSettings settings;
  settings.run.programFeeds = true;
  settings.run.wholeJob = true;
  return settings;
}

base::Result<JobSettings> settingsWith(JobSettings settings, const std::string& given) {
  const preparation::SettingsFacts wanted = preparation::factsOfText(given);
  if (wanted.empty() && !given.empty()) {
    return base::fail(ServiceError::BadSettings,
                      "Settings are written as name=value, with a semicolon between them.", given);
  }
  if (valueOf(wanted, "feed") != nullptr && valueOf(wanted, "feeds") == nullptr) {
    settings.run.programFeeds = false;
  }
  preparation::applySettings(settings.run, wanted);
  preparation::applyReading(settings.reading, wanted);
  preparation::SettingsFacts facts = preparation::settingsFacts(settings.run);
  for (auto& fact : preparation::readingFacts(settings.reading)) {
    facts.push_back(std::move(fact));
  }
  for (const auto& [name, value] : wanted) {
    const std::string* taken = valueOf(facts, name);
    if (taken == nullptr) {
      return base::fail(ServiceError::BadSettings,
                        fmt::format("There is no setting {}. The settings are: {}.", name,
                                    preparation::textOf(facts)));
    }
    if (!isSameValue(*taken, value)) {
      return base::fail(
          ServiceError::BadSettings,
          fmt::format("{} is no value of the setting {}, which is {} now.", value, name, *taken));
    }
  }
  if (settings.run.parameters.hasFactor() == settings.run.factor.address.empty()) {
    return base::fail(
        ServiceError::BadSettings,
        settings.run.parameters.hasFactor()
            ? "feed_factor_least and feed_factor_most need a source: feed_from=tcp:4002, "
              "or udp and a port."
            : "feed_from needs the bounds of the factor, such as "
              "feed_factor_least=0.2;feed_factor_most=1.2.");
  }
  return settings;
}

bool LoadedJob::hasFileChanged() const {
  std::error_code gone;
  const auto bytes = std::filesystem::file_size(file, gone);
  if (gone) {
    return false;  // a file that is gone has not changed
  }
  return bytes != fileBytes || std::filesystem::last_write_time(file, gone) != fileTime;
}

void LoadedJob::place(base::Vec3 toolMm, const MachineFacts& machine) {
  const int perLoop = std::max(2, settings.parameters.pointsPerLoop);
  const auto viewOf = [&](const std::shared_ptr<const gcode::Program>& shown) {
    return overview::makeProgramView(shown, toolMm, perLoop, {}, machine.feeds, view->plan);
  };
  view = viewOf(program);
  templates::TemplateParameters parameters = settings.parameters;
  if (base::streamsRotary(parameters.method)) {
    parameters.rotaryAxes = view->turnedAxes;
  }
  parameters.feedPerPoint = false;
  parameters.silenceLimitS = machine.silenceLimitS;
  const feasibility::AccessModel access = accessOf(settings, machine);
  runSettings = preparation::runSettings(settings, parameters, view.get(), machine.feeds,
                                         machine.calibration);
  runSettings.windowSMax =
      streaming::windowSMaxOf(machine.feedProof, parameters.target, machine.stopLimitS);
  reading.moveRules = view->isJob() ? gcode::MoveRules{}
                                    : moveRulesOfRun.value_or(streaming::moveRules(runSettings));
  if (const auto divided = preparation::programByRules(program, reading.moveRules, reading.budget);
      divided != program) {
    view = viewOf(divided);
  }
  if (settings.usesProgramFeeds() && !view->points.points.empty() &&
      streaming::prefersFeedPerPoint(view->points.points, runSettings, access)) {
    runSettings.parameters.feedPerPoint = true;
  }
  judged = preparation::judge(view.get(), runSettings, access);
  released = {
      view->program->hash, preparation::textOf(preparation::releasedFacts(settings, reading)),
      machine.calibration ? machine.calibration->endpoint + " " + machine.calibration->measuredAtUtc
                          : std::string()};
}

base::Result<LoadedJob> loadJob(
    const std::filesystem::path& file, const gcode::LoadOptions& reading,
    const std::function<base::Result<JobSettings>(const std::string& hash)>& settings,
    base::Vec3 toolMm, const MachineFacts& machine) {
  LoadedJob job;
  std::error_code ignored;
  job.file = std::filesystem::absolute(file, ignored);
  job.reading = reading;
  job.reading.moveRules = {};
  machine.load.tell(job.reading);
  // Taken before the text is read: anything written meanwhile counts as a change.
  job.fileBytes = std::filesystem::file_size(job.file, ignored);
  job.fileTime = std::filesystem::last_write_time(job.file, ignored);
  auto program = gcode::loadProgram(job.file, job.reading);
  if (!program) {
    return base::fail(program.error());
  }
  auto chosen = settings(program->hash);
  if (!chosen) {
    return base::fail(chosen.error());
  }
  job.settings = std::move(chosen->run);
  job.moveRulesOfRun = chosen->moveRules;
  if (!(chosen->reading == reading)) {
    job.reading.setReading(chosen->reading);
    program = gcode::loadProgram(job.file, job.reading);
    if (!program) {
      return base::fail(program.error());
    }
  }
  job.settings.parameters = templates::forTarget(
      job.settings.parameters, templates::targetOf(machine.server.applicationUri));
  const bool asJob = job.settings.wholeJob && machine.jobs.runsJobs() &&
                     base::hasWindows(job.settings.parameters.method) &&
                     job.settings.parameters.correctionLimitMm == 0.0;
  preparation::SplitProgram split = preparation::splitProgram(
      *std::move(program), job.reading, job.file, asJob, job.settings.dryRunMm, machine.load.words);
  if (split.dryRunError) {
    return base::fail(*split.dryRunError);
  }
  job.program = split.program;
  job.view = overview::makeProgramView(std::move(split.program), toolMm,
                                       std::max(2, job.settings.parameters.pointsPerLoop), {},
                                       machine.feeds, std::move(split.plan));
  const std::size_t leftOut = job.view->isJob() ? 0 : job.view->outline.needed().size();
  if (leftOut > 0 && job.settings.wholeJob) {
    const job::NativeBlock& first = *job.view->outline.needed().front();
    return base::fail(
        ServiceError::NotAJob,
        fmt::format("{} blocks are for the control (the first is line {}: {}) and would be left "
                    "out: {}. To stream the motion alone, load the program with job=motion only.",
                    leftOut, first.place.line.value, first.source,
                    whyNoJob(*job.view->plan, job.settings, machine)),
        job.view->program->name);
  }
  if (job.view->isJob()) {
    if (base::Result<void> released = machine.jobs.require(*job.view->plan); !released) {
      return base::fail(released.error());
    }
  }
  job.place(toolMm, machine);
  if (job.view->isJob() && machine.known) {
    forecast::CheckedJob checked =
        forecast::checkJob(*job.view->plan, *machine.known, {machine.known->start()});
    job.hazards = std::make_shared<const session::Hazards>(std::move(checked.hazards));
    job.cut = checked.cut;
  }
  return job;
}

}  // namespace rivulet::service
