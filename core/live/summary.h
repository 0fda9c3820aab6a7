// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a run with a live source reports beside the counters. @threadsafety plain values.
#pragma once

#include <cstddef>
#include <string>

#include "base/error.h"
#include "base/instant.h"
#include "trace/analysis/statistics.h"

namespace rivulet::live {

struct Summary {
  std::string source;
  std::size_t lines = 0;         ///< read and understood
  std::size_t accepted = 0;      ///< points, without those that were merged
  std::size_t merged = 0;        ///< closer to the point before than agreed
  std::size_t firstMerged = 0;   ///< line of the first of them; 0: none
  std::size_t lastLine = 0;      ///< of the last point that has been executed; 0: none
  bool hasEnded = false;         ///< the source will send nothing more
  base::Error refusal;           ///< why the stream ended; code clear: `end`, or not ended
  std::size_t windows = 0;       ///< taken by the method
  std::size_t shortWindows = 0;  ///< of them sent before they were full, for want of points
  /// From the arrival of a point to the beginning of its move, as the client sees it: when it read
  /// the point, and when it read that the window moves, with the planned times inside the window.
  trace::DurationStatistics delay;
  base::Duration windowTime{};  ///< mean, from the beginning of a window to that of the next
  /// In theory: the first point of a window waits until the window is full, or goes as it is.
  base::Duration leastDelay{};
  /// The same for a source that is always faster than the machine: all buffers are full.
  base::Duration mostDelay{};
};

/// The state of the source, for a display.
struct Level {
  std::size_t lines = 0;
  std::size_t accepted = 0;
  std::size_t waiting = 0;   ///< points that have arrived, but are not executed
  std::size_t capacity = 0;  ///< largest `waiting` before the source is read no further
};

}  // namespace rivulet::live
