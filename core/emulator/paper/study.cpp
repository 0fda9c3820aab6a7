// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/study.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/contract.h"
#include "emulator/emulator_error.h"

namespace rivulet::emulator::paper {

namespace {

/// Between two values where the rank is not whole. @param rank  of the ascending values, 0 to 1
double betweenRanks(const std::vector<double>& ascending, double rank) {
  const double at = rank * static_cast<double>(ascending.size() - 1);
  const auto before = static_cast<std::size_t>(at);
  const std::size_t after = std::min(before + 1, ascending.size() - 1);
  return std::lerp(ascending[before], ascending[after], at - static_cast<double>(before));
}

}  // namespace

base::Result<TrainTestMatrix> trainAndTest(std::span<const Course> courses,
                                           const LearnSettings& settings, base::Executor& executor,
                                           const std::function<bool(double)>& progress) {
  TrainTestMatrix matrix{settings.lambda, {}, {}};
  // A longer course takes accordingly longer.
  double all = 0.0;
  for (const Course& course : courses) {
    all += static_cast<double>(course.referenceMm[kAxisX].size());
  }
  double done = 0.0;
  for (const Course& course : courses) {
    const double ofThis = static_cast<double>(course.referenceMm[kAxisX].size()) / all;
    bool stopped = false;
    auto learned = learn(course, settings, executor, [&](const Learning& learning) {
      const double share = static_cast<double>(learning.state.generation) /
                           static_cast<double>(std::max(settings.genetic.generations, 1));
      stopped = progress && !progress(done + share * ofThis);
      return !stopped;
    });
    if (!learned) {
      return base::fail(learned.error());
    }
    if (stopped) {
      return base::fail(EmulatorError::Cancelled, "Learning was stopped.", course.name);
    }
    done += ofThis;
    matrix.learned.push_back(std::move(*learned));
  }
  for (const Course& course : courses) {
    std::vector<Misfit>& row = matrix.tests.emplace_back();
    for (const Learning& learning : matrix.learned) {
      row.push_back(misfitOf(course, emulate(course, learning.values, settings.plant)));
    }
  }
  return matrix;
}

Importance importanceOf(const Learning& learning, const BoostingSettings& settings) {
  RIVULET_ASSERT(!learning.trials.empty());
  double worst = 0.0;
  double best = kDivergedObjective;
  for (const Trial& trial : learning.trials) {
    if (trial.objective < kDivergedObjective) {
      worst = std::max(worst, trial.objective);
    }
    best = std::min(best, trial.objective);
  }
  // An objective of 0 has no logarithm; only a machine that is an emulator reaches it.
  constexpr double kLeast = 1e-18;
  worst = std::max(worst, std::max(best, kLeast));
  std::vector<double> predictors;
  std::vector<double> outputs;
  for (const Trial& trial : learning.trials) {
    predictors.insert(predictors.end(), trial.values.begin(), trial.values.end());
    outputs.push_back(std::log10(std::clamp(trial.objective, kLeast, worst)));
  }
  const BoostedTrees trees(predictors, kParameterCount, outputs, settings);
  Importance importance;
  importance.design = learning.design;
  importance.explainedShare = trees.explainedShare();
  const double sum = std::accumulate(trees.importance().begin(), trees.importance().end(), 0.0);
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    importance.share[i] = sum > 0.0 ? trees.importance()[i] / sum : 0.0;
  }
  return importance;
}

std::vector<ImportanceSpread> rankByImportance(std::span<const Importance> designs) {
  RIVULET_ASSERT(!designs.empty());
  std::vector<ImportanceSpread> spreads;
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    std::vector<double> shares;
    for (const Importance& one : designs) {
      shares.push_back(one.share[i]);
    }
    std::ranges::sort(shares);
    spreads.push_back(
        {static_cast<int>(i) + 1,
         std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size()),
         shares.front(), betweenRanks(shares, 0.25), betweenRanks(shares, 0.5),
         betweenRanks(shares, 0.75), shares.back()});
  }
  std::ranges::stable_sort(spreads, std::ranges::greater{}, &ImportanceSpread::mean);
  return spreads;
}

}  // namespace rivulet::emulator::paper
