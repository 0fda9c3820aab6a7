// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What [P2] section 3 does with learned emulators: each tested on each design (Tables 2 and 3),
/// and the importance of the parameters (Figure 9). @threadsafety blocks its caller; emulator runs
/// go to the caller's executor.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/executor.h"
#include "base/result.h"
#include "emulator/paper/boosted_trees.h"
#include "emulator/paper/learning.h"

namespace rivulet::emulator::paper {

/// Emulators learned from one design each.
struct TrainTestMatrix {
  double lambda = 0.0;
  std::vector<Learning> learned;           ///< of each design
  std::vector<std::vector<Misfit>> tests;  ///< [design tested on][design learned from]
};

/// Learns from each course and tests on each. @source [P2] Tables 2 and 3
/// @param progress  share done, 0 to 1; false stops
/// @return what `learn` returns; EmulatorError::Cancelled after a stop
[[nodiscard]] base::Result<TrainTestMatrix> trainAndTest(
    std::span<const Course> courses, const LearnSettings& settings, base::Executor& executor,
    const std::function<bool(double)>& progress = {});

/// How much each parameter says about the objective of a candidate.
struct Importance {
  std::string design;
  std::array<double, kParameterCount> share{};  ///< of all, of p1 to p34; their sum is 1
  double explainedShare = 0.0;                  ///< of the variance of the objectives
};

/// @source [P2] section 3.2
/// @deviation The output is the logarithm of Q, not Q: candidates that ran away have a Q that says
/// nothing but this, and would be all that the trees see. They count as the worst stable one. The
/// importances are given as shares, because Q differs between designs by orders of magnitude.
[[nodiscard]] Importance importanceOf(const Learning& learning,
                                      const BoostingSettings& settings = {});

/// One box of a box plot. @source [P2] Figure 9
struct ImportanceSpread {
  int index = 0;  ///< of p_i
  double mean = 0.0;
  double min = 0.0;
  double lowerQuartile = 0.0;
  double median = 0.0;
  double upperQuartile = 0.0;
  double max = 0.0;
};

/// Over designs; the most important on average first.
/// @pre not empty
[[nodiscard]] std::vector<ImportanceSpread> rankByImportance(std::span<const Importance> designs);

}  // namespace rivulet::emulator::paper
