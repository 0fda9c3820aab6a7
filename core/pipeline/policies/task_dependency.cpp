// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// By task dependency: the nearer to position control, the higher the priority, and it never
/// changes.
/// @source [P3] III.A, Fig. 10

#include "pipeline/policy.h"

namespace rivulet::pipeline {

namespace {

class TaskDependency final : public SchedulingPolicy {
 public:
  [[nodiscard]] bool goesBefore(const Candidate& a, const Candidate& b,
                                const Outlook& /*outlook*/) const override {
    return indexOf(a.task) > indexOf(b.task);
  }
};

}  // namespace

std::unique_ptr<SchedulingPolicy> makeTaskDependency() {
  return std::make_unique<TaskDependency>();
}

}  // namespace rivulet::pipeline
