// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads an NC program as the pre-run of a machine does, without moving anything: what would be
/// beyond the machine's limits, and how long each block takes. @threadsafety pure.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/axes.h"
#include "base/budget.h"
#include "base/id.h"
#include "base/instant.h"
#include "machine/alarm.h"
#include "machine/config.h"
#include "machine/machine.h"
#include "machine/travel.h"

namespace rivulet::machine {

/// What a block does that the machine cannot, or the alarm that ends the program.
struct DryFinding {
  base::LineNumber line;
  std::optional<BeyondTravel> travel;
  double speedPerMin = 0.0;  ///< S beyond the greatest speed; 0: it is not that
  std::string tool;  ///< "T5" or its name, if the tool table lacks it; empty: it is not that
  Alarm alarm;       ///< the program is not read any further; number 0: it is not that
};

/// Time of the motions, dwells and actions of a line, each from standstill to standstill.
struct DryTime {
  base::LineNumber line;
  base::Duration duration{};
};

/// A motion, and where the axes stand before it.
struct DryMotion {
  base::LineNumber line;
  base::AxisPosition from;  ///< workpiece frame of the motion
  base::Vec3 toMm;          ///< likewise
  base::Vec3 zeroMm;        ///< of that frame, machine coordinates
  bool isRapid = false;
};

struct DryRun {
  std::vector<DryFinding> findings;  ///< in the order of the program
  std::vector<DryTime> times;        ///< of the lines that were asked for, in their order
  std::vector<DryMotion> motions;
  // At the end.
  EquipmentState equipment;
  base::Vec3 zeroMm;        ///< of the workpiece frame, machine coordinates
  base::Vec3 axesMm;        ///< where the axes stand, machine coordinates
  bool isComplete = false;  ///< no alarm has ended it before
};

struct DryRunOptions {
  base::AxisPosition start;  ///< of the axes, machine coordinates
  /// Lines whose time is wanted; null: none.
  std::function<bool(base::LineNumber)> isTimed{};
  bool endsWithFeed = false;  ///< nothing behind the first motion with feed is read
  /// Of the statements of the program, and of what is found of it. Beyond it, it ends in an alarm.
  base::Budget budget{};
};

/// Reads to the end, past motions beyond a limit and tools that are missing: only an alarm of
/// another kind ends it. Values of the main run are not known, nor programs on the control.
/// @param text  SINUMERIK
[[nodiscard]] DryRun dryRun(const MachineConfig& config, const std::string& text,
                            const DryRunOptions& options);

}  // namespace rivulet::machine
