// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How far the verdict can be trusted: machines, paths, methods and settings are drawn, the verdict
/// is asked, and the run is made. @threadsafety pure; runs go through the executor of the options.
#pragma once

#include "papers/catalogue.h"

namespace rivulet::papers {

/// Draws for each of the seeds, and seeds where none are asked for.
inline constexpr std::size_t kDrawsPerSeed = 100;
inline constexpr std::size_t kVerdictSeeds = 100;

/// @param options  `machine` is not used: the machines are drawn
/// @return Cancelled, OnlyShare
[[nodiscard]] base::Result<Experiment> runVerdictDraws(const ExperimentOptions& options);

}  // namespace rivulet::papers
