// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "experiments/sparse_learning.h"

#include <algorithm>
#include <utility>

#include "emulator/emulator_error.h"
#include "experiments/recorded_run.h"

namespace rivulet::experiments {

namespace {

using emulator::Emulator;
using emulator::TrainingRun;

/// Clocks of a trace and of its program differ by no more.
constexpr double kClockReachS = 0.6;
/// Puts the delay that is looked for away from its bound at 0.
constexpr double kAddedDelayS = 0.01;

/// Puts the times of a run on the time of its set points.
void align(TrainingRun& run, const Emulator& emulator, double reachS) {
  const double shiftS = emulator::bestTimeShift(emulator, run, reachS);
  for (double& atS : run.observedAt) {
    atS += shiftS;
  }
}

}  // namespace

void alignClock(TrainingRun& run, const Emulator& emulator) {
  align(run, emulator, kClockReachS);
}

base::Result<Emulator> learnWithClocks(std::vector<TrainingRun> runs) {
  constexpr int kRounds = 3;
  Emulator emulator;
  for (const char letter : {'X', 'Y'}) {
    emulator::LearnedAxis axis;
    axis.axis = letter;
    for (const emulator::AxisParameterFacts& facts : emulator::axisParameterFacts()) {
      axis.parameters[facts.parameter] = facts.typical;
    }
    for (const auto part : {emulator::AxisParameter::ResonanceHz, emulator::AxisParameter::Delay,
                            emulator::AxisParameter::FeedForward}) {
      axis.parameters[part] = 0.0;
    }
    emulator.axes.push_back(axis);
  }
  for (int round = 0; round < kRounds; ++round) {
    for (TrainingRun& run : runs) {
      align(run, emulator, round == 0 ? kClockReachS : 0.05);
    }
    if (round == 0) {
      auto axes = emulator::learnAxes(runs, {.knowsTime = false});
      if (!axes) {
        return base::fail(axes.error());
      }
      emulator.axes = std::move(*axes);
      continue;
    }
    // What is left of the clock's shift is found with the axes, as a delay of all of them.
    for (TrainingRun& run : runs) {
      for (double& atS : run.observedAt) {
        atS += kAddedDelayS;
      }
    }
    double commonS = kAddedDelayS;
    for (std::size_t i = 0; i < emulator.axes.size(); ++i) {
      emulator::AxisParameters structure = emulator.axes[i].parameters;
      structure[emulator::AxisParameter::Delay] = kAddedDelayS;
      auto axis = emulator::learnAxis(runs, emulator.axes[i].axis, {.structure = &structure});
      if (!axis) {
        return base::fail(axis.error());
      }
      emulator.axes[i] = std::move(*axis);
      const double delayS = emulator.axes[i].parameters[emulator::AxisParameter::Delay];
      commonS = i == 0 ? delayS : std::min(commonS, delayS);
    }
    for (emulator::LearnedAxis& axis : emulator.axes) {
      axis.parameters[emulator::AxisParameter::Delay] -= commonS;
    }
  }
  return emulator;
}

base::Result<TrainingRun> runOfProgram(const trace::Motion& motion, std::string_view program,
                                       const std::string& name, const TrapezoidRules& rules) {
  const auto blocks = parseRecordedProgram(program, {});
  if (!blocks) {
    return base::fail(blocks.error());
  }
  const std::vector<base::Vec3> course = trapezoidCourse(*blocks, {}, rules);
  if (motion.samples.size() < 2 || course.empty()) {
    return base::fail(
        emulator::EmulatorError::TooShort,
        course.empty() ? "The program moves nothing in X, Y or Z." : "This trace has no positions.",
        name);
  }
  TrainingRun run{name, rules.cycleS, {}, {}};
  for (const trace::MotionSample& sample : motion.samples) {
    run.observedAt.push_back(base::toSeconds(sample.at - motion.samples.front().at));
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // Stands before and after the program for as long as the clocks may differ.
    const auto margin = static_cast<std::size_t>(kClockReachS / rules.cycleS);
    emulator::AxisTrack track{base::kAxisNames[axis], {}, {}};
    track.reference.assign(margin, course.front()[axis]);
    for (const base::Vec3& mm : course) {
      track.reference.push_back(mm[axis]);
    }
    track.reference.insert(track.reference.end(), 2 * margin, course.back()[axis]);
    for (const trace::MotionSample& sample : motion.samples) {
      const base::Vec3 mm = motion.hasActual ? sample.actualMm : sample.setMm;
      track.observed.push_back(mm[axis]);
    }
    run.axes.push_back(std::move(track));
  }
  return run;
}

}  // namespace rivulet::experiments
