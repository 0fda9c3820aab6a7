// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the prediction of a run is made from: the times of the accesses, of the control, and how
/// the control moves. @threadsafety plain values.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "gcode/trajectory.h"

namespace rivulet::feasibility {

/// What one access costs. The time of a node is normal, but never below its least.
struct AccessTimes {
  base::Duration readOverhead = std::chrono::microseconds{900};    ///< once per read request
  base::Duration writeOverhead = std::chrono::microseconds{1300};  ///< once per write request
  base::Duration nodeMean = std::chrono::microseconds{4300};
  base::Duration nodeDeviation = std::chrono::microseconds{2000};
  base::Duration nodeMin = std::chrono::microseconds{300};
};

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
  /// From a stand at `fromMm` through the points to a stand at the last one. @param feedMmPerS  of
  /// moves without a feed of their own
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

}  // namespace rivulet::feasibility
