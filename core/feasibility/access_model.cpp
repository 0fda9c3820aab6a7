// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/access_model.h"

#include <algorithm>

#include "feasibility/symbols.h"

namespace rivulet::feasibility {

using base::Duration;

namespace {

constexpr Duration kLeast = std::chrono::microseconds{1};

}  // namespace

Duration AccessLine::of(int nodes) const {
  return std::max(kLeast, overhead + perNode * nodes);
}

Duration AccessModel::timePerNode(base::MethodKind method, int pointsPerLoop) const {
  if (!measured) {
    return accessTime;
  }
  constexpr int kRead = static_cast<int>(kReadNodesPerPoll);
  constexpr int kWrite = static_cast<int>(kWriteNodesPerPoint);
  const AccessLine& read = measured->read;
  const AccessLine& write = measured->write;
  if (method == base::MethodKind::Position) {
    return (read.of(kRead) + write.of(kWrite)) / (kRead + kWrite);
  }
  if (method == base::MethodKind::Signal) {
    const int half = std::max(kWrite * (pointsPerLoop / 2), 1);
    return (read.of(1) + write.of(half)) / (half + 1);
  }
  // Of the cells beside the points two travel by themselves: the number and the look.
  constexpr int kAlone = 2;
  const int content = kWrite * pointsPerLoop + static_cast<int>(kWindowNodes) - kAlone;
  // Method credit looks at two cells, which the equation counts as one.
  const int looked = method == base::MethodKind::Credit ? 2 : 1;
  return (write.of(content) + write.of(1) + read.of(looked)) / (content + kAlone);
}

}  // namespace rivulet::feasibility
