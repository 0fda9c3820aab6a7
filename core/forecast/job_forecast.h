// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a whole job would do on a machine, before anything moves: where it would leave the travel
/// of an axis, turn the spindle too fast or ask for a tool that is not there, and how long it
/// takes.
/// @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/axes.h"
#include "base/result.h"
#include "job/plan.h"
#include "machine/config.h"
#include "machine/travel.h"
#include "streaming/run/job_times.h"
#include "streaming/run/run.h"
#include "streaming/start/first_move.h"

namespace rivulet::forecast {

enum class HazardKind {
  Travel,        ///< an axis would leave its travel
  SpindleSpeed,  ///< the control reduces the speed
  ToolMissing,   ///< not in the tool table
  Refused,       ///< the machine would stop at the block with an alarm
  NotChecked,    ///< from here on: the block asks for what only the control knows
};

/// "travel", "spindle-speed", "tool-missing", "refused", "not-checked"
[[nodiscard]] std::string_view hazardName(HazardKind kind);

struct Hazard {
  HazardKind kind = HazardKind::Travel;
  base::LineNumber line;  ///< of the source program
  std::string file;       ///< the called file it stands in; empty: the program itself
  int stretch = 0;        ///< of which a point it is; 0: a native block
  std::optional<machine::BeyondTravel> travel;
  double value = 0.0;  ///< SpindleSpeed: 1/min
  double limit = 0.0;  ///< SpindleSpeed: 1/min
  std::string text;    ///< tool, or the alarm
  std::string near;    ///< ToolMissing: one of the table that has nearly the same name
  int alarm = 0;       ///< Refused and NotChecked: its number

  /// The job must not start. Else it runs, and the user should know.
  [[nodiscard]] bool stops() const {
    return kind != HazardKind::SpindleSpeed && kind != HazardKind::NotChecked;
  }
};

/// One English sentence: what, where and by how much.
[[nodiscard]] std::string describe(const Hazard& hazard);

struct HazardOptions {
  base::AxisPosition start;  ///< of the axes before the job, machine coordinates
};

/// What a job meets on a machine, and how long the control is busy with its native blocks.
struct CheckedJob {
  std::vector<Hazard> hazards;
  std::vector<base::Duration> nativeTimes;  ///< by their number in the plan, less 1
  streaming::CutBox cut;                    ///< of stretches and native blocks, machine coordinates
};

/// Travel, tools and spindle, for native blocks and stretches. Within a stretch the farthest point
/// of each axis is reported. What a block does that no file tells (programs on the control,
/// measuring, variables of the control) ends the check with NotChecked.
/// @pre plan.isWhole()
[[nodiscard]] CheckedJob checkJob(const job::Plan& plan, const machine::MachineConfig& machine,
                                  const HazardOptions& options);
[[nodiscard]] std::vector<Hazard> hazardsOf(const job::Plan& plan,
                                            const machine::MachineConfig& machine,
                                            const HazardOptions& options);

/// Whether what a job does before it cuts for the first time passes within its cut. Where only the
/// control knows what a block does, what follows is not looked at.
/// @param tool  where the axes stand, machine coordinates  @param cut  of this job
/// @return nothing: the way is clear; else the height in machine coordinates  @pre plan.isWhole()
[[nodiscard]] std::optional<streaming::CutOnTheWay> cutOnTheWay(
    const job::Plan& plan, const machine::MachineConfig& machine, const base::AxisPosition& tool,
    const streaming::CutBox& cut);

/// @return error `JobError::BeyondMachine`: the first that stops, and how many more there are
[[nodiscard]] base::Result<void> requireNoHazard(const job::Plan& plan,
                                                 const std::vector<Hazard>& hazards);

/// The times of one part of a plan.
struct PartTimes {
  std::size_t part = 0;  ///< index in `Plan::parts`
  streaming::JobTimes times;
};

struct JobForecast {
  std::vector<PartTimes> parts;  ///< in their order; without parts that do nothing
  streaming::JobTimes times;     ///< of all
};

/// Estimates the time, with the look-ahead of the virtual machine and the pauses of the method.
/// Waiting for cycle start at M0 takes no time, nor does what the check cannot see.
/// @param settings  of the run: method, windows, feeds  @pre plan.isWhole()
[[nodiscard]] JobForecast forecast(const job::Plan& plan, const machine::MachineConfig& machine,
                                   const streaming::RunSettings& settings,
                                   const HazardOptions& options);

}  // namespace rivulet::forecast
