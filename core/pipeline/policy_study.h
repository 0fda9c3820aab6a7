// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The policies side by side, in virtual time, with the tasks of the net of [P3]: each takes one
/// item and makes one. @threadsafety pure. @source [P3] Table 1
#pragma once

#include <array>
#include <cstdint>

#include "base/instant.h"
#include "pipeline/policy.h"
#include "pipeline/task.h"
#include "pipeline/virtual_run.h"

namespace rivulet::pipeline {

/// Six tasks without end that move items and do nothing with them.
class UnitStages {
 public:
  [[nodiscard]] std::array<Stage*, kTaskCount> all();

 private:
  class UnitStage final : public Stage {
   public:
    explicit UnitStage(Task task) : m_task(task) {}
    [[nodiscard]] Need need() const override {
      return m_task == Task::Receive ? Need::Nothing : Need::Data;
    }
    [[nodiscard]] base::Result<StepDone> step() override {
      return StepDone{m_task != Task::Position, need()};
    }

   private:
    Task m_task;
  };

  std::array<UnitStage, kTaskCount> m_stages{
      UnitStage{Task::Receive},   UnitStage{Task::Interpret},   UnitStage{Task::Discrete},
      UnitStage{Task::LookAhead}, UnitStage{Task::Interpolate}, UnitStage{Task::Position}};
};

struct StudyCase {
  int processors = 1;
  base::Duration positionCycle{};
  base::Duration switchCost{};
  std::uint64_t seed = 0;  ///< of drawn times, 0 to twice those of Table 1; 0: as in Table 1
};

struct PolicyScore {
  std::uint64_t points = 0;    ///< sent by position control
  double starvedShare = 0.0;   ///< of the time, position control for data
  std::uint64_t switches = 0;  ///< of all processors
  std::uint64_t preemptions = 0;
  double heldItems = 0.0;  ///< in all buffers, on average
};

/// @param duration  simulated
[[nodiscard]] PolicyScore scorePolicy(PolicyKind policy, const StudyCase& study,
                                      base::Duration duration);

}  // namespace rivulet::pipeline
