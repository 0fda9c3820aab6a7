// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The simulation of [P3] (Figure 13) with its net: levels of the five buffers for three cycles of
/// position control under both scheduling policies. @threadsafety pure.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "papers/experiment.h"
#include "pipeline/figure13.h"
#include "pipeline/task.h"

namespace rivulet::papers {

/// One run of the net of [P3].
struct ParallelRun {
  using Level = pipeline::BufferLevel;
  std::array<std::vector<Level>, pipeline::kBufferCount> levels;
  std::array<double, pipeline::kBufferCount> mean{};        ///< over time
  std::array<double, pipeline::kBufferCount> emptyShare{};  ///< of the time
  double setPoints = 0.0;                                   ///< sent by position control
  double waitingShare = 0.0;  ///< of the time, position control for data
  double timeouts = 0.0;
  double preemptions = 0.0;    ///< of all tasks, in the steps that they completed
  double releases = 0.0;       ///< times that position control became ready
  double releasesAtEnd = 0.0;  ///< of these at an instant at which some task ended
};

/// @param seconds  simulated time
/// @return the errors of petri::loadNet
[[nodiscard]] base::Result<ParallelRun> runParallelCnc(const petri::ParameterValues& parameters,
                                                       double seconds);

/// The runs of a reading, by cycle of position control.
struct Figure13Runs {
  std::array<ParallelRun, pipeline::kFigure13CyclesMs.size()> byDependency;
  std::array<ParallelRun, pipeline::kFigure13CyclesMs.size()> byDataFlow;
};
[[nodiscard]] base::Result<Figure13Runs> runFigure13(const pipeline::Figure13Reading& reading);

/// What [P3] says of its Figure 13, and whether runs show it.
struct Figure13Finding {
  const char* what = "";
  std::string ours;  ///< the figures that decide
  bool isSupported = false;
};
/// Always the same findings in the same order. @source [P3] section III.B
[[nodiscard]] std::vector<Figure13Finding> findingsOf(const Figure13Runs& runs);

/// Figure 13 and the findings of [P3], each with our figure, under all readings.
[[nodiscard]] base::Result<Experiment> parallelCncExperiment();

}  // namespace rivulet::papers
