// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// By data flow: the task with the largest difference between the buffer before it and the one
/// after it; of equal ones the first in the order of their numbers.
/// @source [P3] III.A, Fig. 11

#include "pipeline/policy.h"

namespace rivulet::pipeline {

namespace {

class DataFlow final : public SchedulingPolicy {
 public:
  [[nodiscard]] bool goesBefore(const Candidate& a, const Candidate& b,
                                const Outlook& /*outlook*/) const override {
    const int differenceA = a.upstream - a.downstream;
    const int differenceB = b.upstream - b.downstream;
    return differenceA != differenceB ? differenceA > differenceB
                                      : indexOf(a.task) < indexOf(b.task);
  }
};

}  // namespace

std::unique_ptr<SchedulingPolicy> makeDataFlow() {
  return std::make_unique<DataFlow>();
}

}  // namespace rivulet::pipeline
