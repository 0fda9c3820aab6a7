// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run/resume.h"

#include <fmt/format.h>

#include <utility>

#include "job/main_program.h"
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

base::Error jobChanged(const job::Plan& plan) {
  return base::makeError(
      streaming::StreamError::ProgramChanged,
      fmt::format(
          "The program, or an option or setting that changes its blocks, is not that of the "
          "job that was left. Restore it, or begin in the middle. {}",
          streaming::kChooseStretch),
      plan.program.name);
}

JobRestart restartOf(forecast::Restart restart, const machine::MachineConfig& machine,
                     const std::optional<streaming::Resume>& resume,
                     const std::optional<base::Vec3>& toolMm) {
  JobRestart found{std::move(restart), resume, 0, toolMm, {}, 0};
  found.stretch = firstStretch(found.restart.plan);
  found.hazards = forecast::hazardsOf(found.restart.plan, machine, {machine.start()});
  return found;
}

}  // namespace

base::Result<streaming::Resume> askResume(opcua::Link& link, const gcode::Program& program,
                                          const streaming::RunSettings& settings,
                                          const streaming::Checkpoint& checkpoint,
                                          streaming::ActiveProgram active) {
  const report::RunStore runs;
  const auto kept = runs.find(checkpoint.runNumber);
  if (kept && kept->back) {
    return streaming::resumeOnPart(link, program, settings, checkpoint, *kept->back);
  }
  const auto points = kept ? runs.points(*kept) : std::vector<gcode::StreamPoint>();
  return streaming::resumeFrom(link, program, settings, checkpoint, points, active);
}

base::Result<JobRestart> askJob(opcua::Link& link, const job::Plan& plan,
                                const machine::MachineConfig& machine,
                                const streaming::RunSettings& settings,
                                const streaming::Checkpoint& checkpoint,
                                const std::optional<report::SavedJob>& kept,
                                streaming::ActiveProgram active) {
  // What the control executed last: the job of the source, or one that went on already.
  std::optional<forecast::Restart> before;
  if (kept && kept->rest) {
    if (kept->rest->part >= plan.parts.size()) {
      return base::fail(jobChanged(plan));
    }
    auto made = forecast::restartAt(plan, machine, *kept->rest);
    if (!made) {
      return base::fail(made.error());
    }
    before = *std::move(made);
  }
  const job::Plan& left = before ? before->plan : plan;
  if (kept) {
    const auto programs = job::makePrograms(left, settings.parameters);
    if (!programs) {
      return base::fail(programs.error());
    }
    if (programs->number != kept->number) {
      return base::fail(jobChanged(plan));
    }
  }
  const auto inSource = [&](const streaming::JobRest& rest) {
    return before ? forecast::restInSource(*before, rest) : rest;
  };
  const auto found = streaming::whereJobWasLeft(
      link, left, settings, checkpoint,
      [&](std::size_t part) {
        return machine.access.keepsFrame
                   ? base::Result<base::Vec3>()
                   : forecast::zeroAt(plan, machine, inSource({part, {}, {}}).part);
      },
      active);
  if (!found) {
    return base::fail(found.error());
  }
  const streaming::JobRest rest = inSource(*found);
  auto restart = forecast::restartAt(plan, machine, rest);
  if (!restart) {
    return base::fail(restart.error());
  }
  JobRestart job = restartOf(*std::move(restart), machine, rest.resume, rest.toolMm);
  job.firstRun = kept ? kept->firstRun : 0;
  job.restMm = found->restMm;
  return job;
}

base::Result<JobRestart> beginWith(int stretch, const job::Plan& plan,
                                   const machine::MachineConfig& machine) {
  auto restart = forecast::restartAtStretch(plan, machine, stretch);
  if (!restart) {
    return base::fail(restart.error());
  }
  return restartOf(*std::move(restart), machine, {}, {});
}

bool isSame(const streaming::Resume& a, const streaming::Resume& b) {
  return a.point == b.point && a.changedFrom == b.changedFrom;
}

bool isSame(const JobRestart& a, const JobRestart& b) {
  // The tool stands where it was left: roundings of the control are smaller by far.
  constexpr double kStandsMm = 0.05;
  const auto pointOf = [](const JobRestart& restart) {
    return restart.resume ? std::optional(restart.resume->point) : std::nullopt;
  };
  return a.stretch == b.stretch && pointOf(a) == pointOf(b) &&
         a.restart.plan.parts.size() == b.restart.plan.parts.size() &&
         a.toolMm.has_value() == b.toolMm.has_value() &&
         (!a.toolMm || base::distance(*a.toolMm, *b.toolMm) <= kStandsMm);
}

base::Error changedSince() {
  return base::makeError(streaming::StreamError::CannotResume,
                         "The state of the control has changed since it was asked. Resume again, "
                         "and check the place.");
}

std::string restText(const std::optional<double>& restMm) {
  if (!restMm) {
    return {};
  }
  return *restMm > 0.0
             ? fmt::format(
                   "The program still stands on the control: first it executes the rest of its "
                   "window, at most {:.1f} mm, and ends.",
                   *restMm)
             : "The program still stands on the control, between its windows: it ends without a "
               "move.";
}

base::Error machineNotKnown() {
  return base::makeError(
      streaming::StreamError::CannotResume,
      "The tools and offsets of this machine are not known, so the state in which the job goes on "
      "cannot be computed. Start from the beginning.");
}

}  // namespace rivulet::run
