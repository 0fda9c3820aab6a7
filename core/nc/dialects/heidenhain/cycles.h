// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The fixed cycles and point patterns of Heidenhain as the steps they consist of. Rules from the
/// TNC 640 User's Manual Cycle Programming, chapters "Drilling", "Tapping / Thread Milling" and
/// "Pattern Definitions"; old cycles from the iTNC 530 User's Manual Cycles. @threadsafety pure.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "nc/dialects/heidenhain/scanner.h"

namespace rivulet::nc::heidenhain {

/// What is not given as a number: FMAX in a cycle.
inline constexpr double kFeedMax = 99999.0;

/// The cycle that has been defined last.
struct CycleDefinition {
  int number = 0;                            ///< 0: none
  std::map<int, double> values;              ///< of the old form: 1.3 PECKG 5 is 3 → 5
  std::map<int, double> feeds;               ///< of the old form: F of a line
  std::map<int, double> turns;               ///< of the old form: DR of a line, 1 or -1
  std::set<std::string, std::less<>> named;  ///< parameters in its block
};

/// What the cycle finds when it is called. Programmed coordinates and units.
struct CycleSituation {
  const Parameters& parameters;
  base::Vec3 at;
  std::size_t toolAxis = 2;
  double spindlePerMin = 0.0;
  double surfaceShift = 0.0;  ///< Z of CYCL CALL POS, which acts as a datum shift
  double millimetre = 1.0;    ///< in the unit of the program
  /// Of a pattern, in place of the cycle's own (Cycles 220 and 221).
  std::optional<double> setUp;
  std::optional<double> surface;
  std::optional<double> secondSetUp;
};

struct CycleStep {
  enum class Kind { Rapid, Feed, Dwell, Function, Tap, Bore };
  Kind kind = Kind::Rapid;
  base::Vec3 to{};             ///< of Rapid and Feed, and the depth of Tap and Bore
  double feed = 0.0;           ///< per minute
  double seconds = 0.0;        ///< of Dwell, Tap and Bore
  int function = 0;            ///< of Function: an M function; 0: none
  double spindlePerMin = 0.0;  ///< of Function; 0: as before
  bool isLeftHanded = false;   ///< of Tap
  double stroke = 0.0;         ///< of Tap: the chip breaks after so much; 0: never
  double back = 0.0;           ///< of Tap: so far back then; 0: out of the hole
  base::Vec3 aside{};          ///< of Bore: how the edge leaves the wall
  double degrees = 0.0;        ///< of Bore: where the spindle stands then
  double backFeed = 0.0;       ///< of Bore: out of the hole, per minute
};

[[nodiscard]] bool isPattern(int cycle);
/// Cycles that move where they are called.
[[nodiscard]] bool isKnownCycle(int cycle);
/// True if the definition alone does nothing: the cycle acts where it is called, or holds data for
/// one that is called. Others act at once: they turn axes, probe, or set what is not known here.
[[nodiscard]] bool waitsForCall(int cycle);

/// @return fault CycleNotRun, ValueMissing and the like: it cannot be executed
[[nodiscard]] Expected<std::vector<CycleStep>> stepsOf(const CycleDefinition& cycle,
                                                       const CycleSituation& situation);

/// Cycles 220 and 221.
struct Pattern {
  std::vector<base::Vec3> points;  ///< programmed; the tool axis is that of the situation
  double setUp = 0.0;
  double surface = 0.0;
  double secondSetUp = 0.0;
  bool risesBetween = true;  ///< Q301: to the second set-up clearance
};
[[nodiscard]] Expected<Pattern> patternOf(int cycle, const CycleSituation& situation);

}  // namespace rivulet::nc::heidenhain
