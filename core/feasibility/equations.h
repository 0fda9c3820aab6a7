// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The inequalities of [P1], each solved for the largest feed and as a margin. Pure functions.
/// A margin is (right side) / (left side): the condition holds when it exceeds 1, and the margin
/// says how many times faster the feed could be.
#pragma once

#include "base/instant.h"
#include "feasibility/symbols.h"

namespace rivulet::feasibility {

/// Bounds of Δt, the client loop of method 1: three reads, and the writes of a point when one has
/// been passed.
struct PollTime {
  base::Duration min;  ///< reads only (12.9 ms with 4.3 ms per node)
  base::Duration max;  ///< reads and writes (25.8 ms)
};

/// @param accessTime one OPC UA access of one node, > 0 @param cellsPerPoint  axes that are
/// streamed
/// @threadsafety pure.  @source [P1] V.B.a  @deviation number of axes (3 = as published)
[[nodiscard]] PollTime pollTime(base::Duration accessTime, int cellsPerPoint = kPaperAxes);

/// Margin of F·Δt < d_min. @param feedMmPerS > 0 @param pointDistanceMmMin >= 0
/// @param safetyFactor multiplies the left side, >= 1
/// @threadsafety pure.  @source [P1] eq. (1)  @deviation safety factor added (1 = as published)
[[nodiscard]] double pointDistanceMargin(double feedMmPerS, base::Duration pollTime,
                                         double pointDistanceMmMin, double safetyFactor);

/// Margin of F·Δt < 2·δ. @param deltaMm > 0
/// @threadsafety pure.  @source [P1] eq. (2)  @deviation safety factor: the paper advises 1.5
[[nodiscard]] double deltaMargin(double feedMmPerS, base::Duration pollTime, double deltaMm,
                                 double safetyFactor);

/// Margin of F·t·(A⌊N/2⌋+1) < ⌊N/2⌋·d_min with A axes. @param pointsPerLoop N >= 2
/// @threadsafety pure.  @source [P1] eq. (3)
/// @deviation safety factor (1 = as published) and number of axes (3 = as published) added
[[nodiscard]] double windowMargin(double feedMmPerS, base::Duration accessTime, int pointsPerLoop,
                                  double pointDistanceMmMin, double safetyFactor,
                                  int cellsPerPoint = kPaperAxes);

/// Like `windowMargin`, with the real path length d_min^N of the program instead of its lower bound
/// ⌊N/2⌋·d_min, as [P1] VI.A proposes. The standstill is not counted: conservative.
/// @param windowLengthMmMin  smallest path length of ⌊N/2⌋ consecutive steps, mm
/// @threadsafety pure.  @source [P1] VI.A
[[nodiscard]] double realWindowMargin(double feedMmPerS, base::Duration accessTime,
                                      int pointsPerLoop, double windowLengthMmMin,
                                      double safetyFactor, int cellsPerPoint = kPaperAxes);

/// Method window: margin of F·t·(A·M+5) < length of a window of M points with A axes. Of these
/// accesses A·M+3 carry the window with its count, feed and check number, one its number, and one
/// reads whether the control has copied the previous one. Below 1 the machine waits; it never
/// repeats. The standstill is not counted: conservative.
/// @param pointsPerWindow  M >= 1 @param windowLengthMmMin  of M consecutive steps, mm
/// @param cellsOfFirst  see `TurnSize`
/// @threadsafety pure.
[[nodiscard]] double reachMargin(double feedMmPerS, base::Duration accessTime, int pointsPerWindow,
                                 double windowLengthMmMin, double safetyFactor,
                                 int cellsPerPoint = kPaperAxes, int cellsOfFirst = 0);

}  // namespace rivulet::feasibility
