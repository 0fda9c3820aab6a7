// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A plot as an SVG picture for print: axes with round ticks, units, a legend, and series that
/// differ even without colour. @threadsafety pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/plot.h"

namespace rivulet::report {

struct PlotLook {
  std::vector<std::size_t> colours{};  ///< number of each series' colour; empty: all different
  double ySpanMin = 0.0;               ///< at least this much of the vertical axis is seen
  char decimalSign = '.';              ///< of the numbers at the axes
};

/// The same plot gives the same text, to the byte.
[[nodiscard]] std::string svgPlot(const base::Plot& plot, const PlotLook& look = {});

}  // namespace rivulet::report
