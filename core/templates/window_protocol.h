// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The numbers on which program and client agree, defined only here: the generator writes them into
/// the program, and the client and the job write and read them as cells.
/// @threadsafety plain values.
#pragma once

namespace rivulet::templates {

/// Methods window, credit and file.
struct WindowProtocol {
  /// Cells before the first window, counted from the first cell. `Layout` is at the same place as
  /// with the methods of [P1], so that each sees the other's number.
  enum Header {
    Run,
    Delivered,
    Latched,
    Executed,
    Layout,
    State,
    Client,
    Owner,
    Heartbeat,
    Asked,         ///< method file; free with the others
    Override,      ///< the feed cell, see `FeedCell`
    OverrideActs,  ///< what the main run makes of it
    HeaderCells,
  };
  /// Cells before the points of each window, counted from its first cell.
  enum Window { Count, Feed, Check, WindowCells };

  /// Values of the run cell. Above `kRun` the program ends before the next window.
  static constexpr int kHold = 0;
  static constexpr int kRun = 1;
  static constexpr int kEnd = 2;

  static constexpr int kWindowsMax = 8;
  static constexpr int kWindowsAheadMax = 8;

  /// Factors of the check number of a window, so that no window is mistaken for another: program
  /// and client add up the number of the run and, each multiplied by its own factor, the number of
  /// the window, its count, its feed and its coordinates (where each point has its own feed, it
  /// follows its coordinates).
  static constexpr double kCheckNumber = 7.31;
  static constexpr double kCheckCount = 13.7;
  static constexpr double kCheckFeed = 0.917;
  /// @param place  of the coordinate in the window, from 0
  [[nodiscard]] static double checkFactor(int place);

  /// Method credit: path override, in percent, that is left at the end of a window that nothing
  /// follows. At its beginning it is 100: it falls with the blocks of that window.
  static constexpr int kSlowestPercent = 10;

  /// Method file: the answer of a subprogram in the cell `Asked`. @param window  from 1
  [[nodiscard]] static constexpr long long fileAnswer(long long window, bool isLast) {
    return -2 * window - (isLast ? 1 : 0);
  }
};

/// Path override by the client: a synchronized action reads the feed cell in every interpolation
/// cycle, so that it acts at once, wherever the program is. A value that is not a number from 0 to
/// 200 holds the axes, and so does a client that gives no sign. The override in force is written by
/// one action alone, which also tells it in a cell of its own. On LinuxCNC see `LinuxCncProtocol`.
///
/// A program may have a factor beside it, in a cell of its own, for a sensor or another program:
/// whoever holds by the feed cell is not undone by the next factor. The control forms the product.
struct FeedCell {
  static constexpr double kHold = 0.0;
  static constexpr double kProgrammed = 100.0;  ///< the value at the start of a program
  static constexpr double kMax = 200.0;         ///< percent; the control's own limit of $AC_OVR
  /// Of override and factor: the highest override that anybody may set. A factor raises no feed
  /// beyond what the braking distance before the start was told for.
  static constexpr double kProductMax = 120.0;

  // The watch on the heartbeat: the time since it changed, and its value then.
  static constexpr int kBeatTimer = 1;  ///< $AC_TIMER; negative before the first beat
  static constexpr int kBeatSeen = 1;   ///< $AC_PARAM
};

/// Numbers of the synchronized actions of all programs: the control executes them in this order in
/// each interpolation cycle. Modal, they end with the program.
struct ActionNumber {
  static constexpr int kHeld = 1;    ///< feed cell: no override yet
  static constexpr int kWanted = 2;  ///< that of the client, if it may be obeyed
  static constexpr int kSlow = 3;    ///< method credit: while nothing follows the window in motion
  static constexpr int kBeat = 4;    ///< a sign of the client: its time begins anew
  static constexpr int kActs = 5;    ///< what has become of it acts
  // In place of the latter, with a factor:
  static constexpr int kCapped = 6;       ///< the product is no higher than `FeedCell::kProductMax`
  static constexpr int kCappedActs = 7;   ///< what has become of it acts
  static constexpr int kCorrection = 11;  ///< online correction of X; Y and Z follow
  static constexpr int kLowered = 14;     ///< a lifted tool comes back when the hold ends
};

/// Values of the state cell of methods window, credit and file.
enum class WindowState {
  Runs = 0,               ///< it waits or moves
  Done = 1,               ///< ended after the last window
  Stopped = 2,            ///< ended on request of the client
  Damaged = 3,            ///< ended: a window did not match its check number; it was not executed
  Abandoned = 4,          ///< ended: no window and no heartbeat from the client for too long
  OverlayLeft = 5,        ///< ended before it began: an overlay was already active on the axes
  OverlayIntegrates = 6,  ///< ended before it began: the control adds up corrections (MD36750)
};

/// The methods of [P1].
struct LoopProtocol {
  static constexpr int kRun = 1;   ///< run cell: the program leaves its waiting loop
  static constexpr int kStop = 1;  ///< stop cell: the program ends at the end of the loop
  /// Values of the signal cell of method signal.
  static constexpr int kFirstPassed = 0;
  static constexpr int kSecondPassed = 1;
  static constexpr int kRefilled = 2;
};

}  // namespace rivulet::templates
