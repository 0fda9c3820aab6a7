// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The motion of a control without a motion model: even acceleration, and a speed step at corners.
/// @threadsafety plain values.
#pragma once

#include <span>
#include <vector>

#include "base/vec3.h"
#include "feasibility/stream_model.h"

namespace rivulet::feasibility {

/// From a stand through the points to a stand: one leg per point.
class EvenMotion {
 public:
  EvenMotion(std::span<const gcode::StreamPoint> points, base::Vec3 fromMm, double feedMmPerS,
             const ControlTimes& control);

  [[nodiscard]] double durationS() const { return m_durationS; }
  /// Set points on a grid from the start of the motion on; stays at the end.
  void sample(double stepS, std::vector<base::Vec3>& out) const;

 private:
  struct Leg {
    base::Vec3 fromMm;
    base::Vec3 direction;
    double lengthMm = 0.0;
    double feedMmPerS = 0.0;
    double entryMmPerS = 0.0;
    double topMmPerS = 0.0;
    double exitMmPerS = 0.0;
    double startS = 0.0;
    double durationS = 0.0;

    [[nodiscard]] base::Vec3 atMm(double timeS, double accelerationMmPerS2) const;
  };

  static double cornerMmPerS(const Leg& before, const Leg& after, double stepMmPerS);
  void plan();

  double m_accelerationMmPerS2;
  std::vector<Leg> m_legs;
  base::Vec3 m_endMm;
  double m_durationS = 0.0;
};

}  // namespace rivulet::feasibility
