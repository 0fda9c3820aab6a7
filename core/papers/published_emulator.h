// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The emulator of [P2] as published, learned from recordings of the designs G1, G2 and G3: each
/// figure and table of the paper's section 3 with ours beside it, and what models score that have
/// learned nothing; the same on a machine that they fail by far. @threadsafety blocks its caller;
/// emulator runs go to the caller's executor.
#pragma once

#include <filesystem>
#include <functional>

#include "base/executor.h"
#include "base/result.h"
#include "emulator/paper/genetic.h"
#include "papers/experiment.h"

namespace rivulet::papers {

struct PublishedEmulatorOptions {
  emulator::paper::GeneticSettings genetic{};  ///< its seed is the first one
  std::size_t seeds = 1;                       ///< each table is learned so often, >= 1
  /// Generations of the second learning, which varies the ten most important parameters only.
  int generationsOfTen = 25;
  /// Share done, 0 to 1; false stops.
  std::function<bool(double)> progress{};
};

/// Set points are planned from the programs, as the paper's are; actual positions and speeds are
/// those that an OPC UA client saw.
/// @param folder  with `programs`, `data` and `data/opcua` (see recorded_run.h)
/// @return training::RecordedRunError, EmulatorError
[[nodiscard]] base::Result<Experiment> runPublishedEmulator(
    const std::filesystem::path& folder, base::Executor& executor,
    const PublishedEmulatorOptions& options);

}  // namespace rivulet::papers
