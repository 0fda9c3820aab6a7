// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which check of the experiments of [P1] catches which wrong machine or method. A check that no
/// wrong machine fails shows nothing, and a wrong machine that no check catches would pass for the
/// paper's. @threadsafety pure; jobs go through the executor of the options.
#pragma once

#include "base/result.h"
#include "papers/catalogue.h"

namespace rivulet::papers {

/// Runs the experiments with few runs each on the machine of the options and on each wrong one.
/// @param options  with one seed, the longest experiment looks only at what no other has caught
/// @return Cancelled, or the error of an experiment
[[nodiscard]] base::Result<Experiment> runWrongMachines(const ExperimentOptions& options);

}  // namespace rivulet::papers
