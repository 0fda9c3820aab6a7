// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds where a whole job was left. As for a single run (resume.h), the control is asked, and
/// nothing resumes by itself. @threadsafety runs on the calling thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "base/result.h"
#include "base/vec3.h"
#include "job/plan.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

/// What is left where a job cannot be resumed.
inline constexpr const char* kChooseStretch =
    "Choose a stretch to begin with (--from-stretch, or PreflightStretch of a service).";

/// Where a job goes on.
struct JobRest {
  std::size_t part = 0;          ///< the first that is not done, index in `Plan::parts`
  std::optional<Resume> resume;  ///< the part is a stretch that has been begun: of its points
  std::optional<base::Vec3>
      toolMm;                      ///< where the tool stands, frame of that part; nothing: unknown
  std::optional<double> restMm{};  ///< its program still stands on the control: see `Resume`
};

/// The checkpoint of a job that the control has not been allowed to begin: nothing of it has been
/// executed. One that has begun has the checkpoint of a stretch, or one that was granted.
[[nodiscard]] bool isBeforeFirstBlock(const Checkpoint& last);

/// Finds the first part and point that have not been executed. A part that is inserted
/// (`NativeBlock::isInserted`) stands for all of them: a job that goes on re-establishes its state
/// from the beginning.
/// @param settings  of the job  @param last  its checkpoint
/// @param zeroAt    zero of the workpiece frame at a part, machine coordinates: after the end of a
///                  program the control tells positions in these
/// @param active    a program that still waits for its client
/// @return error CannotResume if the control has run another program since, was switched off, or
///         was interrupted within blocks of which it is not known what they have done; ChannelBusy
///         while it executes native blocks; else as `resumeFrom`
[[nodiscard]] base::Result<JobRest> whereJobWasLeft(
    opcua::Link& link, const job::Plan& plan, const RunSettings& settings, const Checkpoint& last,
    const std::function<base::Result<base::Vec3>(std::size_t part)>& zeroAt,
    ActiveProgram active = ActiveProgram::IsEnded);

}  // namespace rivulet::streaming
