// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The variables of a control that Rivulet uses, by meaning; `node_map` turns them into node ids.
/// @threadsafety plain values.
#pragma once

#include <compare>
#include <string>

#include "base/error.h"

namespace rivulet::opcua {

enum class VariableKind : unsigned char {
  RParameter,  ///< index = R number; number, read and write
  /// index = axis from 0; X Y Z in mm, workpiece frame, then the rotary axes in degrees
  /// (aaAcsRel)
  ActualPosition,
  DistanceToGo,   ///< index = axis from 0; mm or degrees to the end of the block (aaDtew)
  PathFeed,       ///< mm/min (actFeedRateIpo)
  ProgramStatus,  ///< 1 interrupted, 2 stopped, 3 running, 4 waiting, 5 aborted
  ChannelStatus,  ///< 0 reset, 1 active, 2 interrupted
  LineNumber,     ///< line of the program in motion
  ProgramName,    ///< text: program selected in the channel
  Message,        ///< text: what MSG("...") shows
  Alarm,          ///< number of the newest alarm of the channel; 0 none
  AxisName,       ///< text; index = axis from 0: "X", "A"
};

/// `ChannelStatus` while no program is active.
inline constexpr int kChannelReset = 0;
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
         kind == VariableKind::AxisName;
}

/// Result of one item of a read.
struct Reading {
  std::error_code status;  ///< clear: the value is good
  double number = 0.0;
  std::string text;
};

struct Assignment {
  Variable variable;
  double value = 0.0;  ///< finite: a link refuses NaN and infinity before anything is sent
};

}  // namespace rivulet::opcua
