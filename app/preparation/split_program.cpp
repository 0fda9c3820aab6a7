// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "preparation/split_program.h"

#include <utility>

#include "gcode/block_observer.h"
#include "job/dry_plan.h"
#include "overview/job_outline.h"

namespace rivulet::preparation {

SplitProgram splitProgram(gcode::Program program, gcode::LoadOptions options,
                          const std::filesystem::path& path, bool asJob, double dryRunMm,
                          const job::Profile& machine) {
  options.subprogram = gcode::subprogramsBeside(path);
  auto made = job::makePlan(program, options, machine);
  if (!made) {
    return {std::make_shared<const gcode::Program>(std::move(program)), nullptr};
  }
  auto plan = std::make_shared<job::Plan>(*std::move(made));
  bool isJob = asJob && plan->isWhole() && plan->stretchCount() > 0 &&
               !overview::JobOutline(plan).needed().empty();
  std::optional<base::Error> dryRunError;
  if (isJob && dryRunMm > 0.0) {
    if (auto dry = job::dryPlan(*plan, dryRunMm)) {
      plan = std::make_shared<job::Plan>(*std::move(dry));
    } else {
      dryRunError = dry.error();
      isJob = false;
    }
  }
  if (isJob) {
    plan->program.text = std::move(program.text);
    std::shared_ptr<const gcode::Program> streamed(plan, &plan->program);
    return {std::move(streamed), std::move(plan)};
  }
  plan->program = {};
  return {std::make_shared<const gcode::Program>(std::move(program)), std::move(plan),
          std::move(dryRunError)};
}

std::shared_ptr<const gcode::Program> programByRules(std::shared_ptr<const gcode::Program> program,
                                                     const gcode::MoveRules& rules,
                                                     const base::Budget& budget) {
  if (rules == gcode::MoveRules{}) {
    return program;
  }
  auto changed = std::make_shared<gcode::Program>(*program);
  base::Result<bool> applied = gcode::applyRules(*changed, rules, budget);
  if (!applied && rules.tolerance != 0.0) {
    gcode::MoveRules exact = rules;
    exact.tolerance = 0.0;
    applied = gcode::applyRules(*changed, exact, budget);
  }
  if (applied && *applied) {
    return changed;
  }
  return program;
}

}  // namespace rivulet::preparation
