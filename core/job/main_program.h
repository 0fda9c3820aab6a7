// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The programs of a whole job for the control: a main program with the native blocks at their
/// place, and the loop that it calls for each stretch. @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/result.h"
#include "gcode/feeds.h"
#include "job/plan.h"
#include "templates/job_loop.h"

namespace rivulet::job {

enum class JobError {
  NotWhole = 1,       ///< a finding or refusal stops it
  ReadsVariables,     ///< a native block reads variables that only Rivulet has computed
  IncrementInFrame,   ///< a native block moves by an increment that would pass another shift
  TooManyStretches,   ///< more than `templates::JobProtocol::kStretchesMax`
  PositionDiffers,    ///< the tool is not where the program says
  BeyondMachine,      ///< travel, tools or what the machine refuses
  FunctionMalformed,  ///< no number of an M function, or nothing that the control does for it
  NotDry,             ///< a block cannot be raised, or turns the spindle itself (`dryPlan`)
  NotTranslated,      ///< the control has no words for a native block
};
[[nodiscard]] std::error_code make_error_code(JobError code);

/// What the name of a job's main program says, "RIVJOB_123B50.MPF".
struct JobName {
  int number = 0;    ///< of the job: a hash of both texts
  int baseCell = 0;  ///< R number of the first cell of its loop
};
[[nodiscard]] std::string mainNameOf(const JobName& name);
/// Inverse of `mainNameOf`, also as a control shows it; nothing for another program.
[[nodiscard]] std::optional<JobName> jobNameOf(std::string_view fileName);

struct JobPrograms {
  int number = 0;        ///< see `JobName`
  std::string mainName;  ///< see `mainNameOf`
  std::string mainText;
  templates::JobLoop loop;
};

/// Why a plan is no job, whatever the machine. @return NotWhole, ReadsVariables, IncrementInFrame,
/// TooManyStretches
[[nodiscard]] base::Result<void> requireWhole(const Plan& plan);

/// @param parameters  see `templates::makeJobLoop`
/// @return NotWhole, ReadsVariables, IncrementInFrame, TooManyStretches, NotTranslated, or
/// the errors of `makeJobLoop`
[[nodiscard]] base::Result<JobPrograms> makePrograms(
    const Plan& plan, const templates::TemplateParameters& parameters);

/// What a line of an outline stands for: a native block or a point of a stretch; all 0: neither.
struct OutlineLine {
  int native = 0;         ///< number in the plan, from 1
  int stretch = 0;        ///< its number
  base::LineNumber line;  ///< of the source program
};

/// A job in short, as one NC program without client and cells: the native blocks as the main
/// program has them, and of each stretch the farthest points along each axis and the last one. For
/// checks of what the job would do; not for a control.
struct Outline {
  std::string text;
  std::vector<OutlineLine> lines;  ///< one for each line of the text
};
/// @param untilPart  the first that is left out, index in `Plan::parts`  @pre plan.isWhole()
[[nodiscard]] Outline outlineOf(const Plan& plan,
                                std::size_t untilPart = static_cast<std::size_t>(-1));

/// A job as one NC program for the virtual machine, without a client: each point of a stretch is a
/// block. What a job is compared with where the source is of another dialect.
/// @param feeds  nothing: all points have `feedMmPerS` @pre plan.isWhole()
[[nodiscard]] std::string plainProgramOf(const Plan& plan,
                                         const std::optional<gcode::ProgramFeeds>& feeds,
                                         double feedMmPerS);

/// R number of the cell that tells how far the native blocks are, between two stretches, where the
/// loop does not use it. The number of a block in the plan, from 1: all before it have been
/// executed, and it has been begun; one that does not move may count with the next. Negative: all
/// up to it have been executed, and none after it has been begun. 0: none since the stretch.
/// `doneNumber`: all of the job.
[[nodiscard]] int blockCell(const templates::JobLoop& loop);
[[nodiscard]] int doneNumber(const Plan& plan);

}  // namespace rivulet::job

template <>
struct std::is_error_code_enum<rivulet::job::JobError> : std::true_type {};
