// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "emulator/emulator_error.h"

namespace rivulet::emulator::paper {

namespace {

/// Less than this is no motion.
constexpr double kStandingMm = 1e-3;

/// Set points are straight between two, and stay at the last.
double valueAt(const std::vector<double>& values, double index) {
  const auto last = static_cast<double>(values.size() - 1);
  const double at = std::clamp(index, 0.0, last);
  const auto before = static_cast<std::size_t>(at);
  const std::size_t after = std::min(before + 1, values.size() - 1);
  return values[before] + (at - static_cast<double>(before)) * (values[after] - values[before]);
}

/// Speed at each sample, as seen, or from the positions of its neighbours.
std::vector<double> speedsOf(const AxisTrack& track, const std::vector<double>& times) {
  if (!track.observedMmPerS.empty()) {
    return track.observedMmPerS;
  }
  std::vector<double> speeds(times.size(), 0.0);
  for (std::size_t i = 1; i < times.size(); ++i) {
    speeds[i] = (track.observed[i] - track.observed[i - 1]) / (times[i] - times[i - 1]);
  }
  return speeds;
}

void copySample(const TrainingRun& from, std::size_t index, TrainingRun& to) {
  to.observedAt.push_back(from.observedAt[index]);
  for (std::size_t axis = 0; axis < from.axes.size(); ++axis) {
    to.axes[axis].observed.push_back(from.axes[axis].observed[index]);
    if (!from.axes[axis].observedMmPerS.empty()) {
      to.axes[axis].observedMmPerS.push_back(from.axes[axis].observedMmPerS[index]);
    }
  }
}

TrainingRun withoutSamples(const TrainingRun& run) {
  TrainingRun empty{run.name, run.period, {}, {}};
  for (const AxisTrack& track : run.axes) {
    empty.axes.push_back({track.axis, track.reference, {}, {}});
  }
  return empty;
}

const AxisTrack* trackOf(const TrainingRun& run, char axis) {
  const auto found = std::ranges::find(run.axes, axis, &AxisTrack::axis);
  return found == run.axes.end() ? nullptr : &*found;
}

}  // namespace

TrainingRun atChangesOfCourse(const TrainingRun& run, double changeMmPerS) {
  TrainingRun slow = withoutSamples(run);
  // A little less than the spacing: times are rounded.
  constexpr double kLeastS = kSampleSpacingS - 1e-6;
  for (std::size_t i = 0; i < run.observedAt.size(); ++i) {
    if (slow.observedAt.empty() || run.observedAt[i] - slow.observedAt.back() >= kLeastS) {
      copySample(run, i, slow);
    }
  }
  const std::size_t count = slow.observedAt.size();
  std::vector<bool> keep(count, false);
  if (count > 0) {
    keep.front() = true;
    keep.back() = true;
  }
  for (const AxisTrack& track : slow.axes) {
    const std::vector<double> speeds = speedsOf(track, slow.observedAt);
    for (std::size_t i = 1; i < count; ++i) {
      if (std::abs(speeds[i] - speeds[i - 1]) >= changeMmPerS) {
        keep[i - 1] = true;
        keep[i] = true;
      }
    }
  }
  TrainingRun kept = withoutSamples(run);
  for (std::size_t i = 0; i < count; ++i) {
    if (keep[i]) {
      copySample(slow, i, kept);
    }
  }
  return kept;
}

base::Result<Course> makeCourse(const TrainingRun& run, double stepS) {
  if (auto sound = checkRun(run); !sound) {
    return base::fail(sound.error());
  }
  Course course{run.name, stepS, {}, {}, {}, {}, 0};
  for (const auto& [axis, letter] : {std::pair{kAxisX, 'X'}, std::pair{kAxisY, 'Y'}}) {
    const AxisTrack* track = trackOf(run, letter);
    if (track == nullptr ||
        std::ranges::max(track->reference) - std::ranges::min(track->reference) < kStandingMm) {
      return base::fail(EmulatorError::NoMotion,
                        fmt::format("Axis {} does not move: this emulator is learned from programs "
                                    "that move X and Y.",
                                    letter),
                        run.name);
    }
    const double seconds = run.period * static_cast<double>(track->reference.size() - 1);
    const auto steps = static_cast<std::size_t>(std::ceil(seconds / stepS - 1e-9)) + 1;
    std::vector<double>& reference = course.referenceMm[axis];
    reference.reserve(steps);
    for (std::size_t i = 0; i < steps; ++i) {
      reference.push_back(valueAt(track->reference, static_cast<double>(i) * stepS / run.period));
    }
    course.observedMm[axis] = track->observed;
    course.observedMmPerS[axis] = track->observedMmPerS;
  }
  for (const double at : run.observedAt) {
    const double steps = std::max(at, 0.0) / stepS;
    const auto before = static_cast<std::size_t>(steps + 1e-9);
    course.points.push_back(
        {at, before, std::clamp(steps - static_cast<double>(before), 0.0, 1.0)});
  }
  course.firstScored = static_cast<std::size_t>(
      std::ranges::lower_bound(run.observedAt, kTransienceS) - run.observedAt.begin());
  if (course.firstScored == course.points.size()) {
    return base::fail(EmulatorError::TooShort,
                      fmt::format("No sample is later than {:g} s, where the emulator has settled: "
                                  "record a longer program.",
                                  kTransienceS),
                      run.name);
  }
  return course;
}

}  // namespace rivulet::emulator::paper
