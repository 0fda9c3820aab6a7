// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How well a motion kept to its program: contour error, following error, corners, feed, time lost,
/// vibration. @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/id.h"
#include "base/instant.h"
#include "base/vec3.h"
#include "trace/analysis/path_match.h"
#include "trace/analysis/standstills.h"

namespace rivulet::trace {

/// Distance to the programmed path. In the XY plane it has a sign: positive to the left of the
/// path, seen in its direction.
struct ContourError {
  std::size_t count = 0;  ///< samples; 0: nothing is known
  double maxMm = 0.0;     ///< largest distance
  double rmsMm = 0.0;
  double p95Mm = 0.0;
  double leftMm = 0.0;   ///< farthest to the left, >= 0
  double rightMm = 0.0;  ///< farthest to the right, <= 0
  base::Instant at{};    ///< of the largest
  base::Vec3 placeMm;
  base::LineNumber line;
};

struct FollowingError {
  double maxMm = 0.0;
  double rmsMm = 0.0;
  /// The part that changes its sign with the direction (friction, backlash), full width. Fitted
  /// together with the part that is proportional to the speed. Nothing: the axis did not reverse.
  std::optional<double> reversalMm;
};

/// A programmed point at which the path turns.
struct CornerRounding {
  std::size_t point = 0;
  base::LineNumber line;
  double turnDeg = 0.0;
  double setMm = 0.0;      ///< distance of the corner to the set point's path
  double actualMm = 0.0;   ///< to the actual path
  double mmPerSMin = 0.0;  ///< lowest path speed near the corner
};

struct TimeLost {
  StopCause cause = StopCause::Unknown;
  double seconds = 0.0;
  std::size_t stops = 0;
};

struct FeedKept {
  bool known = false;        ///< the programmed feed is known
  double share = 0.0;        ///< of the path, at 95 % of the programmed feed or more
  double motionS = 0.0;      ///< from the first motion to the last
  double programmedS = 0.0;  ///< the same path at the programmed feed
  double slowS = 0.0;        ///< lost while moving: accelerating, braking, slower than programmed
  std::vector<TimeLost> standing;  ///< lost while standing, per cause
};

struct SpectrumPeak {
  std::size_t axis = 0;
  double hz = 0.0;
  double amplitudeMmPerS2 = 0.0;
};

struct Vibration {
  bool known = false;  ///< the samples are regular, and enough
  std::array<double, base::kAxisCount> jerkRmsMmPerS3{};
  std::vector<SpectrumPeak> peaks;  ///< of the acceleration, the largest first; at most five
};

struct MotionQuality {
  ContourError setContour;
  ContourError actualContour;
  std::array<FollowingError, base::kAxisCount> following{};  ///< set point minus actual position
  bool hasFollowing = false;
  std::vector<CornerRounding> corners;
  FeedKept feed;
  Vibration vibration;  ///< of the actual position, or of the set point
};

/// Distance of one sample to the programmed path.
struct ContourDistance {
  std::size_t sample = 0;       ///< of the motion
  std::size_t segment = 0;      ///< of the path
  double lengthMm = 0.0;        ///< of the path up to there
  double setMm = 0.0;           ///< of the set point, if there is one
  double actualMm = 0.0;        ///< of the actual position, if there is one
  double actualLengthMm = 0.0;  ///< of the path up to where the actual position is
};
/// Those of the contour errors, in time order.
[[nodiscard]] std::vector<ContourDistance> contourDistances(const Motion& motion,
                                                            const ProgramPath& path,
                                                            const PathMatch& match);

/// @param path, match  null: the program is not known; then there are no contour errors and corners
[[nodiscard]] MotionQuality judgeMotion(const Motion& motion, const std::vector<Standstill>& stops,
                                        const ProgramPath* path, const PathMatch* match);

}  // namespace rivulet::trace
