// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The independent oracle: was each point executed exactly once, in order? It works from what
/// the control executed and from the list of points alone, and knows nothing of methods, slots
/// or of what the client believes. @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "base/id.h"
#include "gcode/trajectory.h"
#include "trace/control_trace.h"

namespace rivulet::trace {

/// The first faults, for the log and the path view.
struct IntegrityFault {
  enum class Kind { Repeated, Skipped, Foreign } kind = Kind::Repeated;
  base::PointIndex point;  ///< the point repeated or skipped; for Foreign the point due
  base::Instant at{};
};

struct Integrity {
  bool judged = false;       ///< false: no trace of the control was available
  std::size_t executed = 0;  ///< points executed at least once
  std::size_t repeated = 0;  ///< executions beyond the first that moved an axis
  std::size_t skipped = 0;   ///< points never executed though a later one was
  std::size_t foreign = 0;   ///< moving blocks whose end is no point of the program
  std::vector<IntegrityFault> faults;  ///< at most 100, in time order

  [[nodiscard]] bool isFaultless() const { return judged && repeated + skipped + foreign == 0; }
};

/// @param toleranceMm  how far a block's end may lie from its point (numbers in R-parameters are
///        doubles: 1e-6 suffices for the virtual machine)
[[nodiscard]] Integrity judgeIntegrity(const std::vector<gcode::StreamPoint>& points,
                                       const std::vector<ExecutedBlock>& blocks,
                                       double toleranceMm);

}  // namespace rivulet::trace
