// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The probability that a stream goes wrong, and the time it takes. The equations of [P1] answer
/// yes or no from averages. Here the scatter of access times and standstills is followed through
/// the program, without simulation and without random numbers: as distributions on a time grid.
///
/// How it works. Every fault is a missed deadline: cells must be visible when the control latches
/// them, and the signal cell before the control sets the next signal. The time line of the control
/// is known except for the standstills (prediction/control_line.h): each stretch between two stops
/// takes the time of its real steps, then the axes stand for a random time. Along this line each
/// method (prediction/methods.h) follows the distribution of the moment at which the client begins
/// its next request: window by window (signal) or point by point (position). What comes too late is
/// a failure and is taken out. A client that is late stays late, because the lateness is part of
/// the distribution (a Lindley recursion with a grid instead of random numbers).
///
/// Approximations:
/// - Sums of eight and more node times are normal, with their exact mean and variance.
/// - A poll of the position reads its axes at mean offsets from its end, not at random ones.
/// - The axes share one servo lag. Without a motion model they also share one acceleration, and
///   jerk, rounding and the axes' top speeds are ignored: the real motion is slower.
/// - Requests for the display are ignored: they are made only where the client has time.
/// - A run that has missed one deadline has failed and is not followed further.
/// - Method signal: a STOPRE at each signal (`SignalStop::EachSignal`).
/// - Method window cannot fail: mean times say how long it takes and how long the machine waits.
///
/// The constants below are the errors found against simulation on the preset dmu75
/// (tests/simulation/tst_probability). Where the probability rises from 0 to 1, the prediction
/// tends to be too low. @threadsafety pure.
#pragma once

#include <functional>
#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "feasibility/stream_model.h"
#include "feasibility/verdict.h"
#include "gcode/trajectory.h"

namespace rivulet::feasibility {

/// Largest mean difference between predicted probability and simulated frequency.
inline constexpr double kProbabilityError = 0.1;
/// Largest factor between the predicted and the simulated feed at which half of the runs fail.
inline constexpr double kFeedErrorFactor = 1.15;
/// Relative error of the duration of a run that does not fail.
inline constexpr double kDurationError = 0.03;
/// The same for method window, where the machine waits for the client.
inline constexpr double kWaitingDurationError = 0.08;

struct Prediction {
  double failureProbability = 0.0;  ///< of the whole program: at least one deadline is missed
  base::Duration duration{};        ///< expected, first motion to end: motion and standstills
  base::Duration standing{};        ///< of which the axes stand
  base::Duration waiting{};         ///< of which only because the client is late (method window)
  std::size_t stops = 0;            ///< standstills within the run
  base::PointIndex weakest;  ///< first point of the window or the point that fails most often
  double weakestProbability = 0.0;  ///< that it is the one that fails
};

/// @param points  at least 1, as they are streamed
/// @param operatingPoint  N >= 2 (signal) or 1 (position, window), δ > 0 (position), feed > 0
/// @param startMm  where the tool stands before the run; its way to the first point counts
/// @threadsafety pure; 10 to 40 ms per 1000 points.
[[nodiscard]] Prediction predict(const std::vector<gcode::StreamPoint>& points,
                                 const OperatingPoint& operatingPoint, const StreamModel& model,
                                 base::Vec3 startMm);
/// As above; the tool stands 1 mm + 2·δ above the first point, out of reach of δ.
[[nodiscard]] Prediction predict(const std::vector<gcode::StreamPoint>& points,
                                 const OperatingPoint& operatingPoint, const StreamModel& model);

/// The largest feed that is not too fast, within 1 %, counted from the slowest: what comes above
/// the first that is too fast does not count. @param feedMmPerSMin  0 is returned if already this
/// one is
/// @param feedMmPerSMax  returned if even this one is not
[[nodiscard]] double largestFeedMmPerS(const std::function<bool(double feedMmPerS)>& isTooFast,
                                       double feedMmPerSMin, double feedMmPerSMax);

/// The largest feed up to which the probability stays at or below `probability`, within 1 %.
/// @param feedMmPerSMin  0 is returned if already this feed is too fast (a δ larger than the steps
///        fails at any feed) @param feedMmPerSMax  returned if even this one is not too fast
[[nodiscard]] double feedMmPerSAt(double probability, const std::vector<gcode::StreamPoint>& points,
                                  const OperatingPoint& operatingPoint, const StreamModel& model,
                                  double feedMmPerSMin, double feedMmPerSMax);

}  // namespace rivulet::feasibility
