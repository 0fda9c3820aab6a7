// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The simulation of [P3] (Figure 13) with its net: levels of the five buffers for three cycles of
/// position control under both scheduling policies. @threadsafety pure.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "papers/experiment.h"
#include "petri/net_file.h"
#include "petri/simulator.h"

namespace rivulet::papers {

inline constexpr std::size_t kBufferCount = 5;

inline constexpr double kFigure13S = 3.0;  ///< simulated time

/// Parameters of the net for Figure 13. @param policy  0: task dependency; 1: data flow
[[nodiscard]] petri::ParameterValues figure13Parameters(petri::Word cycleMs, petri::Word policy);

/// Level of a buffer, as the net records it (DREC).
struct BufferLevel {
  std::size_t buffer = 0;  ///< 0: B1
  double timeS = 0.0;
  double level = 0.0;  ///< from this time on
};

/// Finds levels among what the net of [P3] records. @threadsafety pure.
class LevelReader {
 public:
  /// @param net  of [P3]
  explicit LevelReader(const petri::Net& net);
  [[nodiscard]] std::optional<BufferLevel> read(const petri::Recorded& recorded) const;

 private:
  std::size_t m_place;
  std::size_t m_time;
  std::size_t m_number;
  std::size_t m_data;
};

/// One run of the net of [P3].
struct ParallelRun {
  using Level = BufferLevel;
  std::array<std::vector<Level>, kBufferCount> levels;
  std::array<double, kBufferCount> mean{};        ///< over time
  std::array<double, kBufferCount> emptyShare{};  ///< of the time
  double setPoints = 0.0;                         ///< sent by position control
  double waitingShare = 0.0;                      ///< of the time, position control for data
  double timeouts = 0.0;
  double preemptions = 0.0;  ///< of all tasks
};

/// @param seconds  simulated time
/// @return the errors of petri::loadNet
[[nodiscard]] base::Result<ParallelRun> runParallelCnc(const petri::ParameterValues& parameters,
                                                       double seconds);

/// Figure 13 and the findings of [P3], each with our figure.
[[nodiscard]] base::Result<Experiment> parallelCncExperiment();

}  // namespace rivulet::papers
