// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/tasks/discrete.h"

#include "pipeline/tasks/transfer.h"

namespace rivulet::pipeline {

DiscreteTask::DiscreteTask(const machine::MachineConfig& config, RingReader<NcBlock> in,
                           RingWriter<RoughBlock> out)
    : m_config(config), m_in(in), m_out(out), m_at(config.start()) {
}

base::Result<StepDone> DiscreteTask::step() {
  const auto block = take(m_in);
  if (!block) {
    return base::fail(block.error());
  }
  RoughBlock rough;
  rough.head = block->head;
  if (block->head.kind == BlockKind::Motion) {
    rough.motion = machine::roughMotion(block->motion, m_at, m_config);
    m_at = {block->motion.targetMm, block->motion.targetDeg};
  }
  m_hasEnded = block->head.kind == BlockKind::End || block->head.kind == BlockKind::Alarm;
  if (auto given = give(m_out, rough); !given) {
    return base::fail(given.error());
  }
  return StepDone{true, need()};
}

}  // namespace rivulet::pipeline
