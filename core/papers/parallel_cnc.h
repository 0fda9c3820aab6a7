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
  double preemptions = 0.0;    ///< of all tasks, in the steps that they completed
  double releases = 0.0;       ///< times that position control became ready
  double releasesAtEnd = 0.0;  ///< of these at an instant at which some task ended
};

/// @param seconds  simulated time
/// @return the errors of petri::loadNet
[[nodiscard]] base::Result<ParallelRun> runParallelCnc(const petri::ParameterValues& parameters,
                                                       double seconds);

/// One way to read Table 1 of [P3], which gives all of tasks 1 to 5 the priority 3 while its text
/// orders them, an execution of 10 ms within a cycle of 5 ms, and no number of processors.
struct Figure13Reading {
  bool asPrinted = true;         ///< priority 3 for tasks 1 to 5, ties by ID; else ordered
  petri::Word executionMs = 10;  ///< of tasks 1 to 5
  petri::Word taskCycleMs = 0;   ///< of tasks 2 to 5; 0: as soon as there is data
  petri::Word processors = 5;
};

/// All of them: printed or ordered priorities, 10 or 5 ms, 4 to 6 processors.
[[nodiscard]] std::vector<Figure13Reading> figure13Readings();

inline constexpr std::array<petri::Word, 3> kFigure13CyclesMs{2, 10, 15};  ///< of position control

/// Parameters of the net for a reading. @param dataFlow  the policy; else task dependency
[[nodiscard]] petri::ParameterValues figure13Parameters(const Figure13Reading& reading,
                                                        petri::Word cycleMs, bool dataFlow);

/// The runs of a reading, by cycle of position control.
struct Figure13Runs {
  std::array<ParallelRun, kFigure13CyclesMs.size()> byDependency;
  std::array<ParallelRun, kFigure13CyclesMs.size()> byDataFlow;
};
[[nodiscard]] base::Result<Figure13Runs> runFigure13(const Figure13Reading& reading);

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
