// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The task goes first without which position control would be without a set point first. What lies
/// after a task lasts for some time; less the time that it and those after it need, this is how
/// long the task can wait. An item of a buffer is worth as many set points as have come of one so
/// far, so a block counts for more than a place on the path. Of tasks that are all too late, the one
/// that has executed last goes on for a batch: a switch would cost time, too. Ours.

#include <algorithm>

#include "pipeline/policy.h"

namespace rivulet::pipeline {

namespace {

/// How long a task can wait, s.
double slackS(Task task, const Outlook& outlook) {
  const auto points =
      static_cast<double>(std::max<std::uint64_t>(1, outlook.made[indexOf(Task::Interpolate)]));
  double slack = 0.0;
  for (std::size_t i = indexOf(task); i < kBufferCount; ++i) {
    const auto items = static_cast<double>(std::max<std::uint64_t>(1, outlook.made[i]));
    slack += outlook.levels[i] * (points / items) * base::toSeconds(outlook.positionCycle);
    slack -= base::toSeconds(outlook.meanTimes[i]);
  }
  return std::max(0.0, slack);
}

class EarliestStarvation final : public SchedulingPolicy {
 public:
  [[nodiscard]] bool goesBefore(const Candidate& a, const Candidate& b,
                                const Outlook& outlook) const override {
    const double slackA = slackS(a.task, outlook);
    const double slackB = slackS(b.task, outlook);
    if (slackA != slackB) {
      return slackA < slackB;
    }
    const bool staysA = isWithinBatch(a);
    return staysA != isWithinBatch(b) ? staysA : indexOf(a.task) > indexOf(b.task);
  }
};

}  // namespace

std::unique_ptr<SchedulingPolicy> makeEarliestStarvation() {
  return std::make_unique<EarliestStarvation>();
}

}  // namespace rivulet::pipeline
