// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/tasks/position.h"

#include <fmt/format.h>

#include "pipeline/tasks/transfer.h"

namespace rivulet::pipeline {

base::Result<void> checkFollows(const SetPoint& point, std::uint64_t last) {
  if (point.head.cycle == last + 1) {
    return {};
  }
  return base::fail(PipelineError::SetPointMissing,
                    fmt::format("Set point {} came after set point {}. The axes stand; start the "
                                "program again.",
                                point.head.cycle, last));
}

base::Result<StepDone> PositionTask::step() {
  const auto point = take(m_in);
  if (!point) {
    return base::fail(point.error());
  }
  if (auto follows = checkFollows(*point, m_cycle); !follows) {
    return base::fail(follows.error());
  }
  m_cycle = point->head.cycle;
  if (auto sent = m_output.send(*point); !sent) {
    return base::fail(sent.error());
  }
  m_hasEnded = point->head.kind != CycleKind::Motion;
  return StepDone{false, need()};
}

}  // namespace rivulet::pipeline
