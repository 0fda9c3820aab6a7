// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "emulator/emulator_error.h"
#include "emulator/identification.h"

namespace rivulet::emulator {

namespace {

struct Window {
  double fromS = 0.0;
  double toS = 0.0;
  std::size_t first = 0;
  std::size_t end = 0;
};

/// Whole windows of a run, and what is left at its end if that is more than half of one.
/// @param fromS  nothing is looked at before
std::vector<Window> windowsOf(std::span<const double> atS, double fromS) {
  std::vector<Window> windows;
  auto i = static_cast<std::size_t>(std::ranges::lower_bound(atS, fromS) - atS.begin());
  while (i < atS.size()) {
    Window window{atS[i], atS[i] + kPeakWindowS, i, i};
    while (window.end < atS.size() && atS[window.end] < window.toS) {
      ++window.end;
    }
    i = window.end;
    window.toS = atS[window.end - 1];
    if (window.toS - window.fromS > 0.5 * kPeakWindowS) {
      windows.push_back(window);
    }
  }
  return windows;
}

/// @pre the run has the axis
const AxisTrack& trackOf(const TrainingRun& run, char axis) {
  return *std::ranges::find(run.axes, axis, &AxisTrack::axis);
}

double largestOf(std::span<const double> residuals, const Window& window) {
  const auto begin = residuals.begin() + static_cast<std::ptrdiff_t>(window.first);
  const auto end = residuals.begin() + static_cast<std::ptrdiff_t>(window.end);
  return *std::max_element(begin, end,
                           [](double a, double b) { return std::abs(a) < std::abs(b); });
}

/// Largest speed of the set points within a window.
double fastestMmPerS(const AxisTrack& track, double periodS, const Window& window) {
  double most = 0.0;
  const auto last = static_cast<std::size_t>(std::ceil(window.toS / periodS));
  for (auto i = static_cast<std::size_t>(window.fromS / periodS) + 1;
       i <= last && i < track.reference.size(); ++i) {
    most = std::max(most, std::abs(track.reference[i] - track.reference[i - 1]) / periodS);
  }
  return most;
}

/// By how much a window is faster than what the peaks are from; 1: it is not.
double beyond(const ResidualPeaks& peaks, const AxisTrack& track, double periodS,
              const Window& window) {
  // The last digits of set points are not a speed.
  constexpr double kSameSpeed = 1.01;
  const double share =
      peaks.mmPerSMost > 0.0 ? fastestMmPerS(track, periodS, window) / peaks.mmPerSMost : 1.0;
  return share > kSameSpeed ? share : 1.0;
}

/// Share of a t distribution above `t`. With x = sqrt(f)·tan(angle) its density becomes a power of
/// the cosine, which Simpson's rule integrates well.
double shareAboveT(double t, int freedom) {
  const double f = freedom;
  const double scale =
      std::exp(std::lgamma(0.5 * (f + 1.0)) - std::lgamma(0.5 * f)) / std::sqrt(std::numbers::pi);
  const auto density = [&](double angle) { return std::pow(std::cos(angle), f - 1.0); };
  constexpr int kSteps = 1000;
  const double end = std::atan(t / std::sqrt(f));
  const double step = end / kSteps;
  double sum = density(0.0) + density(end);
  for (int i = 1; i < kSteps; ++i) {
    sum += (i % 2 == 1 ? 4.0 : 2.0) * density(step * i);
  }
  return 0.5 - scale * sum * step / 3.0;
}

}  // namespace

base::Result<std::vector<AxisResiduals>> residualsOf(const Emulator& emulator,
                                                     const TrainingRun& run) {
  if (auto checked = checkRun(run); !checked) {
    return base::fail(checked.error());
  }
  std::vector<AxisResiduals> all;
  for (const AxisTrack& track : run.axes) {
    const LearnedAxis* const learned = emulator.find(track.axis);
    if (learned == nullptr) {
      if (auto stands = requireToStand(track, run.name); !stands) {
        return base::fail(stands.error());
      }
      continue;
    }
    AxisResiduals& residuals = all.emplace_back(AxisResiduals{track.axis, {}});
    const std::vector<AxisState> states =
        predict(learned->parameters, setPointGrid(track, run.period, learned->goesStraight),
                run.observedAt);
    for (std::size_t i = 0; i < states.size(); ++i) {
      residuals.mm.push_back(track.observed[i] - states[i].mm);
    }
  }
  return all;
}

base::Result<void> measurePeaks(Emulator& emulator, std::span<const TrainingRun> runs) {
  for (LearnedAxis& axis : emulator.axes) {
    std::vector<double> peaks;
    double mmPerSMost = 0.0;
    for (const TrainingRun& run : runs) {
      const auto residuals = residualsOf(emulator, run);
      if (!residuals) {
        return base::fail(residuals.error());
      }
      const auto found = std::ranges::find(*residuals, axis.axis, &AxisResiduals::axis);
      if (found == residuals->end()) {
        continue;
      }
      for (const Window& window : windowsOf(run.observedAt, knownFromS(run))) {
        peaks.push_back(std::abs(largestOf(found->mm, window)));
        mmPerSMost =
            std::max(mmPerSMost, fastestMmPerS(trackOf(run, axis.axis), run.period, window));
      }
    }
    const auto count = static_cast<double>(peaks.size());
    if (peaks.size() < kPeaksMin) {
      return base::fail(
          EmulatorError::TooShort,
          fmt::format("Axis {} was seen for {} s: to know how large its deviations are at most, "
                      "record {} s at least.",
                      axis.axis, peaks.size(), kPeaksMin));
    }
    double mean = 0.0;
    for (const double peak : peaks) {
      mean += peak / count;
    }
    double variance = 0.0;
    for (const double peak : peaks) {
      variance += (peak - mean) * (peak - mean) / (count - 1.0);
    }
    // Of a Gumbel distribution: variance π²·scale²/6, mean location + γ·scale.
    const double scaleMm = std::sqrt(6.0 * variance) / std::numbers::pi;
    axis.peaks = {mean - std::numbers::egamma * scaleMm, scaleMm, static_cast<int>(peaks.size()),
                  mmPerSMost};
  }
  return {};
}

bool promisesRate(const LearnedAxis& axis) {
  return std::ranges::any_of(axis.estimates, &ParameterEstimate::hasInterval);
}

double peakThresholdMm(const LearnedAxis& axis, std::size_t axes, const MonitorOptions& options) {
  const double perPeak = std::min(
      0.5, options.falseAlarmsPerHour * kPeakWindowS / (3600.0 * static_cast<double>(axes)));
  const double thresholdMm =
      axis.peaks.locationMm - axis.peaks.scaleMm * std::log(-std::log1p(-perPeak));
  return promisesRate(axis) ? thresholdMm : kOtherStructure * thresholdMm;
}

double secondsBeyondPeaks(const Emulator& emulator, const TrainingRun& run) {
  double seconds = 0.0;
  for (const Window& window : windowsOf(run.observedAt, knownFromS(run))) {
    const bool isBeyond = std::ranges::any_of(run.axes, [&](const AxisTrack& track) {
      const LearnedAxis* const learned = emulator.find(track.axis);
      return learned != nullptr && beyond(learned->peaks, track, run.period, window) > 1.0;
    });
    seconds += isBeyond ? window.toS - window.fromS : 0.0;
  }
  return seconds;
}

base::Result<std::vector<Deviation>> findDeviations(const Emulator& emulator,
                                                    const TrainingRun& run,
                                                    const MonitorOptions& options) {
  const auto residuals = residualsOf(emulator, run);
  if (!residuals) {
    return base::fail(residuals.error());
  }
  const std::vector<Window> windows = windowsOf(run.observedAt, knownFromS(run));
  std::vector<Deviation> deviations;
  for (const AxisResiduals& axis : *residuals) {
    const LearnedAxis& learned = *emulator.find(axis.axis);
    const ResidualPeaks& peaks = learned.peaks;
    if (peaks.windows < kPeaksMin) {
      return base::fail(EmulatorError::BadFile,
                        fmt::format("This emulator does not say how large the deviations of axis "
                                    "{} usually are: learn it again, from {} s of traces at least.",
                                    axis.axis, kPeaksMin));
    }
    const double knownMm = peakThresholdMm(learned, emulator.axes.size(), options);
    const AxisTrack& track = trackOf(run, axis.axis);
    bool goesOn = false;
    for (const Window& window : windows) {
      const double largestMm = largestOf(axis.mm, window);
      const double thresholdMm = knownMm * beyond(peaks, track, run.period, window);
      if (!(std::abs(largestMm) > thresholdMm)) {
        goesOn = false;
        continue;
      }
      if (!goesOn) {
        deviations.push_back({axis.axis, window.fromS, window.toS, largestMm, thresholdMm});
      }
      Deviation& last = deviations.back();
      last.toS = window.toS;
      last.largestMm = std::abs(largestMm) > std::abs(last.largestMm) ? largestMm : last.largestMm;
      goesOn = true;
    }
  }
  return deviations;
}

MissingShare missingWatermark(std::span<const double> residuals, std::span<const double> answer,
                              std::span<const double> atS) {
  struct Sums {
    double product = 0.0;
    double square = 0.0;
  };
  std::vector<Sums> windows;
  Sums all;
  for (const Window& window : windowsOf(atS, atS.empty() ? 0.0 : atS.front())) {
    Sums sums;
    for (std::size_t i = window.first; i < window.end; ++i) {
      sums.product -= residuals[i] * answer[i];
      sums.square += answer[i] * answer[i];
    }
    if (sums.square > 0.0) {
      windows.push_back(sums);
      all.product += sums.product;
      all.square += sums.square;
    }
  }
  MissingShare missing;
  missing.windows = static_cast<int>(windows.size());
  if (missing.windows < 2) {
    return missing;
  }
  // The share of all windows is a mean of those of the windows, weighted by their squares.
  missing.share = all.product / all.square;
  const auto count = static_cast<double>(windows.size());
  double variance = 0.0;
  for (const Sums& sums : windows) {
    const double off = sums.product - missing.share * sums.square;
    variance += off * off;
  }
  missing.standardError = std::sqrt(variance * count / (count - 1.0)) / all.square;
  return missing;
}

double watermarkThreshold(int windows, double falseAlarmProbability) {
  double low = 0.0;
  double high = 1e3;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shareAboveT(middle, windows - 1) > falseAlarmProbability ? low : high) = middle;
  }
  return high;
}

}  // namespace rivulet::emulator
