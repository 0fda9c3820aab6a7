// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds where a run of method window or credit can be resumed: the control is asked; the client's
/// memory alone is not enough. Called only on request of an operator; nothing resumes by itself.
/// @threadsafety runs on the calling thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "streaming/run/run.h"

namespace rivulet::streaming {

/// Finds the first point that has not been executed. A program that still waits for the run's
/// windows is first commanded to end (it executes only the windows it has copied), and its end is
/// awaited. If the control was reset in the middle of them, the place of the tool on their path
/// decides.
/// @param settings  of the earlier run
/// @param last      its checkpoint
/// @param earlier   the points of the whole earlier run, if they were kept. Without them the
///                  program must be the same. With them it may differ after the place where the run
///                  is resumed: see `Resume::changedFrom`
/// @return what `RunSettings::resume` needs. CannotResume if the control has run another program
///         since, every point is done, the tool is off the path or where the path passes twice;
///         ProgramChanged; ChannelBusy if another program is running; StopNotConfirmed; or a link
///         error
[[nodiscard]] base::Result<Resume> resumeFrom(opcua::Link& link, const gcode::Program& program,
                                              const RunSettings& settings, const Checkpoint& last,
                                              std::span<const gcode::StreamPoint> earlier = {});

/// The same. @return nothing: every point has been executed
[[nodiscard]] base::Result<std::optional<Resume>> leftAt(
    opcua::Link& link, const gcode::Program& program, const RunSettings& settings,
    const Checkpoint& last, std::span<const gcode::StreamPoint> earlier = {});

/// A hash of everything that decides how points are streamed: their places, the kinds of their
/// moves and feeds of their own, not their lines. Never 0.
[[nodiscard]] std::uint64_t hashOfPoints(std::span<const gcode::StreamPoint> points);

/// Index of the first point ahead of a tool that is on the path.
/// @param path  start of the tool, then the points; at least two
/// @param toolMm  position of the tool
/// @return 1 to path.size() (all reached); nothing if it is off the path, or where the path passes
///         twice
[[nodiscard]] std::optional<std::size_t> pointAhead(const std::vector<base::Vec3>& path,
                                                    base::Vec3 toolMm);
/// The same with rotary axes, which turn evenly along each move: a degree counts as a millimetre.
[[nodiscard]] std::optional<std::size_t> pointAhead(const std::vector<base::AxisPosition>& path,
                                                    const base::AxisPosition& tool);

}  // namespace rivulet::streaming
