// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Experiments on the cost of access: Table I and Fig. 2 of [P1], and its subscriptions.
/// @threadsafety pure.
#pragma once

#include "papers/catalogue.h"

namespace rivulet::papers {

/// Read and write 1, 20 and 100 R-parameters, one by one and in a list.
[[nodiscard]] base::Result<Experiment> runTable1(const ExperimentOptions& options);
[[nodiscard]] base::Result<Experiment> runTable1On(const Endpoint& endpoint,
                                                   const ExperimentOptions& options);

/// How long values written back to back are held, as the NC sees them.
[[nodiscard]] base::Result<Experiment> runFigure2(const ExperimentOptions& options);
/// The same on a connection: a program on the control records by synchronized actions when the
/// value changes. @return Failed if the program cannot be run, or the error of the link
[[nodiscard]] base::Result<Experiment> runFigure2On(const Endpoint& endpoint,
                                                    const ExperimentOptions& options);

/// How many of ten quick changes a subscription sees.
[[nodiscard]] base::Result<Experiment> runSubscription(const ExperimentOptions& options);

}  // namespace rivulet::papers
