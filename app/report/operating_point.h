// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The settings of a run that the verdict needs, for both command line and HMI.
/// @threadsafety pure.
#pragma once

#include "feasibility/verdict.h"
#include "gcode/feeds.h"
#include "machine/config.h"
#include "streaming/run/run.h"

namespace rivulet::report {

/// @param settings  with all axes that the run streams: see `streaming::withTurnedAxes`
[[nodiscard]] feasibility::OperatingPoint operatingPointOf(const streaming::RunSettings& settings);

/// The feeds of the program within the limits of a machine. @param rapidMmPerS  0: the machine's
[[nodiscard]] gcode::ProgramFeeds programFeedsOf(const machine::MachineConfig& machine,
                                                 double overrideFactor, double rapidMmPerS = 0.0);

}  // namespace rivulet::report
