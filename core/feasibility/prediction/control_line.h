// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The time line of the control, the same for all methods: motions between two stops, standstills,
/// and the sum of what is known of the run. @threadsafety plain values.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "feasibility/prediction/even_motion.h"
#include "feasibility/probability.h"

namespace rivulet::feasibility {

/// The motion between two stops, by the model's own motion or, without one, an even one.
class Stretch {
 public:
  Stretch(std::span<const gcode::StreamPoint> points, base::Vec3 fromMm, double feedMmPerS,
          const StreamModel& model);

  [[nodiscard]] double durationS() const { return m_durationS; }
  [[nodiscard]] base::Vec3 endMm() const { return m_endMm; }
  /// Set points on a grid from the start of the motion on; stays at the end.
  void sample(double stepS, std::vector<base::Vec3>& out) const;

 private:
  base::Vec3 m_endMm;
  double m_stepS = 0.0;
  double m_durationS = 0.0;
  TimedMotion m_motion;
  std::optional<EvenMotion> m_even;
};

/// Times of the control in ms, and what its cycles make of them.
struct Clockwork {
  explicit Clockwork(const ControlTimes& control);

  /// Whole cycles: the stop is seen at the end of the cycle in which the motion ended.
  [[nodiscard]] double up(double ms) const;
  /// Latest moment at which a cell must have been written to be visible at `ms`.
  [[nodiscard]] double down(double ms) const;

  double cycleMs;
  double standMs;
  double standDeviationMs;
  double relatchMs;
  double blockMs;
};

/// One standstill: from the cycle in which the stop was seen to the begin of the next motion.
struct Stand {
  double ms = 0.0;
  double probability = 0.0;
};

/// What a standstill may take, one entry per interpolation cycle.
/// @param seenLateMs  how long the axes have stood when the stop is seen
/// @param readyMs  after that, when the first block is ready to move
[[nodiscard]] std::vector<Stand> stands(const Clockwork& clock, double seenLateMs, double readyMs,
                                        bool moved);
[[nodiscard]] double meanMsOf(const std::vector<Stand>& list);

/// What is known of a run so far.
struct Tally {
  double alive = 1.0;  ///< probability that no deadline has been missed
  double seconds = 0.0;
  double standingS = 0.0;
  std::size_t stops = 0;
  std::size_t weakest = 0;
  double weakestLoss = 0.0;

  void lose(double mass, std::size_t point);
  [[nodiscard]] Prediction result() const;
};

}  // namespace rivulet::feasibility
