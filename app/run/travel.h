// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The last check of a run of points before it starts: whether its path lies within the travel of
/// the machine. Whole jobs have their own (`forecast::hazardsOf`).
/// @threadsafety the link belongs to the calling thread.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/result.h"
#include "forecast/motion_travel.h"
#include "opcua/link.h"
#include "report/machine_store.h"

namespace rivulet::run {

/// The machine behind a connection, by its limits here or what it reports. @param name  endpoint
/// @return nothing: it is not known
[[nodiscard]] base::Result<std::optional<machine::MachineConfig>> machineOf(
    opcua::Control& control, const std::string& name,
    const report::MachineStore& store = report::MachineStore());

/// Asks the control for its work offset and tool; nothing is changed.
/// @param machine  nothing: it is not known  @param points  that are left of the run
/// @return why it was not checked, or not wholly; empty: it was. BeyondMachine, or a link error
[[nodiscard]] base::Result<std::string> checkTravel(
    opcua::Link& link, opcua::Control& control,
    const std::optional<machine::MachineConfig>& machine,
    std::span<const gcode::StreamPoint> points);

}  // namespace rivulet::run
