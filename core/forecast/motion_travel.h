// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Compares the motion of a run with the travel of the machine, before anything moves: with the
/// work offset, the tool and the edge that are active at the control. @threadsafety pure.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/axes.h"
#include "base/result.h"
#include "gcode/trajectory.h"
#include "machine/config.h"
#include "streaming/run/equipment_watch.h"

namespace rivulet::forecast {

/// Where the zero of the workpiece is, machine coordinates; nothing: the control does not say which
/// offset and tool are active, or the machine has no such tool.
/// @param equipment  as the control has it now
[[nodiscard]] std::optional<base::Vec3> activeZero(const machine::MachineConfig& machine,
                                                   const streaming::EquipmentSeen& equipment);

/// @param zeroMm  see `activeZero`; nothing: only the length of the path is compared with that of
///                the travel
/// @return error `JobError::BeyondMachine`: the point that is farthest beyond its limit
[[nodiscard]] base::Result<void> requireWithinTravel(std::span<const gcode::StreamPoint> points,
                                                     const machine::MachineConfig& machine,
                                                     const std::optional<base::Vec3>& zeroMm);

}  // namespace rivulet::forecast
