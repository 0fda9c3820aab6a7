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

/// What becomes of a program that is still active on the control when it is asked.
enum class ActiveProgram {
  IsEnded,  ///< it executes the windows it has copied, and its end is awaited
  Stays,    ///< nothing is written: what follows is computed from where it stands
};

/// The part of a run's path on which the tool is once it has been driven back: the moves to these
/// points.
struct BackPart {
  std::size_t first = 0;  ///< > 0; counted in the list of the run
  std::size_t next = 0;   ///< the last of them, which the run has not executed
};

/// Finds the first point that has not been executed: of a program that still is active on the
/// control, the first behind the windows it has copied. If the control was reset in the middle of
/// them, the place of the tool on their path decides.
/// @param settings  of the earlier run
/// @param last      its checkpoint
/// @param earlier   the points of the whole earlier run, if they were kept. Without them the
///                  program must be the same. With them it may differ after the place where the run
///                  is resumed: see `Resume::changedFrom`
/// @return what `RunSettings::resume` needs. CannotResume if the control has run another program
///         since, every point is done, the tool is off the path or where the path passes twice;
///         ProgramChanged; ChannelBusy if another program is running, or if one that stays still
///         moves the axes; StopNotConfirmed; or a link error
[[nodiscard]] base::Result<Resume> resumeFrom(opcua::Link& link, const gcode::Program& program,
                                              const RunSettings& settings, const Checkpoint& last,
                                              std::span<const gcode::StreamPoint> earlier = {},
                                              ActiveProgram active = ActiveProgram::IsEnded);

/// Where a run is left once its program has ended.
struct LeftAt {
  std::optional<Resume> resume;  ///< nothing: every point has been executed then
  std::optional<double> restMm;  ///< see `Resume`
  base::Vec3 toolMm;             ///< where the tool stands then
};

/// The same.
[[nodiscard]] base::Result<LeftAt> leftAt(opcua::Link& link, const gcode::Program& program,
                                          const RunSettings& settings, const Checkpoint& last,
                                          std::span<const gcode::StreamPoint> earlier,
                                          ActiveProgram active);

/// Where a run goes on whose tool has been driven back, or is on the way: the cells of the control
/// are those of another run by now, and the place of the tool decides.
/// @return as `resumeFrom`
[[nodiscard]] base::Result<Resume> resumeOnPart(opcua::Link& link, const gcode::Program& program,
                                                const RunSettings& settings, const Checkpoint& last,
                                                const BackPart& part);

/// Points that are executed after each number of windows of an earlier run, from none to all: its
/// windows are cut again as they were.
/// @param points  of the whole program  @param settings  of that run  @param last  its checkpoint
[[nodiscard]] std::vector<std::size_t> windowEnds(std::span<const gcode::StreamPoint> points,
                                                  const RunSettings& settings,
                                                  const Checkpoint& last);

/// A hash of everything that decides how points are streamed: their places, the kinds of their
/// moves and feeds of their own, not their lines. Never 0.
[[nodiscard]] std::uint64_t hashOfPoints(std::span<const gcode::StreamPoint> points);

/// What a program that is told to end still executes.
struct MotionAhead {
  double lengthMm = 0.0;
  double seconds = 0.0;  ///< at an override of 100 %, without acceleration
};

/// The path of the copied windows that is left: all of it where the place of the tool on it is not
/// certain. @param before  place before the first point  @param windows  their points
/// @param feedMmPerS  of points without one of their own, > 0
[[nodiscard]] MotionAhead motionAhead(const base::AxisPosition& before,
                                      std::span<const gcode::StreamPoint> windows,
                                      const base::AxisPosition& tool, double feedMmPerS);

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
