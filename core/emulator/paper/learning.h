// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Learning the 34 parameters from one run, as [P2] section 2.3 does it. It can be stopped after
/// any generation and continued; for the same seed the result is the same on any number of threads.
/// @threadsafety blocks its caller; emulator runs go to the caller's executor.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/executor.h"
#include "base/result.h"
#include "emulator/paper/course.h"
#include "emulator/paper/emulation.h"
#include "emulator/paper/genetic.h"
#include "emulator/paper/parameters.h"

namespace rivulet::emulator::paper {

struct LearnSettings {
  double lambda = 0.0;  ///< weight of the speeds in the objective, s², >= 0; the paper: 0 and 0.8
  GeneticSettings genetic;
  PlantSettings plant;
};

/// A candidate that was tried.
struct Trial {
  int generation = 0;
  double objective = 0.0;
  Parameters values{};
};

/// A learning run, finished or not; what it takes to continue it.
struct Learning {
  std::string design;  ///< name of the course
  std::string course;  ///< digest of the course and the settings: with others it does not continue
  GeneticState state;
  std::vector<int> varied;       ///< paper's indices of the genes, ascending
  Parameters values{};           ///< the best; parameters not varied are as they were
  std::vector<Trial> trials;     ///< all generations; the elite once, when it was new
  std::vector<double> bestEach;  ///< best objective of generation 0, 1, ...

  [[nodiscard]] double objective() const { return bestEach.back(); }
};

/// Called after each generation, the first included. @return false to stop
using OnGeneration = std::function<bool(const Learning&)>;

/// @param from  to continue
/// @return EmulatorError::BadNumbers if speeds count and the course has none; BadFile if `from`
/// belongs to another course or other settings; Diverged if no candidate was stable
[[nodiscard]] base::Result<Learning> learn(const Course& course, const LearnSettings& settings,
                                           base::Executor& executor,
                                           const OnGeneration& onGeneration = {},
                                           std::optional<Learning> from = {});

/// Goes on with some parameters only, from the last population of a learning run.
/// @param indices  of the paper, each once
/// @return as `learn`
[[nodiscard]] base::Result<Learning> refine(const Course& course, const LearnSettings& settings,
                                            base::Executor& executor, const Learning& learned,
                                            std::vector<int> indices,
                                            const OnGeneration& onGeneration = {});

/// A learning run as text: a heading, then one line for each trial, as CSV that other tools read.
[[nodiscard]] std::string learningText(const Learning& learning);
/// @return EmulatorError::BadFile
[[nodiscard]] base::Result<Learning> parseLearning(std::string_view text);

}  // namespace rivulet::emulator::paper
