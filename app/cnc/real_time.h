// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the system grants of real time: SCHED_FIFO, locked memory, a core of one's own.
/// @threadsafety for the calling thread; `grantsRealTime` from any.
#pragma once

#include <string>
#include <vector>

namespace rivulet::cnc {

struct RealTimeWish {
  int priority = 0;  ///< of SCHED_FIFO, 1 to 99; 0: none
  int core = -1;     ///< -1: any
};

/// Asks for it. @return a sentence for each thing that was not granted; empty: all was
[[nodiscard]] std::vector<std::string> makeRealTime(const RealTimeWish& wish);

/// Whether the system would grant SCHED_FIFO: a thread of its own asks for it and ends.
[[nodiscard]] bool grantsRealTime();

}  // namespace rivulet::cnc
