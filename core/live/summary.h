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
  std::size_t executed = 0;      ///< of them, as a whole: parts of a divided move do not count
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

enum class SourceState : unsigned char {
  Waiting,    ///< no line has come yet
  Receiving,  ///< or not asked, because as many points wait as there is room for
  Silent,     ///< for a second or longer
  Ended,      ///< by `end`, or by closing where that is the same
  Refused,    ///< see `Level::refusal`
};

/// The state of the source, for a display.
struct Level {
  SourceState state = SourceState::Waiting;
  base::Duration silence{};  ///< since something has come, or since the source was last not asked
  /// The run holds because of the source, and goes on by itself with the next point.
  bool holdsRun = false;
  std::size_t lines = 0;
  std::size_t accepted = 0;
  std::size_t executed = 0;  ///< as `Summary::executed`
  std::size_t merged = 0;
  std::size_t waiting = 0;    ///< points that have arrived, but are not executed
  std::size_t capacity = 0;   ///< largest `waiting` before the source is read no further
  double acceptedPerS = 0.0;  ///< of the last two seconds
  double executedPerS = 0.0;
  std::size_t delays = 0;        ///< points that `delayMedian` and `delayP99` stand for
  base::Duration delayMedian{};  ///< of these, which are the last ones; see `Summary::delay`
  base::Duration delayP99{};
  base::Duration leastDelay{};  ///< see `Summary`; 0: not known yet
  base::Duration mostDelay{};
  base::Error refusal;  ///< as `Summary::refusal`
};

}  // namespace rivulet::live
