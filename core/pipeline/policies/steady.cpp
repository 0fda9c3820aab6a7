// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A processor stays with its task for a batch: a switch of tasks costs time and brings nothing by
/// itself. After that, or when its task has no data or no room, the tasks go by their dependency.
/// Ours.

#include "pipeline/policy.h"

namespace rivulet::pipeline {

namespace {

class Steady final : public SchedulingPolicy {
 public:
  [[nodiscard]] bool goesBefore(const Candidate& a, const Candidate& b,
                                const Outlook& /*outlook*/) const override {
    const bool staysA = isWithinBatch(a);
    return staysA != isWithinBatch(b) ? staysA : indexOf(a.task) > indexOf(b.task);
  }
};

}  // namespace

std::unique_ptr<SchedulingPolicy> makeSteady() {
  return std::make_unique<Steady>();
}

}  // namespace rivulet::pipeline
