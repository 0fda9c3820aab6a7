// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "training/sparse_learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/median.h"
#include "emulator/emulator_error.h"
#include "emulator/identification.h"
#include "emulator/monitor.h"
#include "training/recorded_run.h"

namespace rivulet::training {

namespace {

using emulator::Emulator;
using emulator::TrainingRun;

/// Clocks of a trace and of its program differ by no more.
constexpr double kClockReachS = 0.6;
/// Puts the delay that is looked for away from its bound at 0.
constexpr double kAddedDelayS = 0.01;
/// Stretches with motion are early or late by no more, one against another.
constexpr double kSteadyS = 0.03;
constexpr double kSteadyStretchS = 2.0;
constexpr double kSteadyMotionMm = 1.0;
/// Of the largest speed of a run: where the axes are slower, a position says little of its time.
constexpr double kFastShare = 0.5;
/// Standard deviation of a normal distribution by its median deviation.
constexpr double kSigmaPerDeviation = 1.4826;

/// Puts the times of a run on the time of its set points.
void align(TrainingRun& run, const Emulator& emulator, double reachS) {
  const double shiftS = emulator::bestTimeShift(emulator, run, reachS);
  for (double& atS : run.observedAt) {
    atS += shiftS;
  }
}

/// The least delay of the axes is taken as the shift of the clocks.
void takeCommonDelay(Emulator& emulator) {
  using emulator::AxisParameter;
  double commonS = std::numeric_limits<double>::infinity();
  for (const emulator::LearnedAxis& axis : emulator.axes) {
    commonS = std::min(commonS, axis.parameters[AxisParameter::Delay]);
  }
  for (emulator::LearnedAxis& axis : emulator.axes) {
    axis.parameters[AxisParameter::Delay] -= commonS;
    for (emulator::ParameterEstimate& estimate : axis.estimates) {
      if (estimate.parameter == AxisParameter::Delay) {
        estimate.value -= commonS;
        estimate.low = std::max(0.0, estimate.low - commonS);
        estimate.high -= commonS;
      }
    }
    std::erase_if(axis.estimates, [](const emulator::ParameterEstimate& estimate) {
      return estimate.parameter == AxisParameter::Delay && estimate.value <= 0.0;
    });
  }
}

/// To first order, a position that is seen s too early differs by -s times the speed: the error of
/// a time is that of least squares over all axes. A value for each observation.
struct TimeErrors {
  std::vector<double> products;  ///< of residual and speed, mm²/s
  std::vector<double> squares;   ///< of the speed, mm²/s²
};

base::Result<TimeErrors> timeErrors(const TrainingRun& run, const Emulator& emulator) {
  const auto residuals = emulator::residualsOf(emulator, run);
  if (!residuals) {
    return base::fail(residuals.error());
  }
  TimeErrors errors{std::vector<double>(run.observedAt.size(), 0.0),
                    std::vector<double>(run.observedAt.size(), 0.0)};
  for (const emulator::AxisResiduals& one : *residuals) {
    const emulator::LearnedAxis& axis = *emulator.find(one.axis);
    const auto track = std::ranges::find(run.axes, one.axis, &emulator::AxisTrack::axis);
    const std::vector<emulator::AxisState> states = emulator::predict(
        axis.parameters, emulator::setPointGrid(*track, run.period, axis.goesStraight),
        run.observedAt);
    for (std::size_t i = 0; i < states.size(); ++i) {
      errors.products[i] += one.mm[i] * states[i].mmPerS;
      errors.squares[i] += states[i].mmPerS * states[i].mmPerS;
    }
  }
  return errors;
}

}  // namespace

base::Result<double> sampleJitterS(const TrainingRun& run, const Emulator& emulator) {
  const auto known = timeErrors(run, emulator);
  if (!known) {
    return base::fail(known.error());
  }
  const double fastest = *std::ranges::max_element(known->squares);
  std::vector<double> errors;
  for (std::size_t i = 0; i < known->squares.size(); ++i) {
    if (known->squares[i] > kFastShare * kFastShare * fastest) {
      errors.push_back(known->products[i] / known->squares[i]);
    }
  }
  if (errors.empty()) {
    return 0.0;  // nothing moves
  }
  const double middle = base::median(errors);
  for (double& error : errors) {
    error = std::abs(error - middle);
  }
  return kSigmaPerDeviation * base::median(std::move(errors));
}

void alignClock(TrainingRun& run, const Emulator& emulator) {
  align(run, emulator, kClockReachS);
}

base::Result<void> requireSteadyClock(const TrainingRun& run, const Emulator& emulator) {
  const auto known = timeErrors(run, emulator);
  if (!known) {
    return base::fail(known.error());
  }
  const auto& [products, squares] = *known;
  struct Stretch {
    double atS = 0.0;
    double aheadS = 0.0;  ///< the machine is ahead of its program
  };
  std::vector<Stretch> stretches;
  for (std::size_t begin = 0, end = 0; begin < run.observedAt.size(); begin = end) {
    double product = 0.0;
    double square = 0.0;
    double movedMm = 0.0;
    for (; end < run.observedAt.size() &&
           run.observedAt[end] < run.observedAt[begin] + kSteadyStretchS;
         ++end) {
      product += products[end];
      square += squares[end];
      if (end > begin) {
        movedMm += std::sqrt(squares[end]) * (run.observedAt[end] - run.observedAt[end - 1]);
      }
    }
    if (movedMm > kSteadyMotionMm) {
      stretches.push_back({run.observedAt[begin], product / square});
    }
  }
  if (stretches.empty()) {
    return {};
  }
  const auto [behind, ahead] = std::ranges::minmax_element(stretches, {}, &Stretch::aheadS);
  const double driftS = ahead->aheadS - behind->aheadS;
  if (driftS <= kSteadyS) {
    return {};
  }
  const bool isLate = ahead < behind;
  return base::fail(
      emulator::EmulatorError::WrongProgram,
      fmt::format(
          "From {:.1f} s to {:.1f} s the machine {} {:.0f} ms {} its program: check that "
          "the preset has the machine's limits, and that program and trace belong together.",
          (isLate ? ahead : behind)->atS, (isLate ? behind : ahead)->atS, isLate ? "falls" : "gets",
          1e3 * driftS, isLate ? "behind" : "ahead of"),
      run.name);
}

base::Result<Emulator> learnWithClocks(std::vector<TrainingRun> runs,
                                       const emulator::LearnOptions& options) {
  // Without delays, a first model puts the clocks nearly right; with delays, the parts are chosen
  // again, and then fitted once more.
  enum Round { First, Chosen, Fitted, kRounds };
  constexpr std::array<double, kRounds> kShareUntil{0.4, 0.9, 1.0};  // of the time
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
  for (const Round round : {First, Chosen, Fitted}) {
    for (TrainingRun& run : runs) {
      align(run, emulator, round == First ? kClockReachS : 0.05);
      for (double& atS : run.observedAt) {
        // What is left of the clock's shift is found with the axes, as a delay of all of them.
        atS += round == First ? 0.0 : kAddedDelayS;
      }
    }
    emulator::LearnOptions part{
        .delay = round == First ? emulator::DelayPart::Without : emulator::DelayPart::With,
        .isCancelled = options.isCancelled};
    const double from = round == First ? 0.0 : kShareUntil[static_cast<std::size_t>(round) - 1];
    const double until = kShareUntil[round];
    if (options.progress) {
      part.progress = [&options, from, until](emulator::LearnProgress progress) {
        progress.share = from + (until - from) * progress.share;
        return options.progress(progress);
      };
    }
    if (round != Fitted) {
      auto axes = emulator::learnAxes(runs, part);
      if (!axes) {
        return base::fail(axes.error());
      }
      emulator.axes = std::move(*axes);
    } else {
      for (emulator::LearnedAxis& known : emulator.axes) {
        emulator::AxisParameters structure = known.parameters;
        structure[emulator::AxisParameter::Delay] += kAddedDelayS;
        part.structure = &structure;
        auto axis = emulator::learnAxis(runs, known.axis, part);
        if (!axis) {
          return base::fail(axis.error());
        }
        known = std::move(*axis);
      }
    }
    if (round != First) {
      takeCommonDelay(emulator);
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

}  // namespace rivulet::training
