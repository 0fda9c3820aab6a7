// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How probable is it that a stream goes wrong, and how long does it take? The equations of [P1]
/// answer yes or no from averages; here the chance of access times and stand-stills is followed
/// through the program. No simulation and no random numbers: distributions on a time grid.
///
/// How it works. Everything that goes wrong is a deadline missed: cells that are to be visible when
/// the control latches them, or the signal cell before the control sets the next signal. The time
/// line of the control is known but for the stand-stills: each stretch between two stops takes the
/// time its real steps need, then the axes stand for a random time. Along it the model carries the
/// distribution of the moment at which the client begins its next request, one window (signal) or
/// one point (position) after the other, and puts aside what comes too late. A client that falls
/// behind stays behind: the lateness is in the distribution (a Lindley recursion with a grid in
/// place of random numbers).
///
/// What is approximated.
/// - Sums of eight and more node times are normal, with their exact mean and variance.
/// - A poll of the position takes its axes at mean offsets from its end, not at random ones.
/// - The axes share one servo lag. Without a motion model they also share one acceleration, and
///   jerk, roundings and top speeds are left out: the real motion is slower.
/// - Requests for the display are left out: they are made only where the client has slack.
/// - A run that has missed one deadline has failed; what comes after it is not followed.
/// - Method signal: a STOPRE at each signal (`SignalStop::EachSignal`).
/// - Method window cannot fail: mean times tell how long it takes and how long the machine waits.
///
/// Error found against simulation on the preset dmu75 (tests/simulation/tst_probability): see the
/// three constants below. Where the probability rises from 0 to 1 the model tends to the low side.
/// @threadsafety pure.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "feasibility/verdict.h"
#include "gcode/trajectory.h"

namespace rivulet::feasibility {

/// Largest mean difference between predicted probability and simulated frequency.
inline constexpr double kProbabilityError = 0.1;
/// The feed at which half of the runs fail is right within this factor.
inline constexpr double kFeedErrorFactor = 1.15;
/// Relative error of the duration of a run that does not fail.
inline constexpr double kDurationError = 0.03;
/// The same for method window, where the machine waits for the client.
inline constexpr double kWaitingDurationError = 0.08;

/// What one access costs. The time of a node is normal, but never below its least.
struct AccessTimes {
  base::Duration readOverhead = std::chrono::microseconds{900};    ///< once per read request
  base::Duration writeOverhead = std::chrono::microseconds{1300};  ///< once per write request
  base::Duration nodeMean = std::chrono::microseconds{4300};
  base::Duration nodeDeviation = std::chrono::microseconds{2000};
  base::Duration nodeMin = std::chrono::microseconds{300};
};

/// How long one request took, as measured.
struct RequestSample {
  base::Duration took{};
  int nodes = 1;
  bool write = false;
};

/// Access times from measured requests: the node time is the slope over the number of nodes, the
/// overheads what is left (0 if all requests had the same number of nodes), the deviation the
/// scatter about that line. @param samples at least 2, nodes >= 1
[[nodiscard]] AccessTimes accessTimesFrom(std::span<const RequestSample> samples);

/// What the control needs for its part.
struct ControlTimes {
  base::Duration interpolationCycle = std::chrono::milliseconds{4};
  base::Duration standstillMean = std::chrono::milliseconds{40};  ///< around a STOPRE
  base::Duration standstillDeviation = std::chrono::milliseconds{4};
  base::Duration relatch = std::chrono::milliseconds{30};  ///< from standing to the next block read
  base::Duration blockPreparation = std::chrono::milliseconds{1};
  double accelerationMmPerS2 = 5000.0;
  double cornerStepMmPerS = 24.0;  ///< speed step an axis may make at a corner
  base::Duration servoLag = std::chrono::milliseconds{10};  ///< time constant, first order
};

/// The motion from one stand to the next, as the set point makes it.
struct TimedMotion {
  double durationS = 0.0;
  std::vector<base::Vec3> setPointsMm;  ///< at every `stepS` from the start of the motion on
};

/// How the control would move. @threadsafety `move` may be called on several threads.
class MotionModel {
 public:
  virtual ~MotionModel() = default;
  /// From a stand at `fromMm` through the points to a stand at the last one.
  [[nodiscard]] virtual TimedMotion move(std::span<const gcode::StreamPoint> points,
                                         base::Vec3 fromMm, double feedMmPerS,
                                         double stepS) const = 0;
};

struct StreamModel {
  AccessTimes access;
  ControlTimes control;
  /// Null: the axes are taken to accelerate evenly, with a step of the speed at corners, as
  /// `control` says.
  std::shared_ptr<const MotionModel> motion;
};

struct Prediction {
  double failureProbability = 0.0;  ///< of the whole program: at least one deadline is missed
  base::Duration duration{};        ///< expected, first motion to end: motion and stand-stills
  base::Duration standing{};        ///< of which the axes stand
  base::Duration waiting{};         ///< of which only because the client is late (method window)
  std::size_t stops = 0;            ///< stand-stills within the run
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

/// The largest feed up to which the probability stays at or below `probability`, within 1 %.
/// @param feedMmPerSMin  0 is returned if already this feed is too fast (a δ larger than the steps
///        fails at any feed) @param feedMmPerSMax  returned if even this one is not too fast
[[nodiscard]] double feedMmPerSAt(double probability, const std::vector<gcode::StreamPoint>& points,
                                  const OperatingPoint& operatingPoint, const StreamModel& model,
                                  double feedMmPerSMin, double feedMmPerSMax);

/// Where an equation lies beside the model.
struct Strictness {
  double equationMmPerS = 0.0;  ///< feed limit of the verdict
  double modelMmPerS = 0.0;     ///< feed at which one run of a thousand fails
  /// Above 1 the equations are too strict by this factor, below 1 they promise too much.
  [[nodiscard]] double factor() const { return modelMmPerS / equationMmPerS; }
};

/// Compares at one program, N and δ; the feed of the operating point does not matter.
/// @return the errors of `judge`
[[nodiscard]] base::Result<Strictness> strictness(const std::vector<gcode::StreamPoint>& points,
                                                  const OperatingPoint& operatingPoint,
                                                  const StreamModel& model,
                                                  const SafetyFactors& safety = {});

}  // namespace rivulet::feasibility
