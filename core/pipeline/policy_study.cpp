// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/policy_study.h"

#include <numeric>

#include "base/contract.h"
#include "base/random.h"

namespace rivulet::pipeline {

namespace {

constexpr base::Duration kStep = std::chrono::milliseconds{10};
constexpr base::Duration kPositionStep = std::chrono::milliseconds{5};

}  // namespace

std::array<Stage*, kTaskCount> UnitStages::all() {
  std::array<Stage*, kTaskCount> stages{};
  for (std::size_t i = 0; i < kTaskCount; ++i) {
    stages[i] = &m_stages[i];
  }
  return stages;
}

PolicyScore scorePolicy(PolicyKind policy, const StudyCase& study, base::Duration duration) {
  UnitStages stages;
  base::Random random(study.seed);
  VirtualOptions options;
  options.dispatch.processors = study.processors;
  options.dispatch.positionCycle = study.positionCycle;
  options.switchCost = study.switchCost;
  options.until = base::Instant{duration};
  options.duration = [&](Task task, std::uint64_t /*step*/) {
    const base::Duration usual = task == Task::Position ? kPositionStep : kStep;
    return study.seed == 0 ? usual
                           : base::Duration{1} +
                                 base::fromSeconds(2.0 * random.uniform() * base::toSeconds(usual));
  };
  const auto scheduler = factsOf(policy).make();
  const auto run = runVirtual(stages.all(), *scheduler, options);
  RIVULET_ASSERT(run.has_value());  // these tasks cannot fail
  PolicyScore score;
  const TaskRecord& position = run->records[indexOf(Task::Position)];
  score.points = position.count;
  score.starvedShare = base::toSeconds(position.waitedData) / base::toSeconds(duration);
  for (const TaskRecord& record : run->records) {
    score.switches += record.switches;
    score.preemptions += record.preemptions;
  }
  score.heldItems = std::accumulate(run->meanLevels.begin(), run->meanLevels.end(), 0.0);
  return score;
}

}  // namespace rivulet::pipeline
