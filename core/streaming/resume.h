// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a run of method window or credit can be taken up again: asked of the control, never
/// remembered by the client alone. Called only because an operator wants it; nothing resumes by
/// itself.
/// @threadsafety runs on the calling thread.
#pragma once

#include "streaming/run.h"

namespace rivulet::streaming {

/// Finds the first point that has not been executed. A program that still waits for the run's
/// windows is told to end first (it executes the windows it has taken over, nothing more) and its
/// end is awaited. Where the control was reset in the middle of them, the place of the tool on
/// their path decides.
/// @param settings  of the earlier run
/// @param last      the checkpoint in its report
/// @return what `RunSettings::resume` needs. CannotResume if the control has run something else
///         since, every point is done, or the tool stands beside the path or where the path passes
///         twice; ChannelBusy if another program runs; StopNotConfirmed; or a link error
[[nodiscard]] base::Result<Resume> resumeFrom(opcua::Link& link, const gcode::Program& program,
                                              const RunSettings& settings, const Checkpoint& last);

/// Index of the first point ahead of a tool that stands on the path.
/// @param path   where the tool came from, then the points; at least two
/// @param toolMm where it stands
/// @return 1 to path.size() (all reached); nothing if it stands beside the path, or where the path
///         passes twice
[[nodiscard]] std::optional<std::size_t> pointAhead(const std::vector<base::Vec3>& path,
                                                    base::Vec3 toolMm);
/// The same with rotary axes, which turn evenly along each way: a degree counts as a millimetre.
[[nodiscard]] std::optional<std::size_t> pointAhead(const std::vector<base::AxisPosition>& path,
                                                    const base::AxisPosition& tool);

}  // namespace rivulet::streaming
