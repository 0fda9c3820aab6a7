// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a run goes on that was left, as the control and the files of this computer have it.
/// @threadsafety plain values; the link belongs to the calling thread.
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "forecast/job_forecast.h"
#include "forecast/job_restart.h"
#include "report/run_store.h"
#include "streaming/recovery/resume.h"

namespace rivulet::run {

/// How a whole job goes on that was left, or begins in the middle.
struct JobRestart {
  forecast::Restart restart;
  std::optional<streaming::Resume> resume;  ///< within its first stretch
  int stretch = 0;                          ///< with which it goes on, or that comes next; 0: none
  std::optional<base::Vec3> toolMm;         ///< to which the tool goes first; nothing: nowhere
  std::vector<forecast::Hazard> hazards;    ///< of what is left
  int firstRun = 0;                         ///< see `report::SavedJob`; 0: a job of its own
  std::optional<double> restMm{};           ///< its program still stands: see `streaming::Resume`

  /// What is kept of the job while it goes on. @param number  of its programs
  [[nodiscard]] report::SavedJob kept(int number) const { return {number, firstRun, restart.rest}; }
};

/// Of a motion. With its points at hand, a program that differs where nothing was executed can be
/// confirmed. @return as `streaming::resumeFrom`
[[nodiscard]] base::Result<streaming::Resume> askResume(opcua::Link& link,
                                                        const gcode::Program& program,
                                                        const streaming::RunSettings& settings,
                                                        const streaming::Checkpoint& checkpoint,
                                                        streaming::ActiveProgram active);

/// Of a whole job. @param plan  of its source, whole
/// @param kept  what was kept of it; nothing: by an earlier version
/// @return CannotResume, ProgramChanged, ChannelBusy
[[nodiscard]] base::Result<JobRestart> askJob(opcua::Link& link, const job::Plan& plan,
                                              const machine::MachineConfig& machine,
                                              const streaming::RunSettings& settings,
                                              const streaming::Checkpoint& checkpoint,
                                              const std::optional<report::SavedJob>& kept,
                                              streaming::ActiveProgram active);

/// A job that begins with a stretch of the operator's choice. @return CannotResume
[[nodiscard]] base::Result<JobRestart> beginWith(int stretch, const job::Plan& plan,
                                                 const machine::MachineConfig& machine);

/// The same is done first, at the same place, whether its program has ended by now or not.
[[nodiscard]] bool isSame(const streaming::Resume& a, const streaming::Resume& b);
[[nodiscard]] bool isSame(const JobRestart& a, const JobRestart& b);
/// The answer differs from the one that somebody has confirmed. Code: CannotResume.
[[nodiscard]] base::Error changedSince();

/// What a program that still stands does before the run goes on. @param restMm  see
/// `streaming::Resume`  @return a sentence; empty: it has ended
[[nodiscard]] std::string restText(const std::optional<double>& restMm);

/// The machine of a job is not known here. Code: CannotResume.
[[nodiscard]] base::Error machineNotKnown();

}  // namespace rivulet::run
