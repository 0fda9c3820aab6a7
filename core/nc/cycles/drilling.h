// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The drilling cycles of SINUMERIK as the steps they consist of: CYCLE81 to CYCLE89, CYCLE840, and
/// the patterns of holes HOLES1, HOLES2, CYCLE801 and CYCLE802. Whoever executes a program makes
/// motions of the steps. Parameters as in the Cycles Programming Manual of the 840D (PGZ); what a
/// newer control adds behind them is not looked at, except where `expandCycle` says so.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/vec3.h"

namespace rivulet::nc {

/// What the cycle finds when it is called. Programmed coordinates, mm.
struct CycleStart {
  base::Vec3 positionMm;
  std::size_t planeFirstAxis = 0;  ///< 0: G17, 2: G18, 1: G19
  double lengthFactor = 1.0;       ///< mm per unit of the parameters
  double spindlePerMin = 0.0;      ///< S
  double toolRadiusMm = 0.0;
};

struct CycleStep {
  enum class Kind { Rapid, Feed, Dwell, Spindle };
  Kind kind = Kind::Rapid;
  base::Vec3 toMm{};         ///< of Rapid and Feed: all three axes, programmed coordinates
  double feedFactor = 1.0;   ///< of the programmed feed
  double feedMmPerS = 0.0;   ///< 0: the programmed feed; else it does not count
  double seconds = 0.0;      ///< of Dwell
  int function = 0;          ///< of Spindle: M3, M4, M5, M19, and M0
  double spindlePerMin = 0;  ///< of Spindle; 0: as before
};

[[nodiscard]] inline bool moves(const CycleStep& step) {
  return step.kind == CycleStep::Kind::Rapid || step.kind == CycleStep::Kind::Feed;
}

/// Why a cycle cannot be executed.
struct CycleFault {
  int alarm = 0;          ///< of the control
  std::string parameter;  ///< the one that is wrong
};
inline constexpr int kReferencePlaneWrong = 61101;
inline constexpr int kSpindleDirectionMissing = 61102;
inline constexpr int kFirstDepthWrong = 61107;
inline constexpr int kPitchWrong = 61001;

/// Nothing: the parameter is left out.
using CycleArguments = std::span<const std::optional<double>>;

/// @param name  upper case
[[nodiscard]] bool isDrillingCycle(std::string_view name);
[[nodiscard]] bool isHolePattern(std::string_view name);

/// The steps of a drilling cycle where the tool stands. A deep hole whose strokes get smaller by a
/// fixed amount ends with two equal strokes as soon as the rest is less than two strokes; that the
/// control does so also before the smallest stroke is reached is assumed.
/// @param name  isDrillingCycle
[[nodiscard]] tl::expected<std::vector<CycleStep>, CycleFault> expandCycle(std::string_view name,
                                                                           CycleArguments arguments,
                                                                           const CycleStart& start);

/// Where the holes of a pattern are, in the order of drilling: HOLES1 begins at the nearer end.
/// CYCLE801 goes to and fro, row by row: in which order the control drills them is assumed. The
/// third coordinate is that of the start. @param name  isHolePattern
[[nodiscard]] std::vector<base::Vec3> holesOf(std::string_view name, CycleArguments arguments,
                                              const CycleStart& start);

}  // namespace rivulet::nc
