// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The variables of a control that Rivulet uses, by meaning; `node_map` turns them into node ids.
/// @threadsafety plain values.
#pragma once

#include <compare>
#include <optional>
#include <string>

#include "base/error.h"

namespace rivulet::opcua {

enum class VariableKind : unsigned char {
  RParameter,  ///< index = R number; number, read and write
  /// index = axis from 0; X Y Z in mm, workpiece frame, then the rotary axes in degrees
  /// (aaAcsRel)
  ActualPosition,
  DistanceToGo,     ///< index = axis from 0; mm or degrees to the end of the block (aaDtew)
  PathFeed,         ///< mm/min (actFeedRateIpo)
  ProgramStatus,    ///< 1 interrupted, 2 stopped, 3 running, 4 waiting, 5 aborted
  ChannelStatus,    ///< 0 reset, 1 active, 2 interrupted
  LineNumber,       ///< line of the program in motion
  ProgramName,      ///< text: program selected in the channel
  Message,          ///< text: what MSG("...") shows
  Alarm,            ///< number of the newest alarm of the channel; 0 none
  AxisName,         ///< text; index = axis from 0: "X", "A"
  ToolNumber,       ///< T number in the spindle; 0: none, or one that has only a name (actTNumber)
  ToolName,         ///< text: of the tool in the spindle (actToolIdent)
  EdgeNumber,       ///< D (actDNumber)
  SpindleSpeed,     ///< index = spindle from 0; 1/min, without direction (actSpeed)
  SpindleSpeedSet,  ///< the same, commanded (cmdSpeed)
  SpindleTurn,      ///< index = spindle from 0; `SpindleTurn` (turnState)
  GFunction,        ///< text; index = G group: "G54" (ncFktAct)
  /// index = group of auxiliary functions: number of its last M function, below 0 for none
  /// (acAuxfuMValue)
  MFunction,
};

/// Values of `VariableKind::SpindleTurn`. Which number means what is assumed.
enum class SpindleTurn { Clockwise = 0, Counterclockwise = 1, Stands = 2 };

/// @param perMin  positive: clockwise, M3
[[nodiscard]] constexpr SpindleTurn turnOf(double perMin) {
  return perMin == 0.0  ? SpindleTurn::Stands
         : perMin > 0.0 ? SpindleTurn::Clockwise
                        : SpindleTurn::Counterclockwise;
}

/// G group of the settable work offsets, G54 and the like.
inline constexpr int kWorkOffsetGroup = 8;
/// Groups of the auxiliary functions M8 M9 and M7 M9. Each machine has its own; these are assumed.
inline constexpr int kFloodGroup = 5;
inline constexpr int kMistGroup = 6;
inline constexpr int kMistOn = 7;
inline constexpr int kFloodOn = 8;
inline constexpr int kCoolantOff = 9;

/// `ChannelStatus` while no program is active.
inline constexpr int kChannelReset = 0;
/// `ChannelStatus` while a program is executed.
inline constexpr int kChannelActive = 1;
/// `ChannelStatus` while the program waits for cycle start, as at M0.
inline constexpr int kChannelInterrupted = 2;

/// One variable of channel 1.
struct Variable {
  VariableKind kind = VariableKind::RParameter;
  int index = 0;

  friend constexpr auto operator<=>(const Variable&, const Variable&) = default;
};

[[nodiscard]] constexpr Variable rParameter(int index) {
  return {VariableKind::RParameter, index};
}

/// True if the variable carries text rather than a number.
[[nodiscard]] constexpr bool isText(VariableKind kind) {
  return kind == VariableKind::ProgramName || kind == VariableKind::Message ||
         kind == VariableKind::AxisName || kind == VariableKind::ToolName ||
         kind == VariableKind::GFunction;
}

/// Result of one item of a read.
struct Reading {
  std::error_code status;  ///< clear: the value is good
  double number = 0.0;
  std::string text;

  /// Nothing: it could not be read, which is not zero.
  [[nodiscard]] std::optional<double> value() const {
    return status ? std::nullopt : std::optional(number);
  }
};

struct Assignment {
  Variable variable;
  double value = 0.0;  ///< finite: a link refuses NaN and infinity before anything is sent
};

}  // namespace rivulet::opcua
