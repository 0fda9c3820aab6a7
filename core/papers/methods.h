// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Comparison of the streaming methods: same contours, same machine, same access.
/// @threadsafety pure; jobs go through the executor of the options.
#pragma once

#include "papers/catalogue.h"

namespace rivulet::papers {

/// How fast each method can be without an error, and its cost in pauses and access.
[[nodiscard]] base::Result<Experiment> runMethods(const ExperimentOptions& options);

}  // namespace rivulet::papers
