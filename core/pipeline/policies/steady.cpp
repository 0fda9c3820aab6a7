// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A processor stays with its task while that can run: a switch of tasks costs time and brings
/// nothing by itself. Only when the set points run short, the tasks go by their dependency; so a
/// processor changes when its task has no data, no room, or when position control is in danger.
/// Ours.

#include "pipeline/policy.h"

namespace rivulet::pipeline {

namespace {

/// Set points below which the shortest way to the next one counts.
constexpr int kReserve = 4;

class Steady final : public SchedulingPolicy {
 public:
  [[nodiscard]] bool goesBefore(const Candidate& a, const Candidate& b,
                                const Outlook& outlook) const override {
    if (a.isWarm != b.isWarm && outlook.levels.back() >= kReserve) {
      return a.isWarm;
    }
    return indexOf(a.task) > indexOf(b.task);
  }
};

}  // namespace

std::unique_ptr<SchedulingPolicy> makeSteady() {
  return std::make_unique<Steady>();
}

}  // namespace rivulet::pipeline
