// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/policy.h"

#include <cstddef>

namespace rivulet::pipeline {

namespace {

/// Of 1, 2, 4, 6, 8, 16 and 40, none gave `steady` more set points with one and two processors and
/// 1 ms per switch. With less, processors switch more often; with more, position control waits.
constexpr int kBatch = 8;

}  // namespace

const std::array<PolicyFacts, 4>& policies() {
  static const std::array<PolicyFacts, 4> rows{{
      {PolicyKind::TaskDependency, "task-dependency", "task dependency", &makeTaskDependency},
      {PolicyKind::DataFlow, "data-flow", "data flow", &makeDataFlow},
      {PolicyKind::EarliestStarvation, "earliest-starvation", "earliest starvation",
       &makeEarliestStarvation},
      {PolicyKind::Steady, "steady", "steady", &makeSteady},
  }};
  return rows;
}

bool isWithinBatch(const Candidate& candidate) {
  return candidate.isWarm && candidate.downstream < kBatch;
}

const PolicyFacts& factsOf(PolicyKind kind) {
  return policies()[static_cast<std::size_t>(kind)];
}

}  // namespace rivulet::pipeline
