// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a plot shows, however it is drawn. @threadsafety plain values.
#pragma once

#include <string>
#include <vector>

namespace rivulet::base {

enum class SeriesStyle {
  Line,
  Points,
  Steps,  ///< holds each value until the next
  Band,   ///< between `y` and `yUpper`
};

struct Series {
  std::string name;
  SeriesStyle style = SeriesStyle::Line;
  bool fromPaper = false;  ///< drawn so that it differs from ours even without colour
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> yUpper;  ///< Band only
};

struct Plot {
  std::string title;
  std::string xLabel;  ///< with unit
  std::string yLabel;
  std::vector<Series> series;
};

}  // namespace rivulet::base
