// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Will this program stream without wrong motion, and with method window without waiting? Names the
/// limiting equation, its place in the program and the change that would help.
/// @threadsafety pure.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/id.h"
#include "base/instant.h"
#include "base/method_kind.h"
#include "base/result.h"
#include "feasibility/access_model.h"
#include "gcode/trajectory.h"

namespace rivulet::feasibility {

enum class FeasibilityError {
  FeedNotPositive = 1,
  DeltaNotPositive,
  TooFewPointsPerLoop,  ///< N < 2
  NothingKnown,         ///< method file: the cost of a transfer is not known for any control
};

[[nodiscard]] std::error_code make_error_code(FeasibilityError code);

enum class Equation {
  PointDistance,  ///< (1) of [P1]
  Delta,          ///< (2) of [P1]
  Window,         ///< (3) of [P1], with ⌊N/2⌋·d_min
  RealWindow,     ///< (3) with the program's real d_min^N
  Reach,          ///< method window: a window is delivered in the time of executing another
  Machine,        ///< no equation: what a machine would do, see `forecast::judgeOn`
};

/// "(1)", "(2)", "(3)", "(3) with d_min^N", "reach", "machine".
[[nodiscard]] std::string_view equationLabel(Equation equation);

struct OperatingPoint {
  base::MethodKind method = base::kDefaultMethod;
  int pointsPerLoop = 7;  ///< N, >= 2; method window: points per window
  double deltaMm = 0.3;   ///< δ; used by method position only
  double feedMmPerS = 500.0 / 60.0;
  int cellsPerPoint = kPaperAxes;  ///< `templates::cellsPerPoint`
  bool feedPerPoint = false;       ///< windows need not end where the feed changes
  int cellsOfFirst = 0;            ///< `templates::cellsOfFirstPoint`; above 0: packed

  [[nodiscard]] TurnSize turn() const {
    return {method, pointsPerLoop, cellsPerPoint, cellsOfFirst};
  }
};

/// Each multiplies the left side of its inequality; 1 is the inequality as published.
struct SafetyFactors {
  double pointDistance = 1.0;
  double delta = 1.5;  ///< [P1] VI.A
  double window = 1.0;
};

/// A place in the CAM program, from the block that ends at the first point to that of the last.
struct Place {
  base::PointIndex point;  ///< index of the first of the points, into the streamed points
  base::LineNumber firstLine;
  base::LineNumber lastLine;
  std::size_t steps = 1;  ///< moves between them
};

struct ProgramDistances {
  double pointDistanceMmMin = 0.0;  ///< d_min
  Place pointDistancePlace;
  int windowSteps = 0;             ///< ⌊N/2⌋
  double windowLengthMmMin = 0.0;  ///< d_min^N
  Place windowPlace;
};

/// Where the program is closest to the limit of a method.
[[nodiscard]] const Place& tightestPlace(const ProgramDistances& distances,
                                         base::MethodKind method);

/// d_min and d_min^N of the streamed points. @param points at least 2
/// @param pointsPerLoop N >= 2; if the list has fewer than ⌊N/2⌋ steps, its whole length counts
/// @param referenceMmPerS  > 0: a move with a feed of its own counts as long as this feed goes in
/// its time, so that the equations hold for the whole program at this one feed; 0: real lengths
/// @threadsafety pure; O(points).
[[nodiscard]] ProgramDistances programDistances(const std::vector<gcode::StreamPoint>& points,
                                                int pointsPerLoop, double referenceMmPerS = 0.0);

struct Condition {
  Equation equation = Equation::PointDistance;
  double margin = 0.0;  ///< > 1: holds; see equations.h
  bool decides = true;  ///< false: shown for information, does not count for the verdict
  std::optional<Place> place;
};

struct Verdict {
  bool feasible = false;  ///< no wrong motion; method window: always
  /// Method window: the client is slower than the machine, which will sometimes wait for it.
  bool waits = false;
  Condition limiting;  ///< the deciding condition with the smallest margin
  std::vector<Condition> conditions;
  /// Largest feed at which all deciding conditions hold; method window: without waiting.
  double feedMmPerSMax = 0.0;
  double deltaMmMin = 0.0;      ///< smallest δ at this feed (method position; else 0)
  base::Duration accessTime{};  ///< t as used in the equations: see `AccessModel`
  bool accessMeasured = false;  ///< from a calibration, else assumed
};

/// Position is decided by (1) and (2) with the longer poll time; signal by (3). If the program is
/// known, (3) with its real d_min^N decides for signal and (3) as published is shown. Method window
/// is always feasible: the question is how fast it can be, and the reach answers it.
/// @param distances of the loaded program, or d_min alone in `pointDistanceMmMin` with
///        windowSteps = 0 for a program that is not loaded
/// @return FeedNotPositive, DeltaNotPositive, TooFewPointsPerLoop
[[nodiscard]] base::Result<Verdict> judge(const OperatingPoint& operatingPoint,
                                          const ProgramDistances& distances,
                                          const AccessModel& access = {},
                                          const SafetyFactors& safety = {});

}  // namespace rivulet::feasibility

template <>
struct std::is_error_code_enum<rivulet::feasibility::FeasibilityError> : std::true_type {};
