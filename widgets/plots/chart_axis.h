// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The axis of a chart that is painted by hand: its range, and round numbers on it.
/// @threadsafety plain values.
#pragma once

#include <QString>
#include <vector>

namespace rivulet::widgets {

enum class AxisScale { Even, Logarithmic };

struct ChartAxis {
  AxisScale scale = AxisScale::Even;
  double min = 0.0;
  double max = 1.0;
  std::vector<double> ticks{};
  int decimals = 0;     ///< of the ticks of an even axis
  bool counts = false;  ///< what is counted has no ticks between whole numbers

  /// @return 0 at `min`, 1 at `max`
  [[nodiscard]] double share(double value) const;
  /// It can be drawn: finite, and positive on a logarithmic axis.
  [[nodiscard]] bool has(double value) const;
  /// Nothing to show (`least` above `greatest`): some range. @param ticksWanted  about as many
  void fit(double least, double greatest, int ticksWanted);
  [[nodiscard]] QString textOf(double tick) const;
};

}  // namespace rivulet::widgets
