// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds the parameters of an axis from runs, by least squares (Levenberg-Marquardt from several
/// starts) on the positions. Which parts the model has (feed-forward, lags, delay, viscous
/// friction, resonance) is decided by the error on parts of the runs that were not used to fit it.
///
/// How it works. From each run stretches of a second are taken: those with most changes of speed,
/// and others evenly spaced. Every third one is held out. Each structure is fitted to the others;
/// the one with the least held-out error is kept, or a simpler one that is as good. It is then
/// fitted to all runs as a whole. If what is left of the positions then is not chance (Ljung and
/// Box's test of its neighbours, 0.1 %), no structure in the list is that of the axis, and its
/// parameters have no intervals. Where set points are more than 1 ms apart, it is tried too whether
/// the machine goes straight between them. @threadsafety pure functions.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "emulator/axis_model.h"
#include "emulator/training_run.h"

namespace rivulet::emulator {

/// A parameter and the interval it is in.
struct ParameterEstimate {
  AxisParameter parameter = AxisParameter::PositionGain;
  double value = 0.0;
  double low = 0.0;  ///< of the simultaneous interval, see LearnOptions::confidence
  double high = 0.0;

  /// There is none where what the model leaves is not chance: then the axis has another structure,
  /// and its parameters may be far from these.
  [[nodiscard]] bool hasInterval() const { return high > low; }
};

/// Why an axis has no intervals, after a colon.
inline constexpr const char* kNoIntervals =
    "what the model leaves is not chance, so the axis has another structure, and its parameters "
    "may be far from these.";

/// How large the deviations of an axis in good order are: see monitor.h.
struct ResidualPeaks {
  double locationMm = 0.0;  ///< of a Gumbel distribution
  double scaleMm = 0.0;
  int windows = 0;  ///< how many peaks it is from
  /// Largest speed of the set points that they are from; 0: not known.
  double mmPerSMost = 0.0;
};

/// An axis as it was learned.
struct LearnedAxis {
  char axis = 'X';
  AxisParameters parameters;
  std::vector<ParameterEstimate> estimates;  ///< of the parts that the model has
  double fitRmsMm = 0.0;                     ///< on all the runs it was fitted to
  double heldOutRmsMm = 0.0;  ///< of this structure, on stretches that it was not fitted to
  /// The set points go straight from one to the next (the interpolation cycle of a control); else
  /// smoothly. Makes a difference if they are more than 1 ms apart.
  bool goesStraight = false;
  ResidualPeaks peaks = {};
};

/// How far the search has come: shown, and asked whether to go on.
struct LearnProgress {
  char axis = 'X';
  int step = 0;
  int steps = 0;
  double triedRmsMm = std::numeric_limits<double>::infinity();    ///< of the last structure
  double heldOutRmsMm = std::numeric_limits<double>::infinity();  ///< best so far
  double share = 0.0;                                             ///< of all axes, 0 to 1
};

/// Whether the model of an axis has a delay.
enum class DelayPart {
  Chosen,   ///< if that makes it better
  Without,  ///< the times of the observations are known up to a constant, which is no delay
  With,
};

struct LearnOptions {
  /// Probability that all intervals of an axis together hold its true parameters, if the model has
  /// the structure of the axis.
  double confidence = 0.99;
  /// Only this structure: every part whose parameter is not 0. The values are where the search
  /// begins. Nullptr: the structure is chosen.
  const AxisParameters* structure = nullptr;
  DelayPart delay = DelayPart::Chosen;
  /// Told after each structure. @return false to stop; what has been found is lost then
  std::function<bool(const LearnProgress&)> progress{};
  /// Asked every few milliseconds. @return true to stop, as `progress` does
  std::function<bool()> isCancelled{};
};

/// @return error EmulatorError::NoMotion, TooShort, BadUnits, BadTimes, BadNumbers, Diverged,
///         Cancelled
[[nodiscard]] base::Result<LearnedAxis> learnAxis(std::span<const TrainingRun> runs, char axis,
                                                  const LearnOptions& options = {});

/// All axes that move in any of the runs, in the order in which they are recorded.
[[nodiscard]] base::Result<std::vector<LearnedAxis>> learnAxes(std::span<const TrainingRun> runs,
                                                               const LearnOptions& options = {});

/// An axis that moves less is not learned.
[[nodiscard]] bool moves(const AxisTrack& track);

/// From when on a run says how its axes follow. Of an axis that moves already when the run begins
/// nobody knows what it did before; a short run is taken as it is all the same.
/// @return s on the time of the run
[[nodiscard]] double knownFromS(const TrainingRun& run);

/// The set points of a run on the grid on which axes are simulated: at most 1 ms apart.
struct SetPointGrid {
  double stepS = 0.0;
  std::vector<double> mm;
  double startMmPerS = 0.0;  ///< speed of the set point at the first one
};
/// @param goesStraight  see LearnedAxis
[[nodiscard]] SetPointGrid setPointGrid(const AxisTrack& track, double periodS, bool goesStraight);

/// What an axis would show at these times. @param atS  ascending, from the first set point
[[nodiscard]] std::vector<AxisState> predict(const AxisParameters& parameters,
                                             const SetPointGrid& grid, std::span<const double> atS);

}  // namespace rivulet::emulator
