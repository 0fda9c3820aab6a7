// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Task 4, forward-looking acceleration and deceleration: the look-ahead of the virtual machine. It
/// takes blocks until it has as many as the control buffers, and makes the place of one
/// interpolation cycle whenever it has them, or when no more can come: what it makes does not
/// depend on when blocks arrive. @threadsafety one object, one thread. @source [P3] II.B
#pragma once

#include <deque>
#include <vector>

#include "base/instant.h"
#include "machine/config.h"
#include "machine/equipment.h"
#include "machine/path_planner.h"
#include "pipeline/items.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

class LookAheadTask final : public Stage, private machine::AuxiliaryRun {
 public:
  LookAheadTask(const machine::MachineConfig& config, RingReader<RoughBlock> in,
                RingWriter<CyclePlace> out);
  LookAheadTask(const LookAheadTask&) = delete;
  LookAheadTask& operator=(const LookAheadTask&) = delete;

  [[nodiscard]] Need need() const override;
  [[nodiscard]] base::Result<StepDone> step() override;

 private:
  [[nodiscard]] bool wantsBlock() const;
  void append(const RoughBlock& block);
  [[nodiscard]] base::Result<StepDone> makeCycle();
  [[nodiscard]] double begin(const machine::PreparedActions& actions, base::Instant at) override;
  void dwell(base::LineNumber /*line*/, base::Instant /*at*/, double /*seconds*/) override {}

  machine::MachineConfig m_config;
  RingReader<RoughBlock> m_in;
  RingWriter<CyclePlace> m_out;
  machine::Equipment m_equipment;
  machine::PathPlanner m_planner;
  machine::PreparedActions m_actions;  ///< of a block that is not complete yet
  std::deque<Auxiliary> m_begun;       ///< not passed on yet
  BlockHead m_last;                    ///< End or Alarm, once it has come
  bool m_isLastHere = false;
  bool m_hasEnded = false;
  bool m_stops = false;  ///< takes no block before the axes stand
  base::Instant m_now{};
  std::uint64_t m_cycle = 0;
  std::vector<trace::ExecutedBlock> m_executed;
  std::vector<trace::ControlEvent> m_events;
};

}  // namespace rivulet::pipeline
