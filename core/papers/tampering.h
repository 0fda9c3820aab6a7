// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A learned emulator as a guard: somebody shifts the axes of a virtual machine by 0.05 mm, openly
/// or while reporting made-up positions. How often is it noticed, and how often is there a false
/// alarm?
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <functional>

#include "base/result.h"
#include "papers/experiment.h"

namespace rivulet::papers {

struct TamperingOptions {
  std::size_t draws = 400;  ///< runs of each kind, each with its own seed
  /// Share done, 0 to 1; false stops.
  std::function<bool(double)> progress{};
};

/// @return errors of emulator and machine; ExperimentError::Cancelled
[[nodiscard]] base::Result<Experiment> runTampering(const TamperingOptions& options);

}  // namespace rivulet::papers
