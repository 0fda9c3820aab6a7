// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Equations (1) to (3) of [P1] compared with whole runs: their predictions, the results of the
/// runs, and the factor by which each equation would have to be changed to be right.
/// @threadsafety pure; the runs go through the executor.
#pragma once

#include <cstdint>

#include "base/executor.h"
#include "base/result.h"
#include "forecast/region.h"
#include "papers/experiment.h"

namespace rivulet::papers {

struct EquationsOptions {
  std::size_t contours = 8;        ///< drawn contours per combination of d_min, N and δ
  std::size_t runsPerPoint = 5;    ///< runs per contour and feed
  std::size_t pointsPerRun = 120;  ///< points of a contour
  std::uint64_t seed = 1;
};

/// @param machine  e.g. the preset dmu75
/// @param progress see RegionProgress; cancelled: the experiment says so in its notes and fails
/// @return ExperimentError::OnlyShare; why a run could not be executed, if only a share was done
[[nodiscard]] base::Result<Experiment> runEquations(const EquationsOptions& options,
                                                    const machine::MachineConfig& machine,
                                                    base::Executor& executor,
                                                    const forecast::RegionProgress& progress = {});

}  // namespace rivulet::papers
