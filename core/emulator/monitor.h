// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A learned emulator beside its machine: where does a trace depart from what was expected, by more
/// than chance explains? Wear, a changed parameter or a tampered trajectory can be the reason.
///
/// Peaks. A residual is an observed minus an emulated position. Of each second of a run the largest
/// residual of an axis is taken: its peak. The peaks of runs in good order have a Gumbel
/// distribution, if their tail falls off exponentially; location and scale are those that have
/// their mean and spread. From these follows the threshold that is exceeded with a given rate. It
/// holds at speeds up to those that it was learned at. What a model leaves grows with the speed at
/// most in proportion: where the set points are faster, the threshold is larger by as much, and no
/// rate is promised. Nor is one for an axis without intervals: what its model leaves is not chance
/// and depends on the program, so its threshold is larger by `kOtherStructure`.
///
/// Watermark ([P2] names dynamic watermarking as the purpose of an emulator). Small random
/// movements that only the sender knows are added to the set points. Positions that come from the
/// machine hold its answer to them; positions that somebody made up do not, however well they
/// follow the program. The residuals are compared with this answer: the share of it that is missing
/// is 0 for an honest trace and 1 for one without the watermark. @threadsafety plain values; pure
/// functions.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "emulator/emulator.h"
#include "emulator/training_run.h"

namespace rivulet::emulator {

/// Observed minus emulated positions of an axis, mm, at the times of the observations.
struct AxisResiduals {
  char axis = 'X';
  std::vector<double> mm;
};

/// Of the axes that are learned and recorded.
/// @return EmulatorError::NoMotion if the run moves an axis that was not learned; what checkRun
/// says
[[nodiscard]] base::Result<std::vector<AxisResiduals>> residualsOf(const Emulator& emulator,
                                                                   const TrainingRun& run);

/// Length of the stretches of which each has a peak.
inline constexpr double kPeakWindowS = 1.0;
/// Fewer peaks say nothing of rare ones.
inline constexpr int kPeaksMin = 20;

/// Measures the peaks of runs in good order and keeps them in the emulator.
/// @return as residualsOf; TooShort with fewer than kPeaksMin seconds of all runs together
[[nodiscard]] base::Result<void> measurePeaks(Emulator& emulator,
                                              std::span<const TrainingRun> runs);

struct MonitorOptions {
  /// Marks in an hour of a machine in good order, all axes together, > 0.
  double falseAlarmsPerHour = 0.1;
};

/// Of an axis that has another structure than its model. On the recordings of docs/emulator.md,
/// peaks on other designs than those learned from were 1.3 times what was to be expected.
inline constexpr double kOtherStructure = 3.0;
/// Whether a rate of false alarms can be promised on other programs.
[[nodiscard]] bool promisesRate(const LearnedAxis& axis);

/// Exceeded by a peak of this axis with the rate of false alarms, mm; see above.
[[nodiscard]] double peakThresholdMm(const LearnedAxis& axis, std::size_t axes,
                                     const MonitorOptions& options);

/// A stretch in which an axis departs from what was expected.
struct Deviation {
  char axis = 'X';
  double fromS =
      0.0;  ///< of the first and the last window in which it does, time of the set points
  double toS = 0.0;
  double largestMm = 0.0;  ///< residual, with its sign
  double thresholdMm = 0.0;
};

/// How long a run is faster than what the peaks of an axis were learned at, any axis, s.
[[nodiscard]] double secondsBeyondPeaks(const Emulator& emulator, const TrainingRun& run);

/// @return as residualsOf; BadFile if the emulator has no peaks
[[nodiscard]] base::Result<std::vector<Deviation>> findDeviations(
    const Emulator& emulator, const TrainingRun& run, const MonitorOptions& options = {});

/// How much of a watermark an axis does not show.
struct MissingShare {
  double share = 0.0;          ///< 0: all of it is there; 1: nothing
  double standardError = 0.0;  ///< of the share, from the spread over stretches of a second
  int windows = 0;

  /// Standard errors above 0. An honest trace has a t distribution with windows - 1 degrees.
  [[nodiscard]] double statistic() const {
    return standardError > 0.0 ? share / standardError : 0.0;
  }
};

/// @param residuals  against an emulation of the set points with the watermark
/// @param answer     what the watermark adds to this emulation, mm, at the same times
/// @param atS        times, ascending
[[nodiscard]] MissingShare missingWatermark(std::span<const double> residuals,
                                            std::span<const double> answer,
                                            std::span<const double> atS);

/// The statistic is larger in an honest trace with this probability. @param windows  >= 2
[[nodiscard]] double watermarkThreshold(int windows, double falseAlarmProbability);

}  // namespace rivulet::emulator
