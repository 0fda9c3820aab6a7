// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How a flexible program on LinuxCNC and the bridge in front of it exchange cells. The program
/// reads a cell as a pin of the HAL. It has no assignment to a pin, so it writes through analog
/// outputs of the motion controller, at standstill: the bridge copies their values into the cells.
/// `FeedCell` is not the program's business there, which only puts the planner under the pin
/// `motion.adaptive-feed` (M52 P1): the bridge and the components of docs/linuxcnc.md make it.
/// @threadsafety plain values.
#pragma once

namespace rivulet::templates {

struct LinuxCncProtocol {
  /// Analog outputs (M67 and M68 E<n>), from 0: `motion.analog-out-00` and so on.
  enum Output {
    /// Counts the starts of the program. At a change the bridge sets the header cells to 0, all
    /// but layout and heartbeat, and the feed cell to 100. It tries whether the planner obeys the
    /// feed cell, and then sets the pin `rivulet.started` to this number.
    Start,
    Latched,  ///< as the cells of `WindowProtocol`
    Executed,
    Layout,
    State,
    Owner,
    Base,          ///< number of the first cell
    SilenceLimit,  ///< as in `WindowSettings`, s; set before `Start`
    /// Of a whole job; set before `Start`. Other than 0: the program goes on, so that `Start`
    /// leaves the feed cell as it is and tries nothing.
    Stretch,
    Call,   ///< the call cell, see `JobProtocol`
    Block,  ///< of a whole job, between two stretches: see `job::blockCell`
    Outputs,
  };
  /// In `Block`: the cell is the client's.
  static constexpr double kNoBlock = -0.5;
  /// `#<_hal[rivulet.r-12]>`: pin of cell 12.
  /// Method credit: comment at the end of every motion block, followed by the number of its window
  /// in the ring, from 0. The bridge takes from it and from the line in motion which windows the
  /// axes have begun.
  static constexpr const char* kMotionMark = ";window ";
  static constexpr const char* kCellPin = "rivulet.r-";
  static constexpr const char* kStartedPin = "rivulet.started";
  static constexpr const char* kOutputPin = "motion.analog-out-";

  /// The program of this name is a preset (`machine::parsePreset`): limits, tools and offsets as
  /// LinuxCNC has them when it is read.
  static constexpr const char* kMachineFile = "MACHINE.TOML";

  /// Largest deviation from the programmed path at corners (G64 P).
  static constexpr double kPathToleranceMm = 0.01;
};

}  // namespace rivulet::templates
