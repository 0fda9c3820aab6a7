// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Task 3, discrete (rough interpolation): each motion becomes a piece of geometry.
/// @threadsafety one object, one thread. @source [P3] II.B
#pragma once

#include "base/axes.h"
#include "machine/config.h"
#include "pipeline/items.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

class DiscreteTask final : public Stage {
 public:
  DiscreteTask(const machine::MachineConfig& config, RingReader<NcBlock> in,
               RingWriter<RoughBlock> out);

  [[nodiscard]] Need need() const override { return m_hasEnded ? Need::Ended : Need::Data; }
  [[nodiscard]] base::Result<StepDone> step() override;

 private:
  machine::MachineConfig m_config;
  RingReader<NcBlock> m_in;
  RingWriter<RoughBlock> m_out;
  base::AxisPosition m_at;  ///< end of the last motion
  bool m_hasEnded = false;
};

}  // namespace rivulet::pipeline
