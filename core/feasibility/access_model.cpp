// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/access_model.h"

#include <algorithm>

namespace rivulet::feasibility {

using base::Duration;

namespace {

constexpr Duration kLeast = std::chrono::microseconds{1};

}  // namespace

Duration AccessLine::of(int nodes) const {
  return std::max(kLeast, overhead + perNode * nodes);
}

Duration AccessModel::timePerNode(const TurnSize& size) const {
  if (!measured) {
    return accessTime;
  }
  TurnSize filled = size;
  if (base::methodTraits(size.method).portion == base::Portion::HalfLoop) {
    filled.pointsPerLoop = std::max(size.pointsPerLoop, 2);
  }
  const ClientTurn turn = turnOf(filled);
  Duration took = measured->read.of(turn.read) + measured->write.of(turn.content);
  if (turn.number > 0) {
    took += measured->write.of(turn.number);
  }
  return took / turn.charged;
}

}  // namespace rivulet::feasibility
