// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Request and result of a simulation of the region, as the page shows them.
/// @threadsafety plain values.
#pragma once

#include <cstddef>
#include <vector>

#include "feasibility/sweep.h"
#include "widgets/feasibility/feed_scale.h"

namespace rivulet::widgets {

/// A grid that fills the picture of one chart.
struct SimulationWanted {
  feasibility::SweepAxis axis = feasibility::SweepAxis::PointDistance;
  std::vector<double> abscissas;  ///< d_min in mm, N, or δ in mm; ascending, > 0
  std::vector<double> feedsMmPerS;
};

/// Runs at one point of the grid.
struct SimulatedPoint {
  double abscissa = 0.0;
  double feedMmPerS = 0.0;
  std::size_t runs = 0;
  std::size_t failures = 0;  ///< of these
};

/// Feeds between which the probability of a failed run rises, from the extended model.
struct ProbabilityBand {
  double abscissa = 0.0;
  double rareMmPerS = 0.0;  ///< one run of a thousand fails
  double halfMmPerS = 0.0;  ///< half of them do
};

struct SimulatedRegion {
  feasibility::SweepAxis axis = feasibility::SweepAxis::PointDistance;
  feasibility::OperatingPoint operatingPoint;  ///< method, N and δ it was made with
  FeedScale scale{};                           ///< as in the model it was made for
  std::size_t programPoints = 0;               ///< points of the simulated section
  std::vector<SimulatedPoint> points;
  std::vector<ProbabilityBand> band;  ///< ascending
};

}  // namespace rivulet::widgets
