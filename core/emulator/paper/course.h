// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run as [P2] learns from it: set points of X and Y in the steps of the model, and the few
/// samples that an OPC UA client keeps. Frame: machine. @threadsafety plain values; pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/result.h"
#include "emulator/paper/parameters.h"
#include "emulator/training_run.h"

namespace rivulet::emulator::paper {

/// Samples before this time are left out of the objective. @source [P2] section 3.1, Figure 7
inline constexpr double kTransienceS = 2.0;
/// At least this is between two samples. @source [P2] section 2.2
inline constexpr double kSampleSpacingS = 0.1;

/// The samples of a run that [P2] would have: at most 10 a second, and of these only those next to
/// a change of course, which is a change of the speed of an axis between two samples. The first and
/// the last stay. @param changeMmPerS  least change of an axis's speed, > 0
[[nodiscard]] TrainingRun atChangesOfCourse(const TrainingRun& run, double changeMmPerS = 1.0);

enum Axis : std::size_t { kAxisX = 0, kAxisY = 1 };

struct CoursePoint {
  double atS = 0.0;
  std::size_t step = 0;  ///< the model's step at or before it
  double share = 0.0;    ///< of the step after this one, 0 to 1
};

struct Course {
  std::string name;
  double stepS = 0.0;
  std::array<std::vector<double>, 2> referenceMm;  ///< each step, from time 0; of X, of Y
  std::vector<CoursePoint> points;
  std::array<std::vector<double>, 2> observedMm;      ///< at the points
  std::array<std::vector<double>, 2> observedMmPerS;  ///< at the points; empty: not seen
  std::size_t firstScored = 0;                        ///< first point at kTransienceS or later
};

/// @param stepS  of the model, > 0
/// @return EmulatorError: what checkRun says; NoMotion without an X and a Y that move; TooShort
/// without a sample after kTransienceS
[[nodiscard]] base::Result<Course> makeCourse(const TrainingRun& run, double stepS);

}  // namespace rivulet::emulator::paper
