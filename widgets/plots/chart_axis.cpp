// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/chart_axis.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "base/nice_step.h"

namespace rivulet::widgets {

namespace {

/// With more decades, only their beginnings have a number.
constexpr double kFewDecades = 2.0;

}  // namespace

double ChartAxis::share(double value) const {
  return scale == AxisScale::Logarithmic ? std::log(value / min) / std::log(max / min)
                                         : (value - min) / (max - min);
}

bool ChartAxis::has(double value) const {
  return std::isfinite(value) && (scale == AxisScale::Even || value > 0.0);
}

void ChartAxis::fit(double least, double greatest, int ticksWanted) {
  ticks.clear();
  if (!(least <= greatest)) {
    least = greatest = 1.0;
  }
  if (scale == AxisScale::Logarithmic) {
    min = least;
    max = std::max(greatest, 1.5 * least);
    const bool isFine = std::log10(max / min) < kFewDecades;
    for (double decade = std::pow(10.0, std::floor(std::log10(min))); decade <= max;
         decade *= 10.0) {
      for (const double part : {1.0, 2.0, 5.0}) {
        const double tick = decade * part;
        if ((part == 1.0 || isFine) && tick >= 0.999 * min && tick <= 1.001 * max) {
          ticks.push_back(tick);
        }
      }
    }
    return;
  }
  const double span = std::max({greatest - least, 1e-6 * std::abs(greatest), 1e-9});
  min = least;
  max = least + span;
  const double step = base::niceStepAbove(std::max(span / ticksWanted, counts ? 0.9 : 0.0));
  decimals = base::decimalsOfStep(step);
  for (double tick = std::ceil(min / step - 1e-9) * step; tick <= max + 1e-9 * step; tick += step) {
    ticks.push_back(tick);
  }
}

QString ChartAxis::textOf(double tick) const {
  const QLocale locale;
  return scale == AxisScale::Logarithmic ? locale.toString(tick, 'g', 6)
                                         : locale.toString(tick, 'f', decimals);
}

}  // namespace rivulet::widgets
