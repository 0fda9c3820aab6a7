// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Follows a trace along the programmed path, without a recording of the blocks: which points were
/// executed, repeated or skipped, and where the motion left the path. Only positions and times are
/// used. @threadsafety pure.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/id.h"
#include "base/instant.h"
#include "trace/analysis/program_path.h"
#include "trace/motion.h"

namespace rivulet::trace {

struct PathMatchOptions {
  /// The motion is on the path within this distance. Programmed points nearer to each other cannot
  /// be told apart.
  double toleranceMm = 0.05;
};

/// What the trace shows of the place of one sample.
struct MatchedSample {
  std::size_t sample = 0;  ///< of the motion
  PathPlace place;         ///< the nearest place of the part of the path that is executed
  bool isOnPath = false;   ///< within the tolerance
};

struct PathFault {
  enum class Kind { Repeated, Skipped, Foreign } kind = Kind::Foreign;
  base::PointIndex point;  ///< repeated or skipped; Foreign: the point due
  base::LineNumber line;   ///< of the program, of that point
  base::Instant at{};
  base::Vec3 placeMm;  ///< where the tool was
};

struct PathMatch {
  bool judged = false;       ///< false: the trace or the program holds no motion
  std::size_t points = 0;    ///< programmed points (ends of blocks)
  std::size_t executed = 0;  ///< passed within the tolerance, or rounded
  /// Passed between two samples that are too far apart to show by which way; also points that the
  /// tolerance does not tell from their neighbours where a fault is.
  std::size_t undecided = 0;
  std::size_t repeated = 0;
  std::size_t skipped = 0;
  std::size_t foreign = 0;        ///< stretches off the path
  double onPathShare = 0.0;       ///< of the length of the motion
  std::vector<PathFault> faults;  ///< at most 100, in time order
  /// Where the motion left the path for good: the program does not belong to the rest.
  std::optional<PathFault> departure;
  std::vector<MatchedSample> samples;  ///< those that moved, in time order

  [[nodiscard]] bool isFaultless() const {
    return judged && repeated + skipped + foreign == 0 && !departure;
  }
};

/// Finds the most plausible course along the path (a hidden Markov model, as in map matching):
/// places near each sample compete; steps that fit the motion cost nothing, jumps and stretches off
/// the path cost. O(samples · places).
[[nodiscard]] PathMatch matchPath(const Motion& motion, const ProgramPath& path,
                                  const PathMatchOptions& options = {});

}  // namespace rivulet::trace
