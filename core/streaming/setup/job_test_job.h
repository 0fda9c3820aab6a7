// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The job that the test of whole jobs runs: forth and back along the move, by the control and by
/// stretches in turns, then the blocks that are to be tried, each followed by a stretch.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "base/vec3.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "streaming/run/run.h"
#include "streaming/setup/job_test.h"

namespace rivulet::streaming {

inline constexpr std::string_view kJobTestSource = "RIVULET_JOB_TEST.MPF";

/// The first stretch goes to where the axis stands. So the client sees, before anything moves,
/// whether the program counts as the control did before it: it may have another work offset.
inline constexpr int kStretchInPlace = 1;
/// The whole way back.
inline constexpr int kStretchOfWay = 2;
/// Between two stretches, before the first and after the last: native blocks. Gaps count from 1.
inline constexpr int kGapOfTwoMoves = 3;  ///< forth, and half of the way back
inline constexpr int kGapOfFirstTrial = 5;
inline constexpr double kTestDwellS = 2.0;

/// The test itself has such blocks: they need no trial, and show nothing.
[[nodiscard]] bool isOfTest(job::NativeReason reason);

struct JobTestJob {
  job::Plan plan;
  job::JobPrograms programs;
  RunSettings settings;
  double nearMm = 0.0;                                ///< where the axis of the move stood
  double farMm = 0.0;                                 ///< the other end of the move
  std::vector<std::vector<job::NativeReason>> kinds;  ///< of the plan's blocks
  /// Index of the dwell in the plan's parts.
  std::size_t dwellPart = 0;
};

/// @param startMm  where the axes stand, workpiece frame
/// @return BadTestBlock, or why no job can be made of it
[[nodiscard]] base::Result<JobTestJob> makeJobTestJob(const JobTestPlan& plan, base::Vec3 startMm);

}  // namespace rivulet::streaming
