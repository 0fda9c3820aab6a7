// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Programs that are proposed to learn an emulator from, against the designs of [P2], on a virtual
/// machine with known axes. @threadsafety pure.
#pragma once

#include <cstddef>
#include <functional>

#include "base/result.h"
#include "emulator/design.h"
#include "machine/config.h"
#include "papers/experiment.h"

namespace rivulet::papers {

/// Set points by the look-ahead of a virtual machine.
[[nodiscard]] emulator::PlanMoves planMovesOn(const machine::MachineConfig& config);

struct DesignStudyOptions {
  std::size_t draws = 12;  ///< how often is learned from each program, each with its own noise
  int exchanges = 300;     ///< of the search
  /// Share done, 0 to 1; false stops.
  std::function<bool(double)> progress{};
};

/// @return errors of the emulator; ExperimentError::Cancelled
[[nodiscard]] base::Result<Experiment> runDesignStudy(const DesignStudyOptions& options);

}  // namespace rivulet::papers
