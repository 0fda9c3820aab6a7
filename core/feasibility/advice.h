// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What could be changed so that a program streams faster, or at all: one change at a time, each
/// with the verdict before and after it. @threadsafety pure.
#pragma once

#include <functional>
#include <vector>

#include "feasibility/verdict.h"

namespace rivulet::feasibility {

/// What gains less is not worth a change.
inline constexpr double kAdviceGainMin = 1.05;

/// The quantity that is changed.
enum class AdviceKind { Feed, PointsPerLoop, Delta, Method };

struct Advice {
  AdviceKind kind = AdviceKind::Feed;
  OperatingPoint before;
  OperatingPoint after;
  double feedMmPerSMaxBefore = 0.0;  ///< largest feed, as `Verdict` has it
  double feedMmPerSMaxAfter = 0.0;

  /// How much faster a run can be. A change of the feed: against the feed of before; else by the
  /// largest feeds. Below 1 for a feed that has to be lowered.
  [[nodiscard]] double gain() const;
};

struct AdviceQuestion {
  OperatingPoint operatingPoint;
  AccessModel access;
  SafetyFactors safety;
  int pointsPerLoopMax = 0;                 ///< largest N that fits; below 2: N is not changed
  std::vector<base::MethodKind> methods{};  ///< that may be chosen instead
  /// With the feeds of the program: that of its fastest move at 100 %, mm/s, which all feeds here
  /// refer to; points carry their feeds at 100 %. 0: one feed for all moves
  double fullFeedMmPerS = 0.0;
  /// What else changes with N or the method, as the cells of a point. Empty: nothing
  std::function<OperatingPoint(const OperatingPoint&)> complete{};
};

/// The greatest gain first; a feed that has to be lowered comes before all others.
void sortByGain(std::vector<Advice>& list);

/// Changes that help, sorted by gain. Of each kind at most one, of methods each. Changes by less
/// than `kAdviceGainMin` are left out.
/// @param points  as streamed, at least 2
/// @param goOn  asked now and then; false: an empty list is returned
/// @return empty also if there is no verdict on the operating point
/// @threadsafety pure; O(points) for each N
[[nodiscard]] std::vector<Advice> advise(const std::vector<gcode::StreamPoint>& points,
                                         const AdviceQuestion& question,
                                         const std::function<bool()>& goOn = {});

}  // namespace rivulet::feasibility
