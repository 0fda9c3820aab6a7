// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Task 5, interpolation (fine): the place of each cycle becomes a set point of the axes.
/// @threadsafety one object, one thread. @source [P3] II.B
#pragma once

#include "pipeline/items.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

class InterpolateTask final : public Stage {
 public:
  InterpolateTask(RingReader<CyclePlace> in, RingWriter<SetPoint> out) : m_in(in), m_out(out) {}

  [[nodiscard]] Need need() const override { return m_hasEnded ? Need::Ended : Need::Data; }
  [[nodiscard]] base::Result<StepDone> step() override;

 private:
  RingReader<CyclePlace> m_in;
  RingWriter<SetPoint> m_out;
  bool m_hasEnded = false;
};

}  // namespace rivulet::pipeline
