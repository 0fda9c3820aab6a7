// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Experiments with whole runs in virtual time: Fig. 3 and 4 of [P1], its method 2 at tiny
/// distances, and the choice of δ. @threadsafety pure.
#pragma once

#include "papers/catalogue.h"

namespace rivulet::papers {

/// Standstills of both methods.
[[nodiscard]] base::Result<Experiment> runFigure3(const ExperimentOptions& options);
/// Smallest d_min over the feed, method position, and equation (1).
[[nodiscard]] base::Result<Experiment> runFigure4(const ExperimentOptions& options);
/// Method signal with steps down to 0.001 mm.
[[nodiscard]] base::Result<Experiment> runMethod2(const ExperimentOptions& options);
/// Probability of an error over δ, method position.
[[nodiscard]] base::Result<Experiment> runDelta(const ExperimentOptions& options);

}  // namespace rivulet::papers
