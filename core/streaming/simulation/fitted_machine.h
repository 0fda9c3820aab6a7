// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A virtual machine set up for a job, as an operator sets up a real one: tools in the magazine,
/// the workpiece where the program fits into the travel. @threadsafety pure.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "job/plan.h"
#include "machine/config.h"

namespace rivulet::streaming {

/// SD42110 of such a machine: the feed of a program until it names one, 1000 mm/min. The job is to
/// be planned with it (`gcode::LoadOptions::defaultFeedMmPerS`).
inline constexpr double kFittedFeedMmPerS = 1000.0 / 60.0;

struct FittedMachine {
  machine::MachineConfig config;
  std::vector<std::string> notes;  ///< what was set up, one English sentence each
};

/// Tools and cutting edges that the job names are in the table afterwards, rotary axes that it
/// turns exist, a work offset at which its motion leaves the travel is moved to the middle, and
/// motion before any F has a feed.
[[nodiscard]] FittedMachine fitMachine(machine::MachineConfig config, const job::Plan& plan);

/// The tools of a machine for `gcode::LoadOptions::toolRadiusMm`.
/// @param isFitted  the machine will be fitted: a tool that is not in its table has radius 0 there
[[nodiscard]] nc::heidenhain::ToolRadius toolRadii(const std::optional<machine::ToolTable>& tools,
                                                   bool isFitted);

/// The work offsets of a machine for `gcode::LoadOptions::workOffsetMm`; nothing while a tool is in
/// its spindle, whose length would count.
/// @param areRead  becomes true when a program asks for one
[[nodiscard]] std::function<std::optional<base::Vec3>(int)> workOffsets(
    const machine::MachineConfig& config, std::shared_ptr<bool> areRead);

}  // namespace rivulet::streaming
