// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How long requests take, as distributions on a time grid. @threadsafety plain values.
#pragma once

#include <vector>

#include "feasibility/stream_model.h"

namespace rivulet::feasibility {

/// Probability below this is dropped: far below any feed limit of interest.
inline constexpr double kNegligible = 1e-13;
/// Normal distributions are cut off at this many standard deviations.
inline constexpr double kDeviationsKept = 6.0;
/// A client that has been idle for this long may be anywhere in its poll.
inline constexpr double kForgottenMs = 100.0;

/// Standard normal distribution function.
[[nodiscard]] double normalBelow(double x);

/// Distribution of a duration: mass[i] is the probability of (first + i) grid steps.
struct Kernel {
  int first = 0;
  std::vector<double> mass;

  [[nodiscard]] int end() const { return first + static_cast<int>(mass.size()); }
  [[nodiscard]] double mean() const;
  /// Probability that the duration is at most `steps`.
  [[nodiscard]] double upTo(double steps) const;
};

/// The time of one node on a fine grid, with the exact mean and variance of the normal distribution
/// cut off below.
class NodeTimes {
 public:
  explicit NodeTimes(const AccessTimes& access);

  [[nodiscard]] double meanMs() const;
  /// Overhead and `nodes` node times, on a grid of `stepMs`. The mean is kept: a cell between two
  /// grid points is shared by both. @param nodes >= 1
  [[nodiscard]] Kernel sum(double overheadMs, int nodes, double stepMs) const;

 private:
  [[nodiscard]] double varianceMs2() const;

  double m_originMs = 0.0;
  std::vector<double> m_one;  ///< on the fine grid from the origin on
};

/// Time to the next event of a renewal process that has run for long: (1 - P(T <= t)) / mean.
[[nodiscard]] std::vector<double> residual(const Kernel& kernel);

}  // namespace rivulet::feasibility
