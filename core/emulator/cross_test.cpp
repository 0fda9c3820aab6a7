// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/cross_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "emulator/emulator_error.h"

namespace rivulet::emulator {

namespace {

constexpr double kLarger = 1.1;
constexpr double kNotTested = std::numeric_limits<double>::quiet_NaN();

/// The axes of the emulator that can be learned from this run, learned from it alone.
base::Result<Emulator> learnAlone(const Emulator& emulator, const TrainingRun& run,
                                  const std::function<bool()>& isCancelled) {
  Emulator alone;
  for (const LearnedAxis& axis : emulator.axes) {
    auto learned = learnAxis({&run, 1}, axis.axis,
                             {.structure = &axis.parameters, .isCancelled = isCancelled});
    if (learned) {
      alone.axes.push_back(std::move(*learned));
    } else if (learned.error().code == EmulatorError::Cancelled) {
      return base::fail(learned.error());
    }
  }
  return alone;
}

double changeRmsMm(const LearnedAxis& axis, AxisParameter parameter, const TrainingRun& run) {
  const auto track = std::ranges::find(run.axes, axis.axis, &AxisTrack::axis);
  if (track == run.axes.end() || !moves(*track)) {
    return 0.0;
  }
  const SetPointGrid grid = setPointGrid(*track, run.period, axis.goesStraight);
  AxisParameters larger = axis.parameters;
  larger[parameter] *= kLarger;
  const std::vector<AxisState> as = predict(axis.parameters, grid, run.observedAt);
  const std::vector<AxisState> other = predict(larger, grid, run.observedAt);
  double squares = 0.0;
  for (std::size_t i = 0; i < as.size(); ++i) {
    squares += (other[i].mm - as[i].mm) * (other[i].mm - as[i].mm);
  }
  return std::sqrt(squares / static_cast<double>(as.size()));
}

}  // namespace

base::Result<CrossTest> crossTest(const Emulator& emulator, std::span<const TrainingRun> runs,
                                  const CrossTestOptions& options) {
  CrossTest result;
  for (const TrainingRun& run : runs) {
    if (auto checked = checkRun(run); !checked) {
      return base::fail(checked.error());
    }
    result.runs.push_back(run.name);
  }
  result.rmsMm.assign(runs.size(), std::vector<double>(runs.size(), kNotTested));
  for (std::size_t from = 0; from < runs.size(); ++from) {
    const double share = static_cast<double>(from) / static_cast<double>(runs.size());
    if (options.progress && !options.progress(share)) {
      return base::fail(EmulatorError::Cancelled, "The comparison was cancelled.");
    }
    const auto alone = learnAlone(emulator, runs[from], options.isCancelled);
    if (!alone) {
      return base::fail(alone.error());
    }
    for (std::size_t on = 0; on < runs.size(); ++on) {
      if (const auto fit = testRun(*alone, runs[on])) {
        result.rmsMm[on][from] = fit->positionRmsMm;
      }
    }
  }
  for (const LearnedAxis& axis : emulator.axes) {
    for (const ParameterEstimate& estimate : axis.estimates) {
      ParameterWorth& worth =
          result.worth.emplace_back(ParameterWorth{axis.axis, estimate.parameter, {}});
      for (const TrainingRun& run : runs) {
        worth.rmsMm.push_back(changeRmsMm(axis, estimate.parameter, run));
      }
    }
  }
  return result;
}

}  // namespace rivulet::emulator
