// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Figure 13 of [P3] in its net: the parameters of a run under each reading of Table 1, and the
/// levels of the buffers among what the net records. @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "petri/net_file.h"
#include "petri/simulator.h"

namespace rivulet::pipeline {

inline constexpr double kFigure13S = 3.0;  ///< simulated time
/// The net counts microseconds.
inline constexpr double kNetUnitsPerS = 1e6;

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

}  // namespace rivulet::pipeline
