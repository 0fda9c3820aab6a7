// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/limits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/median.h"
#include "base/vec3.h"
#include "emulator/identification.h"

namespace rivulet::emulator {

namespace {

constexpr double kSame = 0.01;  ///< values that differ by less are the same limit
constexpr int kPlacesMin = 6;
constexpr double kHeldShare = 0.2;      ///< of a phase; the top of a circle's sine takes 0.09
constexpr double kNothing = 0.05;       ///< of the largest value: below it, a phase ends
constexpr double kJerkSetPoints = 4.0;  ///< a change of acceleration must take so many to be seen

std::vector<double> slopes(const std::vector<double>& values, double periodS) {
  std::vector<double> result;
  for (std::size_t i = 1; i < values.size(); ++i) {
    result.push_back((values[i] - values[i - 1]) / periodS);
  }
  return result;
}

double largestOf(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// A part of a course in which the value keeps its sign.
struct Phase {
  double peak = 0.0;    ///< largest magnitude
  bool isHeld = false;  ///< for a good part of the phase: a planner holds its limit, a circle not
};

Phase phaseOf(std::span<const double> values) {
  Phase phase;
  for (const double value : values) {
    phase.peak = std::max(phase.peak, std::abs(value));
  }
  const auto atPeak = std::ranges::count_if(
      values, [&](double value) { return std::abs(value) > (1.0 - kSame) * phase.peak; });
  phase.isHeld = static_cast<double>(atPeak) > kHeldShare * static_cast<double>(values.size());
  return phase;
}

/// @param ignored  smaller values end a phase
void addPhases(std::span<const double> values, double ignored, std::vector<Phase>& phases) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= values.size(); ++i) {
    const bool goesOn = i < values.size() && std::abs(values[i]) > ignored &&
                        (i == begin || values[i] * values[i - 1] > 0.0);
    if (goesOn) {
      continue;
    }
    if (i > begin) {
      phases.push_back(phaseOf(values.subspan(begin, i - begin)));
    }
    // One that was ended by the other sign is followed by the next one at once.
    begin = i < values.size() && std::abs(values[i]) > ignored ? i : i + 1;
  }
}

SeenLimit limitOf(const std::vector<Phase>& phases) {
  double largest = 0.0;
  for (const Phase& phase : phases) {
    largest = std::max(largest, phase.peak);
  }
  std::vector<double> held;
  for (const Phase& phase : phases) {
    if (phase.isHeld && phase.peak > (1.0 - kSame) * largest) {
      held.push_back(phase.peak);
    }
  }
  const int places = static_cast<int>(held.size());
  return places == 0 ? SeenLimit{largest, 0} : SeenLimit{base::median(std::move(held)), places};
}

/// Speed, acceleration and jerk of one axis in one run.
struct Derivatives {
  std::vector<double> speed;
  std::vector<double> acceleration;
  std::vector<double> jerk;
  double periodS = 0.0;
};

AxisLimits limitsOf(char axis, const std::vector<Derivatives>& courses) {
  AxisLimits limits;
  limits.axis = axis;
  double acceleration = 0.0;
  double jerk = 0.0;
  double jerkPerCycle = 0.0;
  for (const Derivatives& course : courses) {
    limits.speedMmPerS = std::max(limits.speedMmPerS, largestOf(course.speed));
    acceleration = std::max(acceleration, largestOf(course.acceleration));
    jerk = std::max(jerk, largestOf(course.jerk));
    jerkPerCycle = std::max(jerkPerCycle, course.periodS * largestOf(course.jerk));
  }
  std::vector<Phase> accelerations;
  std::vector<Phase> jerks;
  for (const Derivatives& course : courses) {
    addPhases(course.acceleration, kNothing * acceleration, accelerations);
    addPhases(course.jerk, kNothing * jerk, jerks);
  }
  limits.accelerationMmPerS2 = limitOf(accelerations);
  limits.jerkMmPerS3 = limitOf(jerks);
  limits.showsJerk = kJerkSetPoints * jerkPerCycle < acceleration;
  return limits;
}

}  // namespace

bool isReached(const SeenLimit& seen) {
  return seen.places >= kPlacesMin;
}

std::vector<AxisLimits> limitsSeen(std::span<const TrainingRun> runs) {
  std::vector<AxisLimits> all;
  for (const char axis : base::kAxisNames) {
    std::vector<Derivatives> courses;
    for (const TrainingRun& run : runs) {
      const auto track = std::ranges::find(run.axes, axis, &AxisTrack::axis);
      if (track == run.axes.end() || !moves(*track)) {
        continue;
      }
      Derivatives course;
      course.periodS = run.period;
      course.speed = slopes(track->reference, run.period);
      course.acceleration = slopes(course.speed, run.period);
      course.jerk = slopes(course.acceleration, run.period);
      courses.push_back(std::move(course));
    }
    if (!courses.empty()) {
      all.push_back(limitsOf(axis, courses));
    }
  }
  return all;
}

}  // namespace rivulet::emulator
