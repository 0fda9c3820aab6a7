// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The result of the interpreter for one block: everything the main run needs, as numbers.
/// Rewriting an R-parameter has no effect on it.
/// @threadsafety plain values.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/axes.h"
#include "base/id.h"
#include "base/instant.h"
#include "base/vec3.h"
#include "machine/alarm.h"
#include "machine/tool.h"
#include "nc/geometry/arc.h"
#include "nc/modal/state.h"

namespace rivulet::machine {

struct SyncAction;

/// A circle or helix from the end of the previous block to the block's target: the start point
/// turns about the axis and rises evenly along it. Workpiece frame.
using ArcPath = nc::SpaceArc;

using nc::BlockEnd;
using nc::Dynamics;
using nc::RoundingKind;

/// A motion block ready for the main run.
struct PreparedMotion {
  base::LineNumber line;
  base::Vec3 targetMm;
  double feedMmPerS = 0.0;  ///< path speed: the programmed feed, or the rapid speed
  bool isRapid = false;      ///< G0
  BlockEnd end = BlockEnd::ExactStop;
  RoundingKind rounding = RoundingKind::Deviation;
  double roundingMm = 0.0;  ///< >= 0
  Dynamics dynamics = Dynamics::Brisk;
  std::optional<ArcPath> arc;  ///< none: a straight line
  base::RotaryDeg targetDeg{};
  /// Along the turn, in a block that moves nothing else: the programmed feed in degrees.
  double feedDegPerS = 0.0;
  base::Vec3 zeroMm;  ///< of the workpiece frame: targetMm less this is what was programmed
};

/// What a block does besides moving. The main run carries it out when the block's turn comes.
struct MachineAction {
  enum class Kind {
    SelectTool,    ///< T: `tool`
    ChangeTool,    ///< M6: `tool`
    SelectEdge,    ///< D: `value`
    WorkOffset,    ///< `value`: number of the G function, 500 for none
    SpindleSpeed,  ///< S: `value` in 1/min
    SpindleTurn,   ///< M3 and M4, `value` 1 and -1; M5 and M19, 0
    Coolant,       ///< M7, M8, M9: `value`
    Stop,          ///< M0 and M1, `value`: waits for cycle start
  };
  Kind kind = Kind::Stop;
  double value = 0.0;
  Tool tool{};
};

struct PreparedActions {
  base::LineNumber line;
  std::vector<MachineAction> actions;
  base::Vec3 zeroMm;  ///< of the workpiece frame from here on
};

struct PreparedDwell {
  base::LineNumber line;
  base::Duration duration{};
};

struct PreparedMessage {
  std::string text;
};

struct PreparedNothing {
  bool jumped = false;
};
/// A synchronized action: becomes active with the motion block that follows it.
struct PreparedSync {
  std::shared_ptr<const SyncAction> action;
};
struct PreparedCancel {
  int id = 0;
};
struct PreparedStopre {};
struct PreparedEnd {};

/// Result of one block.
using Prepared =
    std::variant<PreparedNothing, PreparedMotion, PreparedActions, PreparedDwell, PreparedMessage,
                 PreparedSync, PreparedCancel, PreparedStopre, PreparedEnd, Alarm>;

}  // namespace rivulet::machine
