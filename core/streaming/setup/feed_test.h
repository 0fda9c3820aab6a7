// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The test of the feed cell. Hold, stop and override of a run act at once because synchronized
/// actions on the control make the path override of a cell (`templates::feedCellBlocks`). That a
/// control obeys them is documented, but has to be seen on each: it is what the promise of a stop
/// rests on.
///
/// The program of the test has these same actions. First no axis moves: the override that they make
/// must follow the cell, become 0 without a sign of the client, and be let go when the program has
/// ended. Whether the path obeys shows only in motion: if the operator agrees to it, one axis moves
/// forth and back, at 100 and 50 %, is held on its way, and moves once more in a second program
/// without a feed cell. If that was agreed as well, the tool is lifted while it is held
/// (`lift_test.h`).
/// @threadsafety runs on the calling thread.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "base/instant.h"
#include "base/result.h"
#include "opcua/link.h"
#include "streaming/setup/commissioning.h"
#include "templates/cells.h"

namespace rivulet::streaming {

/// R-parameters in a row that the test needs.
inline constexpr int kFeedTestCells = 18;

/// A move that the operator agrees to: of one axis, forth and back to where it stands.
struct AirMove {
  int axis = 0;  ///< 0 to 2: X Y Z, as the workpiece counts
  double mm = 0.0;
  double feedMmPerMin = 0.0;
  /// While the axis is held, the tool is lifted along Z by so much; 0: it is not.
  double liftMm = 0.0;

  [[nodiscard]] base::Duration duration() const;

  friend bool operator==(const AirMove&, const AirMove&) = default;
};

/// "X 20 mm F400"
[[nodiscard]] std::string describe(const AirMove& move);

/// Whether the test can be made with it: it must last long enough to be held on its way.
/// @return BadAirMove
[[nodiscard]] base::Result<void> requireAirMove(const AirMove& move);

struct FeedTestPlan : CommissioningPlan {
  std::optional<AirMove> move;  ///< nothing: no axis moves
};

struct FeedCommissioning : ChecksOfControl {
  std::optional<AirMove> move;  ///< that was made; nothing: no axis has moved
  /// Of the axis that was held: from the moment at which the main run saw 0 in the cell.
  base::Duration braking{};
  /// What the control allows the overlay of Z (SD43350), mm; 0: the tool was not to be lifted.
  double limitMm = 0.0;

  /// The axes have been seen to obey.
  [[nodiscard]] bool proves() const { return passed() && move.has_value(); }
  /// The tool has been seen to be lifted and to come back: a run may lift it by so much, mm.
  [[nodiscard]] double provedLiftMm() const {
    return proves() && move->liftMm > 0.0 ? std::min(limitMm, templates::kLiftMmMax) : 0.0;
  }
};

/// The NC program: LF line ends, ASCII. @param plan  its first cell and its move
[[nodiscard]] std::string feedTestProgram(const FeedTestPlan& plan);
/// Its name on the control.
[[nodiscard]] std::string feedTestFileName();

/// Transfers the program, reads it back, selects it, has it started (with a move twice; a virtual
/// machine: starts it), and judges what it makes of the cell. A control that fails is a result, not
/// an error; no axis moves on a control that has failed without motion.
/// @param progress  called with what the test is waiting for; false ends it, with the override at 0
/// @return BadAirMove, ChannelBusy, ControlAlarm, NotStarted, WrongProgram, TransferRefused,
/// StreamStalled, Cancelled, or the error of the link
[[nodiscard]] base::Result<FeedCommissioning> testFeedCell(
    opcua::Link& link, opcua::Control& control, const FeedTestPlan& plan,
    const std::function<bool(CommissioningStep)>& progress = {});

}  // namespace rivulet::streaming
