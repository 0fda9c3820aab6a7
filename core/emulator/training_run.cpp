// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/training_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "base/error.h"
#include "emulator/emulator_error.h"

namespace rivulet::emulator {

namespace {

base::Result<void> requireFinite(const TrainingRun& run, char axis,
                                 const std::vector<double>& values, const char* what) {
  const auto bad = std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
  if (bad == values.end()) {
    return {};
  }
  return base::fail(EmulatorError::BadNumbers,
                    fmt::format("{} {} of axis {} is not a number: leave this row out of the file.",
                                what, bad - values.begin() + 1, axis),
                    run.name);
}

}  // namespace

std::error_code make_error_code(EmulatorError code) {
  static const base::NamedCategory category("emulator");
  return {static_cast<int>(code), category};
}

base::Result<void> checkRun(const TrainingRun& run) {
  if (!(std::isfinite(run.period) && run.period > 0.0)) {
    return base::fail(EmulatorError::BadTimes, "The set points need a period greater than 0 s.",
                      run.name);
  }
  for (const double at : run.observedAt) {
    if (!std::isfinite(at)) {
      return base::fail(EmulatorError::BadNumbers,
                        "A time is not a number: leave this row out of the file.", run.name);
    }
  }
  const auto back = std::ranges::adjacent_find(run.observedAt, std::greater_equal<>());
  if (back != run.observedAt.end()) {
    return base::fail(
        EmulatorError::BadTimes,
        fmt::format("Time does not advance after {:.4f} s: record the run again, or cut the file "
                    "there.",
                    *back),
        run.name);
  }
  for (const AxisTrack& track : run.axes) {
    if (track.observed.size() != run.observedAt.size() || track.reference.empty()) {
      return base::fail(EmulatorError::BadTimes,
                        fmt::format("Axis {} has {} positions at {} times and {} set points: each "
                                    "time needs one position, and set points must be there.",
                                    track.axis, track.observed.size(), run.observedAt.size(),
                                    track.reference.size()),
                        run.name);
    }
    if (auto finite = requireFinite(run, track.axis, track.reference, "Set point"); !finite) {
      return finite;
    }
    if (auto finite = requireFinite(run, track.axis, track.observed, "Position"); !finite) {
      return finite;
    }
    if (!track.observedMmPerS.empty() && track.observedMmPerS.size() != run.observedAt.size()) {
      return base::fail(EmulatorError::BadTimes,
                        fmt::format("Axis {} has {} speeds at {} times: each time needs one.",
                                    track.axis, track.observedMmPerS.size(), run.observedAt.size()),
                        run.name);
    }
    if (auto finite = requireFinite(run, track.axis, track.observedMmPerS, "Speed"); !finite) {
      return finite;
    }
  }
  return {};
}

}  // namespace rivulet::emulator
