// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run/resume.h"

#include <utility>

#include "report/run_store.h"
#include "streaming/recovery/job_resume.h"

namespace rivulet::run {

namespace {

int firstStretch(const job::Plan& plan) {
  for (const job::Part& part : plan.parts) {
    const auto* const stretch = std::get_if<job::Stretch>(&part);
    if (stretch != nullptr && stretch->number > 0) {
      return stretch->number;
    }
  }
  return 0;
}

JobRestart restartOf(forecast::Restart restart, const machine::MachineConfig& machine,
                     const std::optional<streaming::Resume>& resume,
                     const std::optional<base::Vec3>& toolMm) {
  JobRestart found{std::move(restart), resume, 0, toolMm, {}};
  found.stretch = firstStretch(found.restart.plan);
  found.hazards = forecast::hazardsOf(found.restart.plan, machine, {machine.start()});
  return found;
}

}  // namespace

base::Result<streaming::Resume> askResume(opcua::Link& link, const gcode::Program& program,
                                          const streaming::RunSettings& settings,
                                          const streaming::Checkpoint& checkpoint) {
  const report::RunStore runs;
  const auto kept = runs.find(checkpoint.runNumber);
  const auto points = kept ? runs.points(*kept) : std::vector<gcode::StreamPoint>();
  return streaming::resumeFrom(link, program, settings, checkpoint, points);
}

base::Result<JobRestart> askJob(opcua::Link& link, const job::Plan& plan,
                                const machine::MachineConfig& machine,
                                const streaming::RunSettings& settings,
                                const streaming::Checkpoint& checkpoint) {
  const auto rest = streaming::whereJobWasLeft(
      link, plan, settings, checkpoint,
      [&](std::size_t part) { return forecast::zeroAt(plan, machine, part); });
  if (!rest) {
    return base::fail(rest.error());
  }
  auto restart = forecast::restartAt(plan, machine, *rest);
  if (!restart) {
    return base::fail(restart.error());
  }
  return restartOf(*std::move(restart), machine, rest->resume, rest->toolMm);
}

base::Result<JobRestart> beginWith(int stretch, const job::Plan& plan,
                                   const machine::MachineConfig& machine) {
  auto restart = forecast::restartAtStretch(plan, machine, stretch);
  if (!restart) {
    return base::fail(restart.error());
  }
  return restartOf(*std::move(restart), machine, {}, {});
}

base::Error machineNotKnown() {
  return base::makeError(
      streaming::StreamError::CannotResume,
      "The tools and offsets of this machine are not known, so the state in which the job goes on "
      "cannot be computed. Start from the beginning.");
}

}  // namespace rivulet::run
