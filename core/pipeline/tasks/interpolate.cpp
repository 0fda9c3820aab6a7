// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/tasks/interpolate.h"

#include "pipeline/tasks/transfer.h"

namespace rivulet::pipeline {

base::Result<StepDone> InterpolateTask::step() {
  const auto place = take(m_in);
  if (!place) {
    return base::fail(place.error());
  }
  const SetPoint point{place->head, place->place.positionMm(), place->place.positionDeg()};
  m_hasEnded = point.head.kind != CycleKind::Motion;
  if (auto given = give(m_out, point); !given) {
    return base::fail(given.error());
  }
  return StepDone{true, need()};
}

}  // namespace rivulet::pipeline
