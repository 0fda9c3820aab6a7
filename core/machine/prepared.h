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

#include "base/axes.h"
#include "base/id.h"
#include "base/instant.h"
#include "base/vec3.h"
#include "machine/alarm.h"
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
  BlockEnd end = BlockEnd::ExactStop;
  RoundingKind rounding = RoundingKind::Deviation;
  double roundingMm = 0.0;  ///< >= 0
  Dynamics dynamics = Dynamics::Brisk;
  std::optional<ArcPath> arc;  ///< none: a straight line
  base::RotaryDeg targetDeg{};
  /// Along the turn, in a block that moves nothing else: the programmed feed in degrees.
  double feedDegPerS = 0.0;
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
using Prepared = std::variant<PreparedNothing, PreparedMotion, PreparedDwell, PreparedMessage,
                              PreparedSync, PreparedCancel, PreparedStopre, PreparedEnd, Alarm>;

}  // namespace rivulet::machine
