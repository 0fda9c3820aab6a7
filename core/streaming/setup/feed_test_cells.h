// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The R-parameters of the test of the feed cell: the contract between its program and its client.
/// @threadsafety pure.
#pragma once

#include <optional>

#include "streaming/setup/feed_test.h"

namespace rivulet::streaming {

/// R-parameters of the test, counted from its first.
enum class TestCell {
  Wanted,     ///< client: the feed cell
  Acts,       ///< main run: what it makes of it
  Beat,       ///< client: its sign of life
  Command,    ///< client: number of the move that it wants
  Done,       ///< program: number of the last move
  Round,      ///< client: 2 at the start without a feed cell
  Layout,     ///< program: its number
  Stands,     ///< client: 1 while the axis must not move
  Moved,      ///< main run: cycles in which it moved nevertheless
  Late,       ///< main run: cycles at full speed since 0 is wanted
  Moving,     ///< main run: cycles with motion since the move began
  Step,       ///< main run: way of the set point in a cycle
  Place,      ///< main run: the set point in the cycle before
  Reference,  ///< main run: square of the step at the override that was wanted last
  Lift,       ///< client: the cell of the lift, mm
  Lifted,     ///< main run: the overlay of Z, mm
  LiftLimit,  ///< program: what the control allows the overlay of Z, mm (SD43350); < 0: none fits
  InAir,      ///< main run: cycles in which the axis moved with a lifted tool
};
static_assert(static_cast<int>(TestCell::InAir) + 1 == kFeedTestCells);

/// As a command: the program ends.
inline constexpr double kEndOfTest = 99.0;
/// A set point that moves less in a cycle stands, mm.
inline constexpr double kStepStandsMm = 1e-5;
/// `TestCell::LiftLimit` of a control whose overlay cannot lift.
inline constexpr double kOverlayAddsUp = -1.0;  ///< MD36750
inline constexpr double kOverlayThere = -2.0;   ///< one was active before the test

/// The number of the program.
[[nodiscard]] int layoutOf(const FeedTestPlan& plan);
/// Largest lift of the tool in the test; 0: it is not lifted.
[[nodiscard]] inline double liftMmOf(const FeedTestPlan& plan) {
  return plan.move ? plan.move->liftMm : 0.0;
}

}  // namespace rivulet::streaming
