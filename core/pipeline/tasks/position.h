// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Task 6, position control: sends one set point per cycle to the axes, and none twice.
/// @threadsafety one object, one thread; no allocation in `step`. @source [P3] Fig. 7
#pragma once

#include "pipeline/items.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

/// Where set points go: the servo of a virtual machine, a recording, another computer.
class AxisOutput {
 public:
  virtual ~AxisOutput() = default;
  [[nodiscard]] virtual base::Result<void> send(const SetPoint& point) = 0;
};

class PositionTask final : public Stage {
 public:
  /// @param output  outlives the task
  PositionTask(RingReader<SetPoint> in, AxisOutput& output) : m_in(in), m_output(output) {}

  [[nodiscard]] Need need() const override { return m_hasEnded ? Need::Ended : Need::Data; }
  [[nodiscard]] base::Result<StepDone> step() override;

 private:
  RingReader<SetPoint> m_in;
  AxisOutput& m_output;
  std::uint64_t m_cycle = 0;
  bool m_hasEnded = false;
};

/// @return SetPointMissing unless `point` is the one after the cycle `last`
[[nodiscard]] base::Result<void> checkFollows(const SetPoint& point, std::uint64_t last);

}  // namespace rivulet::pipeline
