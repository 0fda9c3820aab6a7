// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Shows on the virtual machine that a job does what its source program does: the same motion, and
/// between the motions the same actions of the machine, in the same order. @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/instant.h"
#include "base/result.h"
#include "job/plan.h"
#include "machine/config.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

struct JobProof {
  /// The source itself has been run; else its blocks in the language of the machine, without a
  /// client: it is of another dialect, or the machine does not run it as it is.
  bool isSource = false;
  base::Duration plain{};  ///< from the first motion to the last
  base::Duration asJob{};
  std::size_t ends = 0;     ///< ends of motions that were compared
  double farthestMm = 0.0;  ///< of them from each other
  std::string difference;   ///< the first, an English sentence; empty: there is none
};

/// Ends of motions that are this far apart are the same: the axes stand where a stretch begins, not
/// exactly where they were commanded to.
inline constexpr double kSameEndMm = 0.02;

/// Each native block runs in the modal state and the frame that the source has there.
/// @return the first difference, an English sentence; empty: there is none. Of other dialects than
/// SINUMERIK there is nothing to compare.  @pre plan.isWhole()
[[nodiscard]] std::string modalDifference(const job::Plan& plan);

/// Runs source and job in virtual time. @param settings  of the job  @pre plan.isWhole()
/// @return the error of the job, or StreamError::NotStarted if the source ends with an alarm, or if
/// a run is longer than the trace of the machine
[[nodiscard]] base::Result<JobProof> proveJob(const job::Plan& plan,
                                              const machine::MachineConfig& machine,
                                              const RunSettings& settings, std::uint64_t seed = 1);

}  // namespace rivulet::streaming
